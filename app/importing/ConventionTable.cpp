#include "app/importing/ConventionTable.h"

#include "app/importing/Answers.h"
#include "app/importing/ConventionRow.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"

#include <QLabel>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>

namespace taa::app {

namespace {

/// "motion" of "motion.unit"; a path without a point is a group of its own.
std::string_view prefixOf(std::string_view path) {
  return path.substr(0, path.find('.'));
}

QString titleOf(std::string_view prefix) {
  if (prefix == "motion") return ConventionTable::tr("Motion");
  if (prefix == "jitter") return ConventionTable::tr("Jitter");
  if (prefix == "depth") return ConventionTable::tr("Depth");
  if (prefix == "matrices") return ConventionTable::tr("Matrices");
  if (prefix == "color") return ConventionTable::tr("Color");
  return ConventionTable::tr("All planes");
}

} // namespace

ConventionTable::ConventionTable(QWidget* parent) : QScrollArea(parent) {
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFocusPolicy(Qt::NoFocus); // its rows have the keys
  setAccessibleName(tr("Conventions"));
  auto* content = new QWidget;
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(0, 0, 2 * kUnit, 0);
  layout->setSpacing(2);
  std::string_view last;
  for (const capture::Convention& row : capture::conventions())
    if (const std::string_view prefix = prefixOf(row.path); prefix != last) {
      addGroup(layout, prefix);
      last = prefix;
    }
  // Every name is whole, and the fields stand in one line.
  const auto widest = std::ranges::max(rows_, {}, &ConventionRow::labelHint);
  for (ConventionRow* row : rows_) row->setLabelWidth(widest->labelHint());
  layout->addStretch(1);
  setWidget(content);
  // Nothing scrolls sideways: what a row says last is seen at any size of the letters.
  setMinimumWidth(content->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width());
}

void ConventionTable::addGroup(QVBoxLayout* to, std::string_view prefix) {
  auto* title = new QLabel(titleOf(prefix));
  QFont bold = title->font();
  bold.setBold(true);
  title->setFont(bold);
  title->setContentsMargins(0, 2 * kUnit, 0, 0);
  to->addWidget(title);
  for (const capture::Convention& convention : capture::conventions()) {
    if (prefixOf(convention.path) != prefix) continue;
    auto* made = new ConventionRow(convention);
    connect(made, &ConventionRow::edited, this, &ConventionTable::edited);
    connect(made, &ConventionRow::entered, this, &ConventionTable::entered);
    to->addWidget(made);
    rows_.push_back(made);
  }
}

void ConventionTable::display(const capture::Conventions& stated, const capture::Conventions& guessed) {
  stated_ = stated;
  for (ConventionRow* row : rows_) row->display(stated, guessed);
  showVerdicts();
}

void ConventionTable::setFindings(const std::vector<capture::Finding>& findings) {
  findings_ = findings;
  showVerdicts();
}

std::optional<std::pair<QString, QString>> ConventionTable::takeTyped() {
  for (ConventionRow* row : rows_)
    if (std::optional<QString> typed = row->takeTyped()) return std::pair(row->path(), std::move(*typed));
  return {};
}

void ConventionTable::dropTyped() {
  for (ConventionRow* row : rows_) row->takeTyped();
}

void ConventionTable::showVerdicts() {
  for (ConventionRow* row : rows_) {
    const capture::Finding* finding = findingOf(findings_, row->row().path, stated_);
    row->setVerdict(verdictOn(finding, stated_),
                    finding ? QString::fromStdString(finding->reason) : QString());
  }
}

ConventionRow* ConventionTable::row(std::string_view path) const {
  const auto found =
      std::ranges::find_if(rows_, [&](const ConventionRow* row) { return row->row().path == path; });
  return *found;
}

} // namespace taa::app
