// A column of what is said, a table, and what is said of its row. Where there is too little room they give
// way one after another, none of them cut to a part of a line.
#pragma once

#include "app/widgets/areas/FittingArea.h"

#include <QVBoxLayout>

#include <algorithm>

namespace taa::app {

/// px.
struct ColumnHeights {
  int said = 0, table = 0, remark = 0;
  bool operator==(const ColumnHeights&) const = default;
};

/// Shares out `room`: first the least of each, then to the table up to `enough`, to what is said up to what
/// it wants, to the table again as much, to the remark up to what it wants, and the rest to the table.
/// `wholePart` says at which height at most so high no part of what is said is cut.
template <class WholePart>
ColumnHeights sharedHeights(int room, const ColumnHeights& least, const ColumnHeights& wanted, int enough,
                            WholePart wholePart) {
  ColumnHeights heights = least;
  int rest = std::max(0, room - least.said - least.table - least.remark);
  const auto raise = [&rest](int& height, int to) {
    const int by = std::clamp(to - height, 0, rest);
    height += by;
    rest -= by;
  };
  raise(heights.table, enough);
  raise(heights.said, wanted.said);
  if (heights.said < wanted.said) {
    const int whole = wholePart(heights.said); // less than the least rather than a part of a line
    rest += heights.said - whole;
    heights.said = whole;
  }
  raise(heights.table, 2 * enough);
  raise(heights.remark, wanted.remark);
  heights.table += rest;
  return heights;
}

class YieldingColumn : public QVBoxLayout {
 public:
  /// `enough`: px of the table before the others give way.
  YieldingColumn(FittingArea* said, QWidget* table, QWidget* between, QWidget* remark, int enough)
      : said_(said), enough_(enough / textScale()) {
    setSpacing(0);
    for (QWidget* part : {static_cast<QWidget*>(said), table, between, remark}) addWidget(part);
  }

  void setGeometry(const QRect& rect) override {
    QLayout::setGeometry(rect);
    const QRect inside = contentsRect();
    const int between = itemAt(2)->sizeHint().height();
    const auto of = [this](auto size) { return ColumnHeights{size(0), size(1), size(3)}; };
    const ColumnHeights least = of([this](int part) { return itemAt(part)->minimumSize().height(); });
    const ColumnHeights wanted = of([this](int part) { return itemAt(part)->sizeHint().height(); });
    const ColumnHeights heights =
        sharedHeights(inside.height() - between, least, wanted, static_cast<int>(scaled(enough_)),
                      [this](int most) { return said_->wholeHeight(most); });
    int top = inside.top();
    const int high[] = {heights.said, heights.table, between, heights.remark};
    for (int part = 0; part < count(); ++part) {
      itemAt(part)->setGeometry({inside.left(), top, inside.width(), high[part]});
      top += high[part];
    }
  }

 private:
  FittingArea* said_;
  double enough_; ///< of texts of 100 %
};

} // namespace taa::app
