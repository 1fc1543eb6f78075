#include "app/panels/ProfilerPanel.h"

#include "app/style/CurveColor.h"
#include "app/style/Icons.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "app/views/plots/ProfileChart.h"
#include "app/widgets/IconButton.h"
#include "app/widgets/Note.h"
#include "app/widgets/ValueTable.h"

#include <QApplication>
#include <QClipboard>
#include <QEvent>
#include <QHBoxLayout>
#include <QHideEvent>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QShowEvent>
#include <QVBoxLayout>

#include <vector>

namespace taa::app {

namespace {

constexpr int kProfilerRefresh = 200; ///< ms
constexpr int kChartWidth = 230;      ///< px, at least: its axes have words

QString ms(double value) {
  return QString::number(value, 'f', value < 10.0 ? 3 : 2);
}

QString percentNumber(double part) {
  return QString::number(100.0 * part, 'f', 1);
}

QString mebibytes(std::size_t bytes) {
  return QString::number(static_cast<double>(bytes) / (1 << 20), 'f', 2);
}

QWidget* titled(QLabel* title, QWidget* content) {
  auto* part = new QWidget;
  auto* column = new QVBoxLayout(part);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kUnit);
  setSecondary(*title);
  column->addWidget(title);
  column->addWidget(content, 1);
  return part;
}

} // namespace

ProfilerPanel::ProfilerPanel(QWidget* parent) : QWidget(parent) {
  auto* rows = new QVBoxLayout(this);
  // As little as leaves all passes room in a window of 1280×800.
  rows->setContentsMargins(2 * kUnit, kUnit, 2 * kUnit, kUnit);
  rows->setSpacing(kUnit);
  rows->addWidget(makeTop());
  passes_ = new ValueTable({tr("Pass"), tr("ms"), tr("median"), tr("%")});
  chart_ = new ProfileChart;
  stages_ = new ValueTable({tr("Stage"), tr("ms"), tr("±"), tr("%")});
  memory_ = new ValueTable({tr("Resource"), tr("MiB"), tr("objects")});
  passesTitle_ = new QLabel(tr("Passes, from the next frame on"));
  stagesTitle_ = new QLabel(tr("Stages of the resolve, when measured"));
  auto* area = new QScrollArea;
  area->setAccessibleName(tr("Profile"));
  area->setWidgetResizable(true);
  area->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff); // tables scroll by themselves
  auto* content = new QWidget;
  auto* columns = new QHBoxLayout(content);
  columns->setContentsMargins(0, 0, 0, 0);
  columns->setSpacing(4 * kUnit);
  // Where there is less room than their names need, all of them scroll sideways.
  for (ValueTable* table : {passes_, stages_, memory_})
    table->setSizePolicy(QSizePolicy::MinimumExpanding, QSizePolicy::Expanding);
  chart_->setMinimumWidth(scaled(kChartWidth));
  // No stretch: with one their names would be cut before the chart gives way.
  columns->addWidget(titled(passesTitle_, passes_));
  columns->addWidget(titled(new QLabel(tr("Over time")), chart_));
  columns->addWidget(titled(stagesTitle_, stages_));
  columns->addWidget(titled(new QLabel(tr("Memory on the GPU")), memory_));
  area->setWidget(content);
  rows->addWidget(area, 1);
  refresh_.setSingleShot(true);
  refresh_.setInterval(kProfilerRefresh);
  connect(&refresh_, &QTimer::timeout, this, &ProfilerPanel::refresh);
}

QWidget* ProfilerPanel::makeTop() {
  auto* top = new QWidget;
  auto* line = new QHBoxLayout(top);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(2 * kUnit);
  method_ = new QLabel;
  setSecondary(*method_);
  method_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  method_->setWordWrap(true);
  measure_ = new QPushButton(tr("Measure stages"));
  measure_->setObjectName(QStringLiteral("measureStages"));
  measure_->setToolTip(tr(
      "What each stage's settings cost more than the cheapest ones: draws the resolve of the frame on show "
      "in turns with one where that stage has the settings of Minimal (Shift+F11). The costs do not add up "
      "to that of all. The stop button ends it."));
  auto* copy = new IconButton(QStringLiteral("copy"), tr("Copy all figures"));
  copy->setObjectName(QStringLiteral("copyProfile"));
  auto* menu = new QMenu(copy);
  menu->addAction(tr("As text"), this, [this] { this->copy(false); });
  menu->addAction(tr("As CSV"), this, [this] { this->copy(true); });
  connect(copy, &IconButton::clicked, this,
          [copy, menu] { menu->popup(copy->mapToGlobal(QPoint(0, copy->height()))); });
  line->addWidget(method_, 1);
  line->addWidget(measure_);
  line->addWidget(copy);
  connect(measure_, &QPushButton::clicked, this, &ProfilerPanel::measureRequested);
  return top;
}

