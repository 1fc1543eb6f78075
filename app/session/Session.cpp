#include "app/session/Session.h"

#include "app/session/UserPresets.h"
#include "app/style/Text.h"
#include "core/base/Error.h"
#include "core/inspect/MemoryNeed.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"

#include <algorithm>
#include <exception>
#include <limits>
#include <utility>

namespace taa::app {

namespace {
constexpr int kStayMs = 60; // a mouse that only passes stays less
} // namespace

Session::Session(const MakeRenderer& makeRenderer, QObject* parent)
    : QObject(parent),
      mailbox_([this] { QMetaObject::invokeMethod(this, &Session::deliver, Qt::QueuedConnection); }) {
  guarded([&] {
    const Preset& first = builtinPresets().front();
    chosen_ = chosenInForce_ = {first.settings, first.settings, first.id};
    settings_ = Asked<Settings>(first.settings);
  });
  guarded([&] { renderer_ = makeRenderer([this](Answer answer) { mailbox_.put(std::move(answer)); }); });
  stays_.setSingleShot(true);
  stays_.setInterval(kStayMs);
  connect(&stays_, &QTimer::timeout, this, [this] { ask(request::Prepare{considered_}); });
}

Session::~Session() {
  renderer_.reset();
}

const std::shared_ptr<const ViewResult>& Session::picture(int view) const {
  return pictures_.at(static_cast<std::size_t>(view));
}

QString Session::memoryText(const glm::ivec2& sizePx) const {
  std::vector<IntermediateId> watched;
  for (const std::shared_ptr<const ViewResult>& picture : pictures_)
    if (picture && std::ranges::find(watched, picture->request.id) == watched.end())
      watched.push_back(picture->request.id);
  std::vector<Settings> lanes{chosen_.settings};
  lanes.insert(lanes.end(), otherLanes_.begin(), otherLanes_.end());
  const std::size_t bytes = memoryNeed(lanes, sizePx, watched).total();
  return tr("about %1").arg(QString::fromStdString(bytesText(bytes)));
}

bool Session::isPresetChanged() const {
  return !(chosen_.settings == chosen_.presetSettings);
}

void Session::guarded(const std::function<void()>& act) {
  try {
    act();
  } catch (const std::exception& error) {
    // Queued, so that a window that is being built has time to listen.
    QMetaObject::invokeMethod(
        this, [this, sentence = QString::fromUtf8(error.what())] { Q_EMIT errorOccurred(sentence); },
        Qt::QueuedConnection);
  }
}

// 0: it was not asked.
RequestId Session::ask(Request request) {
  RequestId id = 0;
  if (renderer_) guarded([&] { id = renderer_->post(std::move(request)); });
  return id;
}

void Session::deliver() {
  Delivery delivery = mailbox_.take();
  for (const Failure& failure : delivery.errors) refuse(failure);
  if (delivery.status) useStatus(std::move(*delivery.status));
  if (delivery.work) {
    work_ = std::move(*delivery.work);
    Q_EMIT workChanged();
  }
  for (int view = 0; view < kViewCount; ++view)
    if (auto& picture = delivery.pictures[static_cast<std::size_t>(view)]) {
      pictures_[static_cast<std::size_t>(view)] = std::make_shared<const ViewResult>(std::move(*picture));
      Q_EMIT pictureArrived(view);
    }
  bool hasProbes = false;
  for (ProbeResult& probe : delivery.probes) hasProbes = pins_.take(std::move(probe)) || hasProbes;
  if (hasProbes) Q_EMIT probeArrived();
  for (const FrameProfile& profile : delivery.profiles) Q_EMIT profileArrived(profile);
  if (delivery.costs) Q_EMIT stageCostsArrived(*delivery.costs);
  for (const TraceDelivery& trace : delivery.traces) Q_EMIT traceArrived(trace);
  for (const Thumbnail& thumbnail : delivery.thumbnails) Q_EMIT thumbnailArrived(thumbnail);
  for (const FrameFigures& figures : delivery.figures) Q_EMIT figuresArrived(figures);
  if (delivery.shaders) Q_EMIT shadersReloaded(QString::fromStdString(delivery.shaders->error));
  if (delivery.exported) Q_EMIT exported(*delivery.exported);
  if (delivery.shares) Q_EMIT stageSharesArrived(*delivery.shares);
  if (delivery.area) Q_EMIT objectAreaArrived(*delivery.area);
}

// What else was asked for is not concerned.
void Session::refuse(const Failure& failure) {
  Q_EMIT errorOccurred(QString::fromStdString(failure.sentence));
  const RequestId request = failure.request;
  settings_.refused(request);
  motionModes_.refused(request);
  filter_.refused(request);
  classes_.refused(request);
  restarts_.refused(request);
  flown_.refused(request);
  if (failure.kind != RequestKind::Source || request != opening_) return;
  if (const auto before = std::exchange(beforeOpening_, {})) apply(*before);
  Q_EMIT openingFailed();
}

// Settings that were refused give way to those in force.
void Session::takeSettings() {
  settings_.arrived(status_.settings);
  if (settings_.waits()) return;
  if (chosen_.settings == settings_.value()) {
    chosenInForce_ = chosen_;
    return;
  }
  chosen_ = chosenInForce_;
  chosen_.settings = settings_.value();
  Q_EMIT settingsChanged();
}

void Session::useStatus(Status&& status) {
  const bool isNew = status.source != status_.source;
  if (status.opened != status_.opened) { // all that was asked before was asked of another scene
    motionModes_.giveUpBefore(status.opened);
    filter_.giveUpBefore(status.opened);
    flown_.giveUpBefore(status.opened);
    classes_.giveUpBefore(status.opened);
    restarts_.giveUpBefore(status.opened);
    undo_.forgetScene();
    if (status.opened == opening_ && std::exchange(beforeOpening_, {}))
      undo_.clear(); // what was changed before is of another session
  }
  if (isNew && pins_.forgetSurfaces()) sendPins();
  status_ = std::move(status);
  takeSettings();
  takeSceneStatus();
  // Only now: a file that cannot be opened leaves everything as it is, playing or not.
  if (isNew && std::exchange(playsWhenOpen_, false)) setPlaying(true);
  Q_EMIT statusChanged();
  keepPinsInPicture();
}

void Session::open(const QString& source, bool plays) {
  playsWhenOpen_ = plays;
  beforeOpening_.reset();
  opening_ = ask(request::Open{source.toStdString()});
}

void Session::setSize(int width, int height) {
  ask(request::SetSize{width, height});
}

void Session::setCamera(const QString& name) {
  if (name.toStdString() != status_.camera) noteCameras(tr("choice of camera %1").arg(name));
  flown_.giveUp();
  ask(request::SetCamera{name.toStdString()});
}

void Session::setPlaying(bool playing) {
  ask(request::SetPlaying{playing});
}

void Session::togglePlaying() {
  setPlaying(!status_.playing);
}

void Session::setLooping(bool looping) {
  looping_ = looping;
  ask(request::SetLooping{looping});
}

void Session::setTracing(bool tracing) {
  if (std::exchange(tracing_, tracing) == tracing) return;
  ask(request::SetTracing{tracing});
}

void Session::fillTraces(int first, int last) {
  ask(request::FillTraces{first, last});
}

void Session::setPlayback(const Playback& playback) {
  if (playback == playback_) return;
  playback_ = playback;
  ask(request::SetPlayback{playback_});
  Q_EMIT playbackChanged();
}

void Session::seek(int frame) {
  // Before something is open its length is not known; the render thread clamps as well.
  const int last = isOpen() ? status_.frameCount - 1 : std::numeric_limits<int>::max();
  ask(request::Seek{std::clamp(frame, 0, last)});
}

void Session::step(int frames) {
  ask(request::Step{frames});
}

void Session::use(const PresetChoice& choice) {
  if (choice == chosen_) return;
  stays_.stop();
  const bool isNew = !(choice.settings == chosen_.settings);
  chosen_ = choice;
  if (isNew) settings_.ask(choice.settings, ask(request::SetSettings{choice.settings}));
  Q_EMIT settingsChanged(); // also where only the preset's name is another
}

void Session::change(const PresetChoice& choice, const QString& what, const std::string& key) {
  if (choice == chosen_) return;
  UndoStep step = stepBackTo<PresetChoice>(
      chosen_, [this] { return chosen_; }, [this](const PresetChoice& before) { use(before); });
  step.what = what;
  step.key = key;
  use(choice);
  undo_.push(std::move(step));
}

void Session::setParameter(const QString& path, double value) {
  guarded([&] {
    const Parameter& row = parameter(path.toStdString());
    PresetChoice changed = chosen_;
    row.set(changed.settings, value);
    // Numbers are dragged; each choice is one of its own.
    const bool isNumber = row.kind == ParameterKind::Number || row.kind == ParameterKind::Integer;
    change(changed, tr("change of %1").arg(tableText(row.label)),
           isNumber ? std::string(row.path) : std::string());
  });
}

void Session::setPreset(const QString& idOrPath) {
  guarded([&] {
    const Preset preset = taa::preset(idOrPath.toStdString());
    change({preset.settings, preset.settings, preset.id},
           tr("choice of preset %1").arg(tableText(preset.label)));
  });
}

void Session::consider(const Settings& settings) {
  considered_ = settings;
  stays_.start();
}

void Session::prepareParameter(const QString& path, double value) {
  guarded([&] {
    Settings settings = chosen_.settings;
    parameter(path.toStdString()).set(settings, value);
    consider(settings);
  });
}

void Session::preparePreset(const QString& idOrPath) {
  guarded([&] { consider(preset(idOrPath.toStdString()).settings); });
}

void Session::backToPreset() {
  change({chosen_.presetSettings, chosen_.presetSettings, chosen_.presetId}, tr("return to the preset"));
}

void Session::savePreset(const QString& folder, const QString& label) {
  guarded([&] { setPreset(saveUserPreset(folder, label, chosen_.settings)); });
}

void Session::setViews(const std::vector<ViewRequest>& views) {
  if (views == views_) return;
  views_ = views;
  ask(request::SetViews{views_});
}

void Session::setOtherPresets(const QStringList& idsOrPaths) {
  if (idsOrPaths == otherPresets_) return;
  otherPresets_ = idsOrPaths;
  guarded([&] {
    std::vector<Settings> lanes;
    for (const QString& each : idsOrPaths) lanes.push_back(preset(each.toStdString()).settings);
    otherLanes_ = std::move(lanes);
    ask(request::SetOtherLanes{otherLanes_});
  });
}

void Session::setCheckpointBudget(std::size_t bytes) {
  ask(request::SetCheckpointBudget{bytes});
}

void Session::setProfiling(bool profiling) {
  ask(request::SetProfiling{profiling});
}

void Session::measureStages() {
  ask(request::MeasureStages{});
}

void Session::setThumbnails(int width, int height) {
  ask(request::SetThumbnails{width, height});
}

void Session::setReferenceSamples(int samples) {
  ask(request::SetReferenceSamples{samples});
}

void Session::setFigures(const std::vector<Figure>& figures) {
  ask(request::SetFigures{figures});
}

void Session::reloadShaders() {
  ask(request::ReloadShaders{});
}

void Session::cancel() {
  ask(request::Cancel{});
}

} // namespace taa::app
