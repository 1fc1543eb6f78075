// The color at the center of a pixel of the picture, made from the samples of a smaller drawing, and how much these say
// about it (manual §22). In: samples, place. Out: scene-linear color; κ, 0 to 1.

struct CurrentColor {
  vec3 color;
  float confidence; // κ
};

const bool kIsSampleWeight = kCurrentUpsample == kCurrentUpsample_sampleWeight;
const bool kIsHdrpGaussian = kCurrentUpsample == kCurrentUpsample_hdrpGaussian;
const bool kIsHdrp = kCurrentUpsample == kCurrentUpsample_hdrp || kIsHdrpGaussian;
const bool kIsFsr2 = kCurrentUpsample == kCurrentUpsample_fsr2;

float lanczosOfSquare(float squared) {
  float within = minimum(squared, 4.0);
  precise float a = within - 1.0;
  precise float b = within - 4.0;
  precise float result = ((a * b) * (b * b)) / 64.0;
  return result;
}

// Weights of a sample by its d, render px from the pixel's center.

float lanczos2Weight(vec2 offset) { // 22.2
  precise vec2 x = offset / resolveBlock.renderRatio; // px of the picture
  precise vec2 weights = lanczos(x);
  precise float weight = weights.x * weights.y;
  return weight;
}

float hdrpWeight(vec2 offset) { // 22.3
  precise vec2 x = offset / resolveBlock.renderRatio; // px of the picture
  precise float squared = x.x * x.x + x.y * x.y;
  precise float root = 0.9656852 * saturated(squared) - 1.0;
  precise float weight = root * root;
  return weight;
}

float fsr2Weight(vec2 offset) { // 22.4
  precise vec2 scale = 1.0 / resolveBlock.renderRatio;
  precise vec2 scaled = offset * vec2(minimum(scale.x, 1.99), minimum(scale.y, 1.99));
  precise float squared = scaled.x * scaled.x + scaled.y * scaled.y;
  return lanczosOfSquare(squared);
}

float upsampleWeight(vec2 offset) {
  if (kIsHdrp) return hdrpWeight(offset);
  return kIsFsr2 ? fsr2Weight(offset) : lanczos2Weight(offset);
}

/// Σw(c − middle) and Σw.
struct WeightedSum {
  vec3 color;
  float weight;
};

WeightedSum sumOfNine(Samples samples, vec2 offset) {
  precise vec3 sum = vec3(0.0);
  precise float total = 0.0;
  for (int k = 0; k < 9; ++k) {
    precise float weight = upsampleWeight(offset + vec2(k % 3 - 1, k / 3 - 1));
    total = total + weight;
    sum = sum + weight * (samples.color[k] - samples.color[4]);
  }
  return WeightedSum(sum, total);
}

/// The four nearest samples of each axis.
WeightedSum sumOfSixteen(Place place, vec3 middle) {
  ivec2 first = ivec2(place.offset.x > 0.0 ? -2 : -1, place.offset.y > 0.0 ? -2 : -1);
  precise vec3 sum = vec3(0.0);
  precise float total = 0.0;
  for (int k = 0; k < 16; ++k) {
    ivec2 cell = first + ivec2(k % 4, k / 4);
    precise vec3 color = sanitized(texelAt(u_color, place.texel + cell).rgb);
    precise float weight = upsampleWeight(place.offset + vec2(cell));
    total = total + weight;
    sum = sum + weight * (color - middle);
  }
  return WeightedSum(sum, total);
}

/// κ of the nearest sample alone: less with its distance, but all of it where things move (22.1).
float nearestConfidence(vec2 offset, float speed) {
  precise vec2 squared = (offset * offset) / resolveBlock.renderRatio;
  precise float near = 1.0 - (squared.x + squared.y);
  precise float x = saturated(speed);
  precise float moving = (x * x) * (3.0 - 2.0 * x);
  return maximum(saturated(near), moving);
}

/// 1 where the nearest sample lies within ½/r, which beyond the border alone it does not (22.3).
float boxConfidence(vec2 offset) {
  precise vec2 reach = 0.5 / resolveBlock.renderRatio;
  return abs(offset.x) <= reach.x && abs(offset.y) <= reach.y ? 1.0 : 0.0;
}

/// 2^(−½(‖x‖/0.4)²)/r², at most 1: HDRP's Gaussian of the nearest sample's distance x, px of the picture (22.3).
float gaussianConfidence(vec2 offset) {
  precise vec2 x = offset / resolveBlock.renderRatio;
  precise float exponent = -3.125 * (x.x * x.x + x.y * x.y);
  precise float confidence = exp2Of(exponent) / (resolveBlock.renderRatio.x * resolveBlock.renderRatio.y);
  return minimum(confidence, 1.0);
}

/// κ, where the weights do not give it.
float placeConfidence(vec2 offset) { return kIsHdrpGaussian ? gaussianConfidence(offset) : boxConfidence(offset); }

CurrentColor upsample(Samples samples, Place place, float speed) {
  precise vec3 middle = samples.color[4];
  if (kIsSampleWeight) return CurrentColor(middle, nearestConfidence(place.offset, speed));
  WeightedSum sum = WeightedSum(vec3(0.0), 0.0);
  if (kIsFsr2) {
    sum = sumOfSixteen(place, middle);
  } else {
    sum = sumOfNine(samples, place.offset);
  }
  // Differences to the nearest sample, so that a constant stays exactly constant.
  precise vec3 color = middle + sum.color / sum.weight;
  bool isWeighed = sum.weight > 1e-4;
  if (!isWeighed) color = middle;
  if (!kIsHdrp) color = boundedBySamples(color, samples); // negative lobes, as both sources do
  float confidence = isWeighed ? saturated(sum.weight) : 0.0;
  return CurrentColor(storable(color), kIsHdrp ? placeConfidence(place.offset) : confidence);
}
