#include "app/Exports.h"

#include "app/MainWindow.h"
#include "app/Text.h"
#include "app/Theme.h"
#include "app/views/Legend.h"
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"
#include "app/widgets/RangeDialog.h"
#include "core/CommandLine.h"
#include "core/base/Files.h"
#include "core/io/PictureFile.h"
#include "core/taa/GlslExport.h"

#include <QApplication>
#include <QClipboard>
#include <QFileDialog>
#include <QFileInfo>
#include <QPainter>
#include <QPointer>
#include <QThreadPool>

#include <algorithm>
#include <functional>

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
      Q_EMIT said(tr("Exported %n frame(s), the first into %1.", nullptr, result.frames).arg(name));
    else
      Q_EMIT said(tr("The export ended early; none of its files were left."));
  });
}

QImage Exports::viewImage(bool withLegend) const {
  const ViewPanel* view = window_.views()->active();
  const auto& result = view->viewport()->result();
  if (!result || result->picture.width == 0) return {};
  const Picture& picture = result->picture;
  const QImage shown(picture.rgba.data(), picture.width, picture.height, 4 * picture.width,
                     QImage::Format_RGBA8888);
  if (!withLegend) return shown.copy();
  const double ratio = view->devicePixelRatioF();
  const int strip = static_cast<int>(kLegendHeight * ratio);
  QImage image(picture.width, picture.height + strip, QImage::Format_RGBA8888);
  image.fill(themeColors(view).panel);
  for (int y = 0; y < picture.height; ++y) // as it is, see-through where there is no picture
    std::copy_n(shown.constScanLine(y), 4 * picture.width, image.scanLine(y));
  image.setDevicePixelRatio(ratio);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::TextAntialiasing);
  paintLegend(painter,
              QRect(0, static_cast<int>(picture.height / ratio), static_cast<int>(picture.width / ratio),
                    kLegendHeight),
              intermediate(result->request.id), result->request.style, result->request.asDifference,
              themeColors(view));
  return image;
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
  const QImage image = viewImage(withLegend);
  if (image.isNull()) return Q_EMIT failed(tr("There is no picture in this view yet."));
  QThreadPool::globalInstance()->start([guard = QPointer<Exports>(this), path, image] {
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
  askForPlace(&window_, tr("Export the resolve as GLSL"), name, tr("GLSL (*.frag *.glsl)"),
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

QString Exports::commandLine() const {
  const ViewPanel* view = window_.views()->active();
  return QString::fromStdString(renderCommand(window_.session().file(), view->id(), view->style()));
}

void Exports::copyCommandLine() {
  if (!window_.session().isOpen()) return;
  QApplication::clipboard()->setText(commandLine());
  Q_EMIT said(tr("Copied: %1").arg(commandLine()));
}

} // namespace taa::app
