// A part of a panel that is as high as what it shows where there is room, else it scrolls.
#pragma once

#include "app/style/Theme.h"

#include <QAbstractButton>
#include <QEvent>
#include <QLabel>
#include <QResizeEvent>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace taa::app {

/// px, of a widget or an item of a layout that is `wide` px wide.
template <class Part>
int heightAt(const Part& part, int wide) {
  return part.hasHeightForWidth() ? part.heightForWidth(wide) : part.sizeHint().height();
}

/// Bottoms of the parts of a column that begins at `top`, in order, px: a column in it has those of its own
/// parts, too, and a text those of its lines. A button is one part, whatever stands on it.
inline void addBottoms(const QLayout& column, int wide, int top, std::vector<int>& bottoms) {
  const QMargins margins = column.contentsMargins();
  wide -= margins.left() + margins.right();
  top += margins.top();
  for (int place = 0; place < column.count(); ++place) {
    QLayoutItem* item = column.itemAt(place);
    if (item->isEmpty()) continue;
    QWidget* part = item->widget();
    if (part && !qobject_cast<QAbstractButton*>(part))
      if (const auto* inside = qobject_cast<QVBoxLayout*>(part->layout()))
        addBottoms(*inside, wide, top, bottoms);
    const int bottom = top + heightAt(*item, wide);
    if (const auto* text = qobject_cast<QLabel*>(part)) {
      const QMargins around = text->contentsMargins();
      const int high = bottom - top - around.top() - around.bottom();
      const int lines = high / std::max(1, text->fontMetrics().lineSpacing());
      for (int line = 1; line < lines; ++line) bottoms.push_back(top + around.top() + high * line / lines);
    }
    bottoms.push_back(bottom);
    top = bottom + column.spacing();
  }
}

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

  /// As wide as there is room: where a part has less than its least, the others are not cut at the side, too.
  void setWidget(QWidget* shown) {
    QSizePolicy policy = shown->sizePolicy();
    policy.setHorizontalPolicy(QSizePolicy::Ignored);
    shown->setSizePolicy(policy);
    QScrollArea::setWidget(shown);
  }

  QSize sizeHint() const override {
    const int wide = viewport()->width();
    if (alwaysPx_ > 0.0) return {wide, rounded(alwaysPx_)};
    return {wide, std::max(heightAt(*widget(), wide), widget()->minimumHeight())};
  }
  QSize minimumSizeHint() const override { return {120, std::min(sizeHint().height(), rounded(minPx_))}; }
  /// px, at most `most`: so high it cuts none of the parts of the column that it shows. `most` where that
  /// would leave none.
  int wholeHeight(int most) const {
    std::vector<int> bottoms;
    addBottoms(*widget()->layout(), viewport()->width(), 0, bottoms);
    const auto cut = std::ranges::upper_bound(bottoms, most);
    return cut == bottoms.begin() ? most : *std::prev(cut);
  }
  /// Another height where there is room, as the constructor takes it.
  void setAlways(int alwaysPx) {
    alwaysPx_ = alwaysPx / textScale();
    updateGeometry();
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
