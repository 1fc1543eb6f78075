#include "app/panels/PlotsPanel.h"

#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "app/views/plots/CurveChart.h"
#include "app/widgets/Chooser.h"
#include "app/widgets/IconButton.h"
#include "app/widgets/Note.h"
#include "app/widgets/bars/ElidedLabel.h"

#include "core/base/Error.h"
#include "core/base/Files.h"
#include "core/report/TraceText.h"
#include "core/taa/ChannelNames.h"

#include <QApplication>
#include <QClipboard>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHelpEvent>
#include <QHideEvent>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QShowEvent>
#include <QStringList>
#include <QToolButton>
#include <QToolTip>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace taa::app {

namespace {

constexpr const char* kChipRow = "row"; ///< property: the intermediate of a chip

constexpr int kPlotsRefresh = 100; ///< ms

} // namespace

PlotsPanel::PlotsPanel(QWidget* parent) : QWidget(parent) {
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(2 * kUnit, kUnit, 2 * kUnit, kUnit);
  rows->setSpacing(kUnit);
  makeTop();
  invitation_ = new QLabel(tr("Right-click a pixel: its values over frames are drawn here."));
  invitation_->setAlignment(Qt::AlignCenter);
  invitation_->setForegroundRole(QPalette::PlaceholderText);
  rows->addWidget(invitation_, 1);
  auto* area = new QScrollArea;
  area->setAccessibleName(tr("Plots of the probes"));
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  auto* content = new QWidget;
  column_ = new QVBoxLayout(content);
  column_->setContentsMargins(0, 0, 0, 0);
  column_->setSpacing(0);
  area->setWidget(content);
  rows->addWidget(area, 100);
  refresh_.setSingleShot(true);
  refresh_.setInterval(kPlotsRefresh);
  connect(&refresh_, &QTimer::timeout, this, &PlotsPanel::refresh);
  setRows(firstPlotRows());
}

void PlotsPanel::makeTop() {
  auto* line = new QHBoxLayout;
  line->setSpacing(kUnit);
  static_cast<QVBoxLayout*>(layout())->addLayout(line);
  auto* add = new QPushButton(tr("Add a plot…"));
  add->setObjectName(QStringLiteral("addPlot"));
  add->setToolTip(tr("Plot another intermediate (Shift+F6)"));
  connect(add, &QPushButton::clicked, this, &PlotsPanel::chooseRow);
  line->addWidget(add);
  chips_ = new QHBoxLayout;
  chips_->setSpacing(0);
  line->addLayout(chips_);
  summary_ = new ElidedLabel;
  setSecondary(*summary_);
  summary_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  summary_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  line->addWidget(summary_, 1);
  fill_ = new QPushButton(tr("Fill in"));
  fill_->setObjectName(QStringLiteral("fillTraces"));
  fill_->setToolTip(tr("Makes the frames that were not shown yet, in the background while nothing plays "
                       "(Ctrl+F6). The stop button ends it."));
  connect(fill_, &QPushButton::clicked, this, &PlotsPanel::requestFill);
  line->addWidget(fill_);
  auto* reset = new IconButton(QStringLiteral("fit"), tr("Show all frames (Ctrl+0)"));
  connect(reset, &IconButton::clicked, this, &PlotsPanel::resetZoom);
  line->addWidget(reset);
  auto* copy = new IconButton(QStringLiteral("copy"), tr("Copy or save the values as CSV"));
  copy->setObjectName(QStringLiteral("copyTraces"));
  auto* menu = new QMenu(copy);
  menu->addAction(tr("Copy as CSV"), this, &PlotsPanel::copyCsv);
  menu->addAction(tr("Save as CSV…"), this, &PlotsPanel::saveCsv);
  connect(copy, &IconButton::clicked, this,
          [copy, menu] { menu->popup(copy->mapToGlobal(QPoint(0, copy->height()))); });
  line->addWidget(copy);
}

