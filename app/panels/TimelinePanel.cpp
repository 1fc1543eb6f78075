#include "app/panels/TimelinePanel.h"

#include "app/style/Numbers.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "app/views/timeline/Timeline.h"
#include "app/widgets/IconButton.h"
#include "app/widgets/parameters/ChoiceButton.h"
#include "app/widgets/parameters/NumberField.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace taa::app {

void PlaybackRate::note(int frame, double seconds) {
  constexpr double kWindow = 1.0; // seconds
  if (!shown_.empty() && shown_.back().first == frame) return;
  shown_.emplace_back(frame, seconds);
  while (shown_.size() > 2 && shown_.front().second < seconds - kWindow) shown_.pop_front();
}

std::optional<double> PlaybackRate::value() const {
  if (shown_.size() < 2) return {};
  const double took = shown_.back().second - shown_.front().second;
  if (took <= 0.0) return {};
  return static_cast<double>(shown_.size() - 1) / took;
}

TimelinePanel::TimelinePanel(QWidget* parent) : QWidget(parent) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(2 * kUnit, kUnit, 2 * kUnit, kUnit);
  layout->setSpacing(2);
  makeButtons();
  timeline_ = new Timeline;
  connect(timeline_, &Timeline::seekRequested, this, &TimelinePanel::seekRequested);
  connect(timeline_, &Timeline::stepRequested, this, &TimelinePanel::stepRequested);
  timeline_->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(timeline_, &QWidget::customContextMenuRequested, this,
          [this](const QPoint& place) { offerMetrics(timeline_->mapToGlobal(place)); });
  layout->addSpacing(2 * kUnit);
  layout->addWidget(timeline_, 1);
  layout->addSpacing(2 * kUnit);
  connect(timeline_, &Timeline::rangeEdited, this, [this](int first, int last) {
    setRange(FrameSpan{first, last});
  });
  // Two lines, so that the ruler is as long as it can be.
  auto* lines = new QVBoxLayout;
  lines->setSpacing(0);
  layout->addLayout(lines);
  auto* upper = new QHBoxLayout;
  upper->setSpacing(2);
  auto* lower = new QHBoxLayout;
  lines->addLayout(upper);
  lines->addLayout(lower);
  makeChoices(upper);
  makeFrameField(upper);
  jitter_ = makeReadout(QStringLiteral("jitter 16 of 16 (−0.00, −0.00)"), lower);
  jitter_->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  jitter_->setToolTip(
      tr("Place in the jitter pattern, and the displacement of the picture in px (x right, y down)"));
  lower->addStretch(1);
  time_ = makeReadout(QStringLiteral("t = 00.000 s"), lower);
  time_->setToolTip(
      tr("Time of the shot; while it plays the frames that are shown a second, of those wished for"));
  clock_.start();
}

void TimelinePanel::makeButtons() {
  const auto add = [this](const char* icon, const QString& tip, auto act) {
    auto* button = new IconButton(QLatin1String(icon), tip);
    connect(button, &IconButton::clicked, this, act);
    static_cast<QHBoxLayout*>(layout())->addWidget(button);
    return button;
  };
  add("first", tr("First frame (Home)"), [this] { Q_EMIT seekRequested(0); });
  add("previous", tr("One frame back (,)"), [this] { Q_EMIT stepRequested(-1); });
  play_ = add("play", tr("Play or pause (Space)"), [this] { Q_EMIT playToggled(); });
  play_->setObjectName(QStringLiteral("play"));
  add("next", tr("One frame on (.)"), [this] { Q_EMIT stepRequested(1); });
  add("last", tr("Last frame (End)"), [this] { Q_EMIT seekRequested(std::max(0, frameCount_ - 1)); });
  loop_ =
      add("loop", tr("Start again at the end (Ctrl+L)"), [this] { Q_EMIT loopToggled(loop_->isChecked()); });
  loop_->setCheckable(true);
}

const std::vector<double>& TimelinePanel::speeds() {
  static const std::vector<double> speeds{0.05, 0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0};
  return speeds;
}

const std::vector<double>& TimelinePanel::rates() {
  static const std::vector<double> rates{0.0, 24.0, 25.0, 30.0, 50.0, 60.0, 90.0, 120.0, 144.0, 240.0};
  return rates;
}

void TimelinePanel::makeChoices(QBoxLayout* line) {
  const auto add = [line](const QString& name, const QString& tip) {
    auto* button = new ChoiceButton;
    button->setFlat(true);
    button->setFont(secondaryFont());
    button->setAccessibleName(name);
    button->setToolTip(tip);
    button->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    line->addWidget(button);
    return button;
  };
  speed_ = add(tr("Speed"), tr("How fast it plays (Ctrl+[ slower, Ctrl+] faster)"));
  speed_->setObjectName(QStringLiteral("speed"));
  QStringList labels;
  for (const double speed : speeds()) labels << tr("%1×").arg(speed);
  speed_->setChoices(labels);
  rate_ = add(tr("Frames per second"),
              tr("Frames shown a second at speed 1; the shot's own time stays as it is"));
  rate_->setObjectName(QStringLiteral("rate"));
  connect(speed_, &ChoiceButton::chosen, this,
          [this](int index) { setSpeed(speeds()[static_cast<std::size_t>(index)]); });
  connect(rate_, &ChoiceButton::chosen, this,
          [this](int index) { setFramesPerSecond(rates()[static_cast<std::size_t>(index)]); });
  showRates();
}

