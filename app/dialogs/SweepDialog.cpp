#include "app/dialogs/SweepDialog.h"

#include "app/background/BackgroundBar.h"
#include "app/dialogs/FramesField.h"
#include "app/dialogs/SweepScenes.h"
#include "app/session/Session.h"
#include "app/style/DialogSize.h"
#include "app/style/Numbers.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "app/views/plots/CurveChart.h"
#include "app/views/plots/ScatterChart.h"
#include "core/render/CaptureFacts.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QStringList>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace taa::app {

namespace {

enum SweepColumn { SettingsColumn, SceneColumn, FrontColumn, FirstMetric };
constexpr int kAllScenes = -1;
constexpr int kIndexRole = Qt::UserRole, kNumberRole = Qt::UserRole + 1;
constexpr int kFirstFrames = 8;     ///< up to the one on show
constexpr int kLettersOfMetric = 8; ///< of a name that is whole in any case

/// Sorted by its numbers, not by their texts; what is not known comes last.
class SweepLine : public QTreeWidgetItem {
 public:
  using QTreeWidgetItem::QTreeWidgetItem;
  bool operator<(const QTreeWidgetItem& other) const override {
    const int column = treeWidget() ? treeWidget()->sortColumn() : 0;
    const QVariant mine = data(column, kNumberRole), its = other.data(column, kNumberRole);
    if (!mine.isValid() && !its.isValid()) return text(column) < other.text(column);
    return mine.toDouble() < its.toDouble();
  }
};

QString metricTitle(Metric metric) {
  const MetricInfo& info = metricInfo(metric);
  const QString label = qtext(info.label);
  return info.unit.empty() ? label : label + u' ' + qtext(info.unit);
}

} // namespace

SweepDialog::SweepDialog(Session& session, const QString& folder, QWidget* parent, SweepWork::Sweep sweep)
    : WorkDialog(work_, parent), session_(session), work_(std::move(sweep)),
      choices_(new SweepChoices(session, folder)), scenes_(new SweepScenes(session)),
      frames_(new FramesField(session, kFirstFrames)),
      supersampling_(new QCheckBox(tr("Supersampling beside RMSE"))), table_(new QTreeWidget),
      ofX_(new QComboBox), ofY_(new QComboBox), ofCurves_(new QComboBox), ofScene_(new QComboBox),
      scatter_(new ScatterChart), curves_(new CurveChart({}, tr("frame"))),
      bar_(new BackgroundBar(work_, tr("Measure"))) {
  setWindowTitle(tr("Sweep"));
  auto* left = new QVBoxLayout;
  left->setSpacing(2 * kUnit);
  left->addWidget(choices_, 1);
  left->addWidget(new QLabel(tr("Scenes")));
  left->addWidget(scenes_);
  left->addWidget(frames_);
  left->addWidget(supersampling_);
  supersampling_->setObjectName(QStringLiteral("supersampling"));
  supersampling_->setToolTip(qtext(metricInfo(Metric::Supersampling).description));
  auto* sides = new QHBoxLayout;
  sides->setSpacing(3 * kUnit);
  sides->addLayout(left);
  auto* right = new QSplitter(Qt::Vertical);
  right->addWidget(table_);
  right->addWidget(makeCharts());
  sides->addWidget(right, 1);
  choices_->setFixedWidth(scaled(60 * kUnit));
  scenes_->setFixedSize(scenes_->sizeHint());
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(3 * kUnit, 3 * kUnit, 3 * kUnit, 3 * kUnit);
  layout->setSpacing(2 * kUnit);
  layout->addLayout(sides, 1);
  makeButtons();
  layout->addWidget(bar_);
  table_->setAccessibleName(tr("Measured settings"));
  table_->setRootIsDecorated(false);
  table_->setSortingEnabled(true);
  connectParts();
  listMetrics();
  listScenes();
  refresh();
  resize(sizeOver(parent, {scaled(228 * kUnit), sizeHint().height()}));
}

