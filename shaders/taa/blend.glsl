// Mixes current and history (manual §14 to §16). In: scene-linear colors, α, motion in px, history length N,
// least α of invalid history. Out: the resolved color as it will be stored, and N after this frame.

struct Blended {
  vec3 color;
  float historyLength; // N
};

const bool kWeighsByLuma = kBlendTone == kBlendTone_luma || kBlendTone == kBlendTone_lumaAsPrinted;
const bool kMixesCompressed = !kWeighsByLuma && kBlendTone != kBlendTone_none;

/// Bright colors count less (15.1, Karis 2014); as printed by the luma of the compressed color (manual §26, D19).
float toneWeight(vec3 color) {
  precise vec3 measured = color;
  if (kBlendTone == kBlendTone_lumaAsPrinted) measured = compressMax(color);
  precise float weight = 1.0 / (1.0 + weightLuma(measured));
  return kWeighsByLuma ? weight : 1.0;
}

/// Share of the current color once both are weighted.
float blendFactor(float alpha, float currentWeight, float historyWeight) {
  precise float current = alpha * currentWeight;
  precise float factor = current / (current + (1.0 - alpha) * historyWeight);
  if (!kWeighsByLuma) factor = alpha;
  return mix(factor, 1.0, alpha >= 1.0);
}

vec3 compress(vec3 color) {
  if (kBlendTone == kBlendTone_reinhardChannel) return reinhardChannel(color);
  if (kBlendTone == kBlendTone_pq) return pqChannel(color);
  if (kBlendTone == kBlendTone_logarithm) return logarithmChannel(color);
  if (kBlendTone == kBlendTone_whitePoint) return whitePoint(color, settings.blendWhite);
  return compressMax(color);
}

vec3 decompress(vec3 color) {
  if (kBlendTone == kBlendTone_reinhardChannel) return inverseReinhardChannel(color);
  if (kBlendTone == kBlendTone_pq) return inversePqChannel(color);
  if (kBlendTone == kBlendTone_logarithm) return inverseLogarithmChannel(color);
  if (kBlendTone == kBlendTone_whitePoint) return inverseWhitePoint(color, settings.blendWhite);
  return inverseCompressMax(color);
}

/// history + factor · (current − history), of compressed colors where they are mixed so (15.3 to 15.7).
vec3 mixed(vec3 current, vec3 history, vec3 factor) {
  precise vec3 result = history + factor * (current - history);
  if (kMixesCompressed) {
    precise vec3 from = compress(history);
    precise vec3 to = compress(current);
    precise vec3 between = from + factor * (to - from);
    result = current == history ? history : decompress(between);
  }
  // A share of 0 does not go through compression and back (invariant 65).
  const bool kMayKeepAll = kUpsampled || kValidateOffScreen == kValidateOffScreen_oneSided;
  if (kMayKeepAll) result = mix(result, history, lessThanEqual(factor, vec3(0.0)));
  return mix(result, current, greaterThanEqual(factor, vec3(1.0)));
}

/// Mean of the pixel and its diagonals, for pixels without history (5.6).
vec3 blurredRestart(Samples samples) {
  precise vec3 c = samples.color[4];
  precise vec3 sum = (((samples.color[0] - c) + (samples.color[2] - c)) + (samples.color[6] - c)) + (samples.color[8] - c);
  precise vec3 result = c + sum / 5.0;
  return result;
}

/// N after this frame (manual §16): the inverse of the variance that is left, unless printed or counted otherwise. A
/// frame of confidence κ counts as κ frames.
float lengthAfter(float alpha, float lengthBefore, float confidence, vec2 motion) {
  precise float variance = alpha * alpha + ((1.0 - alpha) * (1.0 - alpha)) / lengthBefore;
  precise float historyLength = 1.0 / variance;
  if (kBlendLength == kBlendLength_count) historyLength = lengthBefore + (kUpsampled ? confidence : 1.0);
  if (kBlendLength == kBlendLength_varianceAsPrinted) historyLength = variance;
  if (kBlendLength == kBlendLength_reciprocal)
    historyLength = alpha > 1e-6 ? maximum(confidence / alpha, 1.0) : lengthBefore;
  if (kBlendLength == kBlendLength_confidence) historyLength = confidenceAfter(lengthBefore, motion);
  if (kBlendLength == kBlendLength_countTo16) {
    precise float counted = lengthBefore + (kUpsampled ? confidence : 1.0);
    historyLength = minimum(counted, 16.0);
    if (kDecays || !hasHistory()) return hasHistory() ? historyLength : 0.0; // what decayed to nothing counts from there
  }
  return mix(historyLength, 1.0, alpha >= 1.0);
}

