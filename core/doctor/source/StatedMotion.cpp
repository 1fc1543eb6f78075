#include "core/doctor/source/StatedMotion.h"

#include "core/base/Say.h"
#include "core/capture/decode/ScreenUnits.h"
#include "core/capture/import/FrameSamples.h"
#include "core/doctor/NumberText.h"
#include "core/doctor/depth/DepthCheck.h"
#include "core/doctor/jitter/JitterCheck.h"
#include "core/doctor/motion/findings/MotionWords.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

namespace taa::doctor {

namespace {

using capture::Conventions;
using capture::FramePair;
using capture::FrameSamples;
using capture::JitterInMotion;
using capture::ScreenUnit;
using capture::VerticalAxis;

constexpr int kPairs = 3;
constexpr std::size_t kPlacesOfPair = 2500;
/// Pixels that the camera moves: fewer say nothing.
constexpr std::size_t kEnoughMoved = 200;
constexpr double kMovedShare = 0.1;
/// Of these: what is stated is right, or something else explains them, and so many more than what is stated.
constexpr double kRightShare = 0.9, kExplainedShare = 0.5, kMoreShare = 0.15;
/// What explains so much less explains as much.
constexpr double kSameShare = 0.03;

/// What is stated by one convention; of one group only one can be wrong.
enum class Group : std::uint8_t {
  MotionUnit,
  MotionAxes,
  MotionCamera,
  MotionJitter,
  JitterSign,
  JitterFrame,
  DepthKind,
  DepthRange,
  DepthOrder,
  ClipRange,
  ClipAxis,
  Rows,
};

struct Otherwise {
  Group group;
  std::function<void(Conventions&)> state;
  Finding finding; ///< without what it rests on
  /// Told though nothing else is stated wrongly: what else is examined rests on it, or pictures do not show
  /// it beside something else.
  bool isToldAlone = false;
  /// Told beside jitter in motion alone: what rests has no motion then, in whatever unit and by whatever
  /// depth.
  bool addsCamera = false;
  /// Told beside something else alone: three things that pictures tell one by one.
  bool isOfSeveral = false;
};

Finding motionFinding(const MotionTrial& trial) {
  const MotionFault fault = motionFault(&trial, Region(), RegionEvidence());
  Finding out;
  out.id = fault.id;
  out.name = fault.name;
  out.symptom = fault.symptom;
  out.change = fault.change;
  return out;
}

Finding matricesFinding(std::string id, std::string name) {
  Finding out;
  out.id = std::move(id);
  out.name = std::move(name);
  out.isWholePicture = true;
  out.symptom = say<"Whatever is made of depth and matrices, as motion of the sky, goes the wrong way.">();
  return out;
}

template <typename Value>
Value otherOf(Value now, Value one, Value two) {
  return now == one ? two : one;
}

void turnY(VerticalAxis& axis) {
  axis = otherOf(axis, VerticalAxis::Up, VerticalAxis::Down);
}

void addUnits(const Conventions& stated, const glm::ivec2& sizePx, std::vector<Otherwise>& out) {
  for (const ScreenUnit unit : {ScreenUnit::Pixels, ScreenUnit::Uv, ScreenUnit::Ndc}) {
    if (unit == stated.motion.unit) continue;
    const auto perUnit = [&](ScreenUnit of) { return capture::pxPerUnit(of, VerticalAxis::Down, sizePx); };
    MotionTrial trial{MotionKind::OtherUnit, glm::vec2(perUnit(unit) / perUnit(stated.motion.unit))};
    trial.isDevice = unit == ScreenUnit::Ndc || stated.motion.unit == ScreenUnit::Ndc;
    if (unit != ScreenUnit::Pixels && stated.motion.unit != ScreenUnit::Pixels)
      trial.kind = MotionKind::Scaled;
    out.push_back(
        {Group::MotionUnit, [unit](Conventions& c) { c.motion.unit = unit; }, motionFinding(trial)});
  }
}

void addAxes(std::vector<Otherwise>& out) {
  out.push_back({Group::MotionAxes,
                 [](Conventions& c) {
                   using capture::MotionDirection;
                   c.motion.direction = otherOf(c.motion.direction, MotionDirection::CurrentMinusPrevious,
                                                MotionDirection::PreviousMinusCurrent);
                 },
                 motionFinding({MotionKind::Opposite})});
  out.push_back({Group::MotionAxes, [](Conventions& c) { turnY(c.motion.yAxis); },
                 motionFinding({MotionKind::MirroredY})});
  out.push_back({Group::MotionAxes, [](Conventions& c) { c.motion.scale.x = -c.motion.scale.x; },
                 motionFinding({MotionKind::MirroredX})});
}

void addCamera(const Conventions& stated, std::vector<Otherwise>& out) {
  const bool has = stated.motion.includesCamera;
  out.push_back({Group::MotionCamera, [has](Conventions& c) { c.motion.includesCamera = !has; },
                 motionFinding({has ? MotionKind::LacksCamera : MotionKind::CameraTwice}), !has, has});
}

/// Whose jitter motion holds: of this frame and the one before.
glm::ivec2 heldJitter(JitterInMotion kind) {
  switch (kind) {
  case JitterInMotion::Removed:
    break;
  case JitterInMotion::Both:
    return {1, -1};
  case JitterInMotion::Current:
    return {1, 0};
  case JitterInMotion::Previous:
    return {0, -1};
  }
  return {0, 0};
}

/// What is wrong with motion that holds more or less of it than is taken off.
std::optional<MotionKind> jitterKind(const glm::ivec2& held) {
  const std::pair<glm::ivec2, MotionKind> kinds[] = {
      {{1, -1}, MotionKind::JitterOfBoth},         {{1, 0}, MotionKind::JitterOfThis},
      {{0, -1}, MotionKind::JitterOfPrevious},     {{-1, 1}, MotionKind::JitterTakenOff},
      {{-1, 0}, MotionKind::JitterOfThisTakenOff}, {{0, 1}, MotionKind::JitterOfPreviousTakenOff}};
  for (const auto& [of, kind] : kinds)
    if (of == held) return kind;
  return {};
}

void addJitter(const Conventions& stated, std::vector<Otherwise>& out) {
  for (const JitterInMotion jitter :
       {JitterInMotion::Removed, JitterInMotion::Both, JitterInMotion::Current, JitterInMotion::Previous}) {
    const auto kind = jitterKind(heldJitter(jitter) - heldJitter(stated.motion.jitter));
    if (kind)
      out.push_back({Group::MotionJitter, [jitter](Conventions& c) { c.motion.jitter = jitter; },
                     motionFinding({*kind}), stated.motion.jitter != JitterInMotion::Removed});
  }
  using capture::JitterMeaning;
  const auto turn = [](Conventions& c) {
    c.jitter.meaning = otherOf(c.jitter.meaning, JitterMeaning::Content, JitterMeaning::Sample);
  };
  const auto turnJitterY = [](Conventions& c) { turnY(c.jitter.yAxis); };
  out.push_back({Group::JitterSign, turn, jitterFinding({JitterKind::Opposite}), true});
  out.push_back({Group::JitterSign, turnJitterY, jitterFinding({JitterKind::MirroredY}), true});
  out.push_back({Group::JitterSign,
                 [turn, turnJitterY](Conventions& c) {
                   turn(c);
                   turnJitterY(c);
                 },
                 jitterFinding({JitterKind::MirroredX}), true});
  if (stated.jitter.delay > -1)
    out.push_back({Group::JitterFrame, [](Conventions& c) { --c.jitter.delay; },
                   jitterFinding({JitterKind::FrameLate}), true});
  if (stated.jitter.delay < 1)
    out.push_back({Group::JitterFrame, [](Conventions& c) { ++c.jitter.delay; },
                   jitterFinding({JitterKind::FrameEarly}), true});
}

/// `lowest`: of what is stored. Depth of another range makes the same motion as matrices of another one do:
/// of the two that can be wrong which what is stored lies in.
bool isOtherRange(const Conventions& stated, float lowest) {
  return stated.depth.kind == capture::DepthKind::Window &&
         (stated.depth.range == capture::ClipRange::ZeroToOne) == (lowest < 0.0f);
}

/// Of a depth buffer, either way around; and distances along the axis, on either side of the camera.
void addDepthKinds(const Conventions& stated, float lowest, std::vector<Otherwise>& out) {
  using capture::DepthConventions;
  const DepthConventions& depth = stated.depth;
  if (depth.kind == capture::DepthKind::Window) {
    out.push_back({Group::DepthKind,
                   [lowest](Conventions& c) {
                     DepthConventions distance;
                     distance.kind = capture::DepthKind::Planar;
                     distance.scale = lowest < 0.0f ? -1.0 : 1.0;
                     distance.nothing = c.depth.nothing;
                     distance.jittered = c.depth.jittered;
                     c.depth = distance;
                   },
                   depthFinding(RelationKind::Linear)});
    return;
  }
  for (const bool isReversed : {true, false})
    out.push_back({Group::DepthKind,
                   [isReversed, lowest](Conventions& c) {
                     DepthConventions window;
                     window.reversed = isReversed;
                     window.range =
                         lowest < 0.0f ? capture::ClipRange::MinusOneToOne : capture::ClipRange::ZeroToOne;
                     window.jittered = c.depth.jittered;
                     c.depth = window;
                   },
                   depthKindFinding(), true});
}

void addDepth(const Conventions& stated, float lowest, std::vector<Otherwise>& out) {
  addDepthKinds(stated, lowest, out);
  if (stated.depth.kind != capture::DepthKind::Window) return;
  using capture::ClipRange;
  out.push_back({Group::DepthOrder, [](Conventions& c) { c.depth.reversed = !c.depth.reversed; },
                 depthFinding(RelationKind::Reversed)});
  if (!isOtherRange(stated, lowest)) return;
  Finding range = depthFinding(RelationKind::HalfRange);
  if (stated.depth.range == ClipRange::ZeroToOne)
    range.change = say<"State that depth is stored from −1 to 1: it is not from 0 to 1.">();
  out.push_back({Group::DepthRange,
                 [](Conventions& c) {
                   c.depth.range = otherOf(c.depth.range, ClipRange::ZeroToOne, ClipRange::MinusOneToOne);
                 },
                 std::move(range), true});
}

void addMatrices(const Conventions& stated, float lowest, std::vector<Otherwise>& out) {
  using capture::ClipRange;
  out.push_back({Group::ClipAxis, [](Conventions& c) { turnY(c.matrices.clipY); }, matricesFlipped({})});
  if (isOtherRange(stated, lowest)) return;
  const bool isFrom0 = stated.matrices.clipZ == ClipRange::ZeroToOne;
  Finding range = matricesFinding("matricesRange", say<"Matrices of another range of depth">());
  range.change = isFrom0 ? say<"State that z of clip space goes from −1 to 1, as OpenGL's does.">()
                         : say<"State that z of clip space goes from 0 to 1, as that of Direct3D, Vulkan and "
                               "Metal does.">();
  out.push_back({Group::ClipRange,
                 [](Conventions& c) {
                   c.matrices.clipZ =
                       otherOf(c.matrices.clipZ, ClipRange::ZeroToOne, ClipRange::MinusOneToOne);
                 },
                 std::move(range), true});
}

/// Planes are read once: what is stored from the other end has another y in all that has one.
void addRows(const Conventions& stated, std::vector<Otherwise>& out) {
  out.push_back({Group::Rows,
                 [](Conventions& c) {
                   turnY(c.motion.yAxis);
                   turnY(c.jitter.yAxis);
                   turnY(c.matrices.clipY);
                 },
                 rowsTurned(stated.rows)});
  out.back().isOfSeveral = true;
}

/// The rows alone, where `conventions` say the same by three axes.
void turnRows(Conventions& conventions) {
  using capture::RowOrder;
  turnY(conventions.motion.yAxis);
  turnY(conventions.jitter.yAxis);
  turnY(conventions.matrices.clipY);
  conventions.rows = otherOf(conventions.rows, RowOrder::TopFirst, RowOrder::BottomFirst);
}

std::vector<Otherwise> othersThan(const capture::Manifest& manifest, float lowestDepth) {
  const Conventions& stated = manifest.conventions;
  std::vector<Otherwise> out;
  addUnits(stated, manifest.sizePx, out);
  addAxes(out);
  addCamera(stated, out);
  addJitter(stated, out);
  addDepth(stated, lowestDepth, out);
  addMatrices(stated, lowestDepth, out);
  addRows(stated, out);
  return out;
}

/// A part of a pair's pixels, without its pictures.
FramePair thinned(const FramePair& pair) {
  FramePair out;
  out.index = pair.index;
  const std::size_t step = std::max<std::size_t>(1, pair.places.size() / kPlacesOfPair);
  const std::size_t count = (pair.places.size() + step - 1) / step;
  out.motion = Image(static_cast<int>(count), 1, pair.motion.channels);
  out.depth = Image(static_cast<int>(count), 1, pair.depth.channels);
  for (std::size_t i = 0; i < count; ++i) {
    out.places.push_back(pair.places[i * step]);
    const int from = static_cast<int>(i * step), to = static_cast<int>(i);
    std::copy_n(pair.motion.at(from, 0), pair.motion.channels, out.motion.at(to, 0));
    std::copy_n(pair.depth.at(from, 0), pair.depth.channels, out.depth.at(to, 0));
  }
  return out;
}

/// Pixels that the camera moves, and those of them whose motion is the camera's.
struct Fit {
  std::size_t places = 0, moved = 0, fits = 0;

