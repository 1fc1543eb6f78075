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

std::optional<glm::vec2> given(const FrameNeighbors& frames, const glm::ivec2& pixel) {
  return frames.now.motionAt(pixel.x, pixel.y);
}

std::optional<glm::vec2> none(const FrameNeighbors&, const glm::ivec2&) {
  return glm::vec2(0.0f);
}

std::optional<glm::vec2> ofCamera(const FrameNeighbors& frames, const glm::ivec2& pixel) {
  return cameraMotionPx(frames.now, pixel);
}

template <int times>
std::optional<glm::vec2> plusCamera(const FrameNeighbors& frames, const glm::ivec2& pixel) {
  return withOther(frames.now.motionAt(pixel.x, pixel.y), cameraMotionPx(frames.now, pixel),
                   static_cast<float>(times));
}

std::optional<glm::vec2> ofNext(const FrameNeighbors& frames, const glm::ivec2& pixel) {
  if (!frames.after || frames.after->startsHistory || frames.after->motionPx.empty()) return {};
  return knownMotion(frames.after->motionAt(pixel.x, pixel.y));
}

std::optional<glm::vec2> ofLast(const FrameNeighbors& frames, const glm::ivec2& pixel) {
  if (frames.before.startsHistory || frames.before.motionPx.empty()) return {};
  return knownMotion(frames.before.motionAt(pixel.x, pixel.y));
}

std::optional<glm::vec2> decoded(const FrameNeighbors& frames, const glm::ivec2& pixel) {
  return 2.0f * frames.now.motionAt(pixel.x, pixel.y) - glm::vec2(frames.now.sizePx());
}

std::optional<glm::vec2> squared(const FrameNeighbors& frames, const glm::ivec2& pixel) {
  const glm::vec2 root = frames.now.motionAt(pixel.x, pixel.y);
  return glm::abs(root) * root / glm::vec2(frames.now.sizePx());
}

template <std::optional<glm::mat4> OtherCameras::*other>
std::optional<glm::vec2> without(const FrameNeighbors& frames, const glm::ivec2& pixel) {
  return withoutOther(frames.others.*other, frames.now, pixel);
}

constexpr OwnFault kTurned{"motionTurned", "Motion with its axes turned", "Ghosts beside what moves."};
constexpr OwnFault kJitterTakenOff{"motionJitterTakenOff", "Jitter taken off motion that had none",
                                   "The whole picture trembles, at rest too."};
constexpr std::string_view kMakeWithoutJitter =
    "Make motion with both frames' projections without jitter, or state which jitter is in it.";