void SweepDialog::connectParts() {
  connect(table_, &QTreeWidget::currentItemChanged, this, [this] { choose(chosen()); });
  connect(table_, &QTreeWidget::itemActivated, this, &SweepDialog::apply);
  connect(scatter_, &ScatterChart::pointClicked, this, &SweepDialog::choose);
  connect(choices_, &SweepChoices::changed, this, &SweepDialog::refresh);
  connect(scenes_, &SweepScenes::changed, this, &SweepDialog::refresh);
  connect(frames_, &FramesField::changed, this, &SweepDialog::refresh);
  connect(&session_.presets(), &PresetChoices::settingsChanged, this, [this] {
    if (isVisible()) choices_->refresh();
  });
  connect(&work_, &SweepWork::measured, this, [this](std::size_t index, const LaneMetrics& frames) {
    series_.add(index, frames);
    showTable();
    showCharts();
  });
  connect(&work_, &SweepWork::ended, this, &SweepDialog::finish);
}

void SweepDialog::openAt(Session& session, const QString& folder, QWidget* window) {
  auto* dialog = window->findChild<SweepDialog*>();
  if (!dialog)
    dialog = new SweepDialog(session, folder, window);
  else if (!dialog->isVisible())
    dialog->choices_->refresh();
  dialog->present();
}

QWidget* SweepDialog::makeCharts() {
  auto* charts = new QSplitter;
  const auto page = [&](QWidget* chart, const std::vector<QComboBox*>& boxes) {
    auto* side = new QWidget;
    auto* layout = new QVBoxLayout(side);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(kUnit);
    auto* line = new QHBoxLayout;
    for (QComboBox* box : boxes) line->addWidget(box, 1);
    layout->addLayout(line);
    layout->addWidget(chart, 1);
    charts->addWidget(side);
  };
  page(scatter_, {ofX_, ofY_});
  page(curves_, {ofCurves_, ofScene_});
  charts->setSizes({1, 1}); // as wide as one another
  ofX_->setAccessibleName(tr("Metric to the right"));
  ofY_->setAccessibleName(tr("Metric upwards"));
  ofCurves_->setAccessibleName(tr("Metric of the curves"));
  ofScene_->setAccessibleName(tr("Scene of the charts"));
  ofScene_->setVisible(false);
  for (QComboBox* box : {ofX_, ofY_, ofCurves_, ofScene_}) {
    box->view()->setAccessibleName(box->accessibleName());
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon); // as wide as there is room
    box->setMinimumContentsLength(kLettersOfMetric);
    connect(box, &QComboBox::currentIndexChanged, this, [this] {
      showTable(); // the front is another one
      showCharts();
    });
  }
  return charts;
}

void SweepDialog::makeButtons() {
  copy_ = bar_->addButton(tr("Copy as CSV"), tr("Copy the table as CSV"));
  apply_ = bar_->addButton(tr("Apply"), tr("Apply the chosen settings"));
  apply_->setToolTip(tr("Take the chosen settings up; it can be undone"));
  connect(bar_, &BackgroundBar::startRequested, this, &SweepDialog::begin);
  connect(apply_, &QPushButton::clicked, this, &SweepDialog::apply);
  connect(copy_, &QPushButton::clicked, this, &SweepDialog::copy);
}

// What all scenes have.
int SweepDialog::referenceSamples() const {
  const auto captured = session_.status().capture;
  const bool isOpenOneChosen = std::ranges::any_of(scenes_->chosen(), &SweptScene::isOpen);
  return captured && !captured->hasReference && isOpenOneChosen ? 0 : session_.status().referenceGoal;
}