  bool isEnough() const {
    return moved >= kEnoughMoved && static_cast<double>(moved) >= kMovedShare * static_cast<double>(places);
  }
  double share() const { return isEnough() ? static_cast<double>(fits) / static_cast<double>(moved) : 0.0; }
};

class MotionFits {
 public:
  MotionFits(const std::filesystem::path& folder, const capture::Manifest& manifest, int pairs)
      : samples_(folder, manifest, pairs, {}) {
    for (const FramePair& pair : samples_.pairs())
      if (!pair.motion.empty() && !pair.depth.empty()) pairs_.push_back(thinned(pair));
  }

  float lowestDepth() const {
    float lowest = 0.0f;
    for (const FramePair& pair : pairs_)
      for (const float depth : pair.depth.pixels) lowest = std::min(lowest, depth);
    return lowest;
  }
  Fit of(const Conventions& conventions) {
    Fit out;
    for (const FramePair& pair : pairs_)
      if (const auto motion = samples_.motionOf(pair, {conventions}, true))
        add(*motion, conventions.motion.includesCamera, out);
    return out;
  }

 private:
  static void add(const capture::PairMotion& motion, bool includesCamera, Fit& out) {
    constexpr float kMovedPx = 0.5f, kSamePx = 0.05f, kSameShareOfLength = 1.0f / 512.0f;
    // Where the camera's motion is added, what rests has none: motion of too small a unit is nearly none.
    constexpr float kNothingPx = 5e-4f;
    const auto isKnown = [](const glm::vec2& px) { return std::isfinite(px.x) && std::isfinite(px.y); };
    if (motion.camera.empty() || std::ranges::none_of(motion.stored, isKnown)) return;
    for (std::size_t i = 0; i < motion.camera.size(); ++i) {
      const glm::vec2& camera = motion.camera[i];
      const float length = glm::length(camera);
      ++out.places;
      if (!(length >= kMovedPx) || !(length < kNoPreviousPosition)) continue;
      ++out.moved;
      const float sameAsPx = includesCamera ? kSamePx + kSameShareOfLength * length : kNothingPx;
      // Written so that NaN fails it.
      if (glm::distance(motion.stored[i], camera) <= sameAsPx) ++out.fits;
    }
  }

