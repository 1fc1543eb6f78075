// The window and its probes: what the panel asks for, where the pins are drawn, what is copied.
#include "app/window/MainWindow.h"

#include "app/menus/Menus.h"
#include "app/panels/ProbePanel.h"
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"
#include "app/views/plots/ProbePages.h"
#include "core/report/ProbeReport.h"

#include <QApplication>
#include <QClipboard>

#include <algorithm>
#include <string>

namespace taa::app {

void MainWindow::connectProbe() {
  connect(probe_, &ProbePanel::removeRequested, &session_, [this] { session_.setPick({}); });
  connect(probe_, &ProbePanel::copyRequested, this, [this] { copyProbe(ProbeFormat::Text); });
  connect(probe_, &ProbePanel::pinChosen, &session_, &Session::setActivePin);
  connect(probe_, &ProbePanel::followChosen, &session_,
          [this](Follow follow) { session_.setFollow(session_.activePin(), follow); });
  connect(probe_, &ProbePanel::intermediateChosen, this,
          [this](IntermediateId id) { showIntermediate(id, false); });
  connect(probe_, &ProbePanel::whatIfWanted, &session_, &Session::setWhatIf);
  connect(views_, &ViewArea::pinned, &session_, [this](glm::ivec2 pixel) { session_.addPin(pixel); });
  connect(&session_, &Session::pickChanged, this, &MainWindow::showPick);
  connect(&session_, &Session::probeArrived, this, &MainWindow::showProbe);
}

void MainWindow::showPick() {
  views_->setMarks(session_.pinMarks());
  probe_->setPins(session_.pins(), session_.activePin());
  probe_->setPick(session_.pick());
  menus_->refresh();
  showProbe();
}

void MainWindow::showProbe() {
  views_->setMarks(session_.pinMarks()); // those that follow surfaces have moved
  if (const ProbeResult* result = session_.probe()) probe_->setResult(*result);
}

// Where the mouse is, else to the right of the active probe; the next place that no probe has.
void MainWindow::pinAnother() {
  const auto hovered = views_->active()->viewport()->hovered();
  const auto pick = session_.pick();
  if (!hovered && !pick) return askForPixel();
  const auto isTaken = [this](const glm::ivec2& pixel) {
    return std::ranges::any_of(session_.pins(), [&](const ProbePin& pin) { return pin.pixel == pixel; });
  };
  glm::ivec2 pixel = hovered ? *hovered : *pick;
  while (isTaken(pixel)) ++pixel.x;
  session_.addPin(pixel);
}

void MainWindow::copyValue() {
  const QString text = probe_->valueText(views_->active()->id());
  if (!text.isEmpty()) QApplication::clipboard()->setText(text);
}

void MainWindow::copyProbe(ProbeFormat format) {
  const ProbeResult* result = session_.probe();
  if (!result || result->around.empty()) return;
  const Status& status = session_.status();
  const ProbeReport report{{status.source, status.camera,
                            status.driver.renderer + ", " + status.driver.version, status.width,
                            status.height},
                           {result->x, result->y},
                           {{{"", session_.presetId(), result->settings, result->info},
                             result->around[result->around.size() / 2],
                             {},
                             result->details}}};
  const std::string text = format == ProbeFormat::Json       ? probeJson(report).dump(2) + "\n"
                           : format == ProbeFormat::Markdown ? probeMarkdown(report)
                                                             : probeText(report);
  QApplication::clipboard()->setText(probe_->tab() == ProbeTab::WhatIf && format == ProbeFormat::Text
                                         ? probe_->whatIf()->text()
                                         : QString::fromStdString(text));
}

void MainWindow::setProbeTab(ProbeTab tab) {
  setPanelVisible(probe_, true);
  probe_->setTab(tab);
}

} // namespace taa::app
