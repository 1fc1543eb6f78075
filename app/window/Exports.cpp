#include "app/window/Exports.h"

#include "app/dialogs/RangeDialog.h"
#include "app/session/SessionKeeper.h"
#include "app/style/Text.h"
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"
#include "app/window/MainWindow.h"
#include "core/base/Files.h"
#include "core/io/CameraTrackJson.h"
#include "core/io/PictureFile.h"
#include "core/report/CommandLine.h"
#include "core/taa/glsl/GlslExport.h"

#include <QApplication>
#include <QClipboard>
#include <QCryptographicHash>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QPointer>
#include <QThreadPool>

#include <exception>
#include <functional>
#include <string>

namespace taa::app {

namespace {

/// Asks where to write, then calls `act` with the path.
void askForPlace(QWidget* parent, const QString& title, const QString& name, const QString& filter,
                 const std::function<void(const QString&)>& act) {
  auto* dialog = new QFileDialog(parent, title, name, filter);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(QFileInfo(name).suffix());
  QObject::connect(dialog, &QFileDialog::fileSelected, parent, act);
  dialog->open();
}

} // namespace

Exports::Exports(MainWindow& window) : QObject(&window), window_(window) {
  connect(&window_.session(), &Session::exported, this, [this](const ExportResult& result) {
    const QString name = QFileInfo(QString::fromStdString(result.target)).filePath();
    if (result.frames > 0)
      Q_EMIT said(tr("Exported. Frames: %1, the first into %2.").arg(result.frames).arg(name));
    else
      Q_EMIT said(tr("The export ended early; none of its files were left."));
  });
}

// A part of it may be on its way.
std::optional<QImage> Exports::viewImage(bool withLegend) {
  QImage image = window_.views()->active()->viewport()->picture(withLegend);
  if (!image.isNull()) return image;
  Q_EMIT failed(tr("A part of this view is on its way: pause, or try again when it is there."));
  return {};
}

void Exports::askForView(bool withLegend) {
  const QString name = QStringLiteral("%1.%2.png")
                           .arg(qtext(intermediate(window_.views()->active()->id()).name))
                           .arg(window_.session().status().info.frame, 4, 10, QLatin1Char('0'));
  askForPlace(&window_, withLegend ? tr("Save the view with its legend") : tr("Save the view"), name,
              tr("PNG (*.png)"), [this, withLegend](const QString& path) { writeView(path, withLegend); });
}

// A large picture takes a while to be packed.
void Exports::writeView(const QString& path, bool withLegend) {
  const std::optional<QImage> shown = viewImage(withLegend);
  if (!shown) return;
  QThreadPool::globalInstance()->start([guard = QPointer<Exports>(this), path, image = *shown] {
    QString error;
    try {
      const auto bytes = static_cast<std::size_t>(4) * image.width() * image.height();
      writePng(path.toStdString(), image.width(), image.height(), {image.constBits(), bytes});
    } catch (const std::exception& wrong) {
      error = QString::fromUtf8(wrong.what());
    }
    QMetaObject::invokeMethod(
        qApp,
        [guard, path, error] {
          if (!guard) return;
          if (error.isEmpty())
            Q_EMIT guard->said(tr("Saved %1.").arg(path));
          else
            Q_EMIT guard->failed(error);
        },
        Qt::QueuedConnection);
  });
}

void Exports::askForRange() {
  auto* dialog = new RangeDialog(window_, &window_);
  connect(dialog, &RangeDialog::exportRequested, this, &Exports::writeRange);
  dialog->show();
}

void Exports::writeRange(const SequenceRequest& request) {
  window_.session().exportSequence(request);
}

void Exports::askForGlsl() {
  const QString name =
      QStringLiteral("taa_resolve_%1.frag").arg(QString::fromStdString(window_.session().presetId()));
  askForPlace(&window_, tr("Export resolve and output as GLSL"), name, tr("GLSL (*.frag *.glsl)"),
              [this](const QString& path) { writeGlsl(path); });
}

void Exports::writeGlsl(const QString& path) {
  const Session& session = window_.session();
  try {
    const std::string title = settingsTitle(session.presetId(), session.settings(), session.presetSettings());
    writeFile(path.toStdString(), exportedGlsl(session.settings(), title));
    Q_EMIT said(tr("Saved %1.").arg(path));
  } catch (const std::exception& error) {
    Q_EMIT failed(QString::fromUtf8(error.what()));
  }
}

// Named by what is in it: lines that were copied before stay true.
QString Exports::cameraFile(const SessionFile& session) const {
  if (!needsCameraFile(session)) return {};
  const QByteArray text = QByteArray::fromStdString(cameraTrackJson(*session.track).dump(1));
  const QByteArray hash = QCryptographicHash::hash(text, QCryptographicHash::Sha1).toHex().left(12);
  return QDir(window_.keeper()->cameraFolder())
      .filePath(QStringLiteral("path-%1.json").arg(QString::fromLatin1(hash)));
}

void Exports::copyView(bool withLegend) {
  const std::optional<QImage> shown = viewImage(withLegend);
  if (!shown) return;
  QApplication::clipboard()->setImage(*shown);
  Q_EMIT said(tr("Copied the picture of view %1, %2×%3 pixels.")
                  .arg(QChar(static_cast<char16_t>('A' + window_.views()->activeIndex())))
                  .arg(shown->width())
                  .arg(shown->height()));
}

QString Exports::commandLine() const {
  const ViewPanel* view = window_.views()->active();
  CommandView shown = view->commandView();
  shown.referenceSamples = window_.session().status().referenceGoal;
  const SessionFile session = window_.session().file();
  return QString::fromStdString(renderCommand(session, shown, cameraFile(session).toStdString()));
}

void Exports::copyCommandLine() {
  if (!window_.session().isOpen()) return;
  const SessionFile session = window_.session().file();
  try {
    if (const QString camera = cameraFile(session); !camera.isEmpty()) {
      QDir().mkpath(QFileInfo(camera).path());
      writeFile(camera.toStdString(), cameraTrackJson(*session.track).dump(1));
    }
  } catch (const std::exception& error) {
    return Q_EMIT failed(QString::fromUtf8(error.what()));
  }
  QApplication::clipboard()->setText(commandLine());
  Q_EMIT said(tr("Copied: %1").arg(commandLine()));
}

} // namespace taa::app
