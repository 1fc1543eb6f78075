// Chains the stages and writes down everything they say.
#include "core/taa/twin/Twin.h"

#include "core/taa/twin/Color.h"
#include "core/taa/twin/CompareDepth.h"
#include "core/taa/twin/Details.h"
#include "core/taa/twin/Instances.h"
#include "core/taa/twin/Stages.h"
#include "core/taa/twin/Upsample.h"

#include <glm/vec3.hpp>

namespace taa::twin {
namespace {

template <typename Real>
void set(PixelRecordOf<Real>& record, IntermediateId id, Vec3<Real>& value) {
  observe(id, value);
  at(record, id) = Vec4<Real>(value, 0.0f);
}
template <typename Real>
void set(PixelRecordOf<Real>& record, IntermediateId id, Vec2<Real>& value) {
  observe(id, value);
  at(record, id) = Vec4<Real>(value, 0.0f, 0.0f);
}
template <typename Real>
void set(PixelRecordOf<Real>& record, IntermediateId id, Real& value) {
  observe(id, value);
  at(record, id) = Vec4<Real>(value, 0.0f, 0.0f, 0.0f);
}
/// Of what does not go on.
template <typename Real, typename Value>
void write(PixelRecordOf<Real>& record, IntermediateId id, Value value) {
  set(record, id, value);
}

template <typename Real>
void recordInputs(PixelRecordOf<Real>& record, const Inputs& inputs, const PlaceOf<Real>& place) {
  const glm::ivec2& p = place.texel;
  const Real depth = read<Real>(inputs.depth, p).x;
  write(record, IntermediateId::color, Vec3<Real>(read<Real>(inputs.color, p)));
  write(record, IntermediateId::depth, depth);
  write(record, IntermediateId::depthView, viewDepth(depth, inputs.depthTerms));
  write(record, IntermediateId::motion, Vec2<Real>(read<Real>(inputs.motion, p)));
  write(record, IntermediateId::normal, Vec3<Real>(read<Real>(inputs.normal, p)));
  write(record, IntermediateId::objectId, read<Real>(inputs.objectId, p).x);
  write(record, IntermediateId::reactive, maskAt<Real>(inputs, p).x);
  write(record, IntermediateId::responsive, maskAt<Real>(inputs, p).y);
  const Vec4<Real> overlay =
      inputs.overlay.empty() ? Vec4<Real>(0.0f) : read<Real>(inputs.overlay, place.still);
  write(record, IntermediateId::overlay, Vec3<Real>(overlay));
  write(record, IntermediateId::overlayAlpha, overlay.w);
  const Vec4<Real> fog = inputs.fog.empty() ? Vec4<Real>(0.0f) : read<Real>(inputs.fog, p);
  write(record, IntermediateId::fog, Vec3<Real>(fog));
  write(record, IntermediateId::fogOpacity, fog.w);
  write(record, IntermediateId::objectClass, read<Real>(inputs.normal, p).w);
  write(record, IntermediateId::forwardCount,
        inputs.forwardCount.empty() ? Real(-1.0f) : read<Real>(inputs.forwardCount, p).x);
}

template <typename Real>
void recordNeighborhood(PixelRecordOf<Real>& record, NeighborhoodOf<Real>& neighborhood) {
  set(record, IntermediateId::neighborhoodMean, neighborhood.mean);
  set(record, IntermediateId::neighborhoodDeviation, neighborhood.deviation);
  set(record, IntermediateId::neighborhoodMin, neighborhood.min);
  set(record, IntermediateId::neighborhoodMax, neighborhood.max);
  set(record, IntermediateId::boxGamma, neighborhood.gamma);
  set(record, IntermediateId::boxMin, neighborhood.boxMin);
  set(record, IntermediateId::boxMax, neighborhood.boxMax);
}

template <typename Real>
void recordValidation(PixelRecordOf<Real>& record, ValidityOf<Real>& validated) {
  set(record, IntermediateId::depthExpected, validated.depthExpected);
  set(record, IntermediateId::historyDepth, validated.historyDepth);
  set(record, IntermediateId::depthMismatch, validated.depthMismatch);
  set(record, IntermediateId::depthAllowed, validated.depthAllowed);
  write(record, IntermediateId::geometricFlicker, Real(validated.isFlicker ? 1.0f : 0.0f));
  write(record, IntermediateId::rejectReason, Real(static_cast<float>(validated.reason)));
}

template <typename Real>
void recordGeometry(PixelRecordOf<Real>& record, GeometryMatchOf<Real>& match) {
  set(record, IntermediateId::historyObjectId, match.object);
  set(record, IntermediateId::normalAgreement, match.normalAgreement);
  set(record, IntermediateId::velocityChange, match.velocityChange);
}

template <typename Real>
void recordHeld(PixelRecordOf<Real>& record, LockStateOf<Real>& lockState) {
  set(record, IntermediateId::lock, lockState.lock);
  set(record, IntermediateId::lockLife, lockState.lockLife);
  set(record, IntermediateId::instability, lockState.instability);
}

template <typename Real>
void recordWeights(PixelRecordOf<Real>& record, WeightsOf<Real>& weights) {
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

template <typename Real>
void recordBlend(PixelRecordOf<Real>& record, BlendedOf<Real>& blended) {
  set(record, IntermediateId::toneWeightCurrent, blended.toneWeightCurrent);
  set(record, IntermediateId::toneWeightHistory, blended.toneWeightHistory);
  set(record, IntermediateId::blendFactor, blended.factor);
  set(record, IntermediateId::historyLength, blended.historyLength);
  set(record, IntermediateId::resolved, blended.resolved);
}

template <typename Real>
void recordOutput(PixelRecordOf<Real>& record, ShownColorOf<Real>& shown) {
  set(record, IntermediateId::sharpenDetail, shown.detail);
  set(record, IntermediateId::blurTrust, shown.trust);
  set(record, IntermediateId::output, shown.color);
}

template <typename Real>
void recordRectified(PixelRecordOf<Real>& record, RectifiedOf<Real>& rectified, Real& historyLength) {
  set(record, IntermediateId::historyRectified, rectified.value);
  set(record, IntermediateId::clipAmount, rectified.amount);
  set(record, IntermediateId::rectifyStrength, rectified.strength);
  set(record, IntermediateId::historyKeptLength, historyLength);
}

/// Rec. 601's weights, and never quite 0 (manual 13.11).
template <typename Real>
Real godotLuma(const Vec3<Real>& c) {
  const Real y = (0.299f * c.x + 0.587f * c.y) + 0.114f * c.z;
  return maximum(y, 0.0001f);
}

template <typename Real>
WeightInputsOf<Real> seenBy(const Inputs& inputs, const SpaceSettings& space, const Vec3<Real>& current,
                            const Vec3<Real>& historyRaw, const Vec3<Real>& history,
                            const NeighborhoodOf<Real>& n) {
  const auto boxed = [&space](const Vec3<Real>& color) { return named(boxLuma(toBox(color, space), space)); };
  WeightInputsOf<Real> weighed;
  weighed.hasHistory = !inputs.historyColor.empty();
  weighed.lumaCurrent = named(weightLuma(current, space.luma));
  weighed.lumaHistory = named(weightLuma(history, space.luma));
  weighed.boxCurrent = boxed(current);
  weighed.boxHistoryRaw = boxed(historyRaw);
  weighed.boxHistory = boxed(history);
  weighed.boxLow = named(boxLuma(n.boxMin, space));
  weighed.boxHigh = named(boxLuma(n.boxMax, space));
  weighed.compressedCurrent = named(godotLuma(compress(current, ToneSpace::ReinhardChannel)));
  weighed.compressedHistory = named(godotLuma(compress(history, ToneSpace::ReinhardChannel)));
  weighed.maxCurrent = named(weightLuma(compress(current, ToneSpace::MaxChannel), space.luma));
  weighed.maxHistory = named(weightLuma(compress(history, ToneSpace::MaxChannel), space.luma));
  weighed.stepSeconds = inputs.stepSeconds;
  return weighed;
}

/// Range of each channel over the nine samples, over the filtered color.
template <typename Real>
Vec3<Real> contrastAround(const Inputs& inputs, const glm::ivec2& drawn, const Vec3<Real>& current) {
  const SampleRangeOf<Real> range = sampleRange<Real>(inputs, drawn);
  return (range.high - range.low) / maximum(current, Vec3<Real>(1e-5f));
}

/// Without TAA the sample is taken as it is.
CurrentSettings currentSettings(const Settings& settings) {
  if (isTaaOn(settings)) return settings.current;
  return {.filter = CurrentFilter::Center};
}

template <typename Real>
CurrentColorOf<Real> filteredAt(const Inputs& inputs, const Settings& settings, const PlaceOf<Real>& place,
                                Real speed) {
  if (!isTaaOn(settings)) return {currentColor<Real>(inputs, place.texel), 1.0f};
  if (!isUpsampled(settings))
    return {filterCurrent<Real>(inputs, settings.current, place.texel, settings.space.luma), 1.0f};
  CurrentColorOf<Real> current = upsample(inputs, settings.current.upsample, place, speed);
  current.color = sharpenCurrent(inputs, settings.current, place.texel, current.color);
  return current;
}

} // namespace

template <typename Real>
Vec2<Real> maskAt(const Inputs& inputs, const glm::ivec2& texel) {
  return inputs.mask.empty() ? Vec2<Real>(0.0f) : Vec2<Real>(read<Real>(inputs.mask, texel));
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
  if (inputs.historyColor.empty()) return;
  HistorySettings read = settings.history;
  if (history.isEdge) read.filter = HistoryFilter::Bilinear;
  details.historyTaps = historyTaps(inputs, read, history.position);
}

/// The nine samples around.
void describeAround(const Inputs& inputs, Details& details) {
  for (int k = 0; k < 9; ++k)
    details.filterSamples[static_cast<std::size_t>(k)] =
        currentColor(inputs, details.texel + glm::ivec2(k % 3 - 1, k / 3 - 1));
}

/// What the stages hand on.
template <typename Real>
struct ChainOf {
  PixelRecordOf<Real> record{};
  PlaceOf<Real> place;
  DilatedMotionOf<Real> dilated;
  HistorySampleOf<Real> history;
  NeighborhoodOf<Real> neighborhood;
  GeometryOf<Real> geometry;
  GeometryMatchOf<Real> match;
  LockStateOf<Real> lockState;
  Vec3<Real> rectifiedBox{0.0f};
  WeightInputsOf<Real> weighed;
  DivergenceOf<Real> divergence;
};

template <typename Real>
ChainOf<Real> resolved(const Inputs& inputs, const Settings& settings, const glm::ivec2& p) {
  ChainOf<Real> out;
  PixelRecordOf<Real>& record = out.record;
  out.place = isUpsampled(settings) ? placeOf<Real>(inputs, p) : PlaceOf<Real>{p, Vec2<Real>(0.0f), p};
  const glm::ivec2& texel = out.place.texel;
  recordInputs(record, inputs, out.place);

  DilatedMotionOf<Real>& dilated = out.dilated = dilateMotion<Real>(inputs, settings.dilate, texel);
  write(record, IntermediateId::dilatedOffset, Vec2<Real>(dilated.offset));
  set(record, IntermediateId::dilatedDepth, dilated.depth);
  set(record, IntermediateId::dilatedMotion, dilated.motion);

  const Vec2<Real> readOff = isOn(settings.fault.historyJitter)
                                 ? Vec2<Real>(inputs.lastJitterPx) / renderRatio<Real>(inputs)
                                 : Vec2<Real>(0.0f);
  ReprojectionOf<Real> reprojected = reproject(inputs, settings.reproject, dilated.motion, p, readOff);
  set(record, IntermediateId::historyPosition, reprojected.position);
  set(record, IntermediateId::speed, reprojected.speed);
  write(record, IntermediateId::onScreen, Real(reprojected.onScreen ? 1.0f : 0.0f));

  HistorySampleOf<Real>& history = out.history =
      sampleHistory(inputs, settings.history, reprojected.position, p, texel);
  set(record, IntermediateId::historyRaw, history.color);
  set(record, IntermediateId::historyRawLength, history.historyLength);
  write(record, IntermediateId::depthEdge, Real(history.isEdge ? 1.0f : 0.0f));

  auto [current, confidence] = filteredAt(inputs, settings, out.place, reprojected.speed);
  set(record, IntermediateId::currentFiltered, current);
  set(record, IntermediateId::sampleConfidence, confidence);

  const Vec2<Real> mask = maskAt<Real>(inputs, texel);
  const Real largestMask = maximum(mask.x, mask.y);
  NeighborhoodOf<Real>& neighborhood = out.neighborhood =
      measureNeighborhood(inputs, settings, current, texel,
                          {history.color, reprojected.speed, largestMask,
                           viewDepth(dilated.depth, inputs.depthTerms), dilated.motion});
  recordNeighborhood(record, neighborhood);

  out.geometry = geometryOf(inputs, dilated, texel);
  GeometryMatchOf<Real>& match = out.match =
      compareGeometry(inputs, settings, out.geometry, history.position);
  recordGeometry(record, match);
  ValidityOf<Real> validated =
      validateHistory(inputs, settings.validate, dilated, reprojected, history.position, texel, match);
  recordValidation(record, validated);

  LockStateOf<Real>& lockState = out.lockState =
      holdHistory(inputs, settings, reprojected, history.position, neighborhood,
                  validated.reason == RejectReason::Kept, p, texel);
  recordHeld(record, lockState);
  RectifiedOf<Real> rectified =
      rectifyHistory(inputs, settings, history.color, current, neighborhood,
                     {reprojected.speed, lockState.protection, validated.isFlicker});
  out.rectifiedBox = rectified.boxed;
  const Real left = lengthLeft(settings.validate, history.historyLength, validated);
  Real length = lengthKept(settings, left, rectified, lockState.protection);
  recordRectified(record, rectified, length);

  out.divergence = motionDivergence<Real>(inputs, settings.weight, texel);
  WeightInputsOf<Real>& weighed = out.weighed =
      seenBy(inputs, settings.space, current, history.color, rectified.value, neighborhood);
  weighed.depth = dilated.depth;
  weighed.speed = reprojected.speed;
  weighed.picturePx = {inputs.outputWidth(), inputs.outputHeight()};
  weighed.contrast = contrastAround(inputs, texel, current);
  for (int i = 0; i < 3; ++i) weighed.contrast[i] = named(weighed.contrast[i]);
  weighed.motion = dilated.motion;
  weighed.motionUv = dilated.motion / Vec2<Real>(weighed.picturePx);
  weighed.confidence = confidence;
  weighed.isFlicker = validated.isFlicker;
  // Of a smaller drawing κ knows how far the sample is.
  if (!isUpsampled(settings)) weighed.jitterPx = Vec2<Real>(inputs.jitterPx);
  weighed.mask = mask;
  weighed.relax = settings.neighborhood.maskRelax == Switch::On ? largestMask : Real(0.0f);
  weighed.velocityChange = match.velocityChange;
  weighed.divergence = out.divergence.value;
  weighed.isFrozen = validated.isFrozen;
  weighed.decays = settings.validate.action == RejectAction::Decay;
  WeightsOf<Real> weights = blendWeight(settings, length, validated.invalid, weighed);
  recordWeights(record, weights);
  const bool isBlurred =
      isTaaOn(settings) && settings.blend.restart == Restart::Blurred && validated.invalid >= 1.0f;
  const Vec3<Real> shown = isBlurred ? blurredRestart<Real>(inputs, texel) : current;
  const bool isNan = isOn(settings.fault.nan) && holdsNan(inputs, texel, reprojected);
  BlendedOf<Real> blended =
      blend<Real>(settings, {shown, rectified.value, weights.alpha, weights.channels, length, confidence,
                             dilated.motion, p, inputs.frame, inputs.historyColor.empty(), isNan});
  recordBlend(record, blended);
  if (inputs.resolved.empty()) return out;
  ShownColorOf<Real> output = showOutput<Real>(inputs, settings, p);
  recordOutput(record, output);
  return out;
}

KeptLayers keptOf(const ChainOf<float>& chain) {
  return {{chain.geometry.object, chain.geometry.objectClass},
          glm::vec4(chain.geometry.normal, 0.0f),
          chain.geometry.motion,
          chain.lockState.keptLock,
          chain.lockState.keptLumas};
}

void describe(const Inputs& inputs, const Settings& settings, const ChainOf<float>& chain, Details& details) {
  const glm::ivec2& texel = chain.place.texel;
  details.texel = texel;
  details.neighborhood = chain.neighborhood;
  details.weighed = chain.weighed;
  details.lockState = chain.lockState;
  details.geometry = chain.geometry;
  details.match = chain.match;
  details.divergence = chain.divergence;
  details.isFirst = inputs.historyColor.empty();
  details.jitterPx = inputs.jitterPx;
  details.picturePx = {inputs.outputWidth(), inputs.outputHeight()};
  details.readPosition = chain.history.position;
  describeTaps(inputs, settings, chain.place, chain.history, details);
  describeAround(inputs, details);
}

} // namespace

PixelRecord resolvePixel(const Inputs& inputs, const Settings& settings, int x, int y, KeptLayers* kept) {
  const ChainOf<float> chain = resolved<float>(inputs, settings, {x, y});
  if (kept) *kept = keptOf(chain);
  return chain.record;
}

PixelRecord resolvePixel(const Inputs& inputs, const Settings& settings, const glm::ivec2& pixel,
                         Details& details) {
  const ChainOf<float> chain = resolved<float>(inputs, settings, pixel);
  describe(inputs, settings, chain, details);
  return chain.record;
}

template <Remembering Real>
PixelIn<Real> resolvePixelIn(const Inputs& inputs, const Settings& settings, const glm::ivec2& pixel) {
  const ChainOf<Real> chain = resolved<Real>(inputs, settings, pixel);
  return {chain.record, chain.rectifiedBox};
}
template PixelIn<Dual> resolvePixelIn(const Inputs& inputs, const Settings& settings,
                                      const glm::ivec2& pixel);
template PixelIn<Traced> resolvePixelIn(const Inputs& inputs, const Settings& settings,
                                        const glm::ivec2& pixel);
template PixelIn<Interval> resolvePixelIn(const Inputs& inputs, const Settings& settings,
                                          const glm::ivec2& pixel);

#define TAA_TWIN(Real) template Vec2<Real> maskAt(const Inputs& inputs, const glm::ivec2& texel);
TAA_EACH_NUMBER(TAA_TWIN)
#undef TAA_TWIN

} // namespace taa::twin
