#include "core/doctor/motion/MotionTrials.h"

#include "core/base/NumberText.h"
#include "core/base/Say.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace taa::doctor {

namespace {

/// In the order of the enumerators.
constexpr std::array<MotionRow, 32> motionRows() {
  using enum MotionKind;
  using enum MotionMadeOf;
  return {{
      {AsGiven, "asGiven", "as given", Given},
      {Resting, "resting", "at rest on the screen", Screen, {"fault.motion=zero"}},
      {OfCamera, "ofCamera", "that of the camera", Camera, {"fault.motion=cameraOnly"}},
      {LacksCamera, "lacksCamera", "with the camera's motion added", Camera, {"fault.previousCamera=twice"}},
      {CameraTwice,
       "cameraTwice",
       "with the camera's motion taken off once",
       Camera,
       {"fault.previousCamera=ofNow"}},
      {Scaled, "scaled", "", Factors},
      {OtherUnit, "otherUnit", "", Factors},
      {MirroredX, "mirroredX", "x negated", Factors, {"fault.motionX=-1"}, {-1, 0, 0, 1}},
      {MirroredY, "mirroredY", "y negated", Factors, {"fault.motionY=-1"}, {1, 0, 0, -1}},
      {Opposite,
       "opposite",
       "both negated",
       Factors,
       {"fault.motionX=-1", "fault.motionY=-1"},
       {-1, 0, 0, -1}},
      {SwappedAxes, "swappedAxes", "x and y exchanged", Factors, {"fault.motionSwapped=on"}, {0, 1, 1, 0}},
      {TurnedLeft, "turnedLeft", "x and y exchanged, x negated then", Factors, {}, {0, -1, 1, 0}},
      {TurnedRight, "turnedRight", "x and y exchanged, y negated then", Factors, {}, {0, 1, -1, 0}},
      {JitterOfThis,
       "jitterOfThis",
       "without this frame's jitter",
       Jitter,
       {"fault.motionJitter=thisOff"},
       {-1, 0}},
      {JitterOfPrevious,
       "jitterOfPrevious",
       "without the jitter of the frame before",
       Jitter,
       {"fault.motionJitter=lastOff"},
       {0, 1}},
      {JitterOfBoth,
       "jitterOfBoth",
       "without the difference of both jitters",
       Jitter,
       {"fault.motionJitter=bothOff"},
       {-1, 1}},
      {JitterTakenOff,
       "jitterTakenOff",
       "with the difference of both jitters added",
       Jitter,
       {"fault.motionJitter=both"},
       {1, -1}},
      {JitterOfThisTakenOff,
       "jitterOfThisTakenOff",
       "with this frame's jitter added",
       Jitter,
       {"fault.motionJitter=this"},
       {1, 0}},
      {JitterOfPreviousTakenOff,
       "jitterOfPreviousTakenOff",
       "with the jitter of the frame before added",
       Jitter,
       {"fault.motionJitter=last"},
       {0, -1}},
      {FrameLate, "frameLate", "that of the frame after", OtherFrame, {"fault.motionLag=-1"}},
      {FrameEarly, "frameEarly", "that of the frame before", OtherFrame, {"fault.motionLag=1"}},
      {Forward, "forward", "that which the frame before holds of the same surface", OtherFrame},
      {Encoded, "encoded", "decoded from 0 to 1", Curve, {"fault.motionUnit=asBiased"}},
      {Root, "root", "squared, in shares of the picture", Curve, {"fault.motionUnit=asRoot"}},
      // What an earlier frame added is not known of what moves.
      {TwoFramesOld, "twoFramesOld", "without that of the frame before, which it holds as well", Camera},
      {CameraTurned, "cameraTurned", "with the previous camera turned back", OtherCamera},
      {CameraBeside, "cameraBeside", "with the previous camera moved back", OtherCamera},
      {CameraMirrored, "cameraMirrored", "with the previous camera's own matrix, not that of a mirror",
       OtherCamera},
      {CameraIdentity, "cameraIdentity", "with the previous camera's matrix, which was never set",
       OtherCamera},
      {CameraUnzoomed, "cameraUnzoomed", "with the previous camera's own projection, not this one's",
       OtherCamera},
      {CameraUnmoved, "cameraUnmoved", "with the way of the camera, not its turning alone", OtherCamera},
      {CameraUnturned, "cameraUnturned", "with the turning of the camera, not its way alone", OtherCamera},
  }};
}
constexpr std::array<MotionRow, 32> kMotionRows = motionRows();
static_assert(std::ranges::all_of(kMotionRows, [](const MotionRow& row) {
  return &row - kMotionRows.data() == static_cast<std::ptrdiff_t>(row.kind);
}));

std::optional<glm::vec2> knownMotion(const glm::vec2& motionPx) {
  if (!isMotion(motionPx)) return {};
  return motionPx;
}

std::optional<glm::vec2> withOther(const glm::vec2& motionPx, const std::optional<glm::vec2>& other,
                                   float factor) {
  if (!other) return {};
  return motionPx + factor * *other;
}

/// m was made with another camera: the difference of both is taken off.
std::optional<glm::vec2> withoutOther(const std::optional<glm::mat4>& other, const DoctorFrame& now,
                                      const glm::ivec2& pixel) {
  const auto camera = cameraMotionPx(now, pixel);
  if (!other || !camera) return {};
  const auto wrong = motionUnder(*other, now, pixel, *now.depth.at(pixel.x, pixel.y));
  if (!wrong) return {};
  return now.motionAt(pixel.x, pixel.y) - (*wrong - *camera);
}

/// The pixel of the frame before that a motion leads to; nothing beyond the picture.
std::optional<glm::ivec2> placeBefore(const FrameNeighbors& frames, const glm::ivec2& pixel,
                                      const glm::vec2& motionPx) {
  const glm::ivec2 before(glm::floor(glm::vec2(pixel) + 0.5f - motionPx)), size = frames.now.sizePx();
  if (before.x < 0 || before.y < 0 || before.x >= size.x || before.y >= size.y) return {};
  return before;
}

/// m holds the motion of the frame before as well, that of where the camera's motion leads: of what rests.
std::optional<glm::vec2> withoutOlderCamera(const FrameNeighbors& frames, const glm::ivec2& pixel) {
  const auto camera = cameraMotionPx(frames.now, pixel);
  if (!camera) return {};
  const auto before = placeBefore(frames, pixel, *camera);
  if (!before) return {};
  return withOther(frames.now.motionAt(pixel.x, pixel.y), cameraMotionPx(frames.before, *before), -1.0f);
}

/// What the frame before says that its surface moves by until this one.
std::optional<glm::vec2> forwardMotion(const FrameNeighbors& frames, const glm::ivec2& pixel) {
  constexpr int kSteps = 4;
  constexpr float kConvergedPx = 0.05f;
  if (frames.before.motionPx.empty()) return {};
  glm::vec2 motion = frames.now.motionAt(pixel.x, pixel.y); // about as long
  for (int step = 0; step < kSteps && isMotion(motion); ++step) {
    const auto before = placeBefore(frames, pixel, motion - frames.jitterStep());
    if (!before) return {};
    const glm::vec2 next = frames.before.motionAt(before->x, before->y);
    if (isMotion(next) && glm::distance(next, motion) <= kConvergedPx) return next;
    motion = next;
  }
  return {};
}

/// What an object's motion has grown by since the frame before, where it lay by its mean over two frames; 0
/// where that is not known, or is much, as after a start.
glm::vec2 growth(const FrameNeighbors& frames, const glm::ivec2& pixel) {
  constexpr float kMostGrowth = 0.25f, kRoundingPx = 0.02f;
  const glm::vec2 given = frames.now.motionAt(pixel.x, pixel.y);
  const auto before = placeBefore(frames, pixel, 0.5f * given);
  if (!before || frames.before.startsHistory) return glm::vec2(0.0f);
  const auto objectAt = [](const DoctorFrame& frame, const glm::ivec2& at) {
    return frame.objectId.empty() ? 0u
                                  : frame.objectId[static_cast<std::size_t>(at.y) * frame.sizePx().x + at.x];
  };
  const glm::vec2 earlier = frames.before.motionAt(before->x, before->y);
  const bool isSame = isMotion(earlier) && objectAt(frames.before, *before) == objectAt(frames.now, pixel);
  const float most = kMostGrowth * glm::length(given) + kRoundingPx;
  return isSame && glm::distance(given, earlier) <= most ? given - earlier : glm::vec2(0.0f);
}

/// The same of what moves by itself, faster or slower by as much in each frame: m is then twice the motion,
/// less what that grows by in a frame, which is half of what m grows by. Which of the two a pixel is, its
/// motion says: that of what rests is the camera's of both frames.
std::optional<glm::vec2> withoutOlder(const FrameNeighbors& frames, const glm::ivec2& pixel) {
  constexpr float kSameAsCameraPx = 0.05f;
  const auto camera = cameraMotionPx(frames.now, pixel);
  const auto resting = frames.before.startsHistory ? std::nullopt : withoutOlderCamera(frames, pixel);
  if (camera && resting && glm::distance(*camera, *resting) <= kSameAsCameraPx) return resting;
  return 0.5f * frames.now.motionAt(pixel.x, pixel.y) + 0.25f * growth(frames, pixel);
}

} // namespace

