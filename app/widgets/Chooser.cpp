#include "app/widgets/Chooser.h"

#include "app/style/Icons.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "app/widgets/SearchField.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QScreen>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace taa::app {

namespace {

constexpr int kEntryRole = Qt::UserRole; ///< number of the entry; none: a heading
constexpr int kDetailRole = Qt::UserRole + 1;

class EntryDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const ThemeColors& colors = themeColors(option.palette);
    const bool isHeading = !index.data(kEntryRole).isValid();
    const bool isCurrent = option.state.testFlag(QStyle::State_Selected);
    if (isCurrent) painter->fillRect(option.rect, colors.accent);
    const QRect inside = option.rect.adjusted((isHeading ? 2 : 4) * kUnit, 0, -2 * kUnit, 0);
    const QString detail = index.data(kDetailRole).toString();
    painter->setFont(secondaryFont());
    painter->setPen(isCurrent ? colors.onAccent : colors.secondary);
    painter->drawText(inside, Qt::AlignVCenter | Qt::AlignRight, detail);
    const int used = QFontMetrics(secondaryFont()).horizontalAdvance(detail) + 2 * kUnit;
    const bool isEnabled = option.state.testFlag(QStyle::State_Enabled);
    painter->setFont(isHeading ? secondaryFont() : option.font);
    painter->setPen(isCurrent ? colors.onAccent : isHeading || !isEnabled ? colors.secondary : colors.text);
    const QString text =
        painter->fontMetrics().elidedText(index.data().toString(), Qt::ElideRight, inside.width() - used);
    painter->drawText(inside, Qt::AlignVCenter | Qt::AlignLeft, text);
  }

  QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override {
    return {200, rowHeight()};
  }
};

/// Groups in the order of their first entries, and in a group the order that its entries have.
std::vector<std::size_t> orderByGroups(const std::vector<ChooserEntry>& entries) {
  std::map<QString, std::size_t> first;
  std::vector<std::size_t> order(entries.size());
  std::iota(order.begin(), order.end(), 0u);
  for (const std::size_t index : order) first.try_emplace(entries[index].group, index);
  std::ranges::stable_sort(order, {}, [&](std::size_t index) { return first.at(entries[index].group); });
  return order;
}

struct FoundEntry {
  std::size_t index;
  SearchHit hit;
};

/// Groups by their strongest hits, and in a group the strongest hits first.
void sortByHits(std::vector<FoundEntry>& found, const std::vector<ChooserEntry>& entries) {
  std::ranges::stable_sort(found, {}, [](const FoundEntry& of) { return of.hit.by; });
  std::map<QString, std::size_t> place; // of a group: that of its first
  for (const FoundEntry& of : found) place.try_emplace(entries[of.index].group, place.size());
  std::ranges::stable_sort(found, {},
                           [&](const FoundEntry& of) { return place.at(entries[of.index].group); });
}

/// What is at the right of an entry: also why it was found, where its text does not say it.
QString detailOf(const ChooserEntry& entry, const SearchHit& hit) {
  const QString why = foundText(hit);
  if (why.isEmpty() || (hit.by == FoundBy::Choice && entry.text.contains(QString::fromStdString(hit.why))))
    return entry.detail;
  return entry.detail.isEmpty() ? why : Chooser::tr("%1 · %2").arg(why, entry.detail);
}

} // namespace

ChooserEntry intermediateEntry(const Intermediate& row) {
  return {qtext(row.label), qtext(row.unit), qtext(stageInfo(row.stage).label), searchedRow(row)};
}

