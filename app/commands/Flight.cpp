#include "app/commands/Flight.h"

#include "app/session/Session.h"
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

namespace taa::app {

namespace {

constexpr int kTickMs = 16;
constexpr qint64 kLongestTickMs = 100; ///< a window that was busy does not leap
constexpr float kFaster = 4.0f, kSlower = 0.25f;
constexpr std::array kFlightKeys{Qt::Key_W, Qt::Key_A, Qt::Key_S, Qt::Key_D, Qt::Key_Q, Qt::Key_E};
constexpr float kRadiiPerSecond = 0.3f;            ///< across the scene in some seconds
constexpr float kSlowest = 1e-3f, kFastest = 1e2f; ///< of firstSpeed()
constexpr double kNotchFactor = 1.25;
constexpr float kFarAway = 1e6f;

bool isFlown(const Status& status) {
  return std::ranges::any_of(status.tracks,
                             [&](const CameraTrackHandle& track) { return track->name == status.camera; });
}

bool isFlightKey(int key) {
  return std::ranges::find(kFlightKeys, key) != kFlightKeys.end();
}

} // namespace

CameraPose moved(const CameraPose& pose, const FlightKeys& keys, float distance) {
  if (!keys.isAny()) return pose;
  const glm::vec3 way = static_cast<float>(keys.right) * rightOf(pose) +
                        static_cast<float>(keys.up) * glm::vec3(0.0f, 1.0f, 0.0f) +
                        static_cast<float>(keys.forward) * forwardOf(pose);
  const float length = glm::length(way);
  if (length < 1e-4f) return pose; // straight up against straight down
  CameraPose next = pose;
  next.position =
      glm::clamp(pose.position + way * (distance / length), glm::vec3(-kFarAway), glm::vec3(kFarAway));
  return next;
}

CameraPose turned(const CameraPose& pose, double dx, double dy, double height) {
  // In the middle of the picture a pixel is this many degrees.
  const double slope = 2.0 * std::tan(0.5 * glm::radians(static_cast<double>(pose.fovY)));
  const double degrees = glm::degrees(slope / std::max(height, 1.0));
  CameraPose next = pose;
  next.yaw = static_cast<float>(std::remainder(pose.yaw + dx * degrees, 360.0));
  next.pitch =
      static_cast<float>(std::clamp(pose.pitch - dy * degrees, -double(kMaxPitch), double(kMaxPitch)));
  return next;
}

float firstSpeed(float radius) {
  return kRadiiPerSecond * radius;
}

float changedSpeed(float speed, double notches, float radius) {
  const float wanted = speed * static_cast<float>(std::pow(kNotchFactor, notches));
  return std::clamp(wanted, kSlowest * firstSpeed(radius), kFastest * firstSpeed(radius));
}

Flight::Flight(Session& session, ViewArea* views, QObject* parent)
    : QObject(parent), session_(session), views_(views) {
  for (int view = 0; view < kViewCount; ++view) views->view(view)->viewport()->installEventFilter(this);
  tick_.setInterval(kTickMs);
  tick_.setTimerType(Qt::PreciseTimer);
  connect(&tick_, &QTimer::timeout, this, [this] { move(sinceLast()); });
  connect(&session, &Session::statusChanged, this, &Flight::takeStatus);
}

void Flight::setOn(bool on) {
  if (on == isOn_ || (on && !session_.isOpen())) return;
  isOn_ = on;
  rest();
  takeStatus();
  if (on) views_->active()->viewport()->setFocus();
  if (!on && isRecording()) session_.scene().setRecording(false);
  Q_EMIT changed();
}

bool Flight::isRecording() const {
  return session_.status().recording;
}

int Flight::recordedFrames() const {
  return recordedFrames_;
}

void Flight::toggleRecording() {
  if (!session_.isOpen()) return;
  if (!isRecording()) setOn(true);
  session_.scene().setRecording(!isRecording());
}

void Flight::reset() {
  rest();
  waits_ = false;
  session_.scene().backToSceneCamera();
}

// The camera may be moved by others: by time, a menu, another scene.
void Flight::takeStatus() {
  const Status& status = session_.status();
  if (status.outline && status.outline->radius != radius_) {
    radius_ = status.outline->radius;
    speed_ = firstSpeed(radius_);
    Q_EMIT changed();
  }
  takeRecording();
  // Another camera than the one that is flown was chosen: what was sent before counts no more.
  if (std::exchange(camera_, status.camera) != status.camera && !isFlown(status)) waits_ = false;
  if (status.pose == pose_) waits_ = false;
  if (!waits_ && held_.isEmpty() && button_ == Qt::NoButton) pose_ = status.pose;
}

void Flight::takeRecording() {
  const Status& status = session_.status();
  const bool wasRecording = std::exchange(wasRecording_, status.recording);
  const int before = std::exchange(recordedFrames_, status.recordedFrames);
  if (wasRecording != status.recording || before != recordedFrames_) Q_EMIT changed();
  if (!wasRecording || status.recording) return;
  for (const CameraTrackHandle& track : status.tracks)
    if (track->name == status.camera) Q_EMIT recorded(track);
}

void Flight::rest() {
  held_.clear();
  tick_.stop();
  button_ = Qt::NoButton;
}

FlightKeys Flight::keys() const {
  const auto axis = [this](int more, int less) {
    return int(held_.contains(more)) - int(held_.contains(less));
  };
  return {axis(Qt::Key_D, Qt::Key_A), axis(Qt::Key_E, Qt::Key_Q), axis(Qt::Key_W, Qt::Key_S)};
}

void Flight::send(const CameraPose& pose, double tookSeconds) {
  if (pose == pose_) return;
  pose_ = pose;
  waits_ = true;
  session_.scene().fly(pose_, std::chrono::duration<double>(tookSeconds));
}

float Flight::sinceLast() {
  return static_cast<float>(std::min(since_.restart(), kLongestTickMs)) * 1e-3f;
}

void Flight::move(float seconds) {
  const float pace = modifiers_.testFlag(Qt::ShiftModifier)     ? kFaster
                     : modifiers_.testFlag(Qt::ControlModifier) ? kSlower
                                                                : 1.0f;
  send(moved(pose_, keys(), speed_ * pace * seconds), static_cast<double>(seconds));
}

// Each key moves at once, so that a tap is a step.
bool Flight::pressKey(const QKeyEvent& event) {
  modifiers_ = event.modifiers();
  if (!isFlightKey(event.key())) return false;
  if (event.isAutoRepeat() || held_.contains(event.key())) return true;
  held_.insert(event.key());
  move(kTickMs * 1e-3f);
  if (!tick_.isActive()) {
    since_.start();
    tick_.start();
  }
  return true;
}

bool Flight::drag(QMouseEvent& event, double height) {
  if (event.type() == QEvent::MouseButtonPress) {
    if (event.button() != Qt::LeftButton && event.button() != Qt::MiddleButton) return false;
    button_ = event.button();
    cursor_ = event.position();
    if (!tick_.isActive()) since_.start();
    return false; // the view becomes the active one
  }
  if (button_ == Qt::NoButton) return false;
  if (event.type() == QEvent::MouseButtonRelease) {
    button_ = Qt::NoButton;
    return false;
  }
  const QPointF way = event.position() - cursor_;
  cursor_ = event.position();
  // Keys measure their own time, which is as long.
  const double seconds = tick_.isActive() ? kTickMs * 1e-3 : static_cast<double>(sinceLast());
  send(turned(pose_, way.x(), way.y(), height), seconds);
  return true;
}

bool Flight::eventFilter(QObject* watched, QEvent* event) {
  if (!isOn_) return false;
  switch (event->type()) {
  case QEvent::ShortcutOverride: {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (isFlightKey(key)) event->accept();
    return isFlightKey(key);
  }
  case QEvent::KeyPress:
    return pressKey(*static_cast<QKeyEvent*>(event));
  case QEvent::KeyRelease: {
    const auto* key = static_cast<QKeyEvent*>(event);
    modifiers_ = key->modifiers();
    if (!isFlightKey(key->key())) return false;
    if (key->isAutoRepeat() || !held_.contains(key->key())) return true;
    move(sinceLast()); // up to now
    held_.remove(key->key());
    if (held_.isEmpty()) tick_.stop();
    return true;
  }
  case QEvent::Wheel: {
    speed_ = changedSpeed(speed_, static_cast<QWheelEvent*>(event)->angleDelta().y() / 120.0, radius_);
    Q_EMIT changed();
    return true;
  }
  case QEvent::MouseButtonPress:
  case QEvent::MouseMove:
  case QEvent::MouseButtonRelease:
    return drag(*static_cast<QMouseEvent*>(event), static_cast<QWidget*>(watched)->height());
  case QEvent::FocusOut:
    rest();
    return false;
  default:
    return false;
  }
}

} // namespace taa::app
