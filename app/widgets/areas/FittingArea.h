// A part of a panel that is as high as what it shows where there is room, else it scrolls.
#pragma once

#include "app/style/Theme.h"

#include <QEvent>
#include <QLayout>
#include <QResizeEvent>
#include <QScrollArea>

#include <algorithm>
#include <cmath>

namespace taa::app {

class FittingArea : public QScrollArea {
 public:
  /// `minPx`: how low it becomes before others have to give way. `alwaysPx`: how high it is where there is
  /// room, whatever it shows; 0: as high as that. Both are of texts as large as they are now, and grow with
  /// them.
  explicit FittingArea(int minPx, int alwaysPx = 0, QWidget* parent = nullptr)
      : QScrollArea(parent), minPx_(minPx / textScale()), alwaysPx_(alwaysPx / textScale()) {
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::NoFocus); // the way of the Tab key scrolls it
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Maximum);
    viewport()->setAutoFillBackground(false);
  }

  QSize sizeHint() const override {
    const int wide = viewport()->width();
    if (alwaysPx_ > 0.0) return {wide, rounded(alwaysPx_)};
    const QWidget* shown = widget();
    const int high = shown->hasHeightForWidth() ? shown->heightForWidth(wide) : shown->sizeHint().height();
    return {wide, std::max(high, shown->minimumHeight())};
  }
  QSize minimumSizeHint() const override { return {120, std::min(sizeHint().height(), rounded(minPx_))}; }
  /// px, at most `most`: so high it cuts none of the parts of the column that it shows. `most` where that
  /// would leave none.
  int wholeHeight(int most) const {
    const QLayout* column = widget()->layout();
    int whole = 0, bottom = 0;
    for (int part = 0; part < column->count() && bottom <= most; ++part) {
      const QLayoutItem* item = column->itemAt(part);
      if (item->isEmpty()) continue;
      whole = bottom;
      bottom +=
          item->hasHeightForWidth() ? item->heightForWidth(viewport()->width()) : item->sizeHint().height();
    }
    if (bottom <= most) whole = bottom;
    return whole > 0 ? whole : most;
  }

 protected:
  void resizeEvent(QResizeEvent* event) override {
    QScrollArea::resizeEvent(event);
    if (event->oldSize().width() != event->size().width()) updateGeometry();
  }
  // What it shows has become higher or lower.
  bool viewportEvent(QEvent* event) override {
    if (event->type() == QEvent::LayoutRequest) updateGeometry();
    return QScrollArea::viewportEvent(event);
  }

 private:
  static int rounded(double length) { return static_cast<int>(std::lround(scaled(length))); }

  double minPx_, alwaysPx_; ///< of texts of 100 %
};

/// As high as there is room, whatever it shows: what needs more scrolls. Takes `content`.
inline QScrollArea* scrolled(QWidget* content) {
  auto* area = new QScrollArea;
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setFocusPolicy(Qt::NoFocus);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setWidget(content);
  area->viewport()->setAutoFillBackground(false);
  content->setAutoFillBackground(false);
  return area;
}

/// As wide as there is room, at least `minPx`: where its content needs more it scrolls. Takes `content`.
inline QScrollArea* scrolledSideways(QWidget* content, int minPx) {
  QScrollArea* area = scrolled(content);
  area->setAccessibleName(content->accessibleName());
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
  area->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setMinimumWidth(minPx);
  return area;
}

} // namespace taa::app