  FrameSamples samples_;
  std::vector<FramePair> pairs_;
};

/// Nothing, one or two things that are stated otherwise.
using Changes = std::vector<const Otherwise*>;

/// Whether what is stated beside rows from the other end could stand for a part of them, or for nothing.
bool hidesRows(Group group) {
  return group == Group::MotionAxes || group == Group::ClipAxis || group == Group::JitterSign ||
         group == Group::JitterFrame;
}

std::vector<Changes> changesOf(const std::vector<Otherwise>& others) {
  std::vector<Changes> out;
  for (const Otherwise& one : others)
    if (!one.isOfSeveral) out.push_back({&one});
  for (const Otherwise& one : others)
    for (const Otherwise& two : others) {
      if (!(one.group < two.group) || (two.isOfSeveral && hidesRows(one.group))) continue;
      const bool addsCamera = one.addsCamera || two.addsCamera;
      if (!addsCamera || two.group == Group::MotionJitter) out.push_back({&one, &two});
    }
  return out;
}

Conventions changed(Conventions conventions, const Changes& changes) {
  for (const Otherwise* change : changes) change->state(conventions);
  return conventions;
}

/// What explains most by the fewest changes; nothing where that is what is stated, or several do.
std::optional<Changes> bestChanges(MotionFits& fits, const Conventions& stated,
                                   const std::vector<Otherwise>& others) {
  std::vector<std::pair<double, Changes>> tried;
  const double least = std::max(kExplainedShare, fits.of(stated).share() + kMoreShare);
  double best = least;
  for (Changes& changes : changesOf(others)) {
    const double share = fits.of(changed(stated, changes)).share();
    best = std::max(best, share);
    tried.emplace_back(share, std::move(changes));
  }
  std::optional<Changes> out;
  bool isSeveral = false;
  for (const auto& [share, changes] : tried) {
    if (share < std::max(least, best - kSameShare)) continue;
    if (!out || changes.size() < out->size()) {
      out = changes;
      isSeveral = false;
    } else if (changes.size() == out->size()) {
      isSeveral = true;
    }
  }
  if (isSeveral) return {};
  return out;
}

Finding toldFinding(const Otherwise& told, const Changes& changes, double shareStated, double share) {
  Finding out = told.finding;
  out.isWholePicture = true;
  const auto percent = [](double of) { return std::lround(100.0 * of); };
  const bool isAlone = changes.size() == 1;
  const Finding& other = changes[changes.front() == &told ? changes.size() - 1 : 0]->finding;
  out.reason =
      isAlone ? say<"The motion stored is what depth and matrices make it at %1 % of the pixels that the "
                    "camera moves if this is stated otherwise, and at %2 % as it is stated.">(
                    percent(share), percent(shareStated))
              : say<"The motion stored is what depth and matrices make it at %1 % of the pixels that the "
                    "camera moves if two things are stated otherwise, this and “%3”, and at %2 % as it is "
                    "stated.">(percent(share), percent(shareStated), other.name);
  out.measure = say<"pixels whose motion is not what depth and matrices make it, %">();
  out.residuals = {{"otherwise", say<"stated otherwise">(), 100.0 * (1.0 - share), false, true},
                   {"asStated", say<"as stated">(), 100.0 * (1.0 - shareStated), true, false}};
  return out;
}

} // namespace

std::vector<Finding> mendMotion(const std::filesystem::path& folder, capture::Manifest& manifest) {
  const Conventions& stated = manifest.conventions;
  const Fit ofOne = MotionFits(folder, manifest, 1).of(stated);
  if (ofOne.places == 0 || ofOne.share() >= kRightShare) return {};
  MotionFits fits(folder, manifest, kPairs);
  const std::vector<Otherwise> others = othersThan(manifest, fits.lowestDepth());
  const auto changes = bestChanges(fits, stated, others);
  if (!changes || (changes->size() == 1 && !changes->front()->isToldAlone)) return {};
  const Conventions right = changed(stated, *changes);
  const double shareStated = fits.of(stated).share(), share = fits.of(right).share();
  std::vector<Finding> out;
  for (const Otherwise* change : *changes) out.push_back(toldFinding(*change, *changes, shareStated, share));
  manifest.conventions = right;
  if (changes->back()->isOfSeveral) turnRows(manifest.conventions);
  return out;
}

Finding rowsTurned(capture::RowOrder stated) {
  Finding out;
  out.id = "rowsTurned";
  out.name = say<"Rows from the other end">();
  out.isWholePicture = true;
  out.symptom = say<"The picture is upside down; moved by its motion it breaks up.">();
  out.change = stated == capture::RowOrder::TopFirst ? say<"State that rows are stored from the bottom on.">()
                                                     : say<"State that rows are stored from the top on.">();
  return out;
}

Finding matricesFlipped(std::string reason) {
  Finding out = matricesFinding("matricesFlipped", say<"Matrices upside down">());
  out.reason = std::move(reason);
  out.change = say<"State that y of clip space goes the other way, or negate the second row of the "
                   "projection.">();
  return out;
}

} // namespace taa::doctor
