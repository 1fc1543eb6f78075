// What a captured shot has of its own where a drawn one has settings.
#pragma once

#include "core/settings/Parameters.h"
#include "core/settings/Settings.h"

#include <glm/vec2.hpp>

#include <string>
#include <vector>

namespace taa {

/// The name of the only camera of a capture.
inline constexpr const char* kCaptureCamera = "capture";

struct CaptureFacts {
  glm::ivec2 renderPx{0};          ///< size of the inputs
  glm::ivec2 outputPx{0};          ///< size of the picture, a side no smaller
  std::vector<glm::vec2> jitterPx; ///< of all frames: displacement of image content, x right, y down
  int jitterPeriod = 1;            ///< frames until it repeats; all frames where it never does
  bool hasCameraMotion = false;    ///< depth and matrices are known: that of the camera can be made of them
  bool hasMask = false, hasOverlay = false;
  bool hasOutput = false;    ///< of the engine's own TAA, in any frame
  bool hasReference = false; ///< in any frame
};

/// Frames until the jitter repeats, to a thousandth of a pixel; as many as there are where it never does.
int periodOf(const std::vector<glm::vec2>& jitterPx);

/// `settings` with what the frames were captured with in place of what only a renderer can be asked for.
Settings settingsOn(const CaptureFacts& capture, const Settings& settings);

/// Whether the value of the row has no effect on the capture's frames: they have their own.
bool isFixedBy(const CaptureFacts& capture, const Parameter& row);
/// Why, as a sentence without its full stop.
std::string whyFixed(const Parameter& row);
/// Why nothing of the scene can be changed: its cameras, objects, motion and classes.
std::string whyNoScene();
/// Why there is no other size.
std::string whyOneSize(const CaptureFacts& capture);
std::string whyNoReference();
std::string whyNoEngineOutput();

} // namespace taa
