#include "app/commands/DoctorCommands.h"

#include "app/doctor/DoctorPanel.h"
#include "app/doctor/DoctorWords.h"
#include "app/session/Session.h"
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"
#include "core/base/Files.h"
#include "core/base/ShownText.h"
#include "core/report/doctor/DoctorPage.h"
#include "core/settings/Parameters.h"

#include <QFileDialog>

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>
#include <vector>

namespace taa::app {

namespace {

/// Pixels of the frames that were examined as those of the picture.
glm::ivec2 picturePixel(const glm::ivec2& pixel, const glm::ivec2& examinedPx, const Status& status) {
  const glm::dvec2 scale =
      glm::dvec2(status.width, status.height) / glm::dvec2(glm::max(examinedPx, glm::ivec2(1)));
  return glm::ivec2(glm::floor(glm::dvec2(pixel) * scale + 1e-6));
}

} // namespace

DoctorCommands::DoctorCommands(Session& session, ViewArea& views, DoctorPanel& panel, QWidget* window)
    : QObject(window), session_(session), views_(views), panel_(panel), window_(window) {
  connect(&panel_, &DoctorPanel::examineRequested, this, &DoctorCommands::examine);
  connect(&panel_, &DoctorPanel::placeRequested, this, &DoctorCommands::goToFinding);
  connect(&panel_, &DoctorPanel::reportRequested, this, &DoctorCommands::askForReport);
  connect(&panel_, &DoctorPanel::changed, this, [this] {
    showOutlines();
    Q_EMIT reportChanged();
  });
  connect(&session_, &Session::statusChanged, this, &DoctorCommands::takeStatus);
  connect(&session_.presets(), &PresetChoices::settingsChanged, this, [this] {
    panel_.setOutdated(panel_.diagnosis() && !(examined_ == session_.presets().settings()));
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
  const SessionFile shot = session_.file();
  examined_ = shot.settings.settings;
  panel_.begin({shot, panel_.first(), panel_.last() - panel_.first() + 1});
}

void DoctorCommands::goToFinding() {
  const std::vector<doctor::RegionPlace> places = panel_.places();
  if (places.empty()) return;
  session_.setPlaying(false);
  session_.seek(places.front().frame);
  views_.active()->setIntermediate(shownRow(*panel_.finding()));
  views_.active()->viewport()->reveal(
      picturePixel(places.front().pixel, panel_.diagnosis()->sizePx, session_.status()));
}

// In the frame that they were found in: in others they lie elsewhere.
void DoctorCommands::showOutlines() {
  std::vector<gl::Rect> boxes;
  const Status& status = session_.status();
  if (panel_.isVisible())
    for (const doctor::RegionPlace& place : panel_.places()) {
      if (place.frame != status.info.frame) continue;
      const glm::ivec2 sizePx = panel_.diagnosis()->sizePx;
      const glm::ivec2 from = picturePixel({place.box.x, place.box.y}, sizePx, status),
                       to = picturePixel({place.box.z, place.box.w}, sizePx, status);
      boxes.push_back({from.x, from.y, to.x - from.x, to.y - from.y});
    }
  views_.setRegions(boxes);
}

QString DoctorCommands::whyNoReport() const {
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
  try {
    writeFile(path.toStdString(), doctorHtml(*panel_.diagnosis(), source_));
    Q_EMIT said(tr("Saved %1.").arg(path));
  } catch (const std::exception& error) {
    Q_EMIT failed(QString::fromStdString(shownReason(error)));
  }
}

} // namespace taa::app