const MotionRow& motionRow(MotionKind kind) {
  return kMotionRows[static_cast<std::size_t>(kind)];
}

MotionMadeOf madeOf(MotionKind kind) {
  return motionRow(kind).madeOf;
}

std::optional<glm::dmat2> factorsOf(const MotionTrial& trial) {
  const MotionRow& row = motionRow(trial.kind);
  if (row.madeOf != MotionMadeOf::Factors) return {};
  if (trial.kind == MotionKind::Scaled || trial.kind == MotionKind::OtherUnit)
    return glm::dmat2(glm::dvec2(trial.factor.x, 0.0), glm::dvec2(0.0, trial.factor.y));
  const auto& [xOfX, xOfY, yOfX, yOfY] = row.shares;
  return glm::dmat2(glm::dvec2(xOfX, yOfX), glm::dvec2(xOfY, yOfY));
}

std::vector<MotionTrial> motionTrials(const glm::ivec2& sizePx) {
  std::vector<MotionTrial> trials;
  for (const MotionKind kind :
       {MotionKind::AsGiven, MotionKind::Resting, MotionKind::MirroredX, MotionKind::MirroredY,
        MotionKind::Opposite, MotionKind::SwappedAxes, MotionKind::TurnedLeft, MotionKind::TurnedRight,
        MotionKind::JitterOfThis, MotionKind::JitterOfPrevious, MotionKind::JitterOfBoth,
        MotionKind::JitterTakenOff, MotionKind::JitterOfThisTakenOff, MotionKind::JitterOfPreviousTakenOff,
        MotionKind::FrameLate, MotionKind::FrameEarly, MotionKind::Forward})
    trials.push_back({kind});
  for (const float factor :
       {0.5f, 2.0f, 0.25f, 1.0f / 3.0f, 2.0f / 3.0f, 0.75f, 4.0f / 3.0f, 1.5f, 3.0f, 4.0f})
    trials.push_back({MotionKind::Scaled, glm::vec2(factor)});
  for (const MotionKind kind : {MotionKind::LacksCamera, MotionKind::CameraTwice}) trials.push_back({kind});
  for (const MotionKind kind : {MotionKind::Encoded, MotionKind::Root}) trials.push_back({kind});
  // Texture or device coordinates taken for pixels, and the other way; y of the latter may point up.
  // Direction and axes may be wrong besides.
  const glm::vec2 uv(sizePx), ndc = 0.5f * uv, yUp(1.0f, -1.0f), xLeft(-1.0f, 1.0f);
  for (const glm::vec2& unit : {uv, 1.0f / uv})
    for (const glm::vec2& factor : {unit, unit * yUp, -unit, unit * xLeft})
      trials.push_back({MotionKind::OtherUnit, factor});
  for (const glm::vec2& unit : {ndc, 1.0f / ndc})
    for (const glm::vec2& factor : {unit * yUp, unit, unit * xLeft, -unit})
      trials.push_back({MotionKind::OtherUnit, factor, true});
  for (const MotionKind kind :
       {MotionKind::TwoFramesOld, MotionKind::CameraTurned, MotionKind::CameraBeside,
        MotionKind::CameraMirrored, MotionKind::CameraIdentity, MotionKind::CameraUnzoomed,
        MotionKind::CameraUnmoved, MotionKind::CameraUnturned})
    trials.push_back({kind});
  // Last: whatever is wrong with what rests in the world, this fits it, and says the least.
  trials.push_back({MotionKind::OfCamera});
  return trials;
}

