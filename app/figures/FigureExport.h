// Figures leave the window: which one and where to is asked for, and it is written as PNG or SVG.
#pragma once

#include "app/figures/Figure.h"

#include <QObject>

#include <functional>
#include <optional>
#include <vector>

class QPoint;

namespace taa::app {

class FigureExport : public QObject {
  Q_OBJECT
 public:
  /// What there is to be written, shown or not, and what captions begin with: frame and settings.
  struct Source {
    std::function<std::vector<Figure>()> figures;
    std::function<QString()> caption;
  };
  FigureExport(Source source, QWidget* window);

  /// Those that are on show.
  std::vector<Figure> shown() const;
  /// A list of those that are on show, at the mouse or in the middle of the window.
  void choose();
  /// Asks where to; nothing where the figure is not on show.
  void askFor(const QString& id);
  /// As the ending says, .svg or else .png.
  void write(const QString& id, const QString& path);
  /// The same; throws Error.
  void writeOrThrow(const QString& id, const QString& path) const;
  /// "Jitter pattern. builtin:fan, frame 40 …"
  QString captionOf(const Figure& figure, const FigureContent& content) const;

 Q_SIGNALS:
  void said(const QString& sentence);
  void failed(const QString& sentence);

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  std::optional<Figure> shownWith(const QString& id) const;

  Source source_;
  QWidget* window_;
};

} // namespace taa::app
