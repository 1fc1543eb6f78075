#include "app/window/verdict/LineagePresenter.h"

#include "app/models/verdict/LineageMath.h"
#include "app/panels/LineagePanel.h"
#include "app/session/Session.h"
#include "app/views/ViewArea.h"

#include "core/probe/PixelTrace.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace taa::app {

LineagePresenter::LineagePresenter(Session& session, LineagePanel& panel, ViewArea& views)
    : session_(session), panel_(panel), views_(views) {
  connect(&panel_, &LineagePanel::seekRequested, &session_, &Session::seek);
  connect(&panel_, &LineagePanel::shownChanged, this, [this](bool shown) {
    session_.post(request::SetLineage{shown ? kLineageFrames : 0});
    show();
  });
  session_.onArrival<LineageDelivery>(this, &LineagePresenter::take);
  connect(&session_, &Session::statusChanged, this, &LineagePresenter::show);
  connect(&session_.probes(), &ProbeChoices::changed, this, &LineagePresenter::forgetOther);
}

void LineagePresenter::take(const LineageDelivery& delivery) {
  delivery_ = delivery;
  forgetOther(); // it may have been on its way for a while
}

// Another probe, or none: what is known is not of it.
void LineagePresenter::forgetOther() {
  const int active = session_.probes().active();
  if (delivery_ && (active < 0 || !isSamePlace(delivery_->probe,
                                               session_.probes().all()[static_cast<std::size_t>(active)])))
    delivery_.reset();
  show();
}

// The way is that of the frame on show.
void LineagePresenter::show() {
  const Status& status = session_.status();
  const bool isCurrent =
      delivery_ && delivery_->frame == status.info.frame && delivery_->shotVersion == status.shotVersion;
  panel_.show(session_.probes().active() >= 0, delivery_, isCurrent);
  const std::shared_ptr<const Lineage> lineage = panel_.lineage();
  views_.setPath(isCurrent && lineage && panel_.isVisible() ? pathOf(*lineage) : std::vector<PathPlace>());
}

} // namespace taa::app