void ProfilerPanel::setDriver(const gl::Driver& driver) {
  const QString text = tr("%1: %2.").arg(QString::fromStdString(driver.renderer),
                                         qtext(timingWords(gl::timingMethodFor(driver))));
  if (driver.renderer.empty() || text == driver_) return;
  driver_ = text;
  method_->setText(driver_);
}

void ProfilerPanel::addProfile(const FrameProfile& profile) {
  const bool isFirst = series_.isEmpty();
  series_.add(profile);
  if (isFirst) {
    refresh();
    return;
  }
  if (!refresh_.isActive()) refresh_.start();
}

void ProfilerPanel::setMeasuring(bool measuring) {
  measure_->setEnabled(!measuring);
}

void ProfilerPanel::refresh() {
  if (series_.isEmpty() || !isVisible()) return;
  showPasses();
  showMemory();
  chart_->show(series_);
}

void ProfilerPanel::showPasses() {
  std::vector<ValueTable::Row> rows;
  for (const ProfileSeries::Row& row : series_.rows())
    rows.push_back({{qtext(row.name), ms(row.last), ms(row.median), percentNumber(row.share)},
                    onPanel(ProfileChart::colorOf(rows.size()), themeColors(this))});
  rows.push_back({{tr("All"), ms(series_.last().totalMs), ms(series_.medianTotal()), {}}, {}, true});
  passes_->setRows(rows);
  passesTitle_->setText(
      tr("Passes of frame %1, median of %2").arg(series_.last().frame).arg(series_.profiles().size()));
}

void ProfilerPanel::showMemory() {
  const FrameProfile& last = series_.last();
  std::vector<ValueTable::Row> rows;
  rows.push_back({{tr("All"), mebibytes(last.memoryBytes), {}}, {}, true});
  rows.push_back({{tr("of it kept histories"), mebibytes(last.checkpointBytes), {}}});
  for (const MemoryCost& cost : last.memory)
    rows.push_back({{qtext(cost.name), mebibytes(cost.bytes), QString::number(cost.objects)}});
  memory_->setRows(rows);
}

void ProfilerPanel::setStageCosts(const StageCosts& costs) {
  costs_ = costs;
  std::vector<ValueTable::Row> rows;
  const auto share = [&](double time) {
    return percentNumber(costs.whole.median > 0.0 ? time / costs.whole.median : 0.0);
  };
  for (const StageCost& cost : costs.stages) {
    const bool isClear = cost.verdict() == CostVerdict::Clear, isNoise = cost.verdict() == CostVerdict::Noise;
    rows.push_back(
        {{qtext(stageInfo(cost.stage).label), isNoise ? tr("in the noise") : ms(cost.ms.median),
          cost.isCheapest ? QString() : ms(cost.ms.spread()), isClear ? share(cost.ms.median) : QString()},
         {},
         false,
         QString::fromStdString(verdictWords(cost))});
  }
  rows.push_back({{tr("All cheapest"), ms(costs.cheapest.median), ms(costs.cheapest.spread()),
                   share(costs.cheapest.median)}});
  rows.push_back({{tr("All"), ms(costs.whole.median), ms(costs.whole.spread()), {}}, {}, true});
  stages_->setRows(rows);
  stagesTitle_->setText(tr("Above the cheapest, frame %1, %2×%3, ± of %4 rounds")
                            .arg(costs.frame)
                            .arg(costs.width)
                            .arg(costs.height)
                            .arg(costs.rounds));
}

QString ProfilerPanel::text() const {
  return driver_ + QLatin1String("\n\n") + passes_->text() + QLatin1Char('\n') + stages_->text() +
         QLatin1Char('\n') + memory_->text();
}

QString ProfilerPanel::csv() const {
  return passes_->csv() + QLatin1Char('\n') + stages_->csv() + QLatin1Char('\n') + memory_->csv();
}

void ProfilerPanel::copy(bool asCsv) const {
  QApplication::clipboard()->setText(asCsv ? csv() : text());
}

void ProfilerPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (!event->spontaneous()) Q_EMIT shownChanged(true);
}

// Another theme.
void ProfilerPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && !series_.isEmpty()) showPasses();
}

void ProfilerPanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  if (event->spontaneous()) return; // the window is minimized
  series_.clear();                  // frames from before a pause do not belong to those after it
  Q_EMIT shownChanged(false);
}

} // namespace taa::app
