#include "app/panels/ProbePanel.h"

#include "app/models/ProbeModel.h"
#include "app/models/ProbeWords.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "app/views/plots/ColorSpacePage.h"
#include "app/views/plots/ColorSpaceView.h"
#include "app/views/plots/SensitivityPage.h"
#include "app/views/plots/WhatIfPage.h"
#include "app/widgets/IconButton.h"
#include "app/widgets/Line.h"
#include "app/widgets/ScrollPlace.h"
#include "app/widgets/Swatches.h"
#include "app/widgets/ValueTable.h"
#include "app/widgets/areas/FittingArea.h"
#include "app/widgets/areas/YieldingColumn.h"
#include "app/widgets/bars/ElidedLabel.h"
#include "app/widgets/bars/ProbeBar.h"
#include "app/widgets/probe/ProbeTable.h"
#include "app/widgets/probe/VerdictDetails.h"
#include "app/widgets/probe/VerdictLine.h"

#include "core/explanation/ProbeHeadline.h"
#include "core/settings/Faults.h"
#include "core/taa/twin/Known.h"

#include <QHBoxLayout>
#include <QJsonArray>
#include <QLabel>
#include <QScrollBar>
#include <QStackedWidget>
#include <QTabBar>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace taa::app {

namespace {

constexpr std::array<const char*, 4> kTabs{"values", "colorSpace", "whatIf", "sensitivity"};
constexpr std::array<const char*, 2> kSpaces{"rgb", "ycocg"};

/// Place of a text in a list, or nothing.
template <std::size_t Count>
std::optional<int> placeOf(const std::array<const char*, Count>& names, const QJsonValue& text) {
  for (std::size_t place = 0; place < Count; ++place)
    if (text.toString() == QLatin1String(names[place])) return static_cast<int>(place);
  return {};
}

double finite(const QJsonValue& value, double otherwise) {
  const double number = value.toDouble(otherwise);
  return std::isfinite(number) ? number : otherwise;
}

/// The timeline has the frame, too, and the table the object.
QString pixelText(const ProbeResult& result) {
  return QStringLiteral("(%1, %2)").arg(result.x).arg(result.y);
}

constexpr IntermediateId kNeighbors[] = {IntermediateId::color, IntermediateId::historyRectified,
                                         IntermediateId::resolved};
constexpr int kNarrowProbe = 300; ///< px, of texts of 100 %; with larger ones half as much more
constexpr int kEnoughRows = 5;    ///< of values, before what is said of them is cut

} // namespace

