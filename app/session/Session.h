// What the window works on: requests go to the render thread, its answers arrive here as signals.
#pragma once

#include "app/session/Asked.h"
#include "app/session/Mailbox.h"
#include "app/session/Pins.h"
#include "app/session/Renderer.h"
#include "app/session/UndoStack.h"
#include "core/io/SessionFile.h"

#include <QJsonObject>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>

#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace taa::app {

/// The settings in force and the preset they come from, which is gone back to.
struct PresetChoice {
  Settings settings, presetSettings;
  std::string presetId;
  bool operator==(const PresetChoice&) const = default;
};

/// Lives on the UI thread and never waits. No exception leaves a member: errors become errorOccurred().
class Session : public QObject {
  Q_OBJECT
 public:
  using MakeRenderer = std::function<std::unique_ptr<Renderer>(Listener)>;
  explicit Session(const MakeRenderer& makeRenderer = makeRenderThread, QObject* parent = nullptr);
  ~Session() override;

  // State; what has not arrived yet is empty
  const Status& status() const { return status_; }
  const Work& work() const { return work_; }
  /// What last arrived for the active pin, or for another.
  const ProbeResult* probe() const { return pins_.result(pins_.active()); }
  const ProbeResult* probe(int pin) const { return pins_.result(pin); }
  const std::shared_ptr<const ViewResult>& picture(int view) const;
  /// What another size takes with these settings and views: "about 155 MiB".
  QString memoryText(const glm::ivec2& sizePx) const;
  /// The settings asked for, which the picture may not show yet.
  const Settings& settings() const { return chosen_.settings; }
  const std::string& presetId() const { return chosen_.presetId; }
  const Settings& presetSettings() const { return chosen_.presetSettings; }
  bool isPresetChanged() const;
  const std::vector<ProbePin>& pins() const { return pins_.all(); }
  int activePin() const { return pins_.active(); } ///< −1: there is none
  std::vector<PinMark> pinMarks() const { return pins_.marks(); }
  /// Where the active pin is now.
  std::optional<glm::ivec2> pick() const;
  bool isLooping() const { return looping_; }
  /// As asked for.
  const Playback& playback() const { return playback_; }
  /// Of all that is open, the window's views and marks included.
  UndoStack& undoStack() { return undo_; }
  /// Something was opened, and its status has arrived.
  bool isOpen() const { return status_.frameCount > 0; }

  // Wishes
  /// Plays once it is open, or waits at frame 0.
  void open(const QString& source, bool plays = true);
  void setSize(int width, int height);
  void setCamera(const QString& name);
  /// Which motion the objects of this name are given, while this scene is open.
  void setMotionMode(const std::string& object, MotionMode mode);
  void setMotionModes(const std::vector<MotionOverride>& modes);
  const std::vector<MotionOverride>& motionModes() const { return motionModes_.value(); }
  void setPlaying(bool playing);
  void togglePlaying();
  void setLooping(bool looping);
  void setPlayback(const Playback& playback);
  void setTracing(bool tracing);
  void fillTraces(int first, int last);
  void seek(int frame);
  void step(int frames); ///< pauses
  void setParameter(const QString& path, double value);
  void setPreset(const QString& idOrPath);
  /// Somebody looks at this choice and may take it: when they stay, what it needs is compiled ahead.
  void prepareParameter(const QString& path, double value);
  void preparePreset(const QString& idOrPath);
  void backToPreset();
  /// Saves the present settings in `folder` and goes on from them.
  void savePreset(const QString& folder, const QString& label);
  void undo() { undo_.undo(); }
  void redo() { undo_.redo(); }
  void setViews(const std::vector<ViewRequest>& views);
  // Probes are pinned, up to kMostPins of them; one is active
  /// Sets the active pin there, the first one when there is none; nothing: removes it.
  void setPick(std::optional<glm::ivec2> pixel);
  void movePick(int dx, int dy);
  /// Pins another, which becomes active.
  void addPin(glm::ivec2 pixel, Follow follow = Follow::Screen);
  void removePin(int pin);
  void removeAllPins();
  void setActivePin(int pin);
  /// What a pin stays on from now on; begins where it is now.
  void setFollow(int pin, Follow follow);
  void setPins(const std::vector<ProbePin>& pins, int active);
  /// Whether probes come with the active pixel under other choices.
  void setWhatIf(bool wanted);
  /// Memory for histories that are kept, of all lanes together.
  void setCheckpointBudget(std::size_t bytes);
  void setProfiling(bool profiling);
  void measureStages();
  void setThumbnails(int width, int height);           ///< 0: none
  void setReferenceSamples(int samples);               ///< see RenderThread
  void setFigures(const std::vector<Figure>& figures); ///< arrive by figuresArrived
  /// Presets that views are compared with: lanes 1, 2 … next to that of the settings.
  void setOtherPresets(const QStringList& idsOrPaths);
  const std::vector<Settings>& otherLanes() const { return otherLanes_; } ///< their settings
  void reloadShaders();
  void cancel();
  void exportSequence(const SequenceRequest& request);
  /// What the picture depends on; `window` is left empty.
  SessionFile file() const;
  /// Opens what the file says, paused at its frame; where that cannot be opened, goes back to what was open.
  void restore(const SessionFile& file);

