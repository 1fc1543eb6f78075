// Texts and small pictures in lines that wrap where the strip is narrow: nothing of them is left out.
#pragma once

#include "app/style/Theme.h"

#include <QColor>
#include <QFont>
#include <QRect>
#include <QSize>
#include <QString>

#include <functional>
#include <vector>

class QPainter;

namespace taa::app {

/// Of a line.
inline int legendHeight() {
  return scaled(22);
}

class LegendFlow {
 public:
  using PaintIcon = std::function<void(QPainter&, const QRect&)>;

  /// What comes next begins a line.
  void startLine();
  void text(const QString& text, const QFont& font, const QColor& color);
  void icon(QSize size, PaintIcon paint);
  /// What comes next stays beside what was there last.
  void glue() { glues_ = true; }

  bool isEmpty() const { return items_.empty(); }
  /// How many lines it takes in a strip of this width (logical px).
  int lines(int width) const;
  /// Where the last item lies below the upper left corner.
  QRect lastPlace(int width) const;
  /// Paints them downwards from a corner, each on its ground.
  void paint(QPainter& painter, QPoint corner, int width, const ThemeColors& colors) const;
  /// All texts, for what cannot see.
  QString plainText() const;

 private:
  struct Item {
    QString text;
    QFont font;
    QColor color;
    QSize size;
    PaintIcon paint; ///< of an icon
    bool startsLine = false, isGlued = false;
  };
  struct Place {
    int line = 0, left = 0, width = 0;
  };
  void add(Item item);
  std::vector<Place> places(int width) const;

  std::vector<Item> items_;
  bool startsLine_ = true, glues_ = false;
};

} // namespace taa::app
