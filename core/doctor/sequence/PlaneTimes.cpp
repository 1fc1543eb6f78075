#include "core/doctor/sequence/PlaneTimes.h"

#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/capture/import/FrameSamples.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace taa::doctor {

namespace {

constexpr float kComparedPx = 1.0f;      ///< what moves by less looks the same a frame later
constexpr float kSilhouetteShare = 0.1f; ///< of the nearer distance
constexpr float kDetailStep = 0.04f;
constexpr std::size_t kEnoughInFrame = 20, kEnoughSilhouettePixels = 300;
constexpr int kEnoughFrames = 4;
/// Silhouettes on another picture's make its steps so many times as high; an output is so much nearer to it.
constexpr double kHigher = 1.2, kNearer = 0.8, kVotes = 0.85;

bool movesAt(const DoctorFrame& frame, const glm::ivec2& pixel) {
  const glm::vec2 motion = frame.motionAt(pixel.x, pixel.y);
  return isMotion(motion) && glm::length(motion) > kComparedPx;
}

bool isDepthSilhouette(float a, float b) {
  if (a == 0.0f || b == 0.0f) return (a == 0.0f) != (b == 0.0f);
  return std::abs(a - b) > kSilhouetteShare * std::min(a, b);
}

/// Neighbors of a pixel to the right and below.
template <typename Take>
void forNeighbors(const glm::ivec2& size, Take take) {
  for (int y = 0; y + 1 < size.y; ++y)
    for (int x = 0; x + 1 < size.x; ++x) {
      take(glm::ivec2(x, y), glm::ivec2(x + 1, y));
      take(glm::ivec2(x, y), glm::ivec2(x, y + 1));
    }
}

std::string planeWord(TimedPlane plane) {
  switch (plane) {
  case TimedPlane::Depth:
    return say<"Depth">();
  case TimedPlane::ObjectIds:
    return say<"Object numbers">();
  case TimedPlane::Output:
    break;
  }
  return say<"Output">();
}

std::string idOf(const PlaneTime& time) {
  const std::string when = time.delay > 0 ? "FrameLate" : "FrameEarly";
  switch (time.plane) {
  case TimedPlane::Depth:
    return "depth" + when;
  case TimedPlane::ObjectIds:
    return "ids" + when;
  case TimedPlane::Output:
    break;
  }
  return "output" + when;
}

std::string symptomOf(TimedPlane plane) {
  if (plane == TimedPlane::Depth) return say<"Disocclusion is found beside what moves.">();
  if (plane == TimedPlane::ObjectIds) return say<"History is rejected beside what moves.">();
  return say<"The picture comes a frame after what it is shown with.">();
}

} // namespace

void PlaneTimes::add(const DoctorFrame& before, const DoctorFrame& now, const DoctorFrame& after) {
  const glm::ivec2 size = now.sizePx();
  if (now.motionPx.empty() || now.startsHistory || after.startsHistory) return;
  if (before.sizePx() != size || after.sizePx() != size) return;
  const bool hasOutput = now.output.width == size.x && now.output.height == size.y;
  const Image output = hasOutput ? capture::comparedLuma(now.output) : Image();
  const std::array<const Image*, 3> lumas{&before.luma, &now.luma, &after.luma};
  std::array<std::array<double, 3>, kTimedPlanes> sums{};
  std::array<std::size_t, kTimedPlanes> counts{};
  const auto addSilhouette = [&](TimedPlane plane, const glm::ivec2& a, const glm::ivec2& b) {
    const auto index = static_cast<std::size_t>(plane);
    ++counts[index];
    for (std::size_t i = 0; i < lumas.size(); ++i)
      sums[index][i] += static_cast<double>(std::abs(*lumas[i]->at(a.x, a.y) - *lumas[i]->at(b.x, b.y)));
  };
  const bool hasDepth = !now.depthView.empty(), hasIds = !now.objectId.empty();
  const auto idAt = [&](const glm::ivec2& at) {
    return now.objectId[static_cast<std::size_t>(at.y) * static_cast<std::size_t>(size.x) +
                        static_cast<std::size_t>(at.x)];
  };
  forNeighbors(size, [&](const glm::ivec2& a, const glm::ivec2& b) {
    if (!movesAt(now, a) && !movesAt(now, b)) return;
    if (hasDepth && isDepthSilhouette(*now.depthView.at(a.x, a.y), *now.depthView.at(b.x, b.y)))
      addSilhouette(TimedPlane::Depth, a, b);
    if (hasIds && idAt(a) != idAt(b)) addSilhouette(TimedPlane::ObjectIds, a, b);
    if (output.empty() || std::abs(*now.luma.at(a.x, a.y) - *now.luma.at(b.x, b.y)) < kDetailStep) return;
    const auto index = static_cast<std::size_t>(TimedPlane::Output);
    ++counts[index];
    for (std::size_t i = 0; i < lumas.size(); ++i)
      sums[index][i] += static_cast<double>(std::abs(*output.at(a.x, a.y) - *lumas[i]->at(a.x, a.y)));
  });
  for (std::size_t plane = 0; plane < kTimedPlanes; ++plane)
    addFrame(static_cast<TimedPlane>(plane), sums[plane], counts[plane]);
}

