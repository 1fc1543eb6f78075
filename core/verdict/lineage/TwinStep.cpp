#include "core/verdict/lineage/TwinStep.h"

#include "core/taa/twin/Color.h"
#include "core/taa/twin/Details.h"
#include "core/taa/twin/HistoryTaps.h"
#include "core/taa/twin/Stages.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace taa {

namespace {

/// Sums below it are no weights to divide by; as the filters of the current color have it.
constexpr double kMinWeightSum = 1e-4;
/// Sixteen floats that sum up to 1 miss it by no more.
constexpr double kRoundedOff = 1e-5;

struct TexelWeight {
  glm::ivec2 texel{0};
  double weight = 0.0;
};

/// What a pixel of the twin says of itself.
struct TwinPixel {
  const twin::Inputs& inputs;
  const Settings& settings;
  twin::PixelRecord record{};
  twin::Details details{};

  float value(IntermediateId id) const { return twin::at(record, id).x; }
};

/// Manual 15.1 of each channel's α; the tone weights are 1 where colors are not weighed.
glm::dvec3 mixedShares(const TwinPixel& pixel) {
  if (pixel.settings.weight.source != AlphaSource::ContrastPerChannel)
    return glm::dvec3(pixel.value(IntermediateId::blendFactor));
  const double current = pixel.value(IntermediateId::toneWeightCurrent);
  const double history = pixel.value(IntermediateId::toneWeightHistory);
  glm::dvec3 shares(1.0);
  for (int channel = 0; channel < 3; ++channel) {
    const double alpha = twin::at(pixel.record, IntermediateId::alphaChannels)[channel];
    if (alpha < 1.0) shares[channel] = alpha * current / (alpha * current + (1.0 - alpha) * history);
  }
  return shares;
}

/// The texels of the filter. What floats round off their sum is put back.
std::vector<HistoryRead> historyReads(const TwinPixel& pixel) {
  if (pixel.details.isFirst) return {};
  const twin::HistoryTexels texels =
      twin::historyTexels(pixel.settings.history, pixel.details.readPosition, pixel.details.picturePx,
                          pixel.value(IntermediateId::depthEdge) > 0.0f);
  double sum = 0.0;
  for (const twin::HistoryTexels::Texel& texel : texels.all()) sum += static_cast<double>(texel.weight);
  const double divisor = std::fabs(sum - 1.0) < kRoundedOff ? sum : 1.0;
  std::vector<HistoryRead> reads;
  for (const twin::HistoryTexels::Texel& texel : texels.all())
    reads.push_back({texel.at, static_cast<double>(texel.weight) / divisor,
                     glm::vec3(pixel.inputs.historyColor.texel(texel.at.x, texel.at.y))});
  return reads;
}

double weightSum(const std::vector<TexelWeight>& weights) {
  double sum = 0.0;
  for (const TexelWeight& each : weights) sum += each.weight;
  return sum;
}

/// Divided by their sum; the middle texel alone where that is not `enough`.
std::vector<TexelWeight> normalizedWeights(std::vector<TexelWeight> weights, const glm::ivec2& middle,
                                           bool enough) {
  if (!enough) return {{middle, 1.0}};
  const double sum = weightSum(weights);
  for (TexelWeight& each : weights) each.weight /= sum;
  return weights;
}

/// The four texels of a bilinear tap at `offset` px from the center of the middle one (manual 7.1).
std::vector<TexelWeight> unjitterWeights(const glm::ivec2& middle, const glm::dvec2& offset) {
  const glm::dvec2 first = glm::floor(offset), next = offset - first;
  std::vector<TexelWeight> weights;
  for (int corner = 0; corner < 4; ++corner) {
    const glm::ivec2 step(corner % 2, corner / 2);
    weights.push_back({middle + glm::ivec2(first) + step,
                       (step.x == 0 ? 1.0 - next.x : next.x) * (step.y == 0 ? 1.0 - next.y : next.y)});
  }
  return weights;
}

/// The pixel and its diagonals (manual 5.6).
std::vector<TexelWeight> restartWeights(const glm::ivec2& middle) {
  std::vector<TexelWeight> weights{{middle, 0.2}};
  for (int corner = 0; corner < 4; ++corner)
    weights.push_back({middle + glm::ivec2(corner % 2 * 2 - 1, corner / 2 * 2 - 1), 0.2});
  return weights;
}

std::vector<TexelWeight> nineWeights(const TwinPixel& pixel) {
  std::vector<TexelWeight> weights;
  const bool byLuma = isOn(pixel.settings.current.lumaWeighted);
  for (std::size_t k = 0; k < 9; ++k) {
    double weight = pixel.details.filterWeights[k];
    if (byLuma)
      weight /= 1.0 + static_cast<double>(
                          twin::weightLuma(pixel.details.filterSamples[k], pixel.settings.space.luma));
    weights.push_back(
        {pixel.details.texel + glm::ivec2(static_cast<int>(k) % 3 - 1, static_cast<int>(k) / 3 - 1), weight});
  }
  return weights;
}

/// 3×3 or 4×4, row by row, the nearest at `middle`.
std::vector<TexelWeight> upsampleWeights(const TwinPixel& pixel) {
  const twin::Taps& taps = pixel.details.upsampleTaps;
  const int side = taps.count > 9 ? 4 : 3, middle = static_cast<int>(taps.middle);
  std::vector<TexelWeight> weights;
  for (int k = 0; k < static_cast<int>(taps.count); ++k)
    weights.push_back({pixel.details.texel + glm::ivec2(k % side - middle % side, k / side - middle / side),
                       taps.each[static_cast<std::size_t>(k)].weight});
  return weights;
}

/// Of the current color before it is sharpened (manual §7, §22).
std::vector<TexelWeight> filterWeightsOf(const TwinPixel& pixel) {
  const glm::ivec2& middle = pixel.details.texel;
  if (!isTaaOn(pixel.settings)) return {{middle, 1.0}};
  if (isUpsampled(pixel.settings)) {
    const std::vector<TexelWeight> weights = upsampleWeights(pixel);
    return normalizedWeights(weights, middle, weightSum(weights) > kMinWeightSum);
  }
  switch (pixel.settings.current.filter) {
  case CurrentFilter::Unjitter:
    return unjitterWeights(middle, pixel.details.jitterPx);
  case CurrentFilter::UnjitterAsPrinted:
    return unjitterWeights(middle, -pixel.details.jitterPx);
  case CurrentFilter::Center:
    return {{middle, 1.0}};
  case CurrentFilter::Gaussian:
  case CurrentFilter::Tent:
  case CurrentFilter::Box:
  case CurrentFilter::Mitchell:
  case CurrentFilter::CatmullRom:
  case CurrentFilter::BlackmanHarris:
  case CurrentFilter::Lanczos:
  case CurrentFilter::DistanceAsPrinted:
  case CurrentFilter::MitchellAsPrinted:
  case CurrentFilter::BlackmanHarrisAsPrinted:
    break;
  }
  const std::vector<TexelWeight> weights = nineWeights(pixel);
  return normalizedWeights(weights, middle, std::fabs(weightSum(weights)) > kMinWeightSum);
}

/// With what sharpening adds (manual 18.2).
std::vector<TexelWeight> sharpenedWeights(const TwinPixel& pixel, std::vector<TexelWeight> weights) {
  const CurrentSettings& current = pixel.settings.current;
  if (!isTaaOn(pixel.settings) || current.sharpen == CurrentSharpen::None) return weights;
  const double s = current.sharpenAmount;
  const bool isPrinted = current.sharpen == CurrentSharpen::LaplacianAsPrinted;
  for (TexelWeight& each : weights) each.weight *= isPrinted ? 5.0 * s : 1.0 + s;
  for (const glm::ivec2& step : {glm::ivec2(0, -1), glm::ivec2(-1, 0), glm::ivec2(1, 0), glm::ivec2(0, 1)})
    weights.push_back({pixel.details.texel + step, isPrinted ? -s : -0.25 * s});
  return weights;
}

/// Texel k of a frame holds what belongs to k + ½ − j of the picture at rest.
std::vector<SampleRead> sampleReads(const TwinPixel& pixel, const glm::ivec2& at,
                                    const std::vector<TexelWeight>& weights) {
  std::vector<SampleRead> reads;
  for (const TexelWeight& each : weights) {
    if (each.weight == 0.0) continue;
    const glm::ivec2 texel = twin::clampedToDrawn(each.texel, pixel.inputs);
    const auto known = std::ranges::find(reads, texel, &SampleRead::texel);
    if (known != reads.end()) {
      known->weight += each.weight;
      continue;
    }
    const glm::dvec2 place = (glm::dvec2(texel) + 0.5 - glm::dvec2(pixel.details.jitterPx)) /
                             glm::dvec2(pixel.details.renderRatio);
    reads.push_back({texel, each.weight, place - (glm::dvec2(at) + 0.5)});
  }
  return reads;
}

/// By depth: nearer is larger. The sky stays as large as it is.
double scaleOf(const TwinPixel& pixel) {
  const double before = pixel.value(IntermediateId::depthExpected);
  const double now = twin::viewDepth(pixel.value(IntermediateId::dilatedDepth), pixel.inputs.depthTerms);
  return before > 0.0 && now > 0.0 ? before / now : 1.0;
}

bool isBlurredRestart(const TwinPixel& pixel) {
  return isTaaOn(pixel.settings) && pixel.settings.blend.restart == Restart::Blurred &&
         pixel.value(IntermediateId::alphaInvalid) >= 1.0f;
}

} // namespace

