#include "app/commands/DoctorCommands.h"

#include "app/doctor/DoctorPanel.h"
#include "app/doctor/DoctorWords.h"
#include "app/doctor/FindingDetails.h"
#include "app/session/Session.h"
#include "app/style/Text.h"
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"
#include "core/base/Error.h"
#include "core/base/Files.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/report/doctor/DoctorPage.h"
#include "core/settings/Faults.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"

#include <QByteArray>
#include <QCryptographicHash>
#include <QDir>
#include <QFileDialog>

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace taa::app {

namespace {

/// Pixels of the frames that were examined as those of the picture.
glm::ivec2 picturePixel(const glm::ivec2& pixel, const glm::ivec2& examinedPx, const Status& status) {
  const glm::dvec2 scale =
      glm::dvec2(status.width, status.height) / glm::dvec2(glm::max(examinedPx, glm::ivec2(1)));
  return glm::ivec2(glm::floor(glm::dvec2(pixel) * scale + 1e-6));
}

/// As a preset, in a file that is named by what it holds: a view that compares with it reads no other. Throws
/// Error.
QString writeCorrected(const QString& folder, const doctor::Finding& finding, const Settings& settings) {
  Preset row{"mended-" + finding.id,
             DoctorCommands::tr("Mended: %1").arg(qtext(finding.name)).toStdString(),
             "",
             0,
             "Makes right what the doctor found.",
             settings};
  const std::string text = presetToText(row);
  const QByteArray sum =
      QCryptographicHash::hash(QByteArray::fromStdString(text), QCryptographicHash::Sha1).toHex().left(8);
  const QString path = QDir(folder).filePath(qtext(row.id) + QLatin1Char('-') + QString::fromLatin1(sum) +
                                             QStringLiteral(".json"));
  if (!QDir().mkpath(folder)) throw Error(say<"the folder %1 cannot be made">(folder.toStdString()));
  writeFile(path.toStdString(), text);
  return path;
}

} // namespace

DoctorCommands::DoctorCommands(Session& session, ViewArea& views, DoctorPanel& panel, const QString& folder,
                               QWidget* window)
    : QObject(window), session_(session), views_(views), panel_(panel), folder_(folder), window_(window) {
  connect(&panel_, &DoctorPanel::examineRequested, this, &DoctorCommands::examine);
  connect(&panel_, &DoctorPanel::placeRequested, this, &DoctorCommands::goToFinding);
  connect(&panel_, &DoctorPanel::correctedRequested, this, &DoctorCommands::showCorrected);
  connect(&panel_, &DoctorPanel::reportRequested, this, &DoctorCommands::askForReport);
  connect(&panel_, &DoctorPanel::changed, this, [this] {
    showOutlines();
    panel_.details()->setWhyNotCorrected(whyNotCorrected());
    Q_EMIT reportChanged();
  });
  connect(&panel_.work(), &DoctorWork::corrected, this,
          [this](const doctor::CorrectedLook& look) { writeReportWith(&look); });
  connect(&panel_.work(), &DoctorWork::ended, this, &DoctorCommands::endReport);
  connect(&session_, &Session::statusChanged, this, &DoctorCommands::takeStatus);
  connect(&session_.presets(), &PresetChoices::settingsChanged, this, [this] {
    const Settings& examined = examined_.shot.settings.settings;
    panel_.setOutdated(panel_.diagnosis() && !(examined == session_.presets().settings()));
    panel_.details()->setWhyNotCorrected(whyNotCorrected());
    Q_EMIT reportChanged();
  });
}

void DoctorCommands::takeStatus() {
  const Status& status = session_.status();
  if (session_.isOpen() && (status.source != source_ || status.frameCount != frameCount_)) {
    source_ = status.source;
    frameCount_ = status.frameCount;
    panel_.setShot(frameCount_);
  }
  showOutlines();
}

void DoctorCommands::examine() {
  if (!session_.isOpen() || panel_.work().isRunning() || !panel_.whyNot().isEmpty()) return;
  examined_ = {session_.file(), panel_.first(), panel_.last() - panel_.first() + 1};
  healthy_ = healthySettings();
  panel_.begin(examined_);
}

void DoctorCommands::goToFinding() {
  const std::vector<doctor::RegionPlace> places = panel_.places();
  if (places.empty()) return;
  session_.post(request::SetPlaying{false});
  session_.seek(places.front().frame);
  views_.active()->setIntermediate(shownRow(*panel_.finding()));
  views_.active()->viewport()->reveal(
      picturePixel(places.front().pixel, panel_.diagnosis()->sizePx, session_.status()));
}

// Faults go back to what the preset does, as the menu of faults has it.
Settings DoctorCommands::healthySettings() const {
  Settings healthy = session_.presets().presetSettings();
  clearFaults(healthy);
  return healthy;
}

doctor::Corrected DoctorCommands::correctedSettings() const {
  return doctor::corrected({*panel_.finding()}, session_.presets().settings(), healthySettings());
}

QString DoctorCommands::whyNotCorrected() const {
  if (!panel_.finding()) return tr("No finding of the doctor's is chosen");
  const doctor::Corrected corrected = correctedSettings();
  if (!corrected.findings.empty() && corrected.settings == session_.presets().settings())
    return tr("The settings have it right already");
  if (corrected.findings.empty())
    return tr("No setting makes this right: the frames themselves have to be made anew");
  return {};
}

void DoctorCommands::showCorrected() {
  if (!whyNotCorrected().isEmpty()) return;
  try {
    const doctor::Finding& finding = *panel_.finding();
    const QString path = writeCorrected(folder_, finding, correctedSettings().settings);
    session_.post(request::SetPlaying{false});
    const std::vector<doctor::RegionPlace> places = panel_.places();
    if (!places.empty()) session_.seek(places.front().frame);
    views_.active()->setIntermediate(IntermediateId::resolved);
    views_.active()->setComparison({OtherKind::Preset, {}, path.toStdString()});
  } catch (const std::exception& error) {
    Q_EMIT failed(QString::fromStdString(shownReason(error)));
  }
}

// In the frame that they were found in: in others they lie elsewhere.
void DoctorCommands::showOutlines() {
  std::vector<doctor::OutlineEdge> edges;
  const Status& status = session_.status();
  if (panel_.isVisible())
    for (const doctor::RegionPlace& place : panel_.places()) {
      if (place.frame != status.info.frame) continue;
      const glm::ivec2 sizePx = panel_.diagnosis()->sizePx;
      for (const doctor::OutlineEdge& edge : doctor::outlineOf(place.pixels))
        edges.push_back({picturePixel(edge.from, sizePx, status), picturePixel(edge.to, sizePx, status)});
    }
  views_.setOutlines(edges);
}

QString DoctorCommands::whyNoReport() const {
  if (panel_.work().isRunning()) return tr("The doctor is at work");
  return panel_.diagnosis() && panel_.isComplete() ? QString() : tr("No frames were examined yet");
}

void DoctorCommands::askForReport() {
  if (!whyNoReport().isEmpty()) return;
  auto* dialog = new QFileDialog(window_, tr("Save the doctor's report"), QStringLiteral("doctor.html"),
                                 tr("HTML (*.html)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(QStringLiteral("html"));
  connect(dialog, &QFileDialog::fileSelected, this, &DoctorCommands::writeReport);
  dialog->open();
}

void DoctorCommands::writeReport(const QString& path) {
  if (!whyNoReport().isEmpty()) return;
  reportPath_ = path;
  const Settings& examined = examined_.shot.settings.settings;
  if (doctor::corrected(panel_.diagnosis()->findings, examined, healthy_).findings.empty())
    writeReportWith(nullptr);
  else
    panel_.correct(examined_, healthy_);
}

void DoctorCommands::writeReportWith(const doctor::CorrectedLook* corrected) {
  const QString path = std::exchange(reportPath_, {});
  if (path.isEmpty() || !panel_.diagnosis()) return;
  try {
    writeFile(path.toStdString(), doctorHtml(*panel_.diagnosis(), source_, corrected));
    Q_EMIT said(tr("Saved %1.").arg(path));
  } catch (const std::exception& error) {
    Q_EMIT failed(QString::fromStdString(shownReason(error)));
  }
}

// What it says does not depend on pictures: where they cannot be drawn it is written without.
void DoctorCommands::endReport(const QString& error) {
  Q_EMIT reportChanged();
  if (reportPath_.isEmpty()) return;
  if (error.isEmpty())
    Q_EMIT said(tr("%1 is not saved: it was stopped.").arg(std::exchange(reportPath_, {})));
  else
    writeReportWith(nullptr);
}

} // namespace taa::app