// The shot's own rate stands in the list as a number, too.
void TimelinePanel::showRates() {
  QStringList labels;
  for (const double rate : rates())
    labels << (rate > 0.0        ? tr("%1 fps").arg(rate)
               : shotRate_ > 0.0 ? tr("shot: %1 fps").arg(shotRate_)
                                 : tr("shot's fps"));
  rate_->setChoices(labels);
  const auto indexOf = [](const std::vector<double>& values, double value) {
    const auto found = std::ranges::find(values, value);
    return found == values.end() ? -1 : static_cast<int>(found - values.begin());
  };
  rate_->setCurrent(indexOf(rates(), playback_.framesPerSecond));
  rate_->setCaption(rate_->current() >= 0 ? QString() : tr("%1 fps").arg(playback_.framesPerSecond));
  speed_->setCurrent(indexOf(speeds(), playback_.speed));
  speed_->setCaption(speed_->current() >= 0 ? QString() : tr("%1×").arg(playback_.speed));
}

QLabel* TimelinePanel::makeReadout(const QString& widest, QBoxLayout* line) {
  auto* label = new QLabel;
  label->setFont(numberFont());
  label->setMinimumWidth(QFontMetrics(numberFont()).horizontalAdvance(widest) + kUnit);
  label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  line->addWidget(label);
  return label;
}

void TimelinePanel::makeFrameField(QBoxLayout* line) {
  auto* name = new QLabel(tr("frame"));
  name->setFont(secondaryFont());
  line->addStretch(1);
  line->addWidget(name);
  frame_ = new NumberField({0, 1, true});
  frame_->setAccessibleName(tr("Frame"));
  frame_->setObjectName(QStringLiteral("frame"));
  frame_->setToolTip(tr("Go to a frame (G)"));
  frame_->setMaximumWidth(56);
  connect(frame_, &NumberField::valueEdited, this,
          [this](double value) { Q_EMIT seekRequested(static_cast<int>(value)); });
  line->addWidget(frame_);
  count_ = makeReadout(QStringLiteral("of 000"), line);
  count_->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
}

void TimelinePanel::setStatus(const Status& status) {
  if (const QString source = QString::fromStdString(status.source); source != source_) {
    source_ = source;
    showNotes();
  }
  if (status.cuts != cuts_) timeline_->setCuts(cuts_ = status.cuts);
  timeline_->setRestarts(restarts_ = status.restarts);
  if (status.framesPerSecond != shotRate_) {
    shotRate_ = status.framesPerSecond;
    showRates();
  }
  timeline_->setKept(status.keptFrames);
  frameCount_ = status.frameCount;
  timeline_->setFrameCount(status.frameCount);
  const int frame = status.goal.value_or(status.info.frame); // stays under the mouse
  timeline_->setFrame(frame);
  play_->setIconName(status.playing ? QStringLiteral("pause") : QStringLiteral("play"));
  frame_->setScale({0, std::max(1.0, status.frameCount - 1.0), true});
  frame_->setValue(frame);
  count_->setText(tr("of %1").arg(status.frameCount));
  const FrameInfo& info = status.info;
  jitter_->setText(status.jitterPeriod > 1 ? tr("jitter %1 of %2 (%3, %4)")
                                                 .arg(info.jitterIndex)
                                                 .arg(status.jitterPeriod)
                                                 .arg(fixedText(static_cast<double>(info.jitterPx.x), 2),
                                                      fixedText(static_cast<double>(info.jitterPx.y), 2))
                                           : tr("no jitter"));
  time_->setText(timeText(status));
}

// While it plays how fast that really is: a slow machine shows every frame, later.
QString TimelinePanel::timeText(const Status& status) {
  if (!status.playing) {
    shownRate_.stop();
    return tr("t = %1 s").arg(status.info.time, 0, 'f', 3);
  }
  shownRate_.note(status.info.frame, 1e-3 * static_cast<double>(clock_.elapsed()));
  const double rate = playback_.framesPerSecond > 0.0 ? playback_.framesPerSecond : shotRate_;
  const auto shown = shownRate_.value();
  const QString wanted = shortText(rate * playback_.speed);
  return shown ? tr("%1 of %2 fps").arg(shortText(*shown, *shown < 10.0 ? 2 : 3), wanted)
               : tr("%1 fps").arg(wanted);
}

void TimelinePanel::setLooping(bool looping) {
  loop_->setChecked(looping);
}

