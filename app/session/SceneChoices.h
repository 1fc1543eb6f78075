// What is changed in the scene that is open: hidden objects, motion modes, classes, restarts, and cameras,
// the one that is flown included.
#pragma once

#include "app/session/Pending.h"
#include "core/requests/Results.h"

#include <QJsonObject>
#include <QObject>
#include <QString>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace taa::app {

class Outbox;
class UndoStack;
struct UndoStep;

class SceneChoices : public QObject {
  Q_OBJECT
 public:
  /// `status` is that of the frame on show; it outlives this.
  SceneChoices(Outbox& outbox, UndoStack& undo, const Status& status);

  /// Why cameras, objects and size cannot be chosen: a capture is open. Empty: they can.
  QString whyFixed() const;
  /// Why no probe can follow a surface; empty: it can.
  QString whyNoSurfaces() const;
  /// Why there is no output of an engine to compare with; empty: there is one.
  QString whyNoEngineOutput() const;

  // Objects, while this scene is open; named as by nodeKey(), and with what is below them
  /// Which are hidden or isolated, by the requests so far.
  const ObjectFilter& objectFilter() const { return filter_.value(); }
  void setHidden(const std::string& object, bool hidden);
  void setIsolated(const std::vector<std::string>& objects); ///< empty draws all
  void setObjectFilter(const ObjectFilter& filter);
  const std::vector<MotionOverride>& motionModes() const { return motionModes_.value(); }
  /// Which motion the objects of this name are given.
  void setMotionMode(const std::string& object, MotionMode mode);
  void setMotionModes(const std::vector<MotionOverride>& modes);
  const std::vector<ClassOverride>& objectClasses() const { return classes_.value(); }
  /// The class of these objects; nothing: that of what moves them.
  void setObjectClass(const std::string& object, std::optional<ObjectClass> objectClass);
  void setObjectClasses(const std::vector<ClassOverride>& classes);
  /// Where these objects are seen is told from now on.
  void locate(const std::vector<int>& objects);

  /// Frames at which history starts anew, rising, by the requests so far.
  const std::vector<int>& restarts() const { return restarts_.value(); }
  void toggleRestart(int frame);
  void removeRestarts();
  void setRestarts(const std::vector<int>& frames);

  // Cameras
  void setCamera(const QString& name);
  /// The last one that was not flown.
  const std::string& sceneCamera() const { return sceneCamera_; }
  /// The scene's camera that was left for a flown one, or the one it opens with.
  void backToSceneCamera();
  /// The camera is there after it moved for so long.
  void fly(const CameraPose& pose, std::chrono::duration<double> took = {});
  void setRecording(bool recording);
  void addCameraTrack(const CameraTrack& track);
  void removeCamera(const std::string& name); ///< a flown one
  /// Of a flown one; false where the name is empty or taken.
  bool renameCamera(const std::string& name, const std::string& newName);
  /// All flown cameras, which a SessionFile has one of at most; to be set after Session::open().
  QJsonObject state() const;
  void setState(const QJsonObject& state);

  // For the session
  /// The status was replaced.
  void takeStatus();
  void refused(RequestId request);
  /// Requests before this one were of another scene.
  void giveUpBefore(RequestId opened);

 private:
  template <class Act>
  void forEachPending(const Act& act);
  void note(UndoStep step, const QString& what);
  template <class Value>
  void noteChange(const Pending<Value>& pending, const Value& value, void (SceneChoices::*set)(const Value&),
                  const QString& what);
  void noteCameras(const QString& what, const std::string& key = {});
  void useCameras(const FlownCameras& cameras);
  void replaceCamera(const std::optional<CameraTrack>& before, const std::optional<CameraTrack>& after);

  Outbox& outbox_;
  UndoStack& undo_;
  const Status& status_;
  Pending<std::vector<MotionOverride>> motionModes_;
  Pending<ObjectFilter> filter_;
  Pending<std::vector<ClassOverride>> classes_;
  Pending<std::vector<int>> restarts_;
  Pending<FlownCameras> flown_;
  std::string sceneCamera_;
};

} // namespace taa::app
