#include "app/figures/FigureExport.h"

#include "app/style/Text.h"
#include "core/base/Error.h"
#include "core/base/Files.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/io/PictureFile.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QCursor>
#include <QDir>
#include <QFileDialog>
#include <QMenu>
#include <QStringList>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <string_view>
#include <utility>

namespace taa::app {

namespace {

bool isSvg(const QString& path) {
  return path.endsWith(QLatin1String(".svg"), Qt::CaseInsensitive);
}

} // namespace

FigureExport::FigureExport(Source source, QWidget* window)
    : QObject(window), source_(std::move(source)), window_(window) {
  qApp->installEventFilter(this);
}

std::vector<Figure> FigureExport::shown() const {
  std::vector<Figure> figures = source_.figures();
  std::erase_if(figures, [](const Figure& figure) { return !figure.widget->isVisible(); });
  return figures;
}

std::optional<Figure> FigureExport::shownWith(const QString& id) const {
  const std::vector<Figure> figures = shown();
  const auto found = std::ranges::find(figures, id, &Figure::id);
  return found == figures.end() ? std::nullopt : std::optional(*found);
}

void FigureExport::choose() {
  auto* menu = new QMenu(window_);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->setAccessibleName(tr("Figures on show"));
  menu->addSection(tr("Export a figure as PNG or SVG"));
  for (const Figure& figure : shown())
    menu->addAction(figure.label, this, [this, id = figure.id] { askFor(id); });
  if (menu->actions().size() == 1) menu->addAction(tr("No figure is on show"))->setEnabled(false);
  const QPoint middle = window_->mapToGlobal(window_->rect().center());
  menu->popup(window_->underMouse() ? QCursor::pos() : middle);
}

void FigureExport::askFor(const QString& id) {
  if (!shownWith(id)) return;
  auto* dialog =
      new QFileDialog(window_, tr("Export the figure"), QDir::home().filePath(id + QLatin1String(".png")));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  const QString svg = tr("SVG (*.svg)");
  dialog->setNameFilters({tr("PNG (*.png)"), svg});
  dialog->setDefaultSuffix(QStringLiteral("png"));
  connect(dialog, &QFileDialog::filterSelected, dialog, [dialog, svg](const QString& filter) {
    dialog->setDefaultSuffix(filter == svg ? QStringLiteral("svg") : QStringLiteral("png"));
  });
  connect(dialog, &QFileDialog::fileSelected, this, [this, id](const QString& path) { write(id, path); });
  dialog->open();
}

QString FigureExport::captionOf(const Figure& figure, const FigureContent& content) const {
  QStringList parts{tr("%1.").arg(figure.label), source_.caption()};
  if (!content.details.isEmpty()) parts << content.details;
  return parts.join(QLatin1Char(' '));
}

void FigureExport::writeOrThrow(const QString& id, const QString& path) const {
  const std::optional<Figure> figure = shownWith(id);
  if (!figure) throw Error(say<"the figure %1 is not on show">(id.toStdString()));
  const FigureContent content = figure->content();
  if (content.size.isEmpty())
    throw Error(
        say<"a part of the figure %1 is on its way: pause, or try again when it is there">(id.toStdString()));
  const QString caption = captionOf(*figure, content);
  if (isSvg(path)) {
    const QByteArray svg = figureSvg(content, figure->label, caption, *window_);
    writeFile(path.toStdString(), std::string_view(svg.constData(), static_cast<std::size_t>(svg.size())));
    return;
  }
  const QImage picture = figurePicture(content, caption, *window_);
  const auto bytes = static_cast<std::size_t>(4) * picture.width() * picture.height();
  writePng(path.toStdString(), picture.width(), picture.height(), {picture.constBits(), bytes});
}

void FigureExport::write(const QString& id, const QString& path) {
  try {
    writeOrThrow(id, path);
    Q_EMIT said(tr("Saved %1.").arg(path));
  } catch (const std::exception& error) {
    Q_EMIT failed(sentence(shownReason(error)));
  }
}

// The figure's own widget, or what lies in it; views keep their right button for the probe.
bool FigureExport::eventFilter(QObject* object, QEvent* event) {
  if (event->type() != QEvent::ContextMenu) return false;
  const auto* widget = qobject_cast<QWidget*>(object);
  if (!widget) return false;
  const std::vector<Figure> figures = shown();
  const auto found = std::ranges::find_if(figures, [&](const Figure& figure) {
    return figure.widget == widget || figure.widget->isAncestorOf(widget);
  });
  if (found == figures.end() || found->id.startsWith(QLatin1String("view-"))) return false;
  auto* menu = new QMenu(window_);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->addAction(tr("Export figure…"), this, [this, id = found->id] { askFor(id); });
  menu->popup(static_cast<const QContextMenuEvent*>(event)->globalPos());
  return true;
}

} // namespace taa::app
