#include "app/window/ProbePresenter.h"

#include "app/panels/ProbePanel.h"
#include "app/session/Session.h"
#include "app/style/Text.h"
#include "app/views/ViewArea.h"
#include "app/views/ViewPanel.h"
#include "app/views/Viewport.h"
#include "app/views/plots/WhatIfPage.h"
#include "core/render/CaptureFacts.h"
#include "core/settings/Presets.h"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace taa::app {

namespace {
constexpr int kLateAnswerMs = 20; ///< what comes sooner takes the place of the old values without a flicker
} // namespace

ProbePresenter::ProbePresenter(Session& session, ViewArea& views, ProbePanel& panel)
    : session_(session), probes_(session.probes()), views_(views), panel_(panel) {
  connect(&panel_, &ProbePanel::removeRequested, this, [this] { probes_.setPixel({}); });
  connect(&panel_, &ProbePanel::probeChosen, &probes_, &ProbeChoices::setActive);
  connect(&panel_, &ProbePanel::followChosen, this,
          [this](Follow follow) { probes_.setFollow(probes_.active(), follow); });
  connect(&panel_, &ProbePanel::intermediateChosen, this,
          [this](IntermediateId id) { views_.active()->setIntermediate(id); });
  connect(&panel_, &ProbePanel::whatIfWanted, this, [this](bool wanted) {
    probes_.setWhatIf(wanted);
    if (!wanted) probes_.setReference(false);
  });
  connect(&views_, &ViewArea::otherProbed, this, [this](glm::ivec2 pixel) { probes_.add(pixel); });
  connect(&views_, &ViewArea::probed, this, [this](glm::ivec2 pixel) { probes_.setPixel(pixel); });
  connect(&views_, &ViewArea::probeMoved, this, [this](int dx, int dy) {
    probes_.move(dx, dy);
    if (probes_.pixel()) views_.active()->viewport()->reveal(*probes_.pixel());
  });
  late_.setSingleShot(true);
  late_.setInterval(kLateAnswerMs);
  connect(&late_, &QTimer::timeout, this, &ProbePresenter::showGlimpse);
  connect(&probes_, &ProbeChoices::changed, this, &ProbePresenter::showActive);
  connect(&probes_, &ProbeChoices::probeArrived, this, &ProbePresenter::showProbe);
  connect(&views_, &ViewArea::requestsChanged, this, &ProbePresenter::askForOtherSide);
  connect(&views_, &ViewArea::shownChanged, this, &ProbePresenter::askForOtherSide);
  connectWhatIf();
}

void ProbePresenter::connectWhatIf() {
  WhatIfPage* page = panel_.whatIf();
  connect(page, &WhatIfPage::tried, this, [this](const Variant& variant) {
    PresetChoice choice = session_.presets().choice();
    if (variant.group == WhatIfGroup::Preset) {
      choice.presetId = variant.id;
      choice.presetSettings = preset(variant.id).settings;
    }
    choice.settings = variant.settings;
    session_.presets().change(choice, tr("try of %1").arg(qtext(variant.label)));
  });
  connect(page, &WhatIfPage::referenceRequested, this, [this] { probes_.setReference(true); });
  connect(page, &WhatIfPage::measuringRequested, this, [this, page] {
    const auto captured = session_.status().capture;
    const bool hasReference = !captured || captured->hasReference;
    page->measure(session_.file(), hasReference ? session_.status().referenceGoal : 0);
  });
  connect(&session_, &Session::statusChanged, this, [this, page] {
    page->setPlaying(session_.status().playing);
    panel_.setPlaying(session_.status().playing);
    panel_.setOutline(session_.status().outline);
    if (page->hasNumbers()) page->setShot(session_.file());
  });
}

// What the active view is compared with; another row is in the table already.
void ProbePresenter::askForOtherSide() {
  const Comparison& comparison = views_.active()->comparison();
  panel_.setComparison(comparison);
  std::optional<OtherSide> other;
  if (comparison.kind != OtherKind::Row) other = views_.active()->request(views_.comparedPresets()).other;
  if (other) {
    other->id = IntermediateId::resolved;
    other->style = {};
  }
  probes_.setOtherSide(other);
}

void ProbePresenter::showActive() {
  panel_.setProbes(probes_.all(), probes_.active());
  panel_.setPixel(probes_.pixel());
  if (probes_.pixel() && !probes_.hasOwnResult()) late_.start();
  showProbe();
}

void ProbePresenter::showProbe() {
  views_.setMarks(probes_.marks()); // those that follow surfaces have moved
  if (!probes_.hasOwnResult()) return;
  late_.stop();
  panel_.setResult(*probes_.result());
}

// Of the pictures that are on show: a frame may take its time.
void ProbePresenter::showGlimpse() {
  const auto pixel = probes_.pixel();
  if (!pixel || probes_.hasOwnResult()) return;
  Glimpse known{{}, session_.status().settings.space};
  for (int index = 0; index < views_.viewCount(); ++index) {
    const ViewPanel* view = views_.view(index);
    const auto values = view->viewport()->valueAt(*pixel);
    if (!values || view->isDifference() || view->viewport()->absenceAt(*pixel) != Absence::None) continue;
    glm::vec4 value(0.0f);
    for (std::size_t channel = 0; channel < std::min<std::size_t>(4, values->size()); ++channel)
      value[static_cast<int>(channel)] = (*values)[channel];
    known.values[view->id()] = value;
  }
  panel_.setGlimpse(known);
}

} // namespace taa::app