Chooser::Chooser(const QString& placeholder, std::vector<ChooserEntry> entries,
                 std::function<void(int)> choose, QWidget* parent)
    : QFrame(parent, Qt::Popup), entries_(std::move(entries)), choose_(std::move(choose)),
      field_(new QLineEdit), list_(new QListWidget) {
  for (ChooserEntry& entry : entries_) {
    entry.searched.label = entry.text.toStdString();
    entry.searched.group = entry.group.toStdString();
  }
  order_ = orderByGroups(entries_);
  setAttribute(Qt::WA_DeleteOnClose);
  setObjectName(QStringLiteral("popup"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kUnit, kUnit, kUnit, kUnit);
  layout->setSpacing(kUnit);
  field_->setPlaceholderText(placeholder);
  field_->setAccessibleName(placeholder);
  field_->addAction(themedIcon(QStringLiteral("search")), QLineEdit::LeadingPosition);
  field_->installEventFilter(this);
  list_->setItemDelegate(new EntryDelegate(list_));
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setFocusPolicy(Qt::NoFocus);
  layout->addWidget(field_);
  layout->addWidget(list_, 1);
  setFocusProxy(field_);
  connect(field_, &QLineEdit::textChanged, this, &Chooser::search);
  connect(list_, &QListWidget::itemClicked, this, &Chooser::accept);
}

void Chooser::open(const QRect& anchor, int current) {
  fill({}, current);
  QWidget* window = parentWidget()->window();
  const QPoint corner = parentWidget()->mapTo(window, anchor.bottomLeft() + QPoint(0, 1));
  // As high as its rows; in the window, so that a picture of that has all of it. One of a panel that is torn
  // off has the whole screen.
  QPoint place = window->mapToGlobal(corner);
  const bool isTornOff = window->windowType() == Qt::Tool;
  const QRect room = isTornOff ? window->screen()->availableGeometry()
                               : QRect(window->mapToGlobal(QPoint()), window->size());
  const int width = std::min(scaled(anchor.width()), room.width() - 2 * kUnit); // anchors know no large texts
  place.setX(std::min(place.x(), room.right() - width - kUnit));
  const int height =
      std::min(list_->count() * rowHeight() + 12 * kUnit, room.bottom() - place.y() - 2 * kUnit);
  setGeometry(QRect(place, QSize(width, height)));
  show();
  field_->setFocus();
}

void Chooser::search(const QString& text) {
  fill(text.trimmed(), -1);
}

void Chooser::fill(const QString& wanted, int current) {
  list_->clear();
  QString group;
  QListWidgetItem* chosen = nullptr;
  const Search search(wanted.toStdString());
  std::vector<FoundEntry> found;
  for (const std::size_t index : order_)
    if (const auto hit = search.find(entries_[index].searched)) found.push_back({index, *hit});
  if (!search.isEmpty()) sortByHits(found, entries_);
  for (const FoundEntry& of : found) {
    const ChooserEntry& entry = entries_[of.index];
    if (entry.group != group) {
      group = entry.group;
      (new QListWidgetItem(group, list_))->setFlags(Qt::NoItemFlags);
    }
    auto* item = new QListWidgetItem(entry.text, list_);
    item->setData(kEntryRole, static_cast<int>(of.index));
    item->setData(kDetailRole, detailOf(entry, of.hit));
    if (!entry.enabled) item->setFlags(Qt::NoItemFlags);
    if (entry.enabled && (!chosen || static_cast<int>(of.index) == current)) chosen = item;
  }
  if (list_->count() == 0) {
    list_->addItem(tr("Nothing here has “%1”.").arg(wanted));
    list_->addItem(tr("Fewer letters or another word may find it; Esc closes."));
    for (int line = 0; line < list_->count(); ++line) list_->item(line)->setFlags(Qt::NoItemFlags);
  }
  list_->setCurrentItem(chosen);
  if (chosen) list_->scrollToItem(chosen, QAbstractItemView::PositionAtCenter);
}

void Chooser::accept() {
  const QListWidgetItem* item = list_->currentItem();
  if (!item || !item->data(kEntryRole).isValid()) return;
  const int index = item->data(kEntryRole).toInt();
  // Once this popup is gone: another one, which the choice may open, would be closed with it.
  connect(
      this, &QObject::destroyed, parentWidget()->window(), [choose = choose_, index] { choose(index); },
      Qt::QueuedConnection);
  close();
}

void Chooser::moveCurrent(int rows) {
  int row = list_->currentRow();
  const int direction = rows < 0 ? -1 : 1;
  for (int left = std::abs(rows); left > 0; --left) {
    int next = row + direction;
    while (next >= 0 && next < list_->count() && !list_->item(next)->flags().testFlag(Qt::ItemIsSelectable))
      next += direction;
    if (next < 0 || next >= list_->count()) break;
    row = next;
  }
  list_->setCurrentRow(row);
}

bool Chooser::eventFilter(QObject*, QEvent* event) {
  if (event->type() != QEvent::KeyPress) return false;
  switch (static_cast<QKeyEvent*>(event)->key()) {
  case Qt::Key_Up:
    moveCurrent(-1);
    return true;
  case Qt::Key_Down:
    moveCurrent(1);
    return true;
  case Qt::Key_PageUp:
    moveCurrent(-10);
    return true;
  case Qt::Key_PageDown:
    moveCurrent(10);
    return true;
  case Qt::Key_Return:
  case Qt::Key_Enter:
    accept();
    return true;
  case Qt::Key_Escape:
    close();
    return true;
  default:
    return false;
  }
}

} // namespace taa::app
