// Mixes current and history (catalogue §14 to §16). In: scene-linear colors, α, history length N,
// least α of invalid history. Out: the
// resolved color as it will be stored, and N after this frame.

struct Blended {
  vec3 color;
  float frames; // N
};

const bool kWeighsByLuma = kBlendTone == kBlendTone_luma || kBlendTone == kBlendTone_lumaAsPrinted;
const bool kMixesCompressed = kBlendTone == kBlendTone_reinhardChannel || kBlendTone == kBlendTone_maxChannel;

/// Bright colors count less (15.1, Karis 2014); as printed by the luma of the compressed color (§26, D19).
float toneWeight(vec3 color) {
  precise vec3 measured = color;
  if (kBlendTone == kBlendTone_lumaAsPrinted) measured = compressMax(color);
  precise float weight = 1.0 / (1.0 + luma(measured));
  return kWeighsByLuma ? weight : 1.0;
}

/// Share of the current color once both are weighted.
float blendFactor(float alpha, float currentWeight, float historyWeight) {
  precise float current = alpha * currentWeight;
  precise float factor = current / (current + (1.0 - alpha) * historyWeight);
  if (!kWeighsByLuma) factor = alpha;
  return alpha >= 1.0 ? 1.0 : factor;
}

vec3 compressed(vec3 color) {
  return kBlendTone == kBlendTone_reinhardChannel ? reinhardChannel(color) : compressMax(color);
}

vec3 decompressed(vec3 color) {
  return kBlendTone == kBlendTone_reinhardChannel ? inverseReinhardChannel(color) : inverseCompressMax(color);
}

/// history + factor · (current − history), of compressed colors where they are mixed so (15.3, 15.4).
vec3 mixed(vec3 current, vec3 history, float factor) {
  precise vec3 plain = history + factor * (current - history);
  if (factor >= 1.0) return current;
  if (kUpsampled && factor <= 0.0) return history; // not through compression and back (invariant 65)
  if (!kMixesCompressed) return plain;
  precise vec3 from = compressed(history);
  precise vec3 to = compressed(current);
  precise vec3 between = from + factor * (to - from);
  return current == history ? history : decompressed(between);
}

/// Mean of the pixel and its diagonals, for pixels without history (5.6).
vec3 blurredRestart(Samples samples) {
  precise vec3 c = samples.color[4];
  precise vec3 sum = (((samples.color[0] - c) + (samples.color[2] - c)) + (samples.color[6] - c)) + (samples.color[8] - c);
  precise vec3 result = c + sum / 5.0;
  return result;
}

/// N after this frame (§16): the inverse of the variance that is left, unless printed or counted otherwise. A frame of
/// confidence κ counts as κ frames.
float framesAfter(float alpha, float framesBefore, float confidence) {
  precise float variance = alpha * alpha + ((1.0 - alpha) * (1.0 - alpha)) / framesBefore;
  precise float frames = 1.0 / variance;
  if (kBlendLength == kBlendLength_count) frames = framesBefore + (kUpsampled ? confidence : 1.0);
  if (kBlendLength == kBlendLength_varianceAsPrinted) frames = variance;
  return alpha >= 1.0 ? 1.0 : frames;
}

/// The nearest half float, ties to even, of a value from 0 to 65504: unpackHalf2x16(packHalf2x16(x)), which costs
/// llvmpipe ten times as much.
float nearestHalf(float x) {
  uint bits = floatBitsToUint(x);
  float normal = uintBitsToFloat((bits + 0xFFFu + ((bits >> 13u) & 1u)) & 0xFFFFE000u); // 11 significant bits
  precise float shifted = x + 0.5; // below 2⁻¹⁴ halves are multiples of 2⁻²⁴, as floats from ½ to 1 are
  precise float subnormal = shifted - 0.5;
  return x < 6.103515625e-5 ? subnormal : normal;
}

/// The nearest half floats where history is stored as such: drivers may truncate instead.
vec3 asStored(vec3 color) {
  if (kHistoryPrecision != kHistoryPrecision_half) return color;
  return vec3(nearestHalf(color.r), nearestHalf(color.g), nearestHalf(color.b));
}

Blended blend(Samples samples, CurrentColor filtered, vec3 history, float alpha, float historyFrames, float invalid) {
  bool isRestarted = kBlendRestart == kBlendRestart_blurred && invalid >= 1.0;
  precise vec3 current = isRestarted ? blurredRestart(samples) : filtered.color;
  precise float currentWeight = toneWeight(current);
  precise float historyWeight = toneWeight(history);
  precise float factor = blendFactor(alpha, currentWeight, historyWeight);
  precise vec3 color = mixed(current, history, factor);
  precise vec3 sane = vec3(isSane(color.r) ? color.r : current.r, isSane(color.g) ? color.g : current.g,
                           isSane(color.b) ? color.b : current.b);
  Blended result = Blended(asStored(sane), framesAfter(alpha, historyFrames, filtered.confidence));
  expose_toneWeightCurrent(currentWeight);
  expose_toneWeightHistory(historyWeight);
  expose_blendFactor(factor);
  expose_historyLength(result.frames);
  expose_resolved(result.color);
  return result;
}