ProbePanel::ProbePanel(QWidget* parent) : QWidget(parent), model_(new ProbeModel(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  head_ = makeTop();
  layout->addWidget(head_);
  bar_ = new ProbeBar;
  connect(bar_, &ProbeBar::probeChosen, this, &ProbePanel::probeChosen);
  connect(bar_, &ProbeBar::followChosen, this, &ProbePanel::followChosen);
  layout->addWidget(bar_);

  layout->addWidget(makeInvitation(), 1);

  makePages();
  layout->addWidget(content_, 1);
  setPixel({});
}

// What is above the sentence goes before the sentence does.
QWidget* ProbePanel::makeInvitation() {
  auto* text = new QLabel(tr("Right-click a pixel to see every value at it."));
  text->setWordWrap(true);
  text->setAlignment(Qt::AlignHCenter | Qt::AlignTop);
  text->setContentsMargins(3 * kUnit, 0, 3 * kUnit, 0);
  text->setForegroundRole(QPalette::PlaceholderText);
  invitation_ = new QWidget;
  auto* column = new QVBoxLayout(invitation_);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addSpacerItem(new QSpacerItem(0, 8 * kUnit, QSizePolicy::Minimum, QSizePolicy::Maximum));
  column->addWidget(text, 1);
  return invitation_;
}

void ProbePanel::makePages() {
  content_ = new QWidget;
  auto* column = new QVBoxLayout(content_);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  tabs_ = new QTabBar;
  tabs_->setExpanding(false);
  tabs_->setDrawBase(false);
  tabs_->setAccessibleName(tr("Pages of the probe"));
  for (const QString& label : {tr("Values"), tr("Color space"), tr("What if"), tr("Sensitivity")})
    tabs_->addTab(label);
  pages_ = new QStackedWidget;
  colorSpace_ = new ColorSpacePage;
  whatIf_ = new WhatIfPage;
  sensitivity_ = new SensitivityPage;
  for (QWidget* page : {makeValues(), static_cast<QWidget*>(colorSpace_), static_cast<QWidget*>(whatIf_),
                        static_cast<QWidget*>(sensitivity_)})
    pages_->addWidget(page);
  column->addWidget(tabs_);
  column->addWidget(new Line);
  column->addWidget(pages_, 1);
  connect(tabs_, &QTabBar::currentChanged, this, [this](int index) {
    pages_->setCurrentIndex(index);
    Q_EMIT whatIfWanted(tab() != ProbeTab::Values);
  });
}

FittingArea* ProbePanel::makeConclusions() {
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  verdict_ = new VerdictLine;
  summary_ = new QLabel;
  summary_->setWordWrap(true);
  summary_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  summary_->setContentsMargins(2 * kUnit, 0, 2 * kUnit, kUnit);
  verdictDetails_ = new VerdictDetails;
  for (QWidget* part : {static_cast<QWidget*>(verdict_), static_cast<QWidget*>(summary_),
                        static_cast<QWidget*>(verdictDetails_), makeNeighbors()})
    column->addWidget(part);
  column->addStretch(1); // takes what is kept while it plays
  auto* area = new FittingArea(3 * rowHeight());
  area->setWidget(content);
  content->setAutoFillBackground(false);
  conclusions_ = content;
  return area;
}

QWidget* ProbePanel::makeValues() {
  auto* values = new QWidget;
  makeTable();
  description_ = new QLabel;
  description_->setFont(secondaryFont());
  description_->setToolTip(tr("What happened in the selected row; Enter shows the row in the active view."));
  description_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::LinksAccessibleByMouse |
                                        Qt::LinksAccessibleByKeyboard);
  connect(description_, &QLabel::linkActivated, this, [this](const QString& link) {
    depth_ = static_cast<FormulaDepth>(link.toInt());
    describeCurrentRow();
  });
  description_->setWordWrap(true);
  description_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  description_->setContentsMargins(2 * kUnit, kUnit, 2 * kUnit, kUnit);
  descriptionArea_ = new FittingArea(QFontMetrics(secondaryFont()).lineSpacing() + 2 * kUnit);
  descriptionArea_->setWidget(description_);
  description_->setAutoFillBackground(false);
  auto* column =
      new YieldingColumn(makeConclusions(), table_, new Line, descriptionArea_, kEnoughRows * rowHeight());
  column->setContentsMargins(0, 2 * kUnit, 0, 0);
  values->setLayout(column);
  return values;
}

void ProbePanel::setTab(ProbeTab tab) {
  tabs_->setCurrentIndex(static_cast<int>(tab));
}

void ProbePanel::openTab(ProbeTab tab) {
  setVisible(true);
  setTab(tab);
}

ProbeTab ProbePanel::tab() const {
  return static_cast<ProbeTab>(tabs_->currentIndex());
}

QWidget* ProbePanel::makeTop() {
  auto* top = new QWidget;
  auto* line = new QHBoxLayout(top);
  line->setContentsMargins(2 * kUnit, 2 * kUnit, kUnit, 2 * kUnit);
  line->setSpacing(2 * kUnit);
  auto* title = new QLabel(tr("Probe"));
  title->setFont(titleFont());
  place_ = new ElidedLabel;
  place_->setObjectName(QStringLiteral("place"));
  place_->setFont(numberFont(10));
  place_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  copy_ = new IconButton(QStringLiteral("copy"), tr("Copy every value, exact (Ctrl+Shift+C)"));
  remove_ = new IconButton(QStringLiteral("close"), tr("Remove the probe (Del)"));
  line->addWidget(title);
  line->addWidget(place_, 1);
  line->addWidget(copy_);
  line->addWidget(remove_);
  connect(copy_, &IconButton::clicked, this, &ProbePanel::copyRequested);
  connect(remove_, &IconButton::clicked, this, &ProbePanel::removeRequested);
  return top;
}

