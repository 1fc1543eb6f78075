// What a step of a lesson sets: a shot as session files know it, and what the window shows of it.
#pragma once

#include "core/inspect/Comparison.h"
#include "core/io/SessionFile.h"
#include "core/settings/Settings.h"
#include "core/settings/Stage.h"
#include "core/taa/Intermediates.h"

#include <glm/vec2.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace taa {

/// Settings beside those of the state, on the same frames, for claims that compare.
struct LessonLane {
  std::string name; ///< that claims call it by
  Settings settings;
};

/// Frames of the state's scene, written as an engine would hand them out, and opened in its place: how the
/// reader meets somebody else's.
struct LessonRecording {
  int frames = 0;
  std::string like = "taa-inspector"; ///< id of a capture::StartingPoint
  Settings settings{};                ///< that they are drawn with; what is wrong with them is in them
  int referenceSamples = 0;           ///< of a reference for each; 0: none
};

/// What one view shows.
struct LessonView {
  IntermediateId id = IntermediateId::resolved;
  std::vector<std::string> style{}; ///< as --style has it, on top of the row's own
  Comparison comparison{};          ///< with a built-in preset, a frame or a row
  Showing showing = Showing::Wipe;
};

/// Where all views look; they fit the picture where there is none.
struct LessonLook {
  glm::ivec2 pixel{0};
  double zoom = 1.0; ///< screen px of a picture's px
};

/// Parts of the window that a step may point at, by the names that lessons call them by.
inline constexpr std::array<std::string_view, 7> kLessonParts{"views",    "probe", "verdict", "pipeline",
                                                              "timeline", "lower", "menus"};

/// Pictures of lessons are small, so that pixels are seen and whatever is asked for comes at once.
inline constexpr glm::ivec2 kLessonSizePx{320, 180};
inline constexpr int kLessonSamples = 16; ///< of references
inline constexpr int kMaxRecordedFrames = 32;

struct LessonState {
  SessionFile shot{}; ///< without what the window adds to it
  std::optional<LessonRecording> recording{};
  std::vector<LessonLane> lanes{};
  std::vector<LessonView> views{{}};
  std::vector<glm::ivec2> probes{}; ///< px; the first one is active
  std::vector<IntermediateId> plots{};
  std::vector<IntermediateId>
      values{}; ///< of the probe that are read: other stages are folded; none: all are
  std::optional<LessonLook> look{};
  std::string page{}; ///< below the views: "plots", "jitter" …; empty: none
  std::string tab{};  ///< of the probe: "values", "colorSpace", "whatIf", "sensitivity"; empty: the first
  std::string highlight{}; ///< one of kLessonParts; empty: none
  /// Unfolded in the pipeline, which is scrolled to the last one; those of the settings that a step sets,
  /// where it names none.
  std::vector<Stage> stages{};
  bool plays = false;
  int samples = kLessonSamples; ///< of references
};

/// Sets what one line of a header says, `scene: builtin:fan`. `folder`: scenes and captures of a lesson that
/// is a file lie below it; empty: none does. Throws Error: a key that is not known, a value that is none.
void applyLessonKey(LessonState& state, std::string_view key, std::string_view value,
                    const std::string& folder);

/// The keys there are.
std::vector<std::string_view> lessonKeys();

/// The session that is the state: opened in the window, or written to a file and opened by taa-batch.
SessionFile lessonSession(const LessonState& state);

} // namespace taa
