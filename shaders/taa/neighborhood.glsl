// Bounds the colors around the pixel by a box (catalogue §8, §10). In: scene-linear samples, filtered color and
// history, speed in px. Out: box space.

struct Box {
  vec3 lo;
  vec3 hi;
};

/// What is measured of a set of samples.
struct Moments {
  vec3 mean;
  vec3 deviation;
  vec3 lowest;
  vec3 highest;
};

const bool kIsRounded = kNeighborhoodShape == kNeighborhoodShape_rounded;
const bool kIsAlternate = kNeighborhoodShape == kNeighborhoodShape_alternate;
const bool kIsSquare = kNeighborhoodShape == kNeighborhoodShape_square3x3 || kIsRounded;

/// Whether sample k of 3×3 belongs to the cross of five, or to the diagonals with the center.
bool isInCross(int k) { return k == 4 || k % 2 == 1; }
bool isInX(int k) { return k % 2 == 0; }

/// What a sample counts (10.7).
float momentWeight(int k, vec3 color) {
  precise float byLuma = 1.0 / (1.0 + luma(color));
  float byDistance = k == 4 ? 1.0 : (k % 2 == 1 ? 0.47236655 : 0.22313016);
  if (kNeighborhoodWeights == kNeighborhoodWeights_luma) return byLuma;
  return kNeighborhoodWeights == kNeighborhoodWeights_distance ? byDistance : 1.0;
}

/// The samples where the pixels' centers landed: each a bilinear tap at +j (8.8).
Samples unjittered(ivec2 pixel, Samples samples) {
  ivec2 way = ivec2(resolveBlock.jitterPx.x < 0.0 ? -1 : 1, resolveBlock.jitterPx.y < 0.0 ? -1 : 1);
  vec2 f = abs(resolveBlock.jitterPx);
  Samples result = samples;
  for (int k = 0; k < 9; ++k) {
    ivec2 place = pixel + ivec2(k % 3 - 1, k / 3 - 1);
    precise vec3 here = sanitized(texelAt(u_color, place).rgb);
    precise vec3 beside = sanitized(texelAt(u_color, place + ivec2(way.x, 0)).rgb);
    precise vec3 over = sanitized(texelAt(u_color, place + ivec2(0, way.y)).rgb);
    precise vec3 across = sanitized(texelAt(u_color, place + way).rgb);
    precise vec3 near = here + f.x * (beside - here);
    precise vec3 far = over + f.x * (across - over);
    precise vec3 color = near + f.y * (far - near);
    result.color[k] = storable(color);
  }
  return result;
}

Moments measure(Samples samples, vec3 boxed[9], bool isMember[9]) {
  // Moments about the pixel's own color: those about 0 cancel badly for bright colors (invariant 37).
  precise vec3 sum = vec3(0.0);
  precise vec3 sumOfSquares = vec3(0.0);
  precise float total = 0.0;
  Moments result;
  result.lowest = boxed[4];
  result.highest = boxed[4];
  for (int k = 0; k < 9; ++k) {
    if (!isMember[k]) continue;
    precise float weight = momentWeight(k, samples.color[k]);
    precise vec3 difference = boxed[k] - boxed[4];
    total = total + weight;
    sum = sum + weight * difference;
    sumOfSquares = sumOfSquares + weight * (difference * difference);
    result.lowest = lesser(boxed[k], result.lowest);
    result.highest = greater(boxed[k], result.highest);
  }
  precise vec3 first = sum / total;
  precise vec3 mean = boxed[4] + first;
  precise vec3 variance = sumOfSquares / total - first * first;
  result.mean = bounded(mean, result.lowest, result.highest);
  result.deviation = sqrt(greater(variance, vec3(0.0)));
  return result;
}

/// The bounds of nine and of five, meeting in the middle (8.4).
Moments rounded(Moments nine, Moments five) {
  precise vec3 mean = 0.5 * (nine.mean + five.mean);
  precise vec3 lowest = 0.5 * (nine.lowest + five.lowest);
  precise vec3 highest = 0.5 * (nine.highest + five.highest);
  return Moments(mean, nine.deviation, lowest, highest);
}

Moments measureNeighborhood(Samples samples, vec3 boxed[9]) {
  bool isEven = resolveBlock.state.w % 2 == 0;
  bool isMember[9];
  bool isCross[9];
  for (int k = 0; k < 9; ++k) {
    isCross[k] = isInCross(k);
    isMember[k] = kIsSquare || (kNeighborhoodShape == kNeighborhoodShape_x ? isInX(k) : isInCross(k));
    if (kIsAlternate) isMember[k] = isEven ? isInCross(k) : isInX(k);
  }
  Moments moments = measure(samples, boxed, isMember);
  if (kIsRounded) moments = rounded(moments, measure(samples, boxed, isCross));
  return moments;
}

