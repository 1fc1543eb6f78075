#include "app/views/plots/SensitivityPage.h"

#include "app/style/Numbers.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "app/widgets/Note.h"
#include "app/widgets/ValueTable.h"
#include "core/settings/Parameters.h"

#include <QLabel>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace taa::app {

namespace {

enum SensitivityColumn { WhatColumn, LumaColumn };
constexpr int kBarOpacity = 90; ///< of 255: the number stands upon it

/// Luma with a bar behind it, as long as its share of the group's largest.
class LumaBars : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void setShares(std::vector<double> shares) { shares_ = std::move(shares); }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const auto row = static_cast<std::size_t>(index.row());
    if (row < shares_.size() && shares_[row] > 0.0) {
      QColor color = themeColors(option.widget).accent;
      color.setAlpha(kBarOpacity);
      const int width = static_cast<int>(std::lround(shares_[row] * option.rect.width()));
      painter->fillRect(
          QRect(option.rect.right() + 1 - width, option.rect.top() + 1, width, option.rect.height() - 2),
          color);
    }
    QStyledItemDelegate::paint(painter, option, index);
  }

 private:
  std::vector<double> shares_; ///< 0 to 1, by row
};

QString tipOf(const Sensitivity& each) {
  QStringList lines;
  if (each.to == SensitivityTo::Parameter) {
    const Parameter& row = parameter(each.path);
    lines << qtext(each.path) << qtext(row.tooltip);
  } else {
    lines << SensitivityPage::tr("Texel (%1, %2), brightened by 1 in all channels")
                 .arg(each.texel.x)
                 .arg(each.texel.y);
  }
  lines << SensitivityPage::tr("By it: red %1, green %2, blue %3")
               .arg(shortText(each.slope.x), shortText(each.slope.y), shortText(each.slope.z));
  if (each.isOneSided)
    lines << SensitivityPage::tr("To the other side the slope is another, or may be: two things that are "
                                 "compared are the same here.");
  return lines.join(QLatin1Char('\n'));
}

ValueTable::Row lineOf(const Sensitivity& each) {
  QStringList cells{qtext(sensitivityText(each)), shortText(each.lumaChange(), 3)};
  const glm::dvec3 change = each.change();
  for (int channel = 0; channel < 3; ++channel) cells << shortText(change[channel], 2);
  if (each.isOneSided) cells[WhatColumn] += QStringLiteral(" *");
  return {cells, {}, false, tipOf(each)};
}

} // namespace

SensitivityPage::SensitivityPage(QWidget* parent)
    : QWidget(parent), table_(new ValueTable({tr("What moves"), tr("Luma"), tr("R"), tr("G"), tr("B")})) {
  table_->setAccessibleName(tr("How much the pixel moves with what it is made of"));
  table_->setFocusPolicy(Qt::StrongFocus);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setItemDelegateForColumn(LumaColumn, new LumaBars(table_));
  auto* note = new QLabel(tr(
      "Exact slopes of the resolved pixel in this frame, on the history it had, times the step: true where "
      "the step is small. Samples, texels of history and numbers that are not here have none. * has "
      "another to the other side, or may have. Enter on a number shows where over the picture it matters."));
  setSecondary(*note);
  note->setWordWrap(true);
  note->setContentsMargins(2 * kUnit, kUnit, 2 * kUnit, kUnit);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(table_, 1);
  column->addWidget(note);
  connect(table_, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* item) {
    if (const QString path = pathAt(table_->indexOfTopLevelItem(item)); !path.isEmpty())
      Q_EMIT mapRequested(path);
  });
}

QString SensitivityPage::pathAt(int line) const {
  return line >= 0 && line < static_cast<int>(paths_.size()) ? qtext(paths_[static_cast<std::size_t>(line)])
                                                             : QString();
}

void SensitivityPage::setResult(const std::optional<ProbeResult>& result) {
  static const std::vector<Sensitivity> kNone;
  const std::vector<Sensitivity>& all = result ? result->sensitivities : kNone;
  std::vector<ValueTable::Row> rows;
  std::vector<double> shares;
  paths_.clear();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool isFirst = i == 0 || all[i - 1].to != all[i].to;
    if (isFirst) {
      rows.push_back({{qtext(sensitivityLabel(all[i].to))}, {}, true});
      shares.push_back(0.0);
      paths_.emplace_back();
    }
    paths_.push_back(all[i].path);
    const auto largest = std::ranges::find(all, all[i].to, &Sensitivity::to); // sorted
    rows.push_back(lineOf(all[i]));
    shares.push_back(largest->lumaChange() == 0.0 ? 0.0
                                                  : std::fabs(all[i].lumaChange() / largest->lumaChange()));
  }
  static_cast<LumaBars*>(table_->itemDelegateForColumn(LumaColumn))->setShares(std::move(shares));
  table_->setRows(rows);
}

QString SensitivityPage::text() const {
  return table_->text();
}

} // namespace taa::app
