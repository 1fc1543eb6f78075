// This frame's color at the pixel's center, made from the jittered samples around it (manual §7), and how much it
// says about it (manual §22). In and out: scene-linear. Expects upsample.glsl, which takes over where fewer pixels
// are drawn.

/// Weight of sample k: computed once a frame from jitter and variance (see currentFilterWeights).
float currentWeight(int k) {
  vec4 lastRows = k < 6 ? resolveBlock.currentWeights1 : resolveBlock.currentWeights2;
  return (k < 3 ? resolveBlock.currentWeights0 : lastRows)[k % 3];
}

/// Filters that only weigh the nine samples.
const bool kIsUnjitterAsPrinted = kCurrentFilter == kCurrentFilter_unjitterAsPrinted;
const bool kIsUnjitter = kCurrentFilter == kCurrentFilter_unjitter || kIsUnjitterAsPrinted;
const bool kIsWeighted = kCurrentFilter != kCurrentFilter_center && !kIsUnjitter;
/// Filters with negative weights.
const bool kMayRing = kCurrentFilter == kCurrentFilter_mitchell || kCurrentFilter == kCurrentFilter_catmullRom ||
                      kCurrentFilter == kCurrentFilter_lanczos;

/// Weight of sample k, of this color: bright ones may count less (7.2).
float sampleWeight(vec3 color, int k) {
  precise float weight = currentWeight(k);
  if (kCurrentLumaWeighted) weight = weight / (1.0 + weightLuma(color));
  return weight;
}

vec3 weightedSamples(Samples samples) {
  precise float total = sampleWeight(samples.color[0], 0);
  for (int k = 1; k < 9; ++k) total = total + sampleWeight(samples.color[k], k);
  // Differences to the center, so that a constant stays exactly constant.
  precise vec3 sum = sampleWeight(samples.color[0], 0) * (samples.color[0] - samples.color[4]);
  for (int k = 1; k < 9; ++k)
    if (k != 4) sum = sum + sampleWeight(samples.color[k], k) * (samples.color[k] - samples.color[4]);
  precise vec3 result = samples.color[4] + sum / total;
  return mix(samples.color[4], result, bvec3(abs(total) > 1e-4));
}

/// One bilinear tap at the place where the pixel's unjittered center landed (7.1); as printed on the other side (D10).
vec3 unjitteredTap(Samples samples) {
  vec2 landed = kIsUnjitterAsPrinted ? -resolveBlock.jitterPx : resolveBlock.jitterPx;
  ivec2 direction = ivec2(landed.x < 0.0 ? -1 : 1, landed.y < 0.0 ? -1 : 1);
  vec2 f = abs(landed);
  precise vec3 center = samples.color[4];
  precise vec3 beside = samples.color[4 + direction.x];
  precise vec3 over = samples.color[4 + 3 * direction.y];
  precise vec3 across = samples.color[4 + direction.x + 3 * direction.y];
  precise vec3 top = center + f.x * (beside - center);
  precise vec3 bottom = over + f.x * (across - over);
  precise vec3 result = top + f.y * (bottom - top);
  return result;
}

/// f + s(f − mean₄) (18.2); as printed in source 002 max(0, 5s f − s Σ₄), where flat becomes s times as bright.
vec3 sharpenedCurrent(vec3 filteredColor, Samples samples) {
  precise vec3 f = filteredColor;
  precise vec3 around = ((samples.color[1] + samples.color[3]) + samples.color[5]) + samples.color[7];
  precise vec3 sum = (((samples.color[1] - f) + (samples.color[3] - f)) + (samples.color[5] - f)) +
                     (samples.color[7] - f);
  precise vec3 result = f - settings.currentSharpenAmount * (sum / 4.0);
  precise vec3 printed = (5.0 * settings.currentSharpenAmount) * f - settings.currentSharpenAmount * around;
  return storable(kCurrentSharpen == kCurrentSharpen_laplacianAsPrinted ? printed : result);
}

CurrentColor filterCurrent(Samples samples, Place place, float speed) {
  precise vec3 result = samples.color[4];
  CurrentColor current = CurrentColor(result, 1.0);
  if (kIsUnjitter) result = unjitteredTap(samples);
  if (kIsWeighted) {
    result = weightedSamples(samples);
    if (kMayRing && kCurrentDering) result = boundedBySamples(result, samples);
    result = storable(result); // negative weights overshoot both ways
  }
  if (kTaaEnabled) current.color = result;
  if (kTaaEnabled && kUpsampled) current = upsample(samples, place, speed);
  if (kTaaEnabled && kCurrentSharpen != kCurrentSharpen_none)
    current.color = sharpenedCurrent(current.color, samples);
  expose_currentFiltered(current.color);
  expose_sampleConfidence(current.confidence);
  return current;
}
