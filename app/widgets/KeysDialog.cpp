#include "app/widgets/KeysDialog.h"

#include "app/Theme.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace taa::app {

namespace {

constexpr int kColumns = 3;

struct Group {
  QString name;
  std::vector<KeyLine> lines;
  int height() const { return static_cast<int>(lines.size()) + 2; }
};

std::vector<Group> grouped(const std::vector<KeyLine>& lines) {
  std::vector<Group> groups;
  for (const KeyLine& line : lines) {
    if (groups.empty() || groups.back().name != line.group) groups.push_back({line.group, {}});
    groups.back().lines.push_back(line);
  }
  return groups;
}

QWidget* groupWidget(const Group& group) {
  auto* widget = new QWidget;
  auto* grid = new QGridLayout(widget);
  grid->setContentsMargins(0, 0, 0, 3 * kUnit);
  grid->setHorizontalSpacing(3 * kUnit);
  grid->setVerticalSpacing(2);
  auto* title = new QLabel(group.name);
  QFont bold = title->font();
  bold.setBold(true);
  title->setFont(bold);
  grid->addWidget(title, 0, 0, 1, 2);
  int row = 1;
  for (const KeyLine& line : group.lines) {
    auto* keys = new QLabel(line.keys);
    keys->setFont(secondaryFont());
    auto* text = new QLabel(line.text);
    text->setFont(secondaryFont());
    text->setForegroundRole(QPalette::PlaceholderText);
    grid->addWidget(keys, row, 0);
    grid->addWidget(text, row++, 1);
  }
  grid->setColumnStretch(1, 1);
  return widget;
}

} // namespace

KeysDialog::KeysDialog(const std::vector<KeyLine>& lines, QWidget* parent) : QDialog(parent) {
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Keys"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4 * kUnit, 4 * kUnit, 4 * kUnit, 4 * kUnit);
  auto* columns = new QHBoxLayout;
  columns->setSpacing(8 * kUnit);
  const std::vector<Group> groups = grouped(lines);
  int total = 0, used = 0, column = 0;
  for (const Group& group : groups) total += group.height();
  QVBoxLayout* current = nullptr;
  for (const Group& group : groups) {
    // A column takes groups until its share of the lines is reached.
    if (!current || (column < kColumns && used >= total * column / kColumns)) {
      current = new QVBoxLayout;
      current->setSpacing(0);
      columns->addLayout(current);
      ++column;
    }
    current->addWidget(groupWidget(group));
    used += group.height();
  }
  for (int i = 0; i < columns->count(); ++i)
    static_cast<QVBoxLayout*>(columns->itemAt(i)->layout())->addStretch(1);
  layout->addLayout(columns);
  auto* close = new QPushButton(tr("Close"));
  close->setDefault(true);
  connect(close, &QPushButton::clicked, this, &QDialog::close);
  layout->addWidget(close, 0, Qt::AlignRight);
}

} // namespace taa::app
