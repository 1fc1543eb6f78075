// A figure: what a part of the window shows, cropped to it, with a caption below, as a picture or as drawing.
#pragma once

#include <QByteArray>
#include <QImage>
#include <QList>
#include <QSize>
#include <QString>

#include <functional>

class QPainter;
class QWidget;

namespace taa::app {

/// What is drawn now.
struct FigureContent {
  QSize size; ///< logical px
  std::function<void(QPainter&)> paint;
  QString details;         ///< of the caption, beside frame and settings; empty: nothing
  double pixelRatio = 2.0; ///< of a picture: lines and texts are made anew, pixels of a view are not
};

/// One that the window can show.
struct Figure {
  QString id;      ///< in names of files: "jitter"
  QString label;   ///< in lists
  QWidget* widget; ///< which shows it; its context menu offers it
  std::function<FigureContent()> content;
};

/// What of a widget differs from its ground, with a little margin, logical px; all of it where nothing does.
QRect shownPart(QWidget& widget);
/// What widgets show, beside or below one another, each cropped.
FigureContent widgetsContent(const QList<QWidget*>& widgets, Qt::Orientation orientation,
                             const QString& details);

/// The figure with its caption, as pixels: 4 bytes each, RGBA.
QImage figurePicture(const FigureContent& content, const QString& caption, const QWidget& styled);
/// The same as SVG: texts and lines stay what they are.
QByteArray figureSvg(const FigureContent& content, const QString& title, const QString& caption,
                     const QWidget& styled);

} // namespace taa::app