void PlotsPanel::setStatus(const Status& status) {
  setShotVersion(status.shotVersion);
  frame_ = status.info.frame;
  if (status.settings.space.color != space_.color) {
    space_ = status.settings.space;
    makeChips(); // with other names of channels
    refreshSoon();
  }
  for (CurveChart* chart : charts_) chart->setPlayhead(frame_);
  if (status.restarts != restarts_) refreshSoon();
  restarts_ = status.restarts;
  if (status.frameCount == frameCount_ && status.cuts == cuts_) return;
  frameCount_ = std::max(1, status.frameCount);
  cuts_ = status.cuts;
  for (CurveChart* chart : charts_) chart->setBounds(wholeShot());
  setShown(wholeShot());
  refreshSoon();
}

void PlotsPanel::setProbes(const std::vector<Probe>& probes, int active) {
  probes_ = probes;
  active_ = active;
  refreshSoon();
}

void PlotsPanel::setShotVersion(std::uint64_t shotVersion) {
  if (shotVersion == shotVersion_) return;
  shotVersion_ = shotVersion;
  traces_.clear();
  refreshSoon();
}

void PlotsPanel::addSample(const TraceDelivery& delivery) {
  if (delivery.shotVersion < shotVersion_) return; // it came too late
  setShotVersion(delivery.shotVersion);
  auto found = std::ranges::find_if(
      traces_, [&](const ProbeTrace& known) { return isSamePlace(known.probe, delivery.probe); });
  if (found == traces_.end()) found = traces_.insert(traces_.end(), ProbeTrace{delivery.probe, {}});
  found->trace.add(delivery.frame, delivery.sample);
  refreshSoon();
}

const PixelTrace* PlotsPanel::traceOf(const Probe& probe) const {
  for (const ProbeTrace& known : traces_)
    if (isSamePlace(known.probe, probe)) return &known.trace;
  return nullptr;
}

std::vector<ProbeTrace> PlotsPanel::probeTraces() const {
  std::vector<ProbeTrace> traces;
  for (const Probe& probe : probes_) {
    const PixelTrace* trace = traceOf(probe);
    traces.push_back({probe, trace ? *trace : PixelTrace()});
  }
  return traces;
}

void PlotsPanel::setFilling(bool filling) {
  fill_->setEnabled(!filling);
}

void PlotsPanel::setRows(const std::vector<PlotRow>& rows) {
  if (rows == rows_) return;
  rows_ = rows;
  makeCharts();
  makeChips();
  refreshSoon();
}

void PlotsPanel::addRow(IntermediateId id) {
  if (std::ranges::find(rows_, id, &PlotRow::id) != rows_.end()) return;
  std::vector<PlotRow> rows = rows_;
  rows.push_back({id});
  setRows(rows);
}

void PlotsPanel::removeRow(IntermediateId id) {
  std::vector<PlotRow> rows = rows_;
  std::erase_if(rows, [id](const PlotRow& row) { return row.id == id; });
  setRows(rows);
}

void PlotsPanel::setChannel(IntermediateId id, int channel, bool shown) {
  const auto row = std::ranges::find(rows_, id, &PlotRow::id);
  if (row == rows_.end()) return;
  const unsigned bit = 1u << channel;
  row->channels = shown ? row->channels | bit : row->channels & ~bit;
  refreshSoon();
}

void PlotsPanel::makeCharts() {
  for (CurveChart* chart : charts_) {
    column_->removeWidget(chart);
    chart->deleteLater();
  }
  charts_.clear();
  for (const PlotRow& row : rows_) {
    auto* chart = new CurveChart(plotTitle(row), tr("frame"));
    charts_.push_back(chart);
    column_->addWidget(chart, 1);
    connectChart(chart);
  }
  placeCharts();
}