QWidget* ProbePanel::makeNeighbors() {
  auto* row = new QWidget;
  auto* line = new QHBoxLayout(row);
  line->setContentsMargins(2 * kUnit, 0, 2 * kUnit, 2 * kUnit);
  line->setSpacing(4 * kUnit);
  const QString captions[] = {tr("current"), tr("history"), tr("resolved")};
  for (std::size_t i = 0; i < swatches_.size(); ++i) {
    swatches_[i] = new Swatches(captions[i]);
    swatches_[i]->setToolTip(
        tr("The pixel and its neighbors: %1").arg(qtext(intermediate(kNeighbors[i]).label)));
    line->addWidget(swatches_[i]);
  }
  line->addStretch(1);
  return row;
}

QTreeView* ProbePanel::table() const {
  return table_;
}

void ProbePanel::makeTable() {
  table_ = new ProbeTable(model_);
  table_->setAccessibleName(tr("Every intermediate at the pixel"));
  connect(table_->selectionModel(), &QItemSelectionModel::currentChanged, this,
          &ProbePanel::describeCurrentRow);
  connect(table_, &QTreeView::activated, this, [this](const QModelIndex& index) {
    if (const auto id = model_->idOf(index)) Q_EMIT intermediateChosen(*id);
  });
}

void ProbePanel::setOutline(const std::shared_ptr<const SceneOutline>& outline) {
  model_->setOutline(outline);
  if (result_) showPlace(*result_);
}

void ProbePanel::setPlaying(bool playing) {
  if (playing == isPlaying_) return;
  isPlaying_ = playing;
  conclusions_->setMinimumHeight(playing ? conclusions_->height() : 0);
}

// Of frame and object the frame goes first where there is no room: it stands beside the timeline, too.
void ProbePanel::showPlace(const ProbeResult& result) {
  const QString pixel = pixelText(result), place = tr("%1  frame %2").arg(pixel).arg(result.frame);
  const QString object = model_->objectName(
      static_cast<int>(twin::at(result.around[kProbedMiddle], IntermediateId::objectId).x));
  const auto followed = [&](const QString& text) { return QStringLiteral("%1  %2").arg(text, object); };
  if (object.isEmpty())
    place_->setWhole(place, {pixel});
  else
    place_->setWhole(followed(place), {followed(pixel), pixel});
}

// Larger letters leave the views their room.
QSize ProbePanel::minimumSizeHint() const {
  const double ofLarge = std::ceil(kNarrowProbe * 0.5 * (1.0 + textScale()));
  return {std::max(table_->neededWidth(), static_cast<int>(ofLarge)), QWidget::minimumSizeHint().height()};
}

void ProbePanel::resizeEvent(QResizeEvent*) {
  const int room = 3 * Swatches::wideWidth() + 2 * 4 * kUnit + 4 * kUnit;
  for (Swatches* swatches : swatches_) swatches->setWide(width() >= room);
  table_->fitColumns(width());
}

void ProbePanel::setPixel(std::optional<glm::ivec2> pixel) {
  pixel_ = pixel;
  content_->setVisible(pixel.has_value());
  invitation_->setVisible(!pixel);
  bar_->setVisible(pixel.has_value());
  copy_->setVisible(pixel.has_value());
  remove_->setVisible(pixel.has_value());
  if (!pixel) {
    result_.reset();
    place_->setWhole({});
    model_->setRecord({});
    colorSpace_->setResult({});
    whatIf_->setResult({});
    sensitivity_->setResult({});
    return;
  }
  place_->setWhole(QStringLiteral("(%1, %2)").arg(pixel->x).arg(pixel->y));
}

void ProbePanel::setProbes(const std::vector<Probe>& probes, int active) {
  bar_->setProbes(probes, active);
}

void ProbePanel::setResult(const ProbeResult& result) {
  if (!isPlaying_) conclusions_->setMinimumHeight(0);
  if (result.around.size() <= kProbedMiddle) {
    showLost(result);
    return;
  }
  result_ = result;
  showPlace(result);
  showSummary(result);
  model_->setPixel(result);
  showColors();
  colorSpace_->setResult(result);
  whatIf_->setResult(result);
  sensitivity_->setResult(result);
  describeCurrentRow();
  if (isPlaying_)
    conclusions_->setMinimumHeight(
        std::max(conclusions_->minimumHeight(), heightAt(*conclusions_, conclusions_->width())));
  if (at_ && pixel_ == glm::ivec2(result.x, result.y))
    scrollTo(table_, model_->indexOf(*std::exchange(at_, {})));
}