// The usual trade-off is chosen first, and stands first in the table.
void SweepDialog::listMetrics() {
  std::vector<Metric> metrics = metricsThere(referenceSamples(), {OverTime::Flicker});
  const std::array<Metric, 2> usual = defaultTradeOff(metrics);
  std::ranges::stable_partition(metrics,
                                [&](Metric metric) { return metric == usual[0] || metric == usual[1]; });
  if (metrics == metrics_) return;
  metrics_ = std::move(metrics);
  const auto list = [&](QComboBox* box, Metric first) {
    const QSignalBlocker quiet(box);
    const QVariant before = box->currentData();
    box->clear();
    for (const Metric metric : metrics_) box->addItem(metricTitle(metric), static_cast<int>(metric));
    const int place = before.isValid() ? box->findData(before) : -1;
    box->setCurrentIndex(place >= 0 ? place : box->findData(static_cast<int>(first)));
  };
  list(ofX_, usual[0]);
  list(ofY_, usual[1]);
  list(ofCurves_, usual[0]);
  QStringList header{tr("Settings"), tr("Scene"), tr("Front")};
  for (const Metric metric : metrics_) header << metricTitle(metric);
  table_->setColumnCount(static_cast<int>(header.size()));
  table_->setHeaderLabels(header);
  table_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->header()->setSortIndicator(-1, Qt::AscendingOrder); // as they are measured, until one is clicked
  for (std::size_t column = 0; column < metrics_.size(); ++column)
    table_->headerItem()->setToolTip(FirstMetric + static_cast<int>(column),
                                     qtext(metricInfo(metrics_[column]).description));
}

void SweepDialog::listScenes() {
  const QSignalBlocker quiet(ofScene_);
  ofScene_->clear();
  ofScene_->addItem(tr("All scenes"), kAllScenes);
  for (std::size_t scene = 0; scene < series_.sceneCount(); ++scene)
    ofScene_->addItem(series_.sceneName(scene), static_cast<int>(scene));
  ofScene_->setVisible(series_.sceneCount() > 1);
  table_->setColumnHidden(SceneColumn, series_.sceneCount() < 2);
}

std::optional<std::size_t> SweepDialog::sceneShown() const {
  const QVariant scene = ofScene_->currentData();
  if (!scene.isValid() || scene.toInt() == kAllScenes) return {};
  return static_cast<std::size_t>(scene.toInt());
}

Metric SweepDialog::metricOf(const QComboBox* box) const {
  return static_cast<Metric>(box->currentData().toInt());
}

void SweepDialog::begin() {
  swept_ = choices_->chosen();
  ShotSweepRequest request;
  std::vector<QString> names, scenes;
  for (const SweptScene& each : scenes_->chosen()) {
    request.shots.push_back(each.shot);
    scenes.push_back(each.name);
  }
  for (const SweptSettings& each : swept_) {
    request.settings.push_back({each.name.toStdString(), each.choice.settings});
    names.push_back(each.name);
  }
  table_->clear();
  listMetrics();
  request.metrics = {frames_->first(), frames_->last(), metrics_, referenceSamples()};
  const QString sceneNames = QStringList(scenes.begin(), scenes.end()).join(QStringLiteral(", "));
  request.hasSupersampling = supersampling_->isEnabled() && supersampling_->isChecked();
  series_.begin(std::move(names), std::move(scenes), metrics_);
  listScenes();
  table_->headerItem()->setText(SettingsColumn, choices_->title());
  setWindowTitle(tr("Sweep: %1, frames %2 to %3").arg(sceneNames).arg(frames_->first()).arg(frames_->last()));
  curves_->setBounds({static_cast<double>(frames_->first()), static_cast<double>(frames_->last())});
  showTable();
  showCharts();
  work_.begin(request);
  refresh();
}

// The chosen line stays.
void SweepDialog::showTable() {
  const std::optional<std::size_t> before = chosen();
  const std::vector<ScatterPoint> points = series_.tradeOff(metricOf(ofX_), metricOf(ofY_));
  const QSignalBlocker quiet(table_);
  table_->setSortingEnabled(false);
  table_->clear();
  for (std::size_t index = 0; index < series_.count(); ++index) {
    if (!series_.isMeasured(index)) continue;
    auto* line = new SweepLine({series_.name(index)});
    const auto point = std::ranges::find(points, index, &ScatterPoint::index);
    fillLine(*line, index, point != points.end() && point->isOnFront);
    table_->addTopLevelItem(line);
    if (index == before) table_->setCurrentItem(line);
  }
  table_->setSortingEnabled(true);
}