  // The scene and the camera that is flown
  /// As nodeKey() names them; also what is below them.
  void setHidden(const std::string& object, bool hidden);
  void setIsolated(const std::vector<std::string>& objects); ///< none: all are drawn
  void setObjectFilter(const ObjectFilter& filter);
  /// The class of these objects and of what is below them; nothing: that of what moves them.
  void setObjectClass(const std::string& object, std::optional<ObjectClass> objectClass);
  void setObjectClasses(const std::vector<ClassOverride>& classes);
  const std::vector<ClassOverride>& objectClasses() const { return classes_.value(); }
  /// Which of these are hidden or isolated, by the wishes so far.
  const ObjectFilter& objectFilter() const { return filter_.value(); }
  /// Frames at which history starts anew, rising, by the wishes so far.
  const std::vector<int>& restarts() const { return restarts_.value(); }
  void toggleRestart(int frame);
  void removeRestarts();
  void setRestarts(const std::vector<int>& frames);
  /// The camera is there after it moved for so long.
  void fly(const CameraPose& pose, std::chrono::duration<double> took = {});
  void setRecording(bool recording);
  void addCameraTrack(const CameraTrack& track);
  // Of flown cameras; undo takes it back
  void removeCamera(const std::string& name);
  /// False where the name is empty or taken.
  bool renameCamera(const std::string& name, const std::string& newName);
  /// The scene's camera that was left for a flown one, or the one it opens with.
  void backToSceneCamera();
  /// Where these objects are seen is told from now on.
  void locate(const std::vector<int>& objects);
  /// All flown cameras, which a SessionFile has one of at most; to be set after open().
  QJsonObject sceneState() const;
  void setSceneState(const QJsonObject& state);

 Q_SIGNALS:
  void statusChanged();
  void settingsChanged();
  void playbackChanged();
  void traceArrived(const TraceDelivery& trace);
  void pictureArrived(int view);
  void probeArrived(); ///< of at least one pin
  void pickChanged();  ///< a pin was set, removed, or made active
  void workChanged();
  void profileArrived(const FrameProfile& profile);
  void stageCostsArrived(const StageCosts& costs);
  void thumbnailArrived(const Thumbnail& thumbnail);
  void figuresArrived(const FrameFigures& figures);
  void shadersReloaded(const QString& error); ///< empty: they are in use
  void exported(const ExportResult& result);
  void objectAreaArrived(const ObjectArea& area);
  void stageSharesArrived(const StageShares& shares);
  void errorOccurred(const QString& sentence);
  void openingFailed(); ///< of what was opened last; what was open still is

 private:
  void deliver();
  void refuse(const Failure& failure);
  void useStatus(Status&& status);
  void takeSettings();
  void takeSceneStatus();
  void use(const PresetChoice& choice);
  void change(const PresetChoice& choice, const QString& what, const std::string& key = {});
  void replaceCamera(const std::optional<CameraTrack>& before, const std::optional<CameraTrack>& after);
  void useCameras(const FlownCameras& cameras);
  void noteCameras(const QString& what, const std::string& key = {});
  void noteScene(UndoStep step, const QString& what);
  template <class Value>
  void noteAsked(const Asked<Value>& asked, const Value& value, void (Session::*set)(const Value&),
                 const QString& what);
  void consider(const Settings& settings);
  RequestId ask(Request request);
  void apply(const SessionFile& file);
  void guarded(const std::function<void()>& act);
  void sendPins();
  void changePins(const QString& what, const std::string& key, const std::function<bool()>& change);
  glm::ivec2 inPicture(glm::ivec2 pixel) const;
  void keepPinsInPicture();

  Mailbox mailbox_;
  Status status_;
  Work work_;
  Pins pins_;
  bool wantsWhatIf_ = false;
  std::array<std::shared_ptr<const ViewResult>, kViewCount> pictures_;
  PresetChoice chosen_, chosenInForce_; ///< what was asked for; what has arrived of it
  Asked<Settings> settings_;
  Settings considered_;
  QTimer stays_; ///< runs out when somebody has looked at `considered_` for long enough
  UndoStack undo_;
  Asked<std::vector<MotionOverride>> motionModes_;
  Asked<ObjectFilter> filter_;
  Asked<std::vector<ClassOverride>> classes_;
  Asked<std::vector<int>> restarts_;
  Asked<FlownCameras> flown_;
  std::string sceneCamera_; ///< the last one that was not flown
  std::vector<ViewRequest> views_;
  QStringList otherPresets_;
  std::vector<Settings> otherLanes_;
  bool looping_ = true, playsWhenOpen_ = false;
  RequestId opening_ = 0;                    ///< the last request to open something
  std::optional<SessionFile> beforeOpening_; ///< what a session was opened in place of
  Playback playback_;
  bool tracing_ = false;
  std::unique_ptr<Renderer> renderer_; ///< last: ends before what its results are put into
};

} // namespace taa::app