void PlotsPanel::connectChart(CurveChart* chart) {
  chart->setBounds({0.0, frameCount_ - 1.0});
  chart->setShown(shown_);
  chart->setPlayhead(frame_);
  connect(chart, &CurveChart::xClicked, this,
          [this](double frame) { Q_EMIT seekRequested(static_cast<int>(frame)); });
  connect(chart, &CurveChart::hovered, this, [this](std::optional<double> frame) {
    for (CurveChart* other : charts_) other->setHovered(frame);
  });
  connect(chart, &CurveChart::shownChanged, this, &PlotsPanel::setShown);
}

void PlotsPanel::setShown(const Span& frames) {
  if (frames == shown_) return;
  shown_ = frames;
  for (CurveChart* chart : charts_) chart->setShown(frames);
  Q_EMIT framesShown(frames);
}

void PlotsPanel::setRuler(const Span& globalPx) {
  ruler_ = globalPx;
  placeCharts();
}

// A frame stands at one place in all charts and on the ruler below them.
void PlotsPanel::placeCharts() {
  if (!ruler_ || !isVisible()) return;
  for (CurveChart* chart : charts_) {
    const double left = chart->mapToGlobal(QPoint(0, 0)).x();
    chart->setEdges({ruler_->low - left, ruler_->high - left});
  }
}

// One for each row, with its channels and a way out.
void PlotsPanel::makeChips() {
  while (QLayoutItem* item = chips_->takeAt(0)) {
    item->widget()->deleteLater();
    delete item;
  }
  for (const PlotRow& row : rows_) {
    const Intermediate& info = intermediate(row.id);
    auto* chip = new QToolButton;
    chip->setText(qtext(info.label));
    chip->setAccessibleName(tr("Plot of %1").arg(qtext(info.label)));
    chip->setToolTip(qtext(info.description));
    chip->setProperty(kChipRow, static_cast<int>(row.id));
    chip->installEventFilter(this);
    chip->setPopupMode(QToolButton::InstantPopup);
    chip->setFocusPolicy(Qt::TabFocus);
    auto* menu = new QMenu(chip);
    const std::vector<std::string> channels = channelNames(info, space_);
    for (int channel = 0; info.channels > 1 && channel < info.channels; ++channel) {
      QAction* action = menu->addAction(QString::fromStdString(channels[static_cast<std::size_t>(channel)]));
      action->setCheckable(true);
      action->setChecked(row.has(channel));
      connect(action, &QAction::toggled, this,
              [this, id = row.id, channel](bool on) { setChannel(id, channel, on); });
    }
    menu->addAction(tr("Remove this plot"), this, [this, id = row.id] { removeRow(id); });
    chip->setMenu(menu);
    chips_->addWidget(chip);
  }
}

// A plot's name tells how the value came about, once that is known.
bool PlotsPanel::eventFilter(QObject* watched, QEvent* event) {
  const QVariant row = watched->property(kChipRow);
  if (event->type() != QEvent::ToolTip || !row.isValid() || !formulas_)
    return QWidget::eventFilter(watched, event);
  const auto id = static_cast<IntermediateId>(row.toInt());
  QStringList lines{qtext(intermediate(id).description)};
  if (const QString formula = formulas_(id); !formula.isEmpty())
    lines << tr("At the probe, frame %1: %2").arg(frame_).arg(formula);
  QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), lines.join(QLatin1Char('\n')),
                     static_cast<QWidget*>(watched));
  return true;
}

void PlotsPanel::chooseRow() {
  std::vector<ChooserEntry> entries;
  std::vector<IntermediateId> ids;
  for (const IntermediateId id : allRows()) {
    ids.push_back(id);
    entries.push_back(intermediateEntry(intermediate(id)));
  }
  auto* chooser = new Chooser(
      tr("Plot an intermediate"), std::move(entries),
      [this, ids](int index) { addRow(ids[static_cast<std::size_t>(index)]); }, window());
  chooser->open(QRect(mapTo(window(), QPoint(0, 0)), QSize(320, 0)));
}