std::string trialId(const MotionTrial& trial) {
  const std::string id(motionRow(trial.kind).id), x = shortNumber(static_cast<double>(trial.factor.x));
  if (trial.kind == MotionKind::Scaled) return id + ":" + x;
  if (trial.kind != MotionKind::OtherUnit) return id;
  return id + ":" + x + "," + shortNumber(static_cast<double>(trial.factor.y));
}

std::string trialText(const MotionTrial& trial) {
  if (trial.kind == MotionKind::Scaled)
    return say<"times %1">(shortNumber(static_cast<double>(trial.factor.x)));
  if (trial.kind == MotionKind::OtherUnit)
    return say<"times %1: another unit">(shortVector(glm::dvec2(trial.factor)));
  return std::string(motionRow(trial.kind).text);
}

bool wasHidden(const FrameNeighbors& frames, const glm::ivec2& pixel, const glm::ivec2& before, float share) {
  if (frames.now.depth.empty() || frames.before.depth.empty()) return false;
  const float there = *frames.before.depthView.at(before.x, before.y);
  if (*frames.now.depth.at(pixel.x, pixel.y) == 0.0f) return there != 0.0f;
  const float expected = *frames.now.previousDepthView.at(pixel.x, pixel.y);
  return expected > 0.0f && there > 0.0f && there < share * expected;
}