void PlaneTimes::addFrame(TimedPlane plane, const std::array<double, 3>& sums, std::size_t count) {
  if (count < kEnoughInFrame) return;
  Sums& out = planes_[static_cast<std::size_t>(plane)];
  for (std::size_t i = 0; i < sums.size(); ++i) out.sums[i] += sums[i];
  out.count += count;
  ++out.frames;
  const bool isNear = plane == TimedPlane::Output;
  const auto says = [&](double other) { return isNear ? other < sums[1] : other > sums[1]; };
  if (says(sums[0])) ++out.late;
  if (says(sums[2])) ++out.early;
}

std::vector<PlaneTime> PlaneTimes::found() const {
  std::vector<PlaneTime> out;
  for (std::size_t plane = 0; plane < kTimedPlanes; ++plane) {
    const Sums& of = planes_[plane];
    if (of.frames < kEnoughFrames || of.count < kEnoughSilhouettePixels) continue;
    const auto kind = static_cast<TimedPlane>(plane);
    const bool isNear = kind == TimedPlane::Output;
    for (const int delay : {1, -1}) {
      const double other = of.sums[delay > 0 ? 0 : 2], opposite = of.sums[delay > 0 ? 2 : 0],
                   own = of.sums[1];
      const int voting = delay > 0 ? of.late : of.early;
      const bool isClear =
          isNear ? other <= kNearer * own && other < opposite : other >= kHigher * own && other > opposite;
      if (!isClear || voting < kVotes * of.frames) continue;
      const auto mean = [&](double sum) { return sum / static_cast<double>(of.count); };
      out.push_back({kind, delay, mean(own), mean(other), of.frames, voting});
    }
  }
  return out;
}

void tellPlaneTimes(const std::vector<PlaneTime>& found, Diagnosis& out) {
  for (const PlaneTime& time : found) {
    const std::string plane = planeWord(time.plane);
    const bool isLate = time.delay > 0;
    Finding finding;
    finding.id = idOf(time);
    finding.name = isLate ? say<"%1 a frame late">(plane) : say<"%1 a frame early">(plane);
    finding.symptom = symptomOf(time.plane);
    finding.isWholePicture = true;
    finding.change =
        isLate ? say<"Write with each frame the plane of that frame: what is there is that of the frame "
                     "before.">()
               : say<"Write with each frame the plane of that frame: what is there is that of the frame "
                     "after.">();
    finding.reason =
        time.plane == TimedPlane::Output
            ? say<"Where the picture moves it is nearer to that of another frame than to that of its own, in %1 of %2 "
                  "frames.">(time.voting, time.frames)
            : say<"Where something moves its rims lie on those of the picture of another frame and not of its own, in "
                  "%1 of %2 frames.">(time.voting, time.frames);
    finding.measure = time.plane == TimedPlane::Output ? say<"mean difference of luma, × 1000">()
                                                       : say<"mean step of luma at its rims, × 1000">();
    finding.residuals = {{"other", isLate ? say<"in the frame before">() : say<"in the frame after">(),
                          1000.0 * time.other, false, true},
                         {"own", say<"in its own frame">(), 1000.0 * time.own, true, false}};
    out.findings.push_back(std::move(finding));
  }
}

FrameReader withOwnPlanes(FrameReader read, const std::vector<PlaneTime>& found, int first, int frames) {
  return [read = std::move(read), found, first, end = first + frames](int frame) {
    DoctorFrame out = read(frame);
    for (const PlaneTime& time : found) {
      const int from = frame + time.delay;
      if (time.plane == TimedPlane::Output) continue;
      if (from < first || from >= end) { // nobody has its own
        out.startsHistory = true;
        continue;
      }
      DoctorFrame other = read(from);
      if (time.plane == TimedPlane::ObjectIds) {
        out.objectId = std::move(other.objectId);
        continue;
      }
      out.depth = std::move(other.depth);
      out.depthView = std::move(other.depthView);
      out.previousDepthView = out.depthView; // about as far away a frame ago
      out.depthJitterPx = other.depthJitterPx;
    }
    return out;
  };
}

} // namespace taa::doctor