/// In the order of the enumerators.
constexpr std::array kMotionRows = std::to_array<MotionRow>({
    {.kind = MotionKind::AsGiven, .id = "asGiven", .text = "as given", .motion = given},
    {.kind = MotionKind::Resting,
     .id = "resting",
     .text = "at rest on the screen",
     .madeOf = MotionMadeOf::Screen,
     .motion = none,
     .correction = {"fault.motion=zero"},
     .fault = Fault::InterfaceBefore,
     .change =
         "It rests on the screen, and its motion is that of what is behind: draw it after TAA, or write 0 "
         "for it."},
    {.kind = MotionKind::MirroredX,
     .id = "mirroredX",
     .text = "x negated",
     .madeOf = MotionMadeOf::Factors,
     .shares = {-1, 0, 0, 1},
     .correction = {"fault.motionX=-1"},
     .fault = Fault::MotionNegatedX,
     .change =
         "Negate x of the motion that you write; or state the other direction, and that y goes the other "
         "way."},
    {.kind = MotionKind::MirroredY,
     .id = "mirroredY",
     .text = "y negated",
     .madeOf = MotionMadeOf::Factors,
     .shares = {1, 0, 0, -1},
     .correction = {"fault.motionY=-1"},
     .fault = Fault::MotionNegatedY,
     .change = "Negate y of the motion that you write, or state that it points the other way."},
    {.kind = MotionKind::Opposite,
     .id = "opposite",
     .text = "both negated",
     .madeOf = MotionMadeOf::Factors,
     .shares = {-1, 0, 0, -1},
     .correction = {"fault.motionX=-1", "fault.motionY=-1"},
     .fault = Fault::MotionNegated,
     .change = "Negate the motion that you write, or state the other direction."},
    {.kind = MotionKind::SwappedAxes,
     .id = "swappedAxes",
     .text = "x and y exchanged",
     .madeOf = MotionMadeOf::Factors,
     .shares = {0, 1, 1, 0},
     .correction = {"fault.motionSwapped=on"},
     .fault = Fault::MotionSwapped,
     .change = "Exchange x and y of motion."},
    {.kind = MotionKind::TurnedLeft,
     .id = "turnedLeft",
     .text = "x and y exchanged, x negated then",
     .madeOf = MotionMadeOf::Factors,
     .shares = {0, -1, 1, 0},
     .own = kTurned,
     .change = "Exchange x and y of motion, and negate x then: it is turned by a quarter."},
    {.kind = MotionKind::TurnedRight,
     .id = "turnedRight",
     .text = "x and y exchanged, y negated then",
     .madeOf = MotionMadeOf::Factors,
     .shares = {0, 1, -1, 0},
     .own = kTurned,
     .change = "Exchange x and y of motion, and negate y then: it is turned by a quarter."},
    {.kind = MotionKind::JitterOfThis,
     .id = "jitterOfThis",
     .text = "without this frame's jitter",
     .madeOf = MotionMadeOf::Jitter,
     .shares = {-1, 0},
     .correction = {"fault.motionJitter=thisOff"},
     .fault = Fault::MotionJitterThis,
     .change = kMakeWithoutJitter},
    {.kind = MotionKind::JitterOfPrevious,
     .id = "jitterOfPrevious",
     .text = "without the jitter of the frame before",
     .madeOf = MotionMadeOf::Jitter,
     .shares = {0, 1},
     .correction = {"fault.motionJitter=lastOff"},
     .fault = Fault::MotionJitterLast,
     .change = kMakeWithoutJitter},
    {.kind = MotionKind::JitterOfBoth,
     .id = "jitterOfBoth",
     .text = "without the difference of both jitters",
     .madeOf = MotionMadeOf::Jitter,
     .shares = {-1, 1},
     .correction = {"fault.motionJitter=bothOff"},
     .fault = Fault::MotionJitterBoth,
     .change = kMakeWithoutJitter},
    {.kind = MotionKind::JitterTakenOff,
     .id = "jitterTakenOff",
     .text = "with the difference of both jitters added",
     .madeOf = MotionMadeOf::Jitter,
     .shares = {1, -1},
     .correction = {"fault.motionJitter=both"},
     .own = kJitterTakenOff,
     .change =
         "Take no jitter off, or state that it is in motion no more: the matrices that motion is made with "
         "have none."},
    {.kind = MotionKind::JitterOfThisTakenOff,
     .id = "jitterOfThisTakenOff",
     .text = "with this frame's jitter added",
     .madeOf = MotionMadeOf::Jitter,
     .shares = {1, 0},
     .correction = {"fault.motionJitter=this"},
     .own = kJitterTakenOff,
     .change = "Take this frame's jitter off no more, or state that motion does not hold it."},
    {.kind = MotionKind::JitterOfPreviousTakenOff,
     .id = "jitterOfPreviousTakenOff",
     .text = "with the jitter of the frame before added",
     .madeOf = MotionMadeOf::Jitter,
     .shares = {0, -1},
     .correction = {"fault.motionJitter=last"},
     .own = kJitterTakenOff,
     .change = "Take the jitter of the frame before off no more, or state that motion does not hold it."},
    {.kind = MotionKind::FrameLate,
     .id = "frameLate",
     .text = "that of the frame after",
     .madeOf = MotionMadeOf::OtherFrame,
     .motion = ofNext,
     .correction = {"fault.motionLag=-1"},
     .fault = Fault::MotionLingers,
     .change = "Give each frame its own motion: what you write is that of the frame before."},
    {.kind = MotionKind::FrameEarly,
     .id = "frameEarly",
     .text = "that of the frame before",
     .madeOf = MotionMadeOf::OtherFrame,
     .motion = ofLast,
     .correction = {"fault.motionLag=1"},
     .own = {"motionFrameEarly", "Motion a frame early",
             "Edges break for a frame when something stops or starts."},
     .change = "Give each frame its own motion: what you write is that of the frame after."},
    {.kind = MotionKind::Forward,
     .id = "forward",
     .text = "that which the frame before holds of the same surface",
     .madeOf = MotionMadeOf::OtherFrame,
     .motion = forwardMotion,
     .own =
         {"motionForward", "Motion to the next frame",
          "Ghosts of what speeds up or slows down; the history of a pixel is looked for where it will be."},
     .change =
         "Motion has to say where a pixel was in the frame before. What you write says where it will be in "
         "the next one (forward vectors): write the vectors to the frame before, or give each frame those "
         "that the frame before has."},
    {.kind = MotionKind::Scaled, .id = "scaled", .text = "", .madeOf = MotionMadeOf::Factors},
    {.kind = MotionKind::LacksCamera,
     .id = "lacksCamera",
     .text = "with the camera's motion added",
     .madeOf = MotionMadeOf::Camera,
     .motion = plusCamera<1>,
     .correction = {"fault.previousCamera=twice"}},
    {.kind = MotionKind::CameraTwice,
     .id = "cameraTwice",
     .text = "with the camera's motion taken off once",
     .madeOf = MotionMadeOf::Camera,
     .motion = plusCamera<-1>,
     .correction = {"fault.previousCamera=ofNow"},
     .own = {"motionCameraTwice", "The camera's motion twice", "Ghosts grow with speed."},
     .change = "Take the camera's motion off once, or state that motion holds it: it does already."},
    {.kind = MotionKind::Encoded,
     .id = "encoded",
     .text = "decoded from 0 to 1",
     .madeOf = MotionMadeOf::Curve,
     .motion = decoded,
     .correction = {"fault.motionUnit=asBiased"},
     .fault = Fault::MotionEncoded,
     .change =
         "Decode motion before it is used: what is stored is ½ + ½ of it, in shares of the picture. Or state "
         "that encoding."},
    {.kind = MotionKind::Root,
     .id = "root",
     .text = "squared, in shares of the picture",
     .madeOf = MotionMadeOf::Curve,
     .motion = squared,
     .correction = {"fault.motionUnit=asRoot"},
     .fault = Fault::MotionRoot,
     .change =
         "Decode motion before it is used: what is stored is its root, in shares of the picture. Or state "
         "that encoding."},
    {.kind = MotionKind::OtherUnit, .id = "otherUnit", .text = "", .madeOf = MotionMadeOf::Factors},
    // What an earlier frame added is not known of what moves: nothing corrects it.
    {.kind = MotionKind::TwoFramesOld,
     .id = "twoFramesOld",
     .text = "without that of the frame before, which it holds as well",
     .madeOf = MotionMadeOf::Camera,
     .motion = withoutOlder,
     .fault = Fault::PreviousTwoFramesOld,
     .change = "Keep the transforms of the frame before: motion goes back to those of two frames ago."},
    {.kind = MotionKind::CameraTurned,
     .id = "cameraTurned",
     .text = "with the previous camera turned back",
     .madeOf = MotionMadeOf::OtherCamera,
     .motion = without<&OtherCameras::turned>,
     .fault = Fault::CameraTurned,
     .change =
         "What rests moves as if the previous camera had looked elsewhere: make motion with the view of the "
         "frame before, unchanged."},
    {.kind = MotionKind::CameraBeside,
     .id = "cameraBeside",
     .text = "with the previous camera moved back",
     .madeOf = MotionMadeOf::OtherCamera,
     .motion = without<&OtherCameras::beside>,
     .fault = Fault::CameraOfSecondView,
     .change = "What rests moves as if the previous camera had stood beside this one: make motion with the "
               "matrices of the frame before of the same view."},
    {.kind = MotionKind::CameraMirrored,
     .id = "cameraMirrored",
     .text = "with the previous camera's own matrix, not that of a mirror",
     .madeOf = MotionMadeOf::OtherCamera,
     .motion = without<&OtherCameras::mirrored>,
     .fault = Fault::CameraOfMirror,
     .change =
         "What rests moves as if the previous camera had been that of a mirror: keep the matrices of each "
         "view apart."},
    {.kind = MotionKind::CameraIdentity,
     .id = "cameraIdentity",
     .text = "with the previous camera's matrix, which was never set",
     .madeOf = MotionMadeOf::OtherCamera,
     .motion = without<&OtherCameras::identity>,
     .fault = Fault::PreviousIdentity,
     .change =
         "What rests moves as if the previous matrix were 1: set it to that of the frame before, and in the "
         "first frame to this frame's."},
    {.kind = MotionKind::CameraUnzoomed,
     .id = "cameraUnzoomed",
     .text = "with the previous camera's own projection, not this one's",
     .madeOf = MotionMadeOf::OtherCamera,
     .motion = without<&OtherCameras::unzoomed>,
     .own = {"motionWithoutZoom", "The change of the field of view missing in motion",
             "Everything smears towards the border while the camera zooms."},
     .change =
         "Motion is made with this frame's projection for the previous position, too: keep the whole matrix "
         "of the frame before, its projection included."},
    {.kind = MotionKind::CameraUnmoved,
     .id = "cameraUnmoved",
     .text = "with the way of the camera, not its turning alone",
     .madeOf = MotionMadeOf::OtherCamera,
     .motion = without<&OtherCameras::unmoved>,
     .own = {"motionWithoutCamerasWay", "The camera's way missing in motion",
             "Near things smear while the camera moves; where it turns all is right."},
     .change = "Motion knows the turning of the camera and not its way: the previous matrix has this frame's "
               "position. Keep the whole matrix of the frame before."},
    {.kind = MotionKind::CameraUnturned,
     .id = "cameraUnturned",
     .text = "with the turning of the camera, not its way alone",
     .madeOf = MotionMadeOf::OtherCamera,
     .motion = without<&OtherCameras::unturned>,
     .own = {"motionWithoutCamerasTurn", "The camera's turning missing in motion",
             "Everything smears while the camera turns; where it moves straight on all is right."},
     .change = "Motion knows the way of the camera and not its turning: the previous matrix has this frame's "
               "rotation. Keep the whole matrix of the frame before."},
    {.kind = MotionKind::OfCamera,
     .id = "ofCamera",
     .text = "that of the camera",
     .madeOf = MotionMadeOf::Camera,
     .motion = ofCamera,
     .correction = {"fault.motion=cameraOnly"}},
});
static_assert(std::ranges::all_of(kMotionRows, [](const MotionRow& row) {
  return &row - kMotionRows.data() == static_cast<std::ptrdiff_t>(row.kind);
}));

