#include "app/commands/ProbeCommands.h"

#include "app/panels/ProbePanel.h"
#include "app/session/Session.h"
#include "app/style/Numbers.h"
#include "app/style/Text.h"
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"
#include "app/views/plots/SensitivityPage.h"
#include "app/views/plots/WhatIfPage.h"
#include "core/report/ProbeReport.h"
#include "core/report/verdicts/VerdictReport.h"

#include <QApplication>
#include <QClipboard>

#include <algorithm>
#include <optional>
#include <string>

namespace taa::app {

ProbeCommands::ProbeCommands(Session& session, ViewArea& views, ProbePanel& panel, QObject* parent)
    : QObject(parent), session_(session), views_(views), panel_(panel) {
  connect(&panel_, &ProbePanel::copyRequested, this, [this] { copy(ProbeFormat::Text); });
  session_.onArrival<WorstDelivery>(this, [this](const WorstDelivery& worst) { showWorst(worst.found); });
}

void ProbeCommands::showWorst(const FoundWorst& found) {
  session_.probes().setPixel(found.worst.pixel);
  views_.active()->viewport()->reveal(found.worst.pixel);
  Q_EMIT foundWorst(foundText(found));
}

QString ProbeCommands::foundText(const FoundWorst& found) {
  const WorstQuestion& of = found.question;
  QString what = qtext(intermediate(of.row).label);
  switch (found.step) {
  case WorstStep::Rejected:
    return tr("Rejected pixel %1 of %2").arg(found.number).arg(found.count);
  case WorstStep::Clipped:
    return tr("Clipped pixel %1 of %2, moved %3 of the way")
        .arg(found.number)
        .arg(found.count)
        .arg(percentText(100.0 * static_cast<double>(found.worst.badness)));
  case WorstStep::NoNumber:
    return tr("NaN or infinite pixel %1 of %2 of %3").arg(found.number).arg(found.count).arg(what);
  case WorstStep::Pixel:
  case WorstStep::Category:
    break;
  }
  if (of.category) what = tr("%1: %2").arg(what, qtext(categoryText(of.row, *of.category)));
  return tr("Worst pixel %1 of %2 by %3").arg(found.number).arg(found.count).arg(what);
}

void ProbeCommands::goToNextWorst(WorstStep step) {
  session_.probes().findWorst(views_.active()->id(), step);
}

bool ProbeCommands::addAnother() {
  const auto hovered = views_.active()->viewport()->hovered();
  const auto probed = session_.probes().pixel();
  if (!hovered && !probed) return false;
  const auto isTaken = [this](const glm::ivec2& pixel) {
    return std::ranges::any_of(session_.probes().all(),
                               [&](const Probe& probe) { return probe.pixel == pixel; });
  };
  glm::ivec2 pixel = hovered ? *hovered : *probed;
  while (isTaken(pixel)) ++pixel.x;
  session_.probes().add(pixel);
  return true;
}

void ProbeCommands::copyValue() {
  const QString text = panel_.valueText(views_.active()->id());
  if (!text.isEmpty()) QApplication::clipboard()->setText(text);
}

void ProbeCommands::copyVerdict() {
  const VerdictDelivery* verdict = session_.verdicts().verdict();
  if (!verdict || !verdict->answer) return;
  QApplication::clipboard()->setText(
      QString::fromStdString(verdictText({{}, *verdict->answer, verdict->remedies})));
}

void ProbeCommands::copy(ProbeFormat format) {
  const ProbeResult* result = session_.probes().result();
  if (!result || !session_.probes().hasOwnResult() || result->around.empty()) return;
  const Status& status = session_.status();
  const ProbeReport report{{status.source, status.camera,
                            status.driver.renderer + ", " + status.driver.version, status.width,
                            status.height},
                           {result->x, result->y},
                           {{.lane = {"", session_.presets().presetId(), result->settings, result->info},
                             .record = result->around[result->around.size() / 2],
                             .details = result->details,
                             .compared = panel_.comparison() ? result->compared : std::nullopt}},
                           panel_.comparison()};
  const std::string text = format == ProbeFormat::Json       ? probeJson(report).dump(2) + "\n"
                           : format == ProbeFormat::Markdown ? probeMarkdown(report)
                                                             : probeText(report);
  QString copied = QString::fromStdString(text);
  if (format == ProbeFormat::Text && panel_.tab() == ProbeTab::WhatIf) copied = panel_.whatIf()->text();
  if (format == ProbeFormat::Text && panel_.tab() == ProbeTab::Sensitivity)
    copied = panel_.sensitivity()->text();
  QApplication::clipboard()->setText(copied);
}

} // namespace taa::app
