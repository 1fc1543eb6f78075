// Flying the camera: mouse and keys in the views become poses for the session.
#pragma once

#include "core/scene/camera/CameraTrack.h"

#include <QElapsedTimer>
#include <QObject>
#include <QPointF>
#include <QSet>
#include <QTimer>

#include <string>

class QKeyEvent;
class QMouseEvent;

namespace taa::app {

class Session;
class ViewArea;

/// What keys ask for, −1 to 1 each.
struct FlightKeys {
  int right = 0, up = 0, forward = 0;
  bool isAny() const { return right != 0 || up != 0 || forward != 0; }
};

/// The pose after moving straight for `distance` world units; sideways, up and forward together are no
/// faster.
CameraPose moved(const CameraPose& pose, const FlightKeys& keys, float distance);
/// The pose after a drag by logical pixels in a view that is `height` of them high, which looks where the
/// mouse goes.
CameraPose turned(const CameraPose& pose, double dx, double dy, double height);

/// World units a second that the wheel chooses from, around what suits a scene of this radius.
float firstSpeed(float radius);
float changedSpeed(float speed, double notches, float radius);

/// While it is on, W A S D Q E move (Shift faster, Ctrl slower), left or middle drag looks around, the wheel
/// changes the speed; all else is as ever.
class Flight : public QObject {
  Q_OBJECT
 public:
  Flight(Session& session, ViewArea* views, QObject* parent = nullptr);

  bool isOn() const { return isOn_; }
  void setOn(bool on);
  bool isRecording() const;
  int recordedFrames() const; ///< so far
  void toggleRecording();
  /// Back to the camera that was left.
  void reset();
  float speed() const { return speed_; } ///< world units a second

 Q_SIGNALS:
  void changed(); ///< on, recording, how much of it there is, or speed
  /// A recording has ended as this camera.
  void recorded(const CameraTrackHandle& track);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool pressKey(const QKeyEvent& event);
  bool drag(QMouseEvent& event, double height);
  void takeStatus();
  void takeRecording();
  void move(float seconds);
  void send(const CameraPose& pose, double tookSeconds);
  void rest();
  float sinceLast();
  FlightKeys keys() const;

  Session& session_;
  ViewArea* views_;
  bool isOn_ = false, wasRecording_ = false;
  int recordedFrames_ = 0;
  CameraPose pose_;
  bool waits_ = false; ///< for a picture of pose_
  float speed_ = 1.0f, radius_ = 0.0f;
  std::string camera_; ///< that is looked through
  QSet<int> held_;
  Qt::KeyboardModifiers modifiers_;
  Qt::MouseButton button_ = Qt::NoButton;
  QPointF cursor_;
  QTimer tick_;
  QElapsedTimer since_;
};

} // namespace taa::app
