#include "app/commands/Exports.h"

#include "app/dialogs/RangeDialog.h"
#include "app/session/Session.h"
#include "app/style/Text.h"
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"
#include "core/base/Files.h"
#include "core/base/ShownText.h"
#include "core/io/CameraTrackJson.h"
#include "core/io/PictureFile.h"
#include "core/report/CommandLine.h"
#include "core/taa/GlslExport.h"

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

Exports::Exports(Session& session, ViewArea& views, const QString& cameraFolder, QWidget* window)
    : QObject(window), session_(session), views_(views), cameraFolder_(cameraFolder), window_(window) {
  session_.onArrival<ExportResult>(this, [this](const ExportResult& result) {
    const QString name = QFileInfo(QString::fromStdString(result.target)).filePath();
    const bool isOneFile = name.endsWith(QLatin1String(".gif")) || name.endsWith(QLatin1String(".json"));
    if (result.frames == 1)
      Q_EMIT said(tr("Exported one frame into %1.").arg(name));
    else if (result.frames > 1 && isOneFile)
      Q_EMIT said(tr("Exported %1 frames into %2.").arg(result.frames).arg(name));
    else if (result.frames > 1)
      Q_EMIT said(tr("Exported %1 frames, each into a file of its own; the first file is %2.")
                      .arg(result.frames)
                      .arg(name));
    else
      Q_EMIT said(tr("The export ended early; none of its files were left."));
  });
}

// A part of it may be on its way.
std::optional<QImage> Exports::viewImage(bool withLegend) {
  QImage image = views_.active()->viewport()->picture(withLegend);
  if (!image.isNull()) return image;
  Q_EMIT failed(tr("A part of this view is on its way: pause, or try again when it is there."));
  return {};
}

void Exports::askForView(bool withLegend) {
  const QString name = QStringLiteral("%1.%2.png")
                           .arg(qtext(intermediate(views_.active()->id()).name))
                           .arg(session_.status().info.frame, 4, 10, QLatin1Char('0'));
  askForPlace(window_, withLegend ? tr("Save the view with its legend") : tr("Save the view"), name,
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
      error = QString::fromStdString(shownReason(wrong));
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
  auto* dialog = new RangeDialog(session_, views_, window_);
  connect(dialog, &RangeDialog::exportRequested, this, &Exports::writeRange);
  dialog->show();
}

void Exports::writeRange(const SequenceRequest& request) {
  session_.post(request::ExportSequence{request});
}

void Exports::askForGlsl() {
  const QString name =
      QStringLiteral("taa_resolve_%1.frag").arg(QString::fromStdString(session_.presets().presetId()));
  askForPlace(window_, tr("Export resolve and output as GLSL"), name, tr("GLSL (*.frag *.glsl)"),
              [this](const QString& path) { writeGlsl(path); });
}

void Exports::askForGlslOf(const Settings& settings) {
  askForPlace(window_, tr("Export what was found as GLSL"), QStringLiteral("taa_resolve_tuned.frag"),
              tr("GLSL (*.frag *.glsl)"),
              [this, settings](const QString& path) { writeGlsl(path, settings); });
}

void Exports::writeGlsl(const QString& path) {
  writeGlsl(path, session_.presets().settings());
}

void Exports::writeGlsl(const QString& path, const Settings& settings) {
  try {
    const PresetChoices& presets = session_.presets();
    const std::string title = settingsTitle(presets.presetId(), settings, presets.presetSettings());
    writeFile(path.toStdString(), exportedGlsl(settings, title));
    Q_EMIT said(tr("Saved %1.").arg(path));
  } catch (const std::exception& error) {
    Q_EMIT failed(QString::fromStdString(shownReason(error)));
  }
}

// Named by what is in it: lines that were copied before stay true.
QString Exports::cameraFile(const SessionFile& session) const {
  if (!needsCameraFile(session)) return {};
  const QByteArray text = QByteArray::fromStdString(cameraTrackJson(*session.track).dump(1));
  const QByteArray hash = QCryptographicHash::hash(text, QCryptographicHash::Sha1).toHex().left(12);
  return QDir(cameraFolder_).filePath(QStringLiteral("path-%1.json").arg(QString::fromLatin1(hash)));
}

void Exports::copyView(bool withLegend) {
  const std::optional<QImage> shown = viewImage(withLegend);
  if (!shown) return;
  QApplication::clipboard()->setImage(*shown);
  Q_EMIT said(tr("Copied the picture of view %1, %2×%3 pixels.")
                  .arg(QChar(static_cast<char16_t>('A' + views_.activeIndex())))
                  .arg(shown->width())
                  .arg(shown->height()));
}

QString Exports::commandLine() const {
  const ViewPanel* view = views_.active();
  CommandView shown = view->commandView();
  shown.referenceSamples = session_.status().referenceGoal;
  shown.capture = session_.status().capture;
  const SessionFile session = session_.file();
  return QString::fromStdString(renderCommand(session, shown, cameraFile(session).toStdString()));
}

void Exports::copyCommandLine() {
  if (!session_.isOpen()) return;
  const SessionFile session = session_.file();
  try {
    if (const QString camera = cameraFile(session); !camera.isEmpty()) {
      QDir().mkpath(QFileInfo(camera).path());
      writeFile(camera.toStdString(), cameraTrackJson(*session.track).dump(1));
    }
  } catch (const std::exception& error) {
    Q_EMIT failed(QString::fromStdString(shownReason(error)));
    return;
  }
  QApplication::clipboard()->setText(commandLine());
  Q_EMIT said(tr("Copied: %1").arg(commandLine()));
}

} // namespace taa::app
