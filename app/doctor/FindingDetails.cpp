#include "app/doctor/FindingDetails.h"

#include "app/doctor/DoctorWords.h"
#include "app/doctor/ResidualBars.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "app/widgets/Note.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace taa::app {

namespace {

constexpr std::size_t kMostPlaces = 3;

QLabel* wrappingLabel() {
  auto* label = new QLabel;
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  return label;
}

QScrollArea* scrollingArea(QWidget* content, const QString& name) {
  auto* area = new QScrollArea;
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setFocusPolicy(Qt::TabFocus); // arrow keys scroll it
  area->setAccessibleName(name);
  area->setMinimumHeight(2 * rowHeight());
  area->setWidget(content);
  area->viewport()->setAutoFillBackground(false);
  content->setAutoFillBackground(false);
  return area;
}

} // namespace

FindingDetails::FindingDetails(QWidget* parent) : QWidget(parent) {
  auto* columns = new QHBoxLayout(this);
  columns->setContentsMargins(0, 0, 0, 0);
  columns->setSpacing(4 * kUnit);
  columns->addWidget(makeWords(), 1);
  columns->addWidget(makeEvidence(), 1);
}

QWidget* FindingDetails::makeWords() {
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(0, 0, 2 * kUnit, 0);
  column->setSpacing(kUnit);
  title_ = wrappingLabel();
  title_->setFont(titleFont());
  column->addWidget(title_);
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(2 * kUnit);
  grid->setVerticalSpacing(kUnit);
  grid->setColumnStretch(1, 1);
  for (std::size_t row = 0; row < kMostRows; ++row) {
    auto* key = new QLabel;
    key->setForegroundRole(QPalette::PlaceholderText);
    key->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    QLabel* value = wrappingLabel();
    grid->addWidget(key, static_cast<int>(row), 0);
    grid->addWidget(value, static_cast<int>(row), 1);
    lines_.emplace_back(key, value);
  }
  column->addLayout(grid);
  column->addStretch(1);
  words_ = scrollingArea(content, tr("What is said of the chosen line"));
  auto* whole = new QWidget;
  auto* rows = new QVBoxLayout(whole);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(kUnit);
  rows->addWidget(words_, 1);
  rows->addLayout(makeButtons());
  return whole;
}

QHBoxLayout* FindingDetails::makeButtons() {
  go_ = new QPushButton(tr("Go to the frame"));
  go_->setToolTip(tr("Goes to the frame and shows the plane that is wrong in the active view (Enter)"));
  corrected_ = new QPushButton(tr("Show mended"));
  for (QPushButton* button : {go_, corrected_}) button->setAutoDefault(false);
  connect(go_, &QPushButton::clicked, this, &FindingDetails::placeRequested);
  connect(corrected_, &QPushButton::clicked, this, &FindingDetails::correctedRequested);
  auto* line = new QHBoxLayout;
  line->setSpacing(kUnit);
  line->addWidget(go_);
  line->addWidget(corrected_);
  line->addStretch(1);
  return line;
}

void FindingDetails::setWhyNotCorrected(const QString& why) {
  corrected_->setEnabled(why.isEmpty());
  corrected_->setToolTip(why.isEmpty() ? tr("Compares the picture with the one that it would be if this were "
                                            "right, in the active view (Alt+M)")
                                       : why);
}

QWidget* FindingDetails::makeEvidence() {
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(0, 0, 2 * kUnit, 0);
  column->setSpacing(kUnit);
  measure_ = wrappingLabel();
  setSecondary(*measure_);
  bars_ = new ResidualBars;
  column->addWidget(measure_);
  column->addWidget(bars_);
  column->addStretch(1);
  evidence_ = scrollingArea(content, tr("Evidence"));
  return evidence_;
}

void FindingDetails::setRows(const std::vector<Row>& rows) {
  shown_ = rows;
  for (std::size_t row = 0; row < lines_.size(); ++row) {
    const bool isUsed = row < rows.size();
    lines_[row].first->setVisible(isUsed);
    lines_[row].second->setVisible(isUsed);
    lines_[row].first->setText(isUsed ? rows[row].first : QString());
    lines_[row].second->setText(isUsed ? rows[row].second : QString());
  }
  words_->verticalScrollBar()->setValue(0);
}

QString FindingDetails::title() const {
  return title_->text();
}

void FindingDetails::showFinding(const doctor::Finding& finding, int region,
                                 const doctor::FrameNames& names) {
  QStringList places;
  if (region < 0 && (finding.isWholePicture || finding.regions.empty()))
    places << whereText(finding);
  else if (region >= 0)
    places << placeText(finding.regions[static_cast<std::size_t>(region)]);
  else
    for (std::size_t i = 0; i < std::min(finding.regions.size(), kMostPlaces); ++i)
      places << placeText(finding.regions[i]);
  if (places.size() < static_cast<qsizetype>(finding.regions.size()) && !finding.isWholePicture && region < 0)
    places << tr("%n more", nullptr, static_cast<int>(finding.regions.size() - kMostPlaces));
  showText(qtext(finding.name), {{tr("How sure"), confidenceText(finding.confidence)},
                                 {tr("Where"), places.join(QLatin1Char('\n'))},
                                 {tr("One sees"), qtext(finding.symptom)},
                                 {tr("Change"), qtext(finding.change)},
                                 {tr("Rests on"), qtext(finding.reason)}});
  evidence_->show();
  measure_->setText(qtext(finding.measure));
  bars_->setResiduals(finding.residuals);
  evidence_->verticalScrollBar()->setValue(0);
  go_->setVisible(!finding.regions.empty());
  corrected_->show();
  if (finding.regions.empty()) return;
  const doctor::RegionPlace& place = finding.regions[static_cast<std::size_t>(std::max(0, region))];
  go_->setText(tr("Go to frame %1").arg(qtext(names.of(place.frame))));
}

void FindingDetails::showUndecided(const doctor::Undecided& undecided) {
  showText(qtext(undecided.question),
           {{tr("Not decided"), sentence(undecided.reason)}, {tr("Capture"), qtext(undecided.capture)}});
}

void FindingDetails::showText(const QString& title, const std::vector<Row>& rows) {
  title_->setText(title);
  std::vector<Row> said;
  for (const Row& row : rows)
    if (!row.second.isEmpty()) said.push_back(row);
  setRows(said);
  evidence_->hide();
  go_->hide();
  corrected_->hide();
}

} // namespace taa::app