void TimelinePanel::setStripMetric(std::optional<Metric> metric) {
  if (metric == stripMetric_) return;
  stripMetric_ = metric;
  if (!stripMetric_) timeline_->setStrip({});
  Q_EMIT metricChosen(stripMetric_);
}

void TimelinePanel::offerMetrics(const QPoint& place) {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  const auto offer = [&](const QString& text, std::optional<Metric> metric) {
    QAction* action = menu->addAction(text, this, [this, metric] { setStripMetric(metric); });
    action->setCheckable(true);
    action->setChecked(metric == stripMetric_);
  };
  offer(tr("No metric under the ruler"), {});
  for (const MetricInfo& info : kMetrics) offer(qtext(info.label), info.metric);
  menu->popup(place);
}

void TimelinePanel::setStrip(const TimelineStrip& strip) {
  timeline_->setStrip(strip);
}

int TimelinePanel::frame() const {
  return timeline_->frame();
}

void TimelinePanel::setPlayback(const Playback& playback) {
  if (playback == playback_) return;
  playback_ = playback;
  showRates();
  timeline_->setRange(playback_.range);
  Q_EMIT playbackEdited(playback_);
}

void TimelinePanel::setSpeed(double speed) {
  Playback changed = playback_;
  changed.speed = std::clamp(speed, kSlowestPlayback, kFastestPlayback);
  setPlayback(changed);
}

void TimelinePanel::changeSpeed(int steps) {
  const auto place = std::ranges::lower_bound(speeds(), playback_.speed) - speeds().begin();
  const auto most = static_cast<std::ptrdiff_t>(speeds().size()) - 1;
  setSpeed(speeds()[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(place + steps, 0, most))]);
}

void TimelinePanel::setFramesPerSecond(double rate) {
  Playback changed = playback_;
  changed.framesPerSecond = rate > 0.0 ? std::clamp(rate, 1.0, 1000.0) : 0.0;
  setPlayback(changed);
}

void TimelinePanel::setRange(std::optional<FrameSpan> range) {
  notes().range = range;
  Playback changed = playback_;
  changed.range = range;
  setPlayback(changed);
}

void TimelinePanel::setRangeEnd(bool isLast) {
  setRange(withEnd(timeline_->range(), isLast, frame()));
}

void TimelinePanel::clearRange() {
  setRange({});
}

ShotNotes& TimelinePanel::notes() {
  return notes_[source_];
}

const FrameMarks& TimelinePanel::marks() const {
  static const FrameMarks none;
  const auto found = notes_.find(source_);
  return found == notes_.end() ? none : found->second.marks;
}

// After something else was opened, or notes were read from a file.
void TimelinePanel::showNotes() {
  timeline_->setMarks(marks().all());
  Playback changed = playback_;
  const auto found = notes_.find(source_);
  changed.range = found == notes_.end() ? std::nullopt : found->second.range;
  setPlayback(changed);
  Q_EMIT marksChanged();
}

void TimelinePanel::toggleMark() {
  notes().marks.toggle(frame());
  showNotes();
}

void TimelinePanel::nameMark(const QString& name) {
  notes().marks.setName(frame(), name.trimmed());
  showNotes();
}

void TimelinePanel::goToMark(bool after) {
  std::vector<int> frames = cuts_;
  frames.insert(frames.end(), restarts_.begin(), restarts_.end());
  for (const auto& [frame, name] : marks().all()) frames.push_back(frame);
  if (const auto found = neighborOf(frame(), frames, after)) Q_EMIT seekRequested(*found);
}

QJsonObject TimelinePanel::state() const {
  QJsonObject shots;
  for (const auto& [source, notes] : notes_)
    if (notes != ShotNotes{}) shots.insert(source, notes.toJson());
  return {{QStringLiteral("speed"), playback_.speed},
          {QStringLiteral("framesPerSecond"), playback_.framesPerSecond},
          {QStringLiteral("loops"), loop_->isChecked()},
          {QStringLiteral("metric"), stripMetric_ ? qtext(metricInfo(*stripMetric_).id) : QString()},
          {QStringLiteral("shots"), shots}};
}

void TimelinePanel::setState(const QJsonObject& state) {
  setSpeed(state.value(QLatin1String("speed")).toDouble(1.0));
  setFramesPerSecond(state.value(QLatin1String("framesPerSecond")).toDouble(0.0));
  setLooping(state.value(QLatin1String("loops")).toBool(true));
  Q_EMIT loopToggled(loop_->isChecked());
  setStripMetric(findMetric(state.value(QLatin1String("metric")).toString().toStdString()));
  notes_.clear();
  const QJsonObject shots = state.value(QLatin1String("shots")).toObject();
  for (auto shot = shots.begin(); shot != shots.end(); ++shot)
    notes_[shot.key()] = ShotNotes::fromJson(shot.value().toObject());
  showNotes();
}

QString TimelinePanel::readout() const {
  return QStringLiteral("frame %1 %2  %3  %4")
      .arg(QString::number(frame_->value()), count_->text(), jitter_->text(), time_->text());
}

} // namespace taa::app