void PlotsPanel::requestFill() {
  Q_EMIT fillRequested(static_cast<int>(std::floor(shown_.low)), static_cast<int>(std::ceil(shown_.high)));
}

void PlotsPanel::resetZoom() {
  setShown(wholeShot());
}

void PlotsPanel::refreshSoon() {
  if (isVisible() && !refresh_.isActive()) refresh_.start();
}

void PlotsPanel::refresh() {
  if (!isVisible()) return;
  invitation_->setVisible(probes_.empty());
  const std::vector<ProbeTrace> traces = probeTraces();
  const bool hasActive = active_ >= 0 && active_ < static_cast<int>(traces.size());
  const PixelTrace* active = hasActive ? &traces[static_cast<std::size_t>(active_)].trace : nullptr;
  const std::vector<ChartMark> marks = plotMarks(active, cuts_, restarts_);
  for (std::size_t row = 0; row < charts_.size(); ++row) {
    charts_[row]->setBounds({0.0, frameCount_ - 1.0});
    charts_[row]->setMarks(marks);
    charts_[row]->setCurves(plotCurves(rows_[row], traces, space_));
  }
  fill_->setVisible(!probes_.empty());
  if (!active) {
    summary_->setWhole({});
    return;
  }
  const qsizetype known = static_cast<qsizetype>(active->samples().size());
  summary_->setWhole(tr("Frames known at probe %3: %1 of %2 · × history rejected there")
                         .arg(known)
                         .arg(frameCount_)
                         .arg(active_ + 1),
                     {tr("%1 of %2 frames").arg(known).arg(frameCount_)});
}

QString PlotsPanel::csv() const {
  std::vector<IntermediateId> ids;
  for (const PlotRow& row : rows_) {
    ids.push_back(row.id);
    if (row.beside) ids.push_back(*row.beside);
  }
  return QString::fromStdString(traceCsv(probeTraces(), ids, space_));
}

void PlotsPanel::copyCsv() {
  QApplication::clipboard()->setText(csv());
}

void PlotsPanel::saveCsv() {
  auto* dialog = new QFileDialog(this, tr("Save values as CSV"), QString(), tr("CSV files (*.csv)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(QStringLiteral("csv"));
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
    if (const QString error = saveCsvTo(path); !error.isEmpty()) Q_EMIT failed(error);
  });
  dialog->open();
}

QString PlotsPanel::saveCsvTo(const QString& path) const {
  try {
    writeFile(path.toStdString(), csv().toStdString()); // nothing half-written
    return {};
  } catch (const Error& error) {
    return QString::fromUtf8(error.what());
  }
}

QString PlotsPanel::summary() const {
  return summary_->whole();
}

QJsonObject PlotsPanel::state() const {
  QJsonObject state{{QStringLiteral("rows"), toJson(rows_)}};
  if (shown_ != wholeShot()) state[QStringLiteral("frames")] = QJsonArray{shown_.low, shown_.high};
  return state;
}

void PlotsPanel::setState(const QJsonObject& state) {
  const QJsonValue rows = state.value(QLatin1String("rows"));
  const QJsonArray frames = state.value(QLatin1String("frames")).toArray();
  const double low = frames.at(0).toDouble(-1.0), high = frames.at(1).toDouble(-1.0);
  const Span whole = wholeShot();
  const Span shown = low >= whole.low && high > low && high <= whole.high ? Span{low, high} : whole;
  setRows(rows.isArray() ? plotRowsFromJson(rows.toArray()) : firstPlotRows());
  setShown(shown);
}

void PlotsPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (event->spontaneous()) return;
  refresh();
  placeCharts();
  Q_EMIT shownChanged(true);
}

void PlotsPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  placeCharts();
}

void PlotsPanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  if (!event->spontaneous()) Q_EMIT shownChanged(false);
}

} // namespace taa::app
