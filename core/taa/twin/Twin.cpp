// Chains the stages and writes down everything they say.
#include "core/taa/twin/Twin.h"

#include "core/taa/twin/Color.h"
#include "core/taa/twin/CompareDepth.h"
#include "core/taa/twin/Details.h"
#include "core/taa/twin/Stages.h"
#include "core/taa/twin/Upsample.h"

#include <glm/vec3.hpp>

namespace taa::twin {
namespace {

void set(PixelRecord& record, IntermediateId id, const glm::vec3& value) {
  at(record, id) = glm::vec4(value, 0.0f);
}
void set(PixelRecord& record, IntermediateId id, const glm::vec2& value) {
  at(record, id) = glm::vec4(value, 0.0f, 0.0f);
}
void set(PixelRecord& record, IntermediateId id, float value) {
  at(record, id) = glm::vec4(value, 0.0f, 0.0f, 0.0f);
}

void recordInputs(PixelRecord& record, const Inputs& inputs, const Place& place) {
  const glm::ivec2& p = place.texel;
  const float depth = inputs.depth.texel(p.x, p.y).x;
  set(record, IntermediateId::color, glm::vec3(inputs.color.texel(p.x, p.y)));
  set(record, IntermediateId::depth, depth);
  set(record, IntermediateId::depthView, viewDepth(depth, inputs.depthTerms));
  set(record, IntermediateId::motion, glm::vec2(inputs.motion.texel(p.x, p.y)));
  set(record, IntermediateId::normal, glm::vec3(inputs.normal.texel(p.x, p.y)));
  set(record, IntermediateId::objectId, inputs.objectId.texel(p.x, p.y).x);
  set(record, IntermediateId::reactive, maskAt(inputs, p).x);
  set(record, IntermediateId::responsive, maskAt(inputs, p).y);
  const glm::vec4 overlay =
      inputs.overlay.empty() ? glm::vec4(0.0f) : inputs.overlay.texel(place.still.x, place.still.y);
  set(record, IntermediateId::overlay, glm::vec3(overlay));
  set(record, IntermediateId::overlayAlpha, overlay.w);
  const glm::vec4 fog = inputs.fog.empty() ? glm::vec4(0.0f) : inputs.fog.texel(p.x, p.y);
  set(record, IntermediateId::fog, glm::vec3(fog));
  set(record, IntermediateId::fogOpacity, fog.w);
  set(record, IntermediateId::objectClass, inputs.normal.texel(p.x, p.y).w);
  set(record, IntermediateId::forwardCount,
      inputs.forwardCount.empty() ? -1.0f : inputs.forwardCount.texel(p.x, p.y).x);
}

void recordNeighborhood(PixelRecord& record, const Neighborhood& neighborhood) {
  set(record, IntermediateId::neighborhoodMean, neighborhood.mean);
  set(record, IntermediateId::neighborhoodDeviation, neighborhood.deviation);
  set(record, IntermediateId::neighborhoodMin, neighborhood.min);
  set(record, IntermediateId::neighborhoodMax, neighborhood.max);
  set(record, IntermediateId::boxGamma, neighborhood.gamma);
  set(record, IntermediateId::boxMin, neighborhood.boxMin);
  set(record, IntermediateId::boxMax, neighborhood.boxMax);
}

void recordValidation(PixelRecord& record, const Validity& validated) {
  set(record, IntermediateId::depthExpected, validated.depthExpected);
  set(record, IntermediateId::historyDepth, validated.historyDepth);
  set(record, IntermediateId::depthMismatch, validated.depthMismatch);
  set(record, IntermediateId::depthAllowed, validated.depthAllowed);
  set(record, IntermediateId::geometricFlicker, validated.isFlicker ? 1.0f : 0.0f);
  set(record, IntermediateId::rejectReason, static_cast<float>(validated.reason));
}

void recordGeometry(PixelRecord& record, const GeometryMatch& match) {
  set(record, IntermediateId::historyObjectId, match.object);
  set(record, IntermediateId::normalAgreement, match.normalAgreement);
  set(record, IntermediateId::velocityChange, match.velocityChange);
}

void recordHeld(PixelRecord& record, const LockState& lockState) {
  set(record, IntermediateId::lock, lockState.lock);
  set(record, IntermediateId::lockLife, lockState.lockLife);
  set(record, IntermediateId::instability, lockState.instability);
}

void recordWeights(PixelRecord& record, const Weights& weights) {
  set(record, IntermediateId::alphaBase, weights.base);
  set(record, IntermediateId::alphaFloor, weights.floor);
  set(record, IntermediateId::alphaLumaFlicker, weights.lumaFlicker);
  set(record, IntermediateId::alphaNearClamp, weights.nearClamp);
  set(record, IntermediateId::alphaHistoryContrast, weights.historyContrast);
  set(record, IntermediateId::alphaRelax, weights.relax);
  set(record, IntermediateId::alphaSampleDistance, weights.sampleDistance);
  set(record, IntermediateId::alphaFlicker, weights.flicker);
  set(record, IntermediateId::alphaMotion, weights.motion);
  set(record, IntermediateId::alphaVelocityChange, weights.velocityChange);
  set(record, IntermediateId::alphaDivergence, weights.divergence);
  set(record, IntermediateId::alphaFrameRate, weights.byFrameRate);
  set(record, IntermediateId::alphaMask, weights.mask);
  set(record, IntermediateId::alphaInvalid, weights.invalid);
  set(record, IntermediateId::alpha, weights.alpha);
  set(record, IntermediateId::alphaChannels, weights.channels);
}

void recordBlend(PixelRecord& record, const Blended& blended) {
  set(record, IntermediateId::toneWeightCurrent, blended.toneWeightCurrent);
  set(record, IntermediateId::toneWeightHistory, blended.toneWeightHistory);
  set(record, IntermediateId::blendFactor, blended.factor);
  set(record, IntermediateId::historyLength, blended.historyLength);
  set(record, IntermediateId::resolved, blended.resolved);
}

void recordOutput(PixelRecord& record, const ShownColor& shown) {
  set(record, IntermediateId::sharpenDetail, shown.detail);
  set(record, IntermediateId::blurTrust, shown.trust);
  set(record, IntermediateId::output, shown.color);
}

void recordRectified(PixelRecord& record, const Rectified& rectified, float historyLength) {
  set(record, IntermediateId::historyRectified, rectified.value);
  set(record, IntermediateId::clipAmount, rectified.amount);
  set(record, IntermediateId::rectifyStrength, rectified.strength);
  set(record, IntermediateId::historyKeptLength, historyLength);
}

KeptLayers keptOf(const Geometry& geometry, const LockState& lockState) {
  return {{geometry.object, geometry.objectClass},
          glm::vec4(geometry.normal, 0.0f),
          geometry.motion,
          lockState.keptLock,
          lockState.keptLumas};
}

/// Rec. 601's weights, and never quite 0 (manual 13.11).
float godotLuma(const glm::vec3& c) {
  const float y = (0.299f * c.x + 0.587f * c.y) + 0.114f * c.z;
  return y > 0.0001f ? y : 0.0001f;
}

WeightInputs seenBy(const Inputs& inputs, const SpaceSettings& space, const glm::vec3& current,
                    const glm::vec3& historyRaw, const glm::vec3& history, const Neighborhood& n) {
  const auto boxed = [&space](const glm::vec3& color) { return boxLuma(toBox(color, space), space); };
  WeightInputs weighed;
  weighed.hasHistory = !inputs.historyColor.empty();
  weighed.lumaCurrent = weightLuma(current, space.luma);
  weighed.lumaHistory = weightLuma(history, space.luma);
  weighed.boxCurrent = boxed(current);
  weighed.boxHistoryRaw = boxed(historyRaw);
  weighed.boxHistory = boxed(history);
  weighed.boxLow = boxLuma(n.boxMin, space);
  weighed.boxHigh = boxLuma(n.boxMax, space);
  weighed.compressedCurrent = godotLuma(compress(current, ToneSpace::ReinhardChannel));
  weighed.compressedHistory = godotLuma(compress(history, ToneSpace::ReinhardChannel));
  weighed.maxCurrent = weightLuma(compress(current, ToneSpace::MaxChannel), space.luma);
  weighed.maxHistory = weightLuma(compress(history, ToneSpace::MaxChannel), space.luma);
  weighed.stepSeconds = inputs.stepSeconds;
  return weighed;
}

/// Range of each channel over the nine samples, over the filtered color.
glm::vec3 contrastAround(const Inputs& inputs, const glm::ivec2& drawn, const glm::vec3& current) {
  const SampleRange range = sampleRange(inputs, drawn);
  return (range.high - range.low) / maximum(current, glm::vec3(1e-5f));
}

/// Without TAA the sample is taken as it is.
CurrentSettings currentSettings(const Settings& settings) {
  if (isTaaOn(settings)) return settings.current;
  return {.filter = CurrentFilter::Center};
}

CurrentColor filteredAt(const Inputs& inputs, const Settings& settings, const Place& place, float speed) {
  if (!isTaaOn(settings)) return {currentColor(inputs, place.texel), 1.0f};
  if (!isUpsampled(settings))
    return {filterCurrent(inputs, settings.current, place.texel, settings.space.luma), 1.0f};
  CurrentColor current = upsample(inputs, settings.current.upsample, place, speed);
  current.color = sharpenCurrent(inputs, settings.current, place.texel, current.color);
  return current;
}

} // namespace

glm::vec2 maskAt(const Inputs& inputs, const glm::ivec2& texel) {
  return inputs.mask.empty() ? glm::vec2(0.0f) : glm::vec2(inputs.mask.texel(texel.x, texel.y));
}

namespace {

/// What the filters of this frame and of history weigh and how much.
void describeTaps(const Inputs& inputs, const Settings& settings, const Place& place,
                  const HistorySample& history, Details& details) {
  const bool isSmaller = isUpsampled(settings) && isTaaOn(settings);
  const CurrentSettings current = currentSettings(settings);
  details.sampleOffset = place.offset;
  details.renderRatio = renderRatio(inputs);
  if (isSmaller)
    details.upsampleTaps = upsampleTaps(inputs, settings.current.upsample, place);
  else
    details.filterWeights = currentWeights(current, inputs.jitterPx);
  details.unsharpened = isSmaller
                            ? upsample(inputs, settings.current.upsample, place, details.weighed.speed).color
                            : unsharpenedCurrent(inputs, current, place.texel, settings.space.luma);
  if (inputs.historyColor.empty()) return;
  HistorySettings read = settings.history;
  if (history.isEdge) read.filter = HistoryFilter::Bilinear;
  details.historyTaps = historyTaps(inputs, read, history.position);
}

/// The nine samples around, and what the nine pixels resolved to.
void describeAround(const Inputs& inputs, const glm::ivec2& pixel, Details& details) {
  for (int k = 0; k < 9; ++k) {
    const glm::ivec2 step(k % 3 - 1, k / 3 - 1);
    const auto place = static_cast<std::size_t>(k);
    details.filterSamples[place] = currentColor(inputs, details.texel + step);
    if (inputs.resolved.empty()) continue;
    const glm::ivec2 at = clampedToPicture(pixel + step, inputs);
    details.resolvedAround[place] = glm::vec3(inputs.resolved.texel(at.x, at.y));
  }
}

PixelRecord resolved(const Inputs& inputs, const Settings& settings, const glm::ivec2& p, KeptLayers* kept,
                     Details* details) {
  const Place place = isUpsampled(settings) ? placeOf(inputs, p) : Place{p, glm::vec2(0.0f), p};
  const glm::ivec2& texel = place.texel;
  PixelRecord record{};
  recordInputs(record, inputs, place);

  const DilatedMotion dilated = dilateMotion(inputs, settings.dilate, texel);
  set(record, IntermediateId::dilatedOffset, glm::vec2(dilated.offset));
  set(record, IntermediateId::dilatedDepth, dilated.depth);
  set(record, IntermediateId::dilatedMotion, dilated.motion);

  const Reprojection reprojected = reproject(
      inputs, settings.reproject, dilated.motion, p,
      isOn(settings.fault.historyJitter) ? inputs.lastJitterPx / renderRatio(inputs) : glm::vec2(0.0f));
  set(record, IntermediateId::historyPosition, reprojected.position);
  set(record, IntermediateId::speed, reprojected.speed);
  set(record, IntermediateId::onScreen, reprojected.onScreen ? 1.0f : 0.0f);

  const HistorySample history = sampleHistory(inputs, settings.history, reprojected.position, p, texel);
  set(record, IntermediateId::historyRaw, history.color);
  set(record, IntermediateId::historyRawLength, history.historyLength);
  set(record, IntermediateId::depthEdge, history.isEdge ? 1.0f : 0.0f);

  const auto [current, confidence] = filteredAt(inputs, settings, place, reprojected.speed);
  set(record, IntermediateId::currentFiltered, current);
  set(record, IntermediateId::sampleConfidence, confidence);

  const glm::vec2 mask = maskAt(inputs, texel);
  const float largestMask = mask.x > mask.y ? mask.x : mask.y;
  const Neighborhood neighborhood =
      measureNeighborhood(inputs, settings, current, texel,
                          {history.color, reprojected.speed, largestMask,
                           viewDepth(dilated.depth, inputs.depthTerms), dilated.motion});
  recordNeighborhood(record, neighborhood);

  const Geometry geometry = geometryOf(inputs, dilated, texel);
  const GeometryMatch match = compareGeometry(inputs, settings, geometry, history.position);
  recordGeometry(record, match);
  const Validity validated =
      validateHistory(inputs, settings.validate, dilated, reprojected, history.position, texel, match);
  recordValidation(record, validated);

  const LockState lockState = holdHistory(inputs, settings, reprojected, history.position, neighborhood,
                                          validated.reason == RejectReason::Kept, p, texel);
  recordHeld(record, lockState);
  const Rectified rectified = rectifyHistory(inputs, settings, history.color, current, neighborhood,
                                             {reprojected.speed, lockState.protection, validated.isFlicker});
  const float left = lengthLeft(settings.validate, history.historyLength, validated);
  const float length = lengthKept(settings, left, rectified, lockState.protection);
  recordRectified(record, rectified, length);

  WeightInputs weighed =
      seenBy(inputs, settings.space, current, history.color, rectified.value, neighborhood);
  weighed.depth = dilated.depth;
  weighed.speed = reprojected.speed;
  weighed.picturePx = {inputs.outputWidth(), inputs.outputHeight()};
  weighed.contrast = contrastAround(inputs, texel, current);
  weighed.motion = dilated.motion;
  weighed.motionUv = dilated.motion / glm::vec2(inputs.outputWidth(), inputs.outputHeight());
  weighed.confidence = confidence;
  weighed.isFlicker = validated.isFlicker;
  if (!isUpsampled(settings)) weighed.jitterPx = inputs.jitterPx; // else κ knows how far the sample is
  weighed.mask = mask;
  weighed.relax = settings.neighborhood.maskRelax == Switch::On ? largestMask : 0.0f;
  weighed.velocityChange = match.velocityChange;
  const Divergence divergence = motionDivergence(inputs, settings.weight, texel);
  weighed.divergence = divergence.value;
  weighed.isFrozen = validated.isFrozen;
  weighed.decays = settings.validate.action == RejectAction::Decay;
  const Weights weights = blendWeight(settings, length, validated.invalid, weighed);
  recordWeights(record, weights);
  const bool isBlurred =
      isTaaOn(settings) && settings.blend.restart == Restart::Blurred && validated.invalid >= 1.0f;
  const glm::vec3 shown = isBlurred ? blurredRestart(inputs, texel) : current;
  recordBlend(record,
              blend(settings, {shown, rectified.value, weights.alpha, weights.channels, length, confidence,
                               dilated.motion, p, inputs.frame, inputs.historyColor.empty(),
                               isOn(settings.fault.nan) && holdsNan(inputs, texel, reprojected)}));
  ShownColor output;
  if (!inputs.resolved.empty()) recordOutput(record, output = showOutput(inputs, settings, p));
  if (kept) *kept = keptOf(geometry, lockState);
  if (!details) return record;
  details->texel = texel;
  details->neighborhood = neighborhood;
  details->weighed = weighed;
  details->lockState = lockState;
  details->geometry = geometry;
  details->match = match;
  details->divergence = divergence;
  details->slope = depthSlope(inputs, texel + dilated.offset);
  details->isFirst = inputs.historyColor.empty();
  details->depthTerms = inputs.depthTerms;
  details->jitterPx = inputs.jitterPx;
  details->picturePx = {inputs.outputWidth(), inputs.outputHeight()};
  details->readPosition = history.position;
  details->shown = output;
  details->drawnMotion =
      glm::vec2(inputs.motion.texel(texel.x + dilated.offset.x, texel.y + dilated.offset.y));
  describeTaps(inputs, settings, place, history, *details);
  describeAround(inputs, p, *details);
  return record;
}

} // namespace

PixelRecord resolvePixel(const Inputs& inputs, const Settings& settings, int x, int y, KeptLayers* kept) {
  return resolved(inputs, settings, {x, y}, kept, nullptr);
}

PixelRecord resolvePixel(const Inputs& inputs, const Settings& settings, const glm::ivec2& pixel,
                         Details& details) {
  return resolved(inputs, settings, pixel, nullptr, &details);
}

} // namespace taa::twin
