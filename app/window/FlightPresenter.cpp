#include "app/window/FlightPresenter.h"

#include "app/commands/Flight.h"
#include "app/panels/MessagesBar.h"
#include "app/session/Session.h"
#include "app/widgets/bars/FlightBar.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace taa::app {

namespace {

/// From the first of so many frames to the last one.
double secondsOf(int frames, const Status& status) {
  return std::max(0, frames - 1) / status.framesPerSecond;
}

} // namespace

FlightPresenter::FlightPresenter(const Session& session, Flight& flight, FlightBar& bar,
                                 MessagesBar& messages)
    : session_(session), flight_(flight), bar_(bar) {
  connect(&flight_, &Flight::changed, this, &FlightPresenter::showFlight);
  connect(&flight_, &Flight::recorded, this, [this, &messages](const CameraTrackHandle& track) {
    const int frames = static_cast<int>(track->poses.size());
    messages.showNote(tr("%1 has %n frames from frame %2 on, %3 s.", nullptr, frames)
                          .arg(QString::fromStdString(track->name))
                          .arg(track->firstFrame)
                          .arg(secondsOf(frames, session_.status()), 0, 'f', 2));
  });
  connect(&bar_, &FlightBar::recordRequested, &flight_, &Flight::toggleRecording);
  connect(&bar_, &FlightBar::resetRequested, &flight_, &Flight::reset);
  connect(&bar_, &FlightBar::endRequested, this, [this] { flight_.setOn(false); });
}

void FlightPresenter::showFlight() {
  const int frames = flight_.recordedFrames();
  bar_.setFlight(flight_.isOn(), static_cast<double>(flight_.speed()));
  bar_.setRecording(flight_.isRecording()
                        ? std::optional(std::pair(frames, secondsOf(frames, session_.status())))
                        : std::nullopt);
}

} // namespace taa::app
