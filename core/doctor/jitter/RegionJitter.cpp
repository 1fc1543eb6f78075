#include "core/doctor/jitter/RegionJitter.h"

#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/capture/import/FrameSamples.h"
#include "core/doctor/motion/MotionFindings.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace taa::doctor {

namespace {

constexpr int kStridePx = 2; ///< of pixels that are asked
constexpr int kEnoughJitterPixels = 40, kEnoughJitterPairs = 6;
/// px: a shorter step of the jitter says nothing.
constexpr float kLeastStepPx = 0.1f;
/// Shares: of 30 regions of six painted sequences, whose error was below 0.1, none was farther from 0 than
/// 0.09; two that had no jitter were at 1.04 and 1.07, ± 0.01.
constexpr double kHasJitter = 0.2, kLacksJitter = 0.8, kMostShareError = 0.08, kSureShareError = 0.03;

} // namespace

void RegionJitter::add(const FrameNeighbors& frames, const std::vector<RegionIndex>& labels) {
  const glm::ivec2 size = frames.now.sizePx();
  const glm::vec2 step = frames.jitterStep();
  if (frames.now.motionPx.empty() || glm::length(step) < kLeastStepPx) return;
  std::map<RegionIndex, Sums> sums;
  for (int y = 0; y < size.y; y += kStridePx)
    for (int x = 0; x < size.x; x += kStridePx) {
      const std::size_t index = static_cast<std::size_t>(y) * size.x + x;
      const glm::vec2 motion = frames.now.motionAt(x, y);
      if (labels[index] == kNoRegion || !isMotion(motion) || isMasked(frames.now, {x, y}) ||
          !isInside(labels, size, x, y))
        continue;
      const glm::vec2 place = glm::vec2(x, y) + 0.5f - motion + step;
      if (!isInPicture(place - step, size) || !isInPicture(place + step, size)) continue;
      const auto lumaAt = [&](const glm::vec2& at) {
        return static_cast<double>(capture::betweenPixels(frames.before.luma, at));
      };
      // Without jitter the frame before is read at `place` − step.
      const double slope = 0.5 * (lumaAt(place - step) - lumaAt(place + step));
      const double off = static_cast<double>(*frames.now.luma.at(x, y)) - lumaAt(place);
      Sums& of = sums[labels[index]];
      of.together += off * slope;
      of.slopes += slope * slope;
      ++of.pixels;
    }
  for (const auto& [region, of] : sums)
    if (of.pixels >= kEnoughJitterPixels && of.slopes > 0.0) regions_[region].push_back(of);
}

std::map<RegionIndex, MissingJitter> RegionJitter::regions() const {
  std::map<RegionIndex, MissingJitter> out;
  for (const auto& [region, pairs] : regions_) {
    MissingJitter& found = out[region];
    found.pairs = static_cast<int>(pairs.size());
    double together = 0.0, slopes = 0.0, left = 0.0;
    for (const Sums& of : pairs) {
      together += of.together;
      slopes += of.slopes;
    }
    found.share = together / slopes;
    for (const Sums& of : pairs) left += std::pow(of.together - found.share * of.slopes, 2.0);
    found.error = std::sqrt(left) / slopes;
  }
  return out;
}

void tellRegionJitter(const RegionJitter& jitter, const std::vector<Region>& regions,
                      const CaptureInfo& captureInfo, Diagnosis& out) {
  Finding found;
  std::string shares;
  double lacking = 0.0, having = 0.0, worst = 0.0; // pixels, and the largest standard error
  for (const auto& [index, missing] : jitter.regions()) {
    const Region& region = regions[static_cast<std::size_t>(index)];
    if (missing.pairs < kEnoughJitterPairs || missing.error > kMostShareError || region.isSky) continue;
    if (std::abs(missing.share) <= kHasJitter) having += region.pixels;
    if (missing.share < kLacksJitter || missing.share > 2.0 - kLacksJitter) continue;
    lacking += region.pixels;
    worst = std::max(worst, missing.error);
    found.regions.push_back(placeOf(region, captureInfo, allPixels(captureInfo, out)));
    shares +=
        (shares.empty() ? "" : ", ") + say<"%1 ± %2">(shortNumber(missing.share), shortNumber(missing.error));
  }
  if (found.regions.empty() || having < lacking) return;
  // Along the motion given their pixels lack the jitter, and nothing else: that motion is right.
  std::vector<std::string> names;
  for (const RegionPlace& place : found.regions) names.push_back(place.name);
  takeOutOfMotion(names, out.findings);
  found.id = "jitterRegionMissing";
  found.name = say<"Drawn without jitter">();
  found.confidence = worst <= kSureShareError ? Confidence::Sure : Confidence::Likely;
  found.symptom = say<"Its edges stay stairs, and tremble where all else is smooth.">();
  found.reason =
      say<"Its pictures lack the jitter that is stated: %1 of it, by least squares over its pixels, "
          "where 1 is all; other regions have it.">(shares);
  found.change =
      say<"Draw it with the same jitter in its projection; or, if it is meant to have none, after TAA.">();
  out.findings.push_back(std::move(found));
  out.parts.takeBack(say<"Jitter">());
}

} // namespace taa::doctor