std::optional<glm::vec2> trueMotion(const MotionTrial& trial, const FrameNeighbors& frames,
                                    const glm::ivec2& pixel) {
  const glm::vec2 given = frames.now.motionAt(pixel.x, pixel.y);
  if (const auto factors = factorsOf(trial)) return glm::vec2(*factors * glm::dvec2(given));
  if (const MotionRow& row = motionRow(trial.kind); row.madeOf == MotionMadeOf::Jitter)
    return given + (row.shares[0] * frames.now.jitterPx + row.shares[1] * frames.before.jitterPx);
  switch (trial.kind) {
  case MotionKind::AsGiven:
    return given;
  case MotionKind::Resting:
    return glm::vec2(0.0f);
  case MotionKind::OfCamera:
    return cameraMotionPx(frames.now, pixel);
  case MotionKind::LacksCamera:
    return withOther(given, cameraMotionPx(frames.now, pixel), 1.0f);
  case MotionKind::CameraTwice:
    return withOther(given, cameraMotionPx(frames.now, pixel), -1.0f);
  case MotionKind::FrameLate:
    if (!frames.after || frames.after->startsHistory || frames.after->motionPx.empty()) return {};
    return knownMotion(frames.after->motionAt(pixel.x, pixel.y));
  case MotionKind::FrameEarly:
    if (frames.before.startsHistory || frames.before.motionPx.empty()) return {};
    return knownMotion(frames.before.motionAt(pixel.x, pixel.y));
  case MotionKind::Forward:
    return forwardMotion(frames, pixel);
  case MotionKind::Encoded:
    return 2.0f * given - glm::vec2(frames.now.sizePx());
  case MotionKind::Root:
    return glm::abs(given) * given / glm::vec2(frames.now.sizePx());
  case MotionKind::TwoFramesOld:
    return withoutOlder(frames, pixel);
  case MotionKind::CameraTurned:
    return withoutOther(frames.others.turned, frames.now, pixel);
  case MotionKind::CameraBeside:
    return withoutOther(frames.others.beside, frames.now, pixel);
  case MotionKind::CameraMirrored:
    return withoutOther(frames.others.mirrored, frames.now, pixel);
  case MotionKind::CameraIdentity:
    return withoutOther(frames.others.identity, frames.now, pixel);
  case MotionKind::CameraUnzoomed:
    return withoutOther(frames.others.unzoomed, frames.now, pixel);
  case MotionKind::CameraUnmoved:
    return withoutOther(frames.others.unmoved, frames.now, pixel);
  case MotionKind::CameraUnturned:
    return withoutOther(frames.others.unturned, frames.now, pixel);
  default: // by their rows
    return {};
  }
}

} // namespace taa::doctor