/// What is added to γ where current and history differ in luma (10.11, HDRP).
float contrastGrowth(Moments moments, vec3 center, vec3 historyColor) {
  precise float reach = 0.5 * boxLuma(moments.deviation);
  precise float mean = boxLuma(moments.mean);
  precise float low = mean - reach;
  precise float high = mean + reach;
  float current = boxLuma(center);
  float history = lesser(greater(boxLuma(toBox(historyColor)), low), high);
  float largest = greater(greater(current, history), 0.15);
  precise float x = saturated((abs(current - history) / largest - 0.05) / 0.5);
  precise float growth = settings.neighborhoodContrastGrowth * ((x * x) * (3.0 - 2.0 * x));
  return hasHistory() ? growth : 0.0;
}

float gammaUsed(Moments moments, vec3 center, vec3 historyColor, float speed, vec2 mask) {
  precise float gamma = settings.neighborhoodGamma;
  if (kNeighborhoodMotionGamma) { // 10.8
    precise float rest = saturated(1.0 - speed / settings.neighborhoodGammaSpeed);
    gamma = settings.neighborhoodGammaMoving + (gamma - settings.neighborhoodGammaMoving) * (rest * rest);
  }
  if (kNeighborhoodContrastGamma) gamma = gamma + contrastGrowth(moments, center, historyColor);
  if (kNeighborhoodMaskRelax) gamma = gamma * (1.0 + 1.5 * greater(mask.x, mask.y)); // 10.10
  return gamma;
}

/// Directions across which the hull is measured: three axes, six edges and four corners of a cube (10.12).
const vec3 kSlabs[13] = vec3[](vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1), vec3(1, 1, 0), vec3(1, -1, 0),
                               vec3(1, 0, 1), vec3(1, 0, -1), vec3(0, 1, 1), vec3(0, 1, -1), vec3(1, 1, 1),
                               vec3(1, 1, -1), vec3(1, -1, 1), vec3(1, -1, -1));
const bool kIsClipToHull = kRectifyMethod == kRectifyMethod_clipToHull;
const int kSlabCount = kIsClipToHull ? 13 : 1; // those that nobody reads cost time to compile

float across(vec3 direction, vec3 color) {
  precise float result = (direction.x * color.x + direction.y * color.y) + direction.z * color.z;
  return result;
}

/// The measured extremes, kept for what clamps to them first, and those along the slabs.
struct Neighborhood {
  Box box;
  Moments moments;
  float slabLow[kSlabCount];
  float slabHigh[kSlabCount];
};

Neighborhood boundNeighborhood(Samples samples, vec3 currentFiltered, vec3 historyColor, float speed) {
  vec3 boxed[9];
  for (int k = 0; k < 9; ++k) boxed[k] = toBox(samples.color[k]);
  Moments moments = measureNeighborhood(samples, boxed);
  float gamma = gammaUsed(moments, boxed[4], historyColor, speed, samples.mask);

  precise vec3 reach = gamma * moments.deviation;
  precise vec3 below = moments.mean - reach;
  precise vec3 above = moments.mean + reach;
  Box box = Box(moments.lowest, moments.highest);
  if (kNeighborhoodBox == kNeighborhoodBox_variance) box = Box(below, above);
  if (kNeighborhoodBox == kNeighborhoodBox_intersection)
    box = Box(greater(moments.lowest, below), lesser(moments.highest, above));
  if (kNeighborhoodChromaShrink && !kIsRgb) { // 10.6
    precise float extent = 0.125 * (moments.highest.x - moments.lowest.x);
    precise vec2 low = boxed[4].yz - extent;
    precise vec2 high = boxed[4].yz + extent;
    box = Box(vec3(box.lo.x, low), vec3(box.hi.x, high));
  }
  if (kNeighborhoodIncludeFiltered) {
    precise vec3 filteredColor = toBox(currentFiltered);
    box = Box(lesser(box.lo, filteredColor), greater(box.hi, filteredColor));
  }
  expose_neighborhoodMean(moments.mean);
  expose_neighborhoodDeviation(moments.deviation);
  expose_neighborhoodMin(moments.lowest);
  expose_neighborhoodMax(moments.highest);
  expose_boxGamma(gamma);
  expose_boxMin(box.lo);
  expose_boxMax(box.hi);
  Neighborhood around;
  around.box = box;
  around.moments = moments;
  if (kIsClipToHull) {
    for (int slab = 0; slab < 13; ++slab) {
      float low = across(kSlabs[slab], boxed[0]);
      float high = low;
      for (int k = 1; k < 9; ++k) {
        low = lesser(low, across(kSlabs[slab], boxed[k]));
        high = greater(high, across(kSlabs[slab], boxed[k]));
      }
      around.slabLow[slab] = low;
      around.slabHigh[slab] = high;
    }
  }
  return around;
}