/// The nearest half float, ties to even, of a value from 0 to 65504: unpackHalf2x16(packHalf2x16(x)), which costs
/// llvmpipe ten times as much.
vec3 nearestHalf(vec3 x) {
  uvec3 bits = floatBitsToUint(x);
  vec3 normal = uintBitsToFloat((bits + 0xFFFu + ((bits >> 13u) & 1u)) & 0xFFFFE000u); // 11 significant bits
  precise vec3 shifted = x + 0.5; // below 2⁻¹⁴ halves are multiples of 2⁻²⁴, as floats from ½ to 1 are
  precise vec3 subnormal = shifted - 0.5;
  return mix(normal, subnormal, lessThan(x, vec3(6.103515625e-5)));
}

/// One of the two half floats around x, the nearer one more often, so that the mean is x. `random`: 13 bits. Halves
/// stay what they are.
float ditheredHalf(float x, uint random) {
  float normal = uintBitsToFloat((floatBitsToUint(x) + random) & 0xFFFFE000u);
  precise float subnormal = floor(x * 16777216.0 + (float(random) + 0.5) / 8192.0) / 16777216.0;
  return x < 6.103515625e-5 ? subnormal : normal;
}

/// The multiple of 1/steps below x + u/steps, from 0 to 1.
float quantized(float x, float steps, float u) {
  precise float result = floor(saturated(x) * steps + u) / steps;
  return result;
}

const bool kIsHalf = kHistoryPrecision == kHistoryPrecision_half;
const bool kIsUnorm = kHistoryPrecision == kHistoryPrecision_unorm8 || kHistoryPrecision == kHistoryPrecision_unorm10;

/// What the history can hold: halves are rounded here, because drivers may truncate; the multiples of 8 and 10 bits are
/// kept in floats. To the nearest, or up and down at random (14.7, 20.6).
vec3 asStored(vec3 color, ivec2 pixel) {
  if (!kIsHalf && !kIsUnorm) return color;
  if (kIsHalf && !kHistoryDither) return nearestHalf(color);
  uvec3 random = kHistoryDither ? randomBits(pixel) : uvec3(0u);
  vec3 u = kHistoryDither ? (vec3(random) + 0.5) / 8192.0 : vec3(0.5);
  float steps = kHistoryPrecision == kHistoryPrecision_unorm8 ? 255.0 : 1023.0;
  if (kIsUnorm)
    return vec3(quantized(color.r, steps, u.r), quantized(color.g, steps, u.g), quantized(color.b, steps, u.b));
  return vec3(ditheredHalf(color.r, random.r), ditheredHalf(color.g, random.g), ditheredHalf(color.b, random.b));
}

Blended blend(ivec2 pixel, Samples samples, WeightInputs x, Weights weight, float invalid) {
  bool isRestarted = kTaaEnabled && kBlendRestart == kBlendRestart_blurred && invalid >= 1.0;
  precise vec3 current = isRestarted ? blurredRestart(samples) : x.current;
  vec3 history = x.history;
  precise float currentWeight = toneWeight(current);
  precise float historyWeight = toneWeight(history);
  precise float factor = blendFactor(weight.alpha, currentWeight, historyWeight);
  vec3 factors = vec3(factor);
  if (kHasChannelWeights) // 14.2: α and 1 − α, so that never all weights are 0
    factors = vec3(blendFactor(weight.channels.r, currentWeight, historyWeight),
                   blendFactor(weight.channels.g, currentWeight, historyWeight),
                   blendFactor(weight.channels.b, currentWeight, historyWeight));
  precise vec3 color = mixed(current, history, factors);
  precise vec3 sane = saneOr(current, color);
  Blended result = Blended(asStored(sane, pixel),
                           lengthAfter(weight.alpha, x.historyLength, x.confidence, x.dilated.motion));
  expose_toneWeightCurrent(currentWeight);
  expose_toneWeightHistory(historyWeight);
  expose_blendFactor(factor);
  expose_historyLength(result.historyLength);
  expose_resolved(result.color);
  return result;
}
