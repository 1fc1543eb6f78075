#include "core/doctor/sequence/BadValues.h"

#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/doctor/motion/MotionFindings.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <utility>

namespace taa::doctor {

namespace {

constexpr std::size_t kMostSteps = 256;  ///< of 8 bits
constexpr std::size_t kFewInRegion = 16; ///< of a frame: at a silhouette they are those of what is beside

} // namespace

void ValueEvidence::add(const DoctorFrame& frame, const std::vector<RegionIndex>& labels) {
  badColors_ += frame.badColors;
  addDepth(frame);
  if (frame.motionPx.empty()) return;
  asked_.push_back(frame.frame);
  addWhole(frame);
  addSteps(frame);
  std::map<RegionIndex, std::size_t> counts;
  const std::size_t before = motion_.nan + motion_.infinite;
  for (int y = 0; y < frame.motionPx.height; ++y)
    for (int x = 0; x < frame.motionPx.width; ++x) {
      const glm::vec2 motion = frame.motionAt(x, y);
      if (std::isfinite(motion.x) && std::isfinite(motion.y)) continue;
      if (motion_.frames.empty()) motion_.pixel = {x, y};
      if (motion_.frames.empty() || motion_.frames.back() != frame.frame)
        motion_.frames.push_back(frame.frame);
      ++(std::isnan(motion.x) || std::isnan(motion.y) ? motion_.nan : motion_.infinite);
      ++counts[labels[static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.motionPx.width) +
                      static_cast<std::size_t>(x)]];
    }
  if (motion_.nan + motion_.infinite == before) return;
  for (const auto& [region, count] : counts)
    if (region != kNoRegion && count >= kFewInRegion) motion_.regions.insert(region);
}

void ValueEvidence::addWhole(const DoctorFrame& frame) {
  constexpr float kMovesPx = 0.5f, kWholePx = 1e-3f;
  constexpr std::size_t kMostLengths = 64;
  for (int y = 0; y < frame.motionPx.height; ++y)
    for (int x = 0; x < frame.motionPx.width; ++x) {
      const glm::vec2 motion = frame.motionAt(x, y);
      if (!isMotion(motion) || std::max(std::abs(motion.x), std::abs(motion.y)) < kMovesPx) continue;
      ++moving_;
      const glm::vec2 whole(std::round(motion.x), std::round(motion.y));
      if (std::abs(motion.x - whole.x) > kWholePx || std::abs(motion.y - whole.y) > kWholePx) continue;
      ++whole_;
      if (lengths_.size() < kMostLengths)
        lengths_.emplace(static_cast<int>(whole.x), static_cast<int>(whole.y));
    }
}

void ValueEvidence::addSteps(const DoctorFrame& frame) {
  if (frame.startsHistory) return; // its motion refers to itself
  for (int axis = 0; axis < 2; ++axis) {
    std::set<float>& all = values_[static_cast<std::size_t>(axis)];
    if (all.size() > kMostSteps) return;
    std::set<float> values;
    for (int y = 0; y < frame.motionPx.height; ++y)
      for (int x = 0; x < frame.motionPx.width; ++x) {
        const glm::vec2 motion = frame.motionAt(x, y);
        if (isMotion(motion) && values.size() <= kMostSteps) values.insert(motion[axis]);
      }
    mostOfFrame_ = std::max(mostOfFrame_, values.size());
    all.merge(values);
  }
}

std::optional<glm::dvec2> ValueEvidence::stepsPx() const {
  constexpr double kCoarsePx = 0.25, kWhole = 0.02;
  constexpr std::size_t kEnough = 5; // fewer may be as many things, whose speeds change evenly
  glm::dvec2 out(0.0);
  if (mostOfFrame_ < kEnough) return {};
  for (int axis = 0; axis < 2; ++axis) {
    const std::set<float>& values = values_[static_cast<std::size_t>(axis)];
    if (values.size() < 2 || values.size() > kMostSteps) return {};
    double step = std::numeric_limits<double>::infinity();
    for (auto at = std::next(values.begin()); at != values.end(); ++at)
      step = std::min(step, static_cast<double>(*at) - static_cast<double>(*std::prev(at)));
    if (!(step >= kCoarsePx)) return {};
    // Half floats round each; over all of them that comes to little.
    const double all = static_cast<double>(*values.rbegin()) - static_cast<double>(*values.begin());
    step = all / std::round(all / step);
    for (const float value : values) {
      const double steps = (static_cast<double>(value) - static_cast<double>(*values.begin())) / step;
      if (std::abs(steps - std::round(steps)) > kWhole) return {};
    }
    out[axis] = step;
  }
  return out;
}