void addFactors(std::vector<MotionTrial>& trials) {
  for (const float factor :
       {0.5f, 2.0f, 0.25f, 1.0f / 3.0f, 2.0f / 3.0f, 0.75f, 4.0f / 3.0f, 1.5f, 3.0f, 4.0f})
    trials.push_back({MotionKind::Scaled, glm::vec2(factor)});
}

/// Texture or device coordinates taken for pixels, and the other way; y of the latter may point up. Direction
/// and axes may be wrong besides.
void addUnits(const glm::ivec2& sizePx, std::vector<MotionTrial>& trials) {
  const glm::vec2 uv(sizePx), ndc = 0.5f * uv, yUp(1.0f, -1.0f), xLeft(-1.0f, 1.0f);
  for (const glm::vec2& unit : {uv, 1.0f / uv})
    for (const glm::vec2& factor : {unit, unit * yUp, -unit, unit * xLeft})
      trials.push_back({MotionKind::OtherUnit, factor});
  for (const glm::vec2& unit : {ndc, 1.0f / ndc})
    for (const glm::vec2& factor : {unit * yUp, unit, unit * xLeft, -unit})
      trials.push_back({MotionKind::OtherUnit, factor, true});
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
  for (const MotionRow& row : kMotionRows)
    if (row.kind == MotionKind::Scaled)
      addFactors(trials);
    else if (row.kind == MotionKind::OtherUnit)
      addUnits(sizePx, trials);
    else
      trials.push_back({row.kind});
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
  const glm::vec2 stored = frames.now.motionAt(pixel.x, pixel.y);
  if (const auto factors = factorsOf(trial)) return glm::vec2(*factors * glm::dvec2(stored));
  const MotionRow& row = motionRow(trial.kind);
  if (row.madeOf == MotionMadeOf::Jitter)
    return stored + (row.shares[0] * frames.now.jitterPx + row.shares[1] * frames.before.jitterPx);
  return row.motion(frames, pixel);
}

} // namespace taa::doctor
