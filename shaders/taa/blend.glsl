// Mixes current and history (catalogue §14 to §16). In: scene-linear colors, α, history length N. Out: the
// resolved color as it will be stored, and N after this frame.

struct Blended {
  vec3 color;
  float frames; // N
};

/// Bright colors count less (15.1, Karis 2014).
float toneWeight(vec3 color) {
  precise float weight = 1.0 / (1.0 + luma(color));
  return kBlendTone == kBlendTone_luma ? weight : 1.0;
}

/// Share of the current color once both are weighted.
float blendFactor(float alpha, float currentWeight, float historyWeight) {
  precise float current = alpha * currentWeight;
  precise float factor = current / (current + (1.0 - alpha) * historyWeight);
  if (kBlendTone == kBlendTone_none) factor = alpha;
  return alpha >= 1.0 ? 1.0 : factor;
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

Blended blend(vec3 current, vec3 history, float alpha, float historyFrames) {
  precise float currentWeight = toneWeight(current);
  precise float historyWeight = toneWeight(history);
  precise float factor = blendFactor(alpha, currentWeight, historyWeight);
  precise vec3 mixed = history + factor * (current - history);
  mixed = factor >= 1.0 ? current : mixed;
  precise vec3 sane = vec3(isSane(mixed.r) ? mixed.r : current.r, isSane(mixed.g) ? mixed.g : current.g,
                           isSane(mixed.b) ? mixed.b : current.b);
  // Samples' worth of averaging: the inverse of the variance that is left (§16).
  precise float variance = alpha * alpha + ((1.0 - alpha) * (1.0 - alpha)) / historyFrames;
  precise float frames = alpha >= 1.0 ? 1.0 : 1.0 / variance;

  Blended result = Blended(asStored(sane), frames);
  expose_toneWeightCurrent(currentWeight);
  expose_toneWeightHistory(historyWeight);
  expose_blendFactor(factor);
  expose_historyLength(result.frames);
  expose_resolved(result.color);
  return result;
}