void SweepDialog::fillLine(QTreeWidgetItem& line, std::size_t index, bool isOnFront) const {
  line.setData(SettingsColumn, kIndexRole, static_cast<qulonglong>(index));
  line.setData(SettingsColumn, kNumberRole,
               static_cast<double>(series_.settingsOf(index))); // "10" comes after "2"
  line.setText(SceneColumn, series_.sceneName(series_.sceneOf(index)));
  line.setData(SceneColumn, kNumberRole, static_cast<double>(series_.sceneOf(index)));
  line.setText(FrontColumn, isOnFront ? tr("yes") : QString());
  line.setData(FrontColumn, kNumberRole, isOnFront ? 0.0 : 1.0);
  for (std::size_t column = 0; column < series_.metrics().size(); ++column) {
    const int place = FirstMetric + static_cast<int>(column);
    const std::optional<double> mean = series_.mean(index, series_.metrics()[column]);
    line.setText(place, mean ? shortText(*mean, 4) : QStringLiteral("–"));
    line.setData(place, kNumberRole, mean.value_or(std::numeric_limits<double>::max()));
    line.setFont(place, numberFont());
    line.setTextAlignment(place, Qt::AlignVCenter | Qt::AlignRight);
  }
}

void SweepDialog::showCharts() {
  const Metric x = metricOf(ofX_), y = metricOf(ofY_), curve = metricOf(ofCurves_);
  scatter_->setTitles(metricTitle(x), metricTitle(y));
  scatter_->setPoints(series_.tradeOff(x, y, sceneShown()));
  scatter_->setChosen(chosen());
  curves_->setCurves(series_.curves(curve, sceneShown()));
}

std::optional<std::size_t> SweepDialog::chosen() const {
  const QTreeWidgetItem* line = table_->currentItem();
  if (!line) return {};
  return static_cast<std::size_t>(line->data(SettingsColumn, kIndexRole).toULongLong());
}

void SweepDialog::choose(std::optional<std::size_t> index) {
  for (int line = 0; index && line < table_->topLevelItemCount(); ++line)
    if (table_->topLevelItem(line)->data(SettingsColumn, kIndexRole).toULongLong() == *index) {
      const QSignalBlocker quiet(table_);
      table_->setCurrentItem(table_->topLevelItem(line));
    }
  scatter_->setChosen(index);
  refresh();
}

void SweepDialog::apply() {
  const std::optional<std::size_t> index = chosen();
  if (!index) return;
  const SweptSettings& wanted = swept_[series_.settingsOf(*index)];
  session_.presets().change(wanted.choice, tr("settings of a sweep: %1").arg(wanted.name));
}

void SweepDialog::copy() {
  QApplication::clipboard()->setText(series_.csv());
}

void SweepDialog::refresh() {
  const int count = static_cast<int>(choices_->chosen().size());
  const int scenes = static_cast<int>(scenes_->chosen().size());
  supersampling_->setEnabled(!session_.status().capture && referenceSamples() > 0);
  apply_->setEnabled(chosen().has_value());
  copy_->setEnabled(series_.measuredCount() > 0);
  bar_->setReady(count > 0 && scenes > 0 && frames_->isOrdered() && session_.isOpen(),
                 !frames_->isOrdered() ? tr("The last frame is before the first.")
                 : count == 0          ? tr("Nothing is chosen.")
                 : scenes == 0         ? tr("No scene is chosen.")
                 : scenes == 1
                     ? tr("Settings to measure: %1, each in frames: %2.").arg(count).arg(frames_->count())
                     : tr("Settings to measure: %1, on scenes: %2, each in frames: %3.")
                           .arg(count)
                           .arg(scenes)
                           .arg(frames_->count()));
}

void SweepDialog::finish(const QString& error) {
  refresh();
  bar_->setNote(!error.isEmpty()
                    ? error
                    : tr("Settings measured: %1 of %2.").arg(series_.measuredCount()).arg(series_.count()));
}

} // namespace taa::app
