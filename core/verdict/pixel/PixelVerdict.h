// What is wrong with a pixel, since when, because of what, and which stage let it happen: concluded from its
// error by cause and frame, and from what its surface showed over the last frames. No GL.
#pragma once

#include "core/settings/Settings.h"
#include "core/settings/Stage.h"
#include "core/taa/Intermediates.h"
#include "core/verdict/parts/VerdictMaps.h"
#include "core/verdict/pixel/PixelError.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace taa {

/// What may be wrong with a pixel.
enum class VerdictKind : std::uint8_t {
  None,
  Ghost,
  DisocclusionRestart,
  Flicker,
  HighlightFlicker,
  Blur,
  Aliasing,
  MaskSmear,
  Lag,
};

struct VerdictKindInfo {
  VerdictKind kind;
  std::string_view id;    ///< in JSON and tables
  std::string_view label; ///< as a heading
  std::string_view description;
};
/// In the order of the enumerators.
extern const std::array<VerdictKindInfo, 9> kVerdictKinds;

/// All that is judged.
struct VerdictEvidence {
  PixelError error;
  std::optional<PixelError> older{};  ///< that it comes from, where most of it does (olderError())
  std::vector<SurfaceMoment> moments; ///< latest first, along the surface's true motion while it was seen
  int object = -1;                    ///< that the pixel shows; −1: not known
  bool endsHidden = false;            ///< before the last of them the surface was not seen, as far as known
  // Of `older` where it is known.
  twin::PixelRecord ghostRecord{}; ///< of the pixel through which most of the ghost came in
  std::optional<glm::dvec2>
      ghostMotion{};   ///< px, true one of what that pixel shows; nothing: not seen before
  int ghostFrame = -1; ///< −1: no ghost came in
};

/// What is shown may differ by this much without being wrong: 8 of 255 steps of what a screen is sent. A
/// pixel that holds 19 samples' worth of averaging is off by more at no edge of half the contrast.
inline constexpr double kVisibleError = static_cast<double>(kSeenDifference);
/// And may change from frame to frame by this much.
inline constexpr double kVisibleFlicker = 5.0 / 255.0;
/// Frames that are looked at.
inline constexpr int kVerdictFrames = kFollowedFrames;

/// A value that decided something.
struct VerdictRow {
  IntermediateId id{};
  int frame = 0;
  glm::ivec2 pixel{0};
  double value = 0.0;
  std::optional<double> limit; ///< what it was held against
  glm::vec4 channels{0.0f};    ///< all of them; `value` is the first
};

/// Of the frames that were looked at those in which a stage did something, and the largest of what it did.
struct RepeatedEvent {
  int events = 0, frames = 0;
  double largest = 0.0;
};

struct PixelVerdict {
  VerdictKind kind = VerdictKind::None;
  Stage stage = Stage::Reference; ///< that let it happen, or threw good history away; Reference: none
  bool throwsGoodAway = false;    ///< the stage gave up history that was right
  bool isBlended = false;         ///< a ghost is of what was blended over the surface
  double error = 0.0;             ///< largest channel's, as shown, 0 to 1
  double flicker = 0.0;           ///< upper quartile of its change against the frames beside, as shown
  ErrorPart part{};               ///< what most of the error is; Older: what it was then is not known
  double share = 0.0;             ///< of the error that it explains; more than 1 where others work against it
  int since = 0;                  ///< frame it came in with; the frame itself where it is of that alone
  bool isOlder = false;           ///< it was there before the window
  int causeFrame = 0;             ///< frame of what is seen in it; of a ghost the latest
  std::optional<int> causeObject; ///< that a ghost is of, as it is drawn; 0: the sky
  RepeatedEvent repeated;         ///< of flicker, by the stage
  std::vector<VerdictRow> rows;   ///< four or five that decided it
};

/// `settings` made the frames.
PixelVerdict judge(const VerdictEvidence& evidence, const Settings& settings);

/// A scene-linear value as a screen is sent it, 0 to 1 (shownColors() of core/measure).
glm::dvec3 shownValue(const glm::dvec3& linear);

} // namespace taa
