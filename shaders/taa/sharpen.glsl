// Sharpens the resolved color (manual §18). In: the nine resolved colors around the pixel, the place of this frame's
// samples. Out: scene-linear color, storable. All differences are to the pixel itself, so that what is flat stays
// exactly what it is, whatever the amount.

/// Sum of the differences of the four around, or of the four corners, to the pixel.
vec3 crossDifference(Samples c) {
  precise vec3 sum = (((c.color[1] - c.color[4]) + (c.color[3] - c.color[4])) + (c.color[5] - c.color[4])) +
                     (c.color[7] - c.color[4]);
  return sum;
}
vec3 cornerDifference(Samples c) {
  precise vec3 sum = (((c.color[0] - c.color[4]) + (c.color[2] - c.color[4])) + (c.color[6] - c.color[4])) +
                     (c.color[8] - c.color[4]);
  return sum;
}

/// c·(L + k(L − mean₉ L))/L (18.1). Black has no ratio and stays black (manual §26, D8).
vec3 sharpenedByLuma(Samples c) {
  precise float center = luma(c.color[4]);
  precise float sum = luma(c.color[0]) - center;
  for (int k = 1; k < 9; ++k) sum = sum + (luma(c.color[k]) - center);
  precise float ratio = 1.0 - settings.outputAmount * ((sum / 9.0) / center);
  precise vec3 result = ratio * c.color[4];
  return center > 1e-6 ? result : c.color[4];
}

/// c + k(c − mean₄) (18.3).
vec3 sharpenedByLaplacian(Samples c) {
  precise vec3 result = c.color[4] - settings.outputAmount * (crossDifference(c) / 4.0);
  return result;
}

/// c + k(c − mean₉) (18.3).
vec3 unsharpMasked(Samples c) {
  precise vec3 sum = crossDifference(c) + cornerDifference(c);
  precise vec3 result = c.color[4] - settings.outputAmount * (sum / 9.0);
  return result;
}

/// Robust contrast-adaptive sharpening of colors from 0 to 1 (18.5): the lobe is the largest for which no channel
/// leaves them, at most 3/16.
vec3 rcas(vec3 e, vec3 b, vec3 d, vec3 f, vec3 h) {
  vec3 lowest = minimum(minimum(b, d), minimum(f, h));
  vec3 highest = maximum(maximum(b, d), maximum(f, h));
  precise vec3 room = minimum(lowest, e) / (4.0 * highest);
  room = vec3(highest.r > 0.0 ? room.r : 0.0, highest.g > 0.0 ? room.g : 0.0, highest.b > 0.0 ? room.b : 0.0);
  precise vec3 headroom = (1.0 - maximum(highest, e)) / (4.0 - 4.0 * lowest);
  vec3 limit = minimum(room, headroom);
  precise float lobe = minimum(0.1875, minimum(minimum(limit.r, limit.g), limit.b));
  lobe = lobe * saturated(settings.outputAmount);
  precise vec3 sum = (((b - e) + (d - e)) + (f - e)) + (h - e);
  precise vec3 result = e - (lobe * sum) / (1.0 - 4.0 * lobe);
  return result;
}

vec3 sharpenedByRcas(Samples c) {
  precise vec3 center = compressMax(c.color[4]);
  precise vec3 result = rcas(center, compressMax(c.color[1]), compressMax(c.color[3]), compressMax(c.color[5]),
                             compressMax(c.color[7]));
  return result == center ? c.color[4] : inverseCompressMax(result);
}

vec3 overLuma(vec3 color) {
  precise vec3 result = color / (1.0 + luma(color));
  return result;
}

/// c + 3k max(0, c − mean₉) (18.6). The mean is of this frame's samples over 1 + luma, brought back.
vec3 brightenedInResolve(Samples c, Samples samples) {
  precise vec3 center = overLuma(samples.color[4]);
  precise vec3 sum = overLuma(samples.color[0]) - center;
  for (int k = 1; k < 9; ++k) sum = sum + (overLuma(samples.color[k]) - center);
  precise vec3 mean = center + sum / 9.0;
  precise vec3 linear = mean / inverseDivisor(luma(mean));
  if (mean == center) linear = samples.color[4];
  precise vec3 result = c.color[4] + (3.0 * settings.outputAmount) * maximum(c.color[4] - linear, vec3(0.0));
  return result;
}

/// ratio to the power of the amount in steps of 1/256, by products and square roots, which unlike pow are exact.
vec3 toAmount(vec3 ratio) {
  precise float exponent = settings.outputAmount * 256.0 + 0.5;
  int steps = int(floor(exponent));
  precise vec3 power = vec3(1.0);
  for (; steps >= 256; steps -= 256) power = power * ratio;
  precise vec3 root = ratio;
  for (int bit = 128; bit > 0; bit /= 2) {
    root = sqrt(root);
    if (steps >= bit) power = power * root;
    if (steps >= bit) steps -= bit;
  }
  return power;
}

/// exp₂((1 + k)x − ¼k Σx) − 1 of x = log₂(1 + c) (18.7), which is (1 + c)·((1 + c)/geometric mean₄)ᵏ − 1.
vec3 sharpenedInLogarithms(Samples c) {
  precise vec3 center = 1.0 + c.color[4];
  precise vec3 upright = sqrt((1.0 + c.color[1]) * (1.0 + c.color[7]));
  precise vec3 level = sqrt((1.0 + c.color[3]) * (1.0 + c.color[5]));
  precise vec3 ratio = center / sqrt(upright * level);
  precise vec3 power = toAmount(ratio);
  precise vec3 result = c.color[4] + center * (power - 1.0);
  return result;
}

/// The cubic of Mitchell and Netravali with B = −k at the pixels' centers: −k/6, 1 + k/3, −k/6 each way (18.4).
vec3 reconstructed(Samples c) {
  precise float b = settings.outputAmount / 6.0;
  precise vec3 result = c.color[4] + ((b * b) * cornerDifference(c) - (b * (1.0 + 2.0 * b)) * crossDifference(c));
  return result;
}

/// The same with B = C = ⅓: 1/18, 8/9, 1/18 each way (6.6).
vec3 mitchellFiltered(Samples c) {
  precise vec3 result = c.color[4] + (cornerDifference(c) + 16.0 * crossDifference(c)) / 324.0;
  return result;
}

const bool kIsSharpened = kTaaEnabled && kOutputSharpen != kOutputSharpen_none;

vec3 sharpen(Samples c, Place place) {
  if (!kIsSharpened) return c.color[4];
  precise vec3 result = c.color[4];
  if (kOutputSharpen == kOutputSharpen_lumaRatio) result = sharpenedByLuma(c);
  if (kOutputSharpen == kOutputSharpen_laplacian) result = sharpenedByLaplacian(c);
  if (kOutputSharpen == kOutputSharpen_unsharp) result = unsharpMasked(c);
  if (kOutputSharpen == kOutputSharpen_rcas) result = sharpenedByRcas(c);
  if (kOutputSharpen == kOutputSharpen_inResolve) result = brightenedInResolve(c, readInputs(place));
  if (kOutputSharpen == kOutputSharpen_logarithm) result = sharpenedInLogarithms(c);
  if (kOutputSharpen == kOutputSharpen_reconstruct) result = reconstructed(c);
  if (kOutputSharpen == kOutputSharpen_mitchell) result = mitchellFiltered(c);
  if (kOutputDering) result = boundedBySamples(result, c);
  return storable(result);
}
