#include "app/importing/ResidualTable.h"

#include "app/importing/Answers.h"
#include "app/style/Numbers.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QFontMetrics>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cstddef>

namespace taa::app {

namespace {
enum ResidualColumn { AnswerColumn, Residual, Now };
constexpr int kMostWidth = 320; ///< px, of what it asks to have room for

/// px, with which nothing in it is cut.
int neededWidth(const QTreeWidget& table) {
  int sum = table.verticalScrollBar()->sizeHint().width() + kUnit;
  for (int column = 0; column < table.columnCount(); ++column) {
    int widest = table.fontMetrics().horizontalAdvance(table.headerItem()->text(column));
    for (int line = 0; line < table.topLevelItemCount(); ++line) {
      const QTreeWidgetItem* item = table.topLevelItem(line);
      widest = std::max(widest, QFontMetrics(item->font(column)).horizontalAdvance(item->text(column)));
    }
    sum += widest + 3 * kUnit;
  }
  return sum;
}

} // namespace

ResidualTable::ResidualTable(QWidget* parent)
    : QWidget(parent), questions_(new QComboBox), table_(new QTreeWidget), reason_(new QLabel),
      apply_(new QPushButton(tr("&Use this"))) {
  questions_->setObjectName(QStringLiteral("questions"));
  questions_->setAccessibleName(tr("Question"));
  questions_->view()->setAccessibleName(questions_->accessibleName());
  questions_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  questions_->setMinimumContentsLength(12);
  table_->setObjectName(QStringLiteral("residuals"));
  table_->setAccessibleName(tr("Hypotheses by residual"));
  table_->setRootIsDecorated(false);
  table_->setHeaderLabels({tr("Hypothesis"), tr("Residual"), QString()});
  table_->headerItem()->setToolTip(
      Residual, tr("Mean difference in luma of a frame and the warped frame before it, × 1000, unless the "
                   "question says otherwise. The smallest fits best."));
  table_->header()->setStretchLastSection(false);
  table_->header()->setMinimumSectionSize(5 * kUnit); // of a mark
  table_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->header()->setSectionResizeMode(AnswerColumn, QHeaderView::Stretch);
  reason_->setWordWrap(true);
  reason_->setFont(secondaryFont());
  apply_->setObjectName(QStringLiteral("applyHypothesis"));
  apply_->setAutoDefault(false);
  apply_->setToolTip(
      tr("Set the conventions as the selected hypothesis says (Enter in the table, or Alt+U)"));
  apply_->setAccessibleDescription(apply_->toolTip());
  auto* below = new QHBoxLayout;
  below->setContentsMargins(kUnit, 0, 0, 0); // the words stand in line with those of the table
  below->addWidget(reason_, 1);
  below->addWidget(apply_, 0, Qt::AlignTop);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kUnit);
  layout->addWidget(questions_);
  layout->addWidget(table_, 1);
  layout->addLayout(below);
  connect(questions_, &QComboBox::currentIndexChanged, this, &ResidualTable::refresh);
  connect(table_, &QTreeWidget::itemActivated, this, &ResidualTable::apply);
  connect(table_, &QTreeWidget::currentItemChanged, this,
          [this] { apply_->setEnabled(selected() != nullptr); });
  connect(apply_, &QPushButton::clicked, this, &ResidualTable::apply);
  refresh();
}

const capture::Finding* ResidualTable::shown() const {
  const int index = questions_->currentIndex();
  return index >= 0 && index < static_cast<int>(findings_.size())
             ? &findings_[static_cast<std::size_t>(index)]
             : nullptr;
}

const capture::Hypothesis* ResidualTable::selected() const {
  const capture::Finding* finding = shown();
  const int line = table_->indexOfTopLevelItem(table_->currentItem());
  if (!finding || line < 0 || line >= static_cast<int>(finding->hypotheses.size())) return nullptr;
  const capture::Hypothesis& hypothesis = finding->hypotheses[static_cast<std::size_t>(line)];
  return hypothesis.isStatable ? &hypothesis : nullptr;
}

void ResidualTable::setFindings(const std::vector<capture::Finding>& findings) {
  const QString before = questions_->currentText();
  findings_ = findings;
  {
    const QSignalBlocker quiet(questions_);
    questions_->clear();
    for (const capture::Finding& finding : findings_)
      questions_->addItem(QString::fromStdString(finding.question));
    questions_->setCurrentIndex(std::max(0, questions_->findText(before)));
  }
  refresh();
}

void ResidualTable::setConventions(const capture::Conventions& stated) {
  stated_ = stated;
  refresh();
}

void ResidualTable::showQuestion(const QString& path) {
  if (const capture::Finding* finding = findingOf(findings_, path.toStdString(), stated_))
    questions_->setCurrentIndex(static_cast<int>(finding - findings_.data()));
}

// The line that the keys are on stays.
void ResidualTable::refresh() {
  const capture::Finding* finding = shown();
  const int line = table_->indexOfTopLevelItem(table_->currentItem());
  table_->clear();
  questions_->setEnabled(!findings_.empty());
  apply_->setEnabled(false); // until a line is current
  reason_->setText(finding ? sentence(finding->reason)
                           : tr("Nothing was measured yet, or these frames leave nothing to measure."));
  if (!finding) return;
  if (!finding->measure.empty())
    table_->headerItem()->setToolTip(Residual, QString::fromStdString(finding->measure));
  for (const capture::Hypothesis& hypothesis : finding->hypotheses) {
    const bool isSet = agrees(hypothesis, stated_);
    auto* item =
        new QTreeWidgetItem({QString::fromStdString(hypothesis.text), shortText(hypothesis.residual, 4),
                             isSet ? QStringLiteral("✓") : QString()});
    if (isSet) item->setToolTip(Now, tr("This is set now."));
    item->setFont(Residual, numberFont());
    item->setTextAlignment(Residual, Qt::AlignVCenter | Qt::AlignRight);
    QStringList says;
    for (const std::string& assignment : hypothesis.assignments) says << QString::fromStdString(assignment);
    if (!hypothesis.isStatable) says << tr("No convention says this: it shows what the others are worth.");
    item->setToolTip(AnswerColumn, says.join(QStringLiteral("\n")));
    table_->addTopLevelItem(item);
  }
  // The picture beside it gives way.
  table_->setMinimumWidth(std::min(neededWidth(*table_), scaled(kMostWidth)));
  const int last = table_->topLevelItemCount() - 1;
  if (last >= 0) table_->setCurrentItem(table_->topLevelItem(std::clamp(line, 0, last)));
}

void ResidualTable::apply() {
  const capture::Hypothesis* hypothesis = selected();
  if (!hypothesis) return;
  const std::vector<std::string> assignments = hypothesis->assignments; // findings may change meanwhile
  Q_EMIT applied(assignments, QString::fromStdString(hypothesis->text));
}

} // namespace taa::app
