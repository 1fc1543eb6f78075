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

// Of all that was read, for `stage_ends`: nothing, or in the profiler's programs their end (TaaPass.cpp).
vec4 sumOf(Samples samples) {
  vec3 sum = vec3(0.0);
  for (int k = 0; k < 9; ++k) sum += samples.color[k];
  return vec4(sum, samples.mask.x + samples.mask.y);
}

void main() {
  ivec2 pixel = pixelHere();
  stage_ends(kStage_jitter, vec4(pixel, pixel));
  Place place = placeOf(pixel);
  Samples samples = readInputs(place);
  stage_ends(kStage_inputs, sumOf(samples));
  DilatedMotion dilated = dilateMotion(place.texel);
  stage_ends(kStage_dilate_motion, vec4(dilated.motion, dilated.depth, 0.0));
  Reprojection reprojection = reproject(pixel, dilated.motion);
  stage_ends(kStage_reproject, vec4(reprojection.position, reprojection.speed, float(reprojection.isOutside)));
  HistorySample history = sampleHistory(pixel, place.texel, reprojection.position);
  stage_ends(kStage_sample_history, vec4(history.color, history.historyLength));
  CurrentColor filtered = filterCurrent(samples, place, reprojection.speed);
  stage_ends(kStage_filter_current, vec4(filtered.color, filtered.confidence));
  vec3 current = filtered.color;
  Samples measured = samples;
  if (kNeighborhoodUnjitter) measured = unjittered(place.texel, samples);
  NeighborhoodInputs given =
      NeighborhoodInputs(history.color, dilated.motion, reprojection.speed, viewDepth(dilated.depth));
  Neighborhood around = measureNeighborhood(measured, place.texel, current, given);
  stage_ends(kStage_neighborhood, vec4(around.box.lo + around.box.hi, 0.0));
  // Before it is rectified, because invalid history is not held.
  Validity validity = validateHistory(place.texel, dilated, reprojection, history);
  stage_ends(kStage_validate_history, vec4(validity.invalid, validity.velocityChange, float(validity.isFlicker), 0.0));
  float protection = holdHistory(pixel, samples, reprojection, history, around.moments, validity);
  history.historyLength = lengthLeft(history.historyLength, validity);
  float strength = rectifyStrength(reprojection.speed, validity.isFlicker);
  RectifiedHistory rectified = rectifyHistory(history, around, current, strength, protection);
  stage_ends(kStage_rectify_history, vec4(rectified.color, rectified.historyLength));
  WeightInputs weighed =
      WeightInputs(current, rectified.color, history.color, around.box, dilated, reprojection.speed,
                   rectified.historyLength, validity.velocityChange, motionDivergence(place.texel), samples.mask,
                   filtered.confidence, validity.isFrozen, validity.isFlicker);
  Weights weight = blendWeight(weighed, samples, validity.invalid);
  stage_ends(kStage_blend_weight, vec4(weight.channels, weight.alpha));
  Blended blended = blend(pixel, samples, weighed, weight, validity.invalid);
  if (kFaultNan && holdsNan(place.texel, reprojection)) {
    blended.color = vec3(uintBitsToFloat(kNanBits));
    expose_resolved(blended.color);
  }
  o_color = vec4(blended.color, 1.0);                                // History::color
  o_surface = vec2(blended.historyLength, viewDepth(dilated.depth)); // History::surface: N, view depth
  store_exposed();
}