PixelStep pixelStep(const twin::Inputs& inputs, const Settings& settings, const glm::ivec2& pixel) {
  TwinPixel at{inputs, settings};
  at.record = twin::resolvePixel(inputs, settings, pixel, at.details);
  const bool isBlurred = isBlurredRestart(at);
  PixelStep step;
  step.alpha = mixedShares(at);
  step.rectified = std::clamp(static_cast<double>(at.value(IntermediateId::clipAmount)), 0.0, 1.0);
  step.history = historyReads(at);
  step.samples = sampleReads(
      at, pixel, isBlurred ? restartWeights(at.details.texel) : sharpenedWeights(at, filterWeightsOf(at)));
  step.current = glm::vec3(isBlurred ? glm::vec4(twin::blurredRestart(inputs, at.details.texel), 0.0f)
                                     : twin::at(at.record, IntermediateId::currentFiltered));
  step.resolved = glm::vec3(twin::at(at.record, IntermediateId::resolved));
  step.historyPosition = at.details.readPosition;
  step.scale = scaleOf(at);
  step.historyLength = at.value(IntermediateId::historyLength);
  step.object = static_cast<int>(at.details.geometry.object);
  step.sampled = static_cast<int>(at.value(IntermediateId::objectId));
  return step;
}

} // namespace taa
