// The fused resolve of one pixel: every stage in order. What each one computes stands in its own file; `expose_…`
// in them writes intermediates where they are watched and is nothing otherwise.

#include "taa/inputs.glsl"
#include "taa/dilate_motion.glsl"
#include "taa/reproject.glsl"
#include "taa/sample_history.glsl"
#include "taa/upsample.glsl"
#include "taa/filter_current.glsl"
#include "taa/neighborhood.glsl"
#include "taa/validate_history.glsl"
#include "taa/hold_history.glsl"
#include "taa/rectify_history.glsl"
#include "taa/blend_weight.glsl"
#include "taa/dither.glsl"
#include "taa/blend.glsl"

void main() {
  ivec2 pixel = pixelHere();
  Place place = placeOf(pixel);
  Samples samples = readInputs(place);
  DilatedMotion dilated = dilateMotion(place.texel);
  Reprojection reprojection = reproject(pixel, dilated.motion);
  HistorySample history = sampleHistory(pixel, place.texel, reprojection.position);
  CurrentColor filtered = filterCurrent(samples, place, reprojection.speed);
  vec3 current = filtered.color;
  Samples measured = samples;
  if (kNeighborhoodUnjitter) measured = unjittered(place.texel, samples);
  NeighborhoodInputs given =
      NeighborhoodInputs(history.color, dilated.motion, reprojection.speed, viewDepth(dilated.depth));
  Neighborhood around = measureNeighborhood(measured, place.texel, current, given);
  // Before it is rectified, because invalid history is not held.
  Validity validity = validateHistory(place.texel, dilated, reprojection, history);
  float protection = holdHistory(pixel, samples, reprojection, history, around.moments, validity);
  history.historyLength = lengthLeft(history.historyLength, validity);
  float strength = rectifyStrength(reprojection.speed, validity.isFlicker);
  RectifiedHistory rectified = rectifyHistory(history, around, current, strength, protection);
  WeightInputs weighed =
      WeightInputs(current, rectified.color, history.color, around.box, dilated, reprojection.speed,
                   rectified.historyLength, validity.velocityChange, motionDivergence(place.texel), samples.mask,
                   filtered.confidence, validity.isFrozen, validity.isFlicker);
  Weights weight = blendWeight(weighed, samples, validity.invalid);
  Blended blended = blend(pixel, samples, weighed, weight, validity.invalid);
  if (kFaultNan && holdsNan(place.texel, reprojection)) {
    blended.color = vec3(uintBitsToFloat(kNanBits));
    expose_resolved(blended.color);
  }
  o_color = vec4(blended.color, 1.0);                                // History::color
  o_surface = vec2(blended.historyLength, viewDepth(dilated.depth)); // History::surface: N, view depth
  store_exposed();
}