void ProbePanel::showSummary(const ProbeResult& result) {
  Settings told = result.settings;
  if (!areFaultsNamed_) clearFaults(told);
  QStringList lines;
  for (const std::string& line : probeHeadline(result.around[kProbedMiddle], told, result.info))
    lines << qtext(line);
  if (result.spot.state == ProbeState::Hidden)
    lines.prepend(tr("The surface is behind something here: these are the values of what hides it"));
  summary_->setText(lines.join(QLatin1Char('\n')));
}

void ProbePanel::setFaultsNamed(bool areNamed) {
  areFaultsNamed_ = areNamed;
  if (result_) showSummary(*result_);
}

void ProbePanel::setGlimpse(const Glimpse& known) {
  result_.reset();
  if (!isPlaying_) conclusions_->setMinimumHeight(conclusions_->height()); // nothing below jumps
  summary_->setText(tr("The frame is being worked on: known so far is what the views show of this pixel."));
  model_->setGlimpse(known);
  for (Swatches* swatches : swatches_) swatches->setColors({});
  colorSpace_->setResult({});
  whatIf_->setResult({});
  sensitivity_->setResult({});
  describeCurrentRow();
}

void ProbePanel::showColors() {
  const ProbeResult& result = *result_;
  for (std::size_t i = 0; i < swatches_.size(); ++i) {
    if (!twin::isKnown(result.around[kProbedMiddle], kNeighbors[i])) {
      swatches_[i]->setColors({});
      continue;
    }
    std::array<std::array<float, 3>, 9> colors{};
    for (std::size_t pixel = 0; pixel < std::min(colors.size(), result.around.size()); ++pixel) {
      const glm::vec4 value = twin::at(result.around[pixel], kNeighbors[i]);
      colors[pixel] = {value.x, value.y, value.z};
    }
    swatches_[i]->setColors(colors);
  }
}

// There are no values where the surface cannot be seen.
void ProbePanel::showLost(const ProbeResult& result) {
  result_.reset();
  model_->setRecord({});
  place_->setWhole(tr("frame %1").arg(result.frame));
  summary_->setText(result.spot.state == ProbeState::Gone ? tr("The surface is not drawn in this frame")
                                                          : tr("The surface is off screen in this frame"));
  for (Swatches* swatches : swatches_) swatches->setColors({});
  colorSpace_->setResult({});
  whatIf_->setResult({});
  sensitivity_->setResult({});
}

void ProbePanel::describeCurrentRow() {
  const auto id = model_->idOf(table_->currentIndex());
  const QString other = id ? model_->comparedText(*id, comparison_) : QString();
  description_->setText(id ? (other.isEmpty() ? other : other.toHtmlEscaped() + QStringLiteral("<br>")) +
                                 explanationHtml(*id, model_->explainRow(*id, depth_)) + depthLinks(*id)
                           : tr("Select a row to read about it."));
  // Seven lines high whatever it says of a row, so that the values stay where they are; in a low window one.
  descriptionArea_->setAlways(id ? 7 * QFontMetrics(secondaryFont()).lineSpacing() + 2 * kUnit : 0);
}

QString ProbePanel::depthLinks(IntermediateId id) const {
  if (model_->explainRow(id, FormulaDepth::Samples).formula.empty()) return {}; // nor at any other depth
  const std::array<std::pair<FormulaDepth, QString>, 3> all{
      {{FormulaDepth::Rows, tr("other rows")},
       {FormulaDepth::Stage, tr("rows of other stages")},
       {FormulaDepth::Samples, tr("samples and settings")}}};
  QStringList links;
  for (const auto& [depth, label] : all)
    links << (depth == depth_ ? QStringLiteral("<b>%1</b>").arg(label.toHtmlEscaped())
                              : QStringLiteral("<a href=\"%1\">%2</a>")
                                    .arg(static_cast<int>(depth))
                                    .arg(label.toHtmlEscaped()));
  return QStringLiteral("<br>") + tr("Formula down to: %1").arg(links.join(QStringLiteral(" · ")));
}

