#include "app/window/ViewPresenter.h"

#include "app/panels/PipelinePanel.h"
#include "app/panels/StatusLine.h"
#include "app/session/Session.h"
#include "app/views/ViewArea.h"
#include "app/window/HoverText.h"

#include <memory>

namespace taa::app {

ViewPresenter::ViewPresenter(Session& session, ViewArea& views, PipelinePanel& pipeline,
                             StatusLine& statusLine)
    : session_(session), views_(views), pipeline_(pipeline), statusLine_(statusLine) {
  connect(&pipeline_, &PipelinePanel::intermediateChosen, &views_, &ViewArea::showIntermediate);
  connect(&views_, &ViewArea::requestsChanged, this, &ViewPresenter::request);
  connect(&views_, &ViewArea::shownChanged, this, &ViewPresenter::markShown);
  connect(&views_, &ViewArea::hoverChanged, this, [this](int view) {
    statusLine_.setHover(hoverText(*views_.view(view), session_.status().info.startsHistory));
  });
  connect(&session_, &Session::pictureArrived, this, &ViewPresenter::showPicture);
  markShown();
}

// Lanes first: what is asked of them waits until they are there.
void ViewPresenter::request() {
  session_.presets().setOtherPresets(views_.comparedPresets());
  views_.setSpaces(session_.presets().settings().space, session_.presets().otherLanes());
  session_.setViews(views_.requests());
}

void ViewPresenter::showPicture(int view) {
  const std::shared_ptr<const ViewResult>& picture = session_.picture(view);
  if (!picture) return;
  views_.view(view)->setResult(picture);
  statusLine_.setPicture(picture->shotVersion);
}

void ViewPresenter::markShown() {
  pipeline_.setShown(views_.shown(), views_.activeIndex());
}

} // namespace taa::app