void ValueEvidence::addDepth(const DoctorFrame& frame) {
  if (frame.depth.empty()) return;
  const float least = *std::ranges::min_element(frame.depth.pixels);
  const auto count = std::ranges::count(frame.depth.pixels, least);
  farthest_.isSame = farthest_.isSame && (farthest_.frames == 0 || least == farthest_.depth);
  farthest_.depth = least;
  if (!frame.depthView.empty()) farthest_.distance = *std::ranges::max_element(frame.depthView.pixels);
  farthest_.share =
      std::min(farthest_.share, static_cast<double>(count) / static_cast<double>(frame.depth.pixels.size()));
  ++farthest_.frames;
}

std::optional<FarthestDepth> ValueEvidence::unstatedSky() const {
  constexpr double kMuch = 0.02; // a surface has one value over so much of the picture only where it faces it
  constexpr int kEnoughFrames = 3;
  const bool isSky = farthest_.frames >= kEnoughFrames && farthest_.isSame && farthest_.share >= kMuch &&
                     farthest_.depth > 0.0f && farthest_.depth < 1.0f;
  return isSky ? std::optional(farthest_) : std::nullopt;
}

bool ValueEvidence::isOfWholePixels() const {
  constexpr std::size_t kEnough = 2000, kManyLengths = 8; // fewer a plain scroll may have
  constexpr double kNearlyAll = 0.995;
  return moving_ >= kEnough && lengths_.size() >= kManyLengths &&
         static_cast<double>(whole_) >= kNearlyAll * static_cast<double>(moving_);
}

void tellBadValues(const ValueEvidence& evidence, const std::vector<Region>& regions,
                   const CaptureInfo& captureInfo, Diagnosis& out) {
  if (evidence.badColors() > 0)
    out.notes.push_back(
        say<"Color is no number (NaN or infinite) at %1 pixels of all frames: each that history takes "
            "over stays there.">(evidence.badColors()));
  if (const auto sky = evidence.unstatedSky())
    out.parts.leaveOpen(
        {say<"The sky in depth">(),
         say<"over %1 % of the picture or more, in all frames, depth is exactly the same, %2 m away; nothing "
             "is farther, and nothing lies in the far plane">(shortNumber(100.0 * sky->share),
                                                              shortNumber(sky->distance)),
         say<"If nothing is drawn there, state what is stored there (depth.nothing).">()});
  if (evidence.isOfWholePixels()) {
    Finding whole;
    whole.id = "motionWholePixels";
    whole.name = say<"Motion of whole pixels alone">();
    whole.symptom = say<"What moves slowly trembles and smears by half a pixel.">();
    whole.isWholePicture = true;
    whole.reason = say<"All motion that is longer than half a pixel is of whole pixels, in many lengths.">();
    whole.change = say<"Store motion in a format with fractions of a pixel, and do not round it.">();
    out.findings.push_back(std::move(whole));
  }
  if (const auto steps = evidence.stepsPx(); steps && !evidence.isOfWholePixels()) {
    Finding coarse;
    coarse.id = kMotionStepsId;
    coarse.name = say<"Motion in coarse steps">();
    coarse.symptom = say<"Everything that moves slowly trembles and smears.">();
    coarse.isWholePicture = true;
    coarse.reason = say<"All motion of all frames is one of a few values that are steps of %1 px along x and "
                        "%2 px along y apart.">(shortNumber(steps->x), shortNumber(steps->y));
    coarse.change =
        say<"Store motion with more bits: 16 of each component, or a range as narrow as motion is.">();
    out.findings.push_back(std::move(coarse));
  }
  const NotFinite& motion = evidence.motion();
  if (motion.frames.empty()) return;
  Finding finding;
  finding.id = "motionNotFinite";
  finding.name = say<"Motion that is no number">();
  finding.symptom = say<"Pixels that flash, or spread black.">();
  for (const RegionIndex region : motion.regions)
    finding.regions.push_back(
        placeOf(regions[static_cast<std::size_t>(region)], captureInfo, allPixels(captureInfo, out)));
  std::ranges::stable_sort(finding.regions, std::greater(), &RegionPlace::share);
  finding.reason =
      say<"In %1 motion is NaN at %2 pixels and infinite at %3, for example at pixel %4, %5 of frame %6.">(
          captureInfo.frameNames.of(motion.frames, evidence.asked()), motion.nan, motion.infinite,
          motion.pixel.x, motion.pixel.y, captureInfo.frameNames.of(motion.frames.front()));
  finding.change = say<
      "Look for a division by 0 where its motion is made: w of a previous position that was never set, or "
      "a matrix that cannot be inverted. If NaN says \"not written\", write a number for that and state it (motion.notWritten).">();
  out.findings.push_back(std::move(finding));
}

} // namespace taa::doctor
