#include "app/session/Session.h"

#include "core/base/ShownText.h"
#include "core/inspect/MemoryNeed.h"

#include <QJsonObject>

#include <algorithm>
#include <exception>
#include <type_traits>
#include <utility>

namespace taa::app {

Session::Session(const MakeRenderer& makeRenderer, QObject* parent)
    : QObject(parent),
      mailbox_([this] { QMetaObject::invokeMethod(this, &Session::deliver, Qt::QueuedConnection); }),
      outbox_([this](const QString& sentence) {
        // Queued, so that a window that is being built has time to listen.
        const auto tell = [this, sentence] { Q_EMIT errorOccurred(sentence); };
        QMetaObject::invokeMethod(this, tell, Qt::QueuedConnection);
      }) {
  try {
    outbox_.setRenderer(makeRenderer([this](Answer answer) { mailbox_.put(std::move(answer)); }));
  } catch (const std::exception& error) {
    const QString sentence = QString::fromStdString(shownReason(error));
    QMetaObject::invokeMethod(
        this, [this, sentence] { end(sentence); }, Qt::QueuedConnection);
  }
}

Session::~Session() {
  outbox_.setRenderer(nullptr); // it ends before what its answers are put into
}

const std::shared_ptr<const ViewResult>& Session::picture(int view) const {
  return pictures_.at(static_cast<std::size_t>(view));
}

QString Session::memoryText(const glm::ivec2& sizePx) const {
  std::vector<IntermediateId> watched;
  for (const std::shared_ptr<const ViewResult>& picture : pictures_)
    if (picture && std::ranges::find(watched, picture->request.id) == watched.end())
      watched.push_back(picture->request.id);
  std::vector<Settings> lanes{presets_.settings()};
  lanes.insert(lanes.end(), presets_.otherLanes().begin(), presets_.otherLanes().end());
  const std::size_t bytes = memoryNeed(lanes, sizePx, watched).total();
  return tr("about %1").arg(QString::fromStdString(bytesText(bytes)));
}

void Session::deliver() {
  mailbox_.take().forEachList([this]<class T>(std::vector<T>& results) {
    if constexpr (std::is_same_v<T, ProbeResult>)
      probes_.arrived(std::move(results)); // all of them are one arrival
    else
      for (T& each : results) take(std::move(each));
  });
}

void Session::take(Work&& work) {
  work_ = std::move(work);
  Q_EMIT workChanged();
}

void Session::take(ViewResult&& picture) {
  const int view = picture.view;
  if (view < 0 || view >= kViewCount) return;
  pictures_[static_cast<std::size_t>(view)] = std::make_shared<const ViewResult>(std::move(picture));
  Q_EMIT pictureArrived(view);
}

// Other requests are not concerned.
void Session::take(Failure&& failure) {
  if (failure.isEnd) {
    end(QString::fromStdString(failure.sentence));
    return;
  }
  const RequestId request = failure.request;
  const bool isOfOpening = failure.kind == RequestKind::Source && request == opening_;
  if (failure.isChoice) Q_EMIT choiceRefused();
  Q_EMIT errorOccurred(QString::fromStdString(failure.sentence));
  if (isOfOpening) offer(failure.neededBudget);
  presets_.refused(request);
  scene_.refused(request);
  choice_.refused(request);
  if (!isOfOpening) return;
  presets_.showScene(status_.source);
  if (const auto before = std::exchange(beforeOpening_, {})) apply(*before);
  Q_EMIT openingFailed();
}

// What is under way never ends by itself: everybody who says that it goes on hears that it does not.
void Session::end(const QString& sentence) {
  whyEnded_ = sentence;
  work_ = {};
  status_.playing = false;
  if (!isOpen()) {
    const UndoStack::Quiet quiet(undo_);
    probes_.set({}, -1);
  }
  presets_.showScene(status_.source);
  Q_EMIT errorOccurred(sentence);
  Q_EMIT workChanged();
  Q_EMIT statusChanged();
  if (!isOpen() || isOpening()) Q_EMIT openingFailed();
  Q_EMIT ended();
}

void Session::take(Status&& status) {
  const bool isNew = status.source != status_.source;
  if (status.opened != status_.opened) {
    const bool isSame = firstChoice_ != 0 && status.opened >= firstChoice_;
    scene_.giveUpBefore(status.opened);
    choice_.giveUpBefore(status.opened);
    if (!isSame) undo_.forgetScene();
    if (status.opened == opening_ && std::exchange(beforeOpening_, {}) && !isSame)
      undo_.clear(); // what was changed before is of another session
  }
  if (isNew) probes_.forgetSurfaces();
  status_ = std::move(status);
  presets_.arrived(status_.settings, status_.taken.of(RequestKind::Settings));
  scene_.takeStatus();
  choice_.arrived(status_.choice, status_.taken.of(RequestKind::Source));
  // Only now: a file that cannot be opened leaves everything as it is, playing or not.
  if (isNew && std::exchange(playsWhenOpen_, false)) post(request::SetPlaying{true});
  Q_EMIT statusChanged();
  probes_.keepInPicture();
}

void Session::open(const QString& source, bool plays, const ShotChoice& choice) {
  if (!whyEnded_.isEmpty()) {
    Q_EMIT errorOccurred(whyEnded_);
    Q_EMIT openingFailed();
    return;
  }
  playsWhenOpen_ = last_.plays = plays;
  beforeOpening_.reset();
  last_.file = {};
  last_.file.source = source.toStdString();
  last_.file.choice = choice;
  last_.isWhole = false;
  offer({});
  firstChoice_ = 0;
  opening_ = outbox_.post(request::Open{last_.file.source, choice, last_.budgetOf(last_.file.source)});
  choice_.sent(choice, opening_);
  presets_.showScene(last_.file.source);
}

void Session::offer(const std::optional<SceneBudget>& needed) {
  const bool changes = last_.needed.has_value() != needed.has_value();
  last_.needed = needed;
  if (changes) Q_EMIT offersOpening(needed.has_value());
}

void Session::openAnyway() {
  if (!last_.needed) return;
  last_.letIn[last_.file.source] = *last_.needed;
  const SessionFile again = last_.file;
  if (last_.isWhole)
    restore(again);
  else
    open(QString::fromStdString(again.source), last_.plays, again.choice);
}

void Session::choose(const ShotChoice& choice) {
  if (!isOpen() || choice == choice_.value()) return;
  UndoStep step = stepBackTo<ShotChoice>(
      choice_.value(), [this] { return choice_.value(); },
      [this](const ShotChoice& before) { choose(before); });
  step.what = choice.animation == choice_.value().animation ? tr("choice of the shot's length")
                                                            : tr("choice of animation");
  step.isVoid = nullptr; // what was posted may not be there yet
  step.ofScene = true;
  undo_.push(std::move(step));
  const UndoStack::Quiet quiet(undo_);
  const RequestId first = firstChoice_;
  const bool plays = status_.playing;
  const QJsonObject cameras = scene_.state();
  SessionFile next = file();
  next.choice = choice;
  restore(next);
  firstChoice_ = first != 0 ? first : opening_;
  scene_.setState(cameras);
  if (plays) post(request::SetPlaying{true});
}

SessionFile Session::file() const {
  SessionFile file;
  file.source = status_.source;
  file.camera = scene_.sceneCamera();
  file.choice = status_.choice;
  for (const CameraTrackHandle& track : status_.tracks)
    if (track->name == status_.camera) file.track = *track;
  file.filter = scene_.objectFilter();
  file.frame = status_.goal.value_or(status_.info.frame);
  file.size = {status_.width, status_.height};
  file.settings = {presets_.presetId(), presets_.presetSettings(), presets_.settings()};
  file.motionModes = scene_.motionModes();
  file.objectClasses = scene_.objectClasses();
  file.restarts = scene_.restarts();
  file.checkpointsMiB = static_cast<int>(status_.checkpointBudget >> 20);
  return file;
}

void Session::restore(const SessionFile& file) {
  std::optional<SessionFile> before;
  if (isOpen()) before = this->file();
  open(QString::fromStdString(file.source), false, file.choice);
  last_.file = file;
  last_.isWhole = true;
  beforeOpening_ = std::move(before);
  apply(file);
}

void Session::apply(const SessionFile& file) {
  const UndoStack::Quiet quiet(undo_);
  post(request::SetPlaying{false});
  presets_.use({file.settings.settings, file.settings.presetSettings, file.settings.preset});
  post(request::SetSize{file.size.x, file.size.y});
  post(request::SetCheckpointBudget{static_cast<std::size_t>(file.checkpointsMiB) << 20});
  if (file.track)
    scene_.addCameraTrack(*file.track);
  else if (!file.camera.empty())
    scene_.setCamera(QString::fromStdString(file.camera));
  scene_.setObjectFilter(file.filter);
  scene_.setMotionModes(file.motionModes);
  scene_.setObjectClasses(file.objectClasses);
  scene_.setRestarts(file.restarts);
  seek(file.frame);
}

void Session::togglePlaying() {
  post(request::SetPlaying{!status_.playing});
}

void Session::setLooping(bool looping) {
  looping_ = looping;
  post(request::SetLooping{looping});
}

void Session::setTracing(bool tracing) {
  if (std::exchange(tracing_, tracing) == tracing) return;
  post(request::SetTracing{tracing});
}

void Session::setPlayback(const Playback& playback) {
  if (playback == playback_) return;
  playback_ = playback;
  post(request::SetPlayback{playback_});
  Q_EMIT playbackChanged();
}

void Session::seek(int frame) {
  post(request::Seek{frame}); // clamped where it is known what is open by then
}

void Session::setViews(const std::vector<ViewRequest>& views) {
  if (views == views_) return;
  views_ = views;
  post(request::SetViews{views_});
}

} // namespace taa::app
