#include "app/dialogs/KeysDialog.h"

#include "app/style/DialogSize.h"
#include "app/style/Theme.h"
#include "app/widgets/SearchField.h"

#include <QFontMetrics>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QStringList>
#include <QVBoxLayout>

#include <algorithm>
#include <memory>

namespace taa::app {

namespace {

constexpr int kMaxColumns = 3;

struct KeyGroup {
  QString name;
  std::vector<KeyLine> lines;
  /// In lines, with its name and what is free below.
  int height() const { return static_cast<int>(lines.size()) + 2; }
};
using Columns = std::vector<std::vector<KeyGroup>>;

QFont nameFont() {
  QFont font;
  font.setBold(true);
  return font;
}

/// All lines are as high, so that those of all columns end at one place.
int keyLineHeight() {
  return std::max(QFontMetrics(nameFont()).height(), QFontMetrics(secondaryFont()).height() + 2);
}

// A menu's keys stay together though its submenus lie between them.
std::vector<KeyGroup> grouped(const std::vector<KeyLine>& lines) {
  std::vector<KeyGroup> groups;
  for (const KeyLine& line : lines) {
    auto group = std::ranges::find(groups, line.group, &KeyGroup::name);
    if (group == groups.end()) group = groups.insert(groups.end(), {line.group, {}});
    group->lines.push_back(line);
  }
  return groups;
}

/// Of the widest keys, so that what they do stands in one line in all groups of a column.
int keysWidth(const std::vector<KeyGroup>& groups) {
  const QFontMetrics metrics(secondaryFont());
  int width = 0;
  for (const KeyGroup& group : groups)
    for (const KeyLine& line : group.lines) width = std::max(width, metrics.horizontalAdvance(line.keys));
  return width;
}

QWidget* groupWidget(const KeyGroup& group, int keysWidth) {
  auto* widget = new QWidget;
  auto* grid = new QGridLayout(widget);
  grid->setContentsMargins(0, 0, 0, keyLineHeight());
  grid->setHorizontalSpacing(3 * kUnit);
  grid->setVerticalSpacing(0);
  auto* title = new QLabel(group.name);
  title->setFont(nameFont());
  title->setFixedHeight(keyLineHeight());
  grid->addWidget(title, 0, 0, 1, 2);
  int row = 1;
  for (const KeyLine& line : group.lines) {
    auto* keys = new QLabel(line.keys);
    keys->setMinimumWidth(keysWidth);
    auto* text = new QLabel(line.text);
    text->setForegroundRole(QPalette::PlaceholderText);
    for (QLabel* label : {keys, text}) {
      label->setFont(secondaryFont());
      label->setFixedHeight(keyLineHeight());
    }
    grid->addWidget(keys, row, 0);
    grid->addWidget(text, row++, 1);
  }
  grid->setColumnStretch(1, 1);
  return widget;
}

/// In order, in columns of which each takes groups until its share of the lines is reached.
Columns inColumns(const std::vector<KeyGroup>& groups, int count) {
  int total = 0, used = 0;
  for (const KeyGroup& group : groups) total += group.height();
  Columns columns;
  for (const KeyGroup& group : groups) {
    const int begun = static_cast<int>(columns.size());
    if (begun == 0 || (begun < count && used >= total * begun / count)) columns.emplace_back();
    columns.back().push_back(group);
    used += group.height();
  }
  return columns;
}

QWidget* pageOf(const Columns& parts) {
  auto* page = new QWidget;
  auto* columns = new QHBoxLayout(page);
  columns->setContentsMargins(0, 0, 2 * kUnit, 0);
  columns->setSpacing(8 * kUnit);
  for (const std::vector<KeyGroup>& part : parts) {
    auto* column = new QVBoxLayout;
    column->setSpacing(0);
    for (const KeyGroup& group : part) column->addWidget(groupWidget(group, keysWidth(part)));
    column->addStretch(1);
    columns->addLayout(column);
  }
  return page;
}

/// As many columns as lie beside each other in `room` px.
Columns columnsIn(int room, const std::vector<KeyGroup>& groups) {
  for (int count = kMaxColumns; count > 1; --count) {
    const Columns columns = inColumns(groups, count);
    const std::unique_ptr<QWidget> page(pageOf(columns));
    if (page->sizeHint().width() <= room) return columns;
  }
  return inColumns(groups, 1);
}

/// px, at most `most`: so high no line is cut, and below no group's name its keys are out of sight.
int wholeHeight(const Columns& columns, int most) {
  int lines = most / keyLineHeight();
  const auto endsInName = [&](const std::vector<KeyGroup>& column) {
    int top = 0;
    for (const KeyGroup& group : column) {
      if (top == lines - 1) return true;
      top += group.height();
    }
    return false;
  };
  while (lines > 1 && std::ranges::any_of(columns, endsInName)) --lines;
  return lines * keyLineHeight();
}

} // namespace

// All of it where there is room; else it scrolls, by the keys, too.
KeysDialog::KeysDialog(const std::vector<KeyLine>& lines, QWidget* parent)
    : QDialog(parent), lines_(lines), noHits_(new NoHits), scroll_(new QScrollArea) {
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Keys"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4 * kUnit, 4 * kUnit, 4 * kUnit, 4 * kUnit);
  auto* search = new SearchField(tr("Search keys by what they do"));
  layout->addWidget(search);
  layout->addWidget(noHits_);
  scroll_->setAccessibleName(tr("Keys"));
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setWidgetResizable(true);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  const int besides = 8 * kUnit + scroll_->verticalScrollBar()->sizeHint().width();
  room_ = sizeOver(parent, {QWIDGETSIZE_MAX, 0}).width() - besides;
  const Columns columns = columnsIn(room_, grouped(lines));
  QWidget* page = pageOf(columns);
  scroll_->verticalScrollBar()->setSingleStep(keyLineHeight());
  scroll_->setWidget(page);
  scroll_->setMinimumWidth(page->sizeHint().width() + scroll_->verticalScrollBar()->sizeHint().width());
  layout->addWidget(scroll_, 1);
  auto* close = new QPushButton(tr("Close"));
  close->setDefault(true);
  connect(close, &QPushButton::clicked, this, &QDialog::close);
  connect(search, &SearchField::textChanged, this, &KeysDialog::find);
  layout->addWidget(close, 0, Qt::AlignRight);
  const int rest = layout->sizeHint().height() - scroll_->sizeHint().height();
  const int least = std::max(60 * kUnit - rest, keyLineHeight());
  const int room = parent ? parent->height() - 8 * kUnit - rest : page->sizeHint().height();
  const int high = std::min(page->sizeHint().height(), wholeHeight(columns, std::max(room, least)));
  resize(sizeHint().width(), high + rest);
  scroll_->setFocus();
}

void KeysDialog::find(const QString& text) {
  const Search search(text.toStdString());
  std::vector<KeyLine> found;
  for (const KeyLine& line : lines_)
    if (search.find({.label = line.text.toStdString(),
                     .id = line.keys.toStdString(),
                     .group = line.group.toStdString()}))
      found.push_back(line);
  scroll_->setWidget(pageOf(columnsIn(room_, grouped(found))));
  noHits_->tell(text.trimmed(), !found.empty());
}

} // namespace taa::app