QString ProbePanel::explanation() const {
  const auto id = model_->idOf(table_->currentIndex());
  return id ? explanationText(*id, model_->explainRow(*id)) : QString();
}

QString ProbePanel::formulaOf(IntermediateId id) const {
  return result_ && result_->details ? qtext(model_->explainRow(id).formula) : QString();
}

QString ProbePanel::valueText(IntermediateId fallback) const {
  if (!result_) return {};
  const auto selected = table_->hasFocus() ? model_->idOf(table_->currentIndex()) : std::nullopt;
  const IntermediateId id = selected.value_or(fallback);
  const PixelRecord& record = result_->around[kProbedMiddle];
  if (!twin::isKnown(record, id))
    return model_->data(model_->indexOf(id, ProbeModel::Meaning), Qt::DisplayRole).toString();
  return rowText(intermediate(id), twin::at(record, id));
}

QString ProbePanel::summary() const {
  return summary_->text();
}

QJsonObject ProbePanel::state() const {
  QJsonArray folded, unfolded;
  for (int row = 0; row < model_->rowCount(); ++row) {
    const QModelIndex branch = model_->index(row, 0);
    if (!table_->isExpanded(branch)) folded << qtext(stageInfo(model_->stageOf(branch)).id);
    if (model_->isUnfolded(branch)) unfolded << qtext(stageInfo(model_->stageOf(branch)).id);
  }
  const auto selected = model_->idOf(table_->currentIndex());
  const SpaceTurn& turn = colorSpace_->view()->turn();
  return {{QStringLiteral("tab"), QLatin1String(kTabs[static_cast<std::size_t>(tab())])},
          {QStringLiteral("folded"), folded},
          {QStringLiteral("showsOff"), unfolded},
          {QStringLiteral("evidence"), verdictDetails_->isUnfolded()},
          {QStringLiteral("row"), selected ? qtext(intermediate(*selected).name) : QString()},
          {QStringLiteral("scroll"), table_->verticalScrollBar()->value()},
          {QStringLiteral("space"), QLatin1String(kSpaces[static_cast<std::size_t>(colorSpace_->space())])},
          {QStringLiteral("turn"), QJsonArray{turn.yaw, turn.pitch}},
          {QStringLiteral("whatIfScroll"), whatIf_->table()->verticalScrollBar()->value()}};
}

void ProbePanel::setState(const QJsonObject& state) {
  setTab(static_cast<ProbeTab>(placeOf(kTabs, state.value(QLatin1String("tab"))).value_or(0)));
  const QJsonArray folded = state.value(QLatin1String("folded")).toArray();
  const QJsonArray unfolded = state.value(QLatin1String("showsOff")).toArray();
  for (int row = 0; row < model_->rowCount(); ++row) {
    const QModelIndex branch = model_->index(row, 0);
    table_->setExpanded(branch, !folded.contains(qtext(stageInfo(model_->stageOf(branch)).id)));
    model_->setUnfolded(branch, unfolded.contains(qtext(stageInfo(model_->stageOf(branch)).id)));
  }
  verdictDetails_->setUnfolded(state.value(QLatin1String("evidence")).toBool());
  const auto row = findIntermediate(state.value(QLatin1String("row")).toString().toStdString());
  table_->setAutoScroll(false); // it would go to the row when the page is shown next
  table_->setCurrentIndex(row ? model_->indexOf(*row) : QModelIndex());
  table_->setAutoScroll(true);
  colorSpace_->setSpace(
      static_cast<PlotSpace>(placeOf(kSpaces, state.value(QLatin1String("space"))).value_or(1)));
  const QJsonArray turn = state.value(QLatin1String("turn")).toArray();
  colorSpace_->view()->setTurn({finite(turn.at(0), SpaceTurn{}.yaw), finite(turn.at(1), SpaceTurn{}.pitch)});
  at_ = findIntermediate(state.value(QLatin1String("at")).toString().toStdString());
  scrollTo(table_->verticalScrollBar(), state.value(QLatin1String("scroll")).toInt());
  scrollTo(whatIf_->table()->verticalScrollBar(), state.value(QLatin1String("whatIfScroll")).toInt());
}

} // namespace taa::app
