#include "tests/soak/RandomRequests.h"

#include "core/measure/MetricTable.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"
#include "core/taa/Intermediates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace taa::soak {

namespace {

/// What the pieces of a request are drawn from.
class Dice {
 public:
  explicit Dice(std::mt19937& random) : random_(random) {}

  int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
  bool oneIn(int count) { return below(count) == 0; }
  template <typename List>
  auto oneOf(const List& list) {
    return list[static_cast<std::size_t>(below(static_cast<int>(std::size(list))))];
  }
  float between(float low, float high) {
    return low + (high - low) * static_cast<float>(below(1 << 16)) / static_cast<float>(1 << 16);
  }
  /// Mostly one that there is.
  int frame() {
    return oneIn(8) ? oneOf(std::array{-1, 100'000, std::numeric_limits<int>::max()}) : below(24);
  }

 private:
  std::mt19937& random_;
};

constexpr std::array<std::string_view, 6> kSources{"builtin:fan",  "builtin:text",       "builtin:fence",
                                                   "builtin:nope", "/nowhere/scene.glb", "."};
constexpr std::array<std::string_view, 7> kObjects{"rotor", "hub", "ground", "a", "", "fan", "blade 1"};
constexpr std::array<std::string_view, 6> kCameras{"still", "pan", "orbit", "dolly", "free", "none such"};

Settings settingsFrom(Dice& dice) {
  Settings settings = dice.oneOf(builtinPresets()).settings;
  for (int changes = dice.below(4); changes > 0; --changes) {
    const Parameter& row = dice.oneOf(parameters());
    const double most = std::min(row.maximum, row.kind == ParameterKind::Number ? 8.0 : row.maximum);
    const double value = row.minimum + (most - row.minimum) * dice.below(1000) / 999.0;
    row.set(settings, row.kind == ParameterKind::Number ? value : std::floor(value));
  }
  return settings;
}

ViewStyle styleFrom(Dice& dice) {
  ViewStyle style;
  style.low = dice.between(-2.0f, 1.0f);
  style.high = dice.between(0.0f, 2.0f);
  style.exposure = dice.between(-8.0f, 8.0f);
  style.red = !dice.oneIn(4);
  style.map = dice.oneOf(kColorMaps);
  style.markClipped = dice.oneIn(3);
  style.markRejected = dice.oneIn(3);
  style.outlineObjects = dice.oneIn(3);
  style.arrows = dice.oneIn(3);
  return style;
}

OtherSide otherFrom(Dice& dice) {
  OtherSide other;
  other.id = dice.oneOf(allRows());
  other.style = styleFrom(dice);
  other.lane = dice.below(3);
  if (dice.oneIn(2)) other.frame = dice.frame();
  other.framesBefore = dice.below(3);
  other.alongMotion = dice.oneIn(4);
  return other;
}

ViewRequest viewFrom(Dice& dice) {
  ViewRequest view;
  view.id = dice.oneOf(allRows());
  view.style = styleFrom(dice);
  view.transform = {.origin = {dice.between(-20.0f, 40.0f), dice.between(-20.0f, 40.0f)},
                    .zoom = dice.oneOf(std::array{0.25f, 1.0f, 3.5f, 32.0f})};
  view.width = dice.below(48);
  view.height = dice.below(48);
  view.lane = dice.below(3);
  view.withValues = dice.oneIn(3);
  if (dice.oneIn(3)) view.other = otherFrom(dice);
  view.asDifference = view.other && dice.oneIn(2);
  return view;
}

CameraPose poseFrom(Dice& dice) {
  CameraPose pose;
  pose.position = {dice.between(-4.0f, 4.0f), dice.between(0.0f, 3.0f), dice.between(-4.0f, 4.0f)};
  pose.yaw = dice.between(-180.0f, 180.0f);
  pose.pitch = dice.between(-kMaxPitch, kMaxPitch);
  return pose;
}

CameraTrack trackFrom(Dice& dice) {
  CameraTrack track{std::string(dice.oneOf(kCameras)), dice.below(4), {}};
  for (int poses = dice.below(6); poses > 0; --poses) track.poses.push_back(poseFrom(dice));
  return track;
}

template <typename Make>
auto several(Dice& dice, int most, Make make) {
  std::vector<decltype(make())> list;
  for (int count = dice.below(most + 1); count > 0; --count) list.push_back(make());
  return list;
}

std::string objectFrom(Dice& dice) {
  return std::string(dice.oneOf(kObjects));
}

Request shotRequest(Dice& dice) {
  switch (dice.below(12)) {
  case 0:
    return request::Open{std::string(dice.oneOf(kSources)), {"", dice.oneIn(3) ? dice.below(60) : 0}};
  case 1:
    return request::SetSize{4 + dice.below(60), 4 + dice.below(60)};
  case 2:
    return request::SetMotionModes{several(dice, 2, [&] {
      return MotionOverride{objectFrom(dice), static_cast<MotionMode>(dice.below(3))};
    })};
  case 3:
    return request::SetOtherLanes{several(dice, 2, [&] { return settingsFrom(dice); })};
  case 4:
    return request::SetObjectFilter{{several(dice, 2, [&] { return objectFrom(dice); }),
                                     several(dice, 1, [&] { return objectFrom(dice); })}};
  case 5:
    return request::SetObjectClasses{several(dice, 2, [&] { return ClassOverride{objectFrom(dice)}; })};
  case 6:
    return request::SetRestarts{several(dice, 3, [&] { return dice.frame(); })};
  case 7:
    return request::SetCamera{std::string(dice.oneOf(kCameras))};
  case 8:
    return request::AddCameraTrack{trackFrom(dice)};
  case 9:
    return request::SetFlownCameras{
        {several(dice, 2, [&] { return trackFrom(dice); }), std::string(dice.oneOf(kCameras))}};
  case 10:
    return request::Prepare{settingsFrom(dice)};
  default:
    return request::SetSettings{settingsFrom(dice)};
  }
}

Request timeRequest(Dice& dice) {
  switch (dice.below(8)) {
  case 0:
    return request::Fly{poseFrom(dice)};
  case 1:
    return request::SetRecording{dice.oneIn(2)};
  case 2:
    return request::SetPlaying{dice.oneIn(2)};
  case 3:
    return request::SetLooping{dice.oneIn(2)};
  case 4:
    return request::SetPlayback{
        {dice.between(0.0f, 120.0f), dice.between(0.05f, 8.0f),
         dice.oneIn(2) ? std::optional(std::pair(dice.below(8), 8 + dice.below(8))) : std::nullopt}};
  case 5:
    return request::Step{dice.below(7) - 3};
  case 6:
    return request::Cancel{};
  default:
    return request::Seek{dice.frame()};
  }
}

Request lookRequest(Dice& dice) {
  const auto pixel = [&] { return glm::ivec2(dice.below(80) - 8, dice.below(80) - 8); };
  switch (dice.below(17)) {
  case 0:
    return request::Locate{several(dice, 2, [&] { return dice.below(12) - 1; })};
  case 1:
  case 2: {
    const auto probes = several(dice, 3, [&] {
      return Probe{pixel(), dice.oneIn(2) ? Follow::Screen : Follow::Surface, dice.below(24), {}};
    });
    return request::SetProbes{probes, dice.below(static_cast<int>(probes.size()) + 1) - 1, dice.oneIn(3),
                              dice.oneIn(3) ? std::optional(otherFrom(dice)) : std::nullopt, dice.oneIn(3)};
  }
  case 3:
    return request::SetCheckpointBudget{static_cast<std::size_t>(dice.below(64)) << 20};
  case 4:
    return request::SetProfiling{dice.oneIn(2)};
  case 5:
    return request::MeasureStages{};
  case 6:
    return request::SetThumbnails{dice.below(24), dice.below(24)};
  case 7:
    // Few: the soak waits for idle work, and metrics of all frames want a reference each.
    return request::SetReferenceSamples{dice.oneOf(std::array{-1, 0, 4, 8, 16})};
  case 8:
    return request::FindWorst{dice.oneOf(allRows()), dice.below(3),
                              dice.oneIn(2) ? std::optional(pixel()) : std::nullopt, WorstStep::Pixel};
  case 9:
    return request::SetMetrics{several(dice, 3, [&] { return dice.oneOf(kMetrics).metric; })};
  case 10:
    return request::SetTracing{dice.oneIn(2)};
  case 11:
    return request::FillTraces{dice.frame(), dice.frame()};
  case 12:
    return request::SetLineage{dice.below(12)};
  case 13:
    return request::SetVerdicts{dice.oneIn(2)};
  case 14:
    return request::ReloadShaders{};
  case 15:
    return request::SetPreviews{dice.oneIn(3) ? std::nullopt : std::optional(0.01 * dice.below(200))};
  default:
    return request::SetViews{several(dice, 4, [&] { return viewFrom(dice); })};
  }
}

} // namespace

RandomRequest randomRequest(std::mt19937& random) {
  Dice dice(random);
  const int kind = dice.below(8);
  Request made = kind < 2 ? shotRequest(dice) : kind < 5 ? timeRequest(dice) : lookRequest(dice);
  const std::string text = "request " + std::to_string(made.index());
  return {std::move(made), text};
}

} // namespace taa::soak
