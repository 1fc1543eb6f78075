#include "core/cli/PlanChecks.h"

#include "core/base/Error.h"
#include "core/io/SessionFile.h"
#include "core/render/CaptureFacts.h"
#include "core/render/FrameClock.h"
#include "core/scene/MotionMode.h"
#include "core/scene/ObjectClass.h"
#include "core/scene/ObjectFilter.h"
#include "core/scene/Pose.h"

#include <string>
#include <string_view>

namespace taa::cli {

namespace {

/// Refuses what `flag`, or the session's field for the same, says.
using Refuse = std::function<void(std::string_view flag, const std::string& reason)>;

void refuseCall(std::string_view flag, const std::string& reason) {
  throw UsageError(std::string(flag) + ": " + reason);
}

Refuse refuseSession(const ShotPlan& plan) {
  return [&plan](std::string_view, const std::string& reason) {
    throw Error(sessionRefusal(plan.session, reason));
  };
}

void check(const ShotWishes& wishes, const OpenedShot& opened, const Refuse& refuse) {
  const auto require = [&](std::string_view flag, bool isSaid, const auto& action) {
    if (isSaid) try {
        if (!opened.scene) throw Error(whyNoScene());
        action(*opened.scene);
      } catch (const Error& error) {
        refuse(flag, error.what());
      }
  };
  const bool isCamera = !wishes.camera.empty() && (opened.scene || wishes.camera != kCaptureCamera);
  require("--camera", isCamera, [&](const Scene& scene) { cameraAt(scene, wishes.camera, 0.0, 1.0f); });
  require("--camera-path", wishes.track.has_value(),
          [&](const Scene& scene) { requireNewCamera(scene, wishes.track->name); });
  require("--motion-mode", !wishes.motionModes.empty(),
          [&](const Scene& scene) { checkMotionOverrides(scene, wishes.motionModes); });
  require("--hide", !wishes.filter.hidden.empty(),
          [&](const Scene& scene) { checkObjectNames(scene, wishes.filter.hidden); });
  require("--isolate", !wishes.filter.isolated.empty(),
          [&](const Scene& scene) { checkObjectNames(scene, wishes.filter.isolated); });
  require("--class", !wishes.objectClasses.empty(),
          [&](const Scene& scene) { checkClassOverrides(scene, wishes.objectClasses); });
  try {
    checkRestarts(wishes.restarts, opened.frames);
  } catch (const Error& error) {
    refuse("--restart", error.what());
  }
}

} // namespace

void checkWishes(const ShotPlan& plan, const OpenedShot& opened) {
  check(plan.ofSession, opened, refuseSession(plan));
  check(plan.ofCall, opened, refuseCall);
}

void openChosen(const ShotPlan& plan, const std::function<void()>& open) {
  try {
    open();
  } catch (const ChoiceError& error) {
    if (plan.isChoiceAsked) refuseCall("--animation, --length", error.what());
    refuseSession(plan)("", error.what());
  }
}

void requireFrame(const ShotPlan& plan, const std::string& source, int frames, int frame) {
  if (frame < frames) return;
  const std::string reason = "there is no frame " + std::to_string(frame) + ": " + source +
                             " has frames 0 to " + std::to_string(frames - 1);
  if (frame == plan.frame) throw Error(sessionRefusal(plan.session, reason));
  throw UsageError(reason);
}

} // namespace taa::cli
