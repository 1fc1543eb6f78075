// Bounds the colors around the pixel by a box (manual §8, §10). In: scene-linear samples, filtered color and
// history, speed in px, depth in m. Out: box space.

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
const bool kIsVarying = kNeighborhoodShape == kNeighborhoodShape_varying;
const bool kIsPairs = kNeighborhoodShape == kNeighborhoodShape_pairs;
const bool kIsSquare = kNeighborhoodShape == kNeighborhoodShape_square3x3 || kIsRounded;

/// Whether sample k of 3×3 belongs to the cross of five, or to the diagonals with the center.
bool isInCross(int k) { return k == 4 || k % 2 == 1; }
bool isInX(int k) { return k % 2 == 0; }

/// What the box may depend on besides the colors of this frame.
struct NeighborhoodInputs {
  vec3 history; // scene-linear, as it was read
  vec2 motion;  // px
  float speed;  // px a frame
  float depth;  // view depth of whose motion it is, m; 0: sky
};

/// What a sample counts (10.7). Taps that vary count as the diagonals that they stand for.
float momentWeight(int k, vec3 color, vec3 boxed) {
  precise float byLuma = 1.0 / (1.0 + weightLuma(color));
  precise float byBoxLuma = 1.0 / (1.0 + boxLuma(boxed));
  float byDistance = k == 4 ? 1.0 : (k % 2 == 1 ? 0.47236655 : 0.22313016);
  if (kNeighborhoodWeights == kNeighborhoodWeights_luma) return byLuma;
  if (kNeighborhoodWeights == kNeighborhoodWeights_boxLuma) return byBoxLuma;
  return kNeighborhoodWeights == kNeighborhoodWeights_distance ? byDistance : 1.0;
}

/// The bilinear tap at `offset` px from a render texel's center.
vec3 tapAt(ivec2 texel, vec2 offset) {
  ivec2 direction = ivec2(offset.x < 0.0 ? -1 : 1, offset.y < 0.0 ? -1 : 1);
  precise vec2 whole = floor(abs(offset));
  precise vec2 f = abs(offset) - whole;
  ivec2 place = texel + direction * ivec2(whole);
  precise vec3 here = sanitized(texelAt(u_color, place).rgb);
  precise vec3 beside = sanitized(texelAt(u_color, place + ivec2(direction.x, 0)).rgb);
  precise vec3 over = sanitized(texelAt(u_color, place + ivec2(0, direction.y)).rgb);
  precise vec3 across = sanitized(texelAt(u_color, place + direction).rgb);
  precise vec3 near = here + f.x * (beside - here);
  precise vec3 far = over + f.x * (across - over);
  precise vec3 color = near + f.y * (far - near);
  return storable(color);
}

/// The samples where the pixels' centers landed: each a bilinear tap at +j (8.8).
Samples unjittered(ivec2 texel, Samples samples) {
  Samples result = samples;
  for (int k = 0; k < 9; ++k)
    result.color[k] = tapAt(texel + ivec2(k % 3 - 1, k / 3 - 1), resolveBlock.jitterPx);
  return result;
}

/// How far the taps that vary lie from the center along both axes: κ of 8.5, px.
float tapReach(NeighborhoodInputs given) {
  precise float product = given.speed * given.depth;
  // Nothing is divided by 0, and the sky is infinitely far even where it rests.
  precise float nearness = saturated(0.5 / mix(product, 1.0, product == 0.0));
  if (product == 0.0) nearness = given.depth == 0.0 ? 0.0 : 1.0;
  precise float reach = 0.5 + 0.1667 * nearness;
  return reach;
}

/// The diagonals drawn in to taps at ±κ, about where the center landed if that is asked for. The pixel's own color
/// stays, though it is not one of them.
Samples varyingTaps(ivec2 texel, Samples samples, NeighborhoodInputs given) {
  float reach = tapReach(given);
  Samples result = samples;
  for (int k = 0; k < 9; k += 2) {
    if (k == 4) continue;
    precise vec2 offset = vec2(k % 3 - 1, k / 3 - 1) * reach;
    if (kNeighborhoodUnjitter) offset = offset + resolveBlock.jitterPx;
    result.color[k] = tapAt(texel, offset);
  }
  return result;
}

/// The sample of a render texel, which may lie beyond the nine.
vec3 sampleAt(ivec2 texel) {
  return kNeighborhoodUnjitter ? tapAt(texel, resolveBlock.jitterPx) : sanitized(texelAt(u_color, texel).rgb);
}

bool isLeftOfPair(ivec2 texel) { return texel.x % 2 == 0; }

/// Seven samples for both of columns 2k and 2k + 1 (8.7): the left one, its diagonals, and the two to the right of it.
/// Those beyond the nine take places of neighbors that are none of them.
Samples pairSamples(ivec2 texel, Samples samples) {
  Samples result = samples;
  if (isLeftOfPair(texel)) {
    result.color[3] = sampleAt(texel + ivec2(2, 0));
  } else {
    result.color[0] = sampleAt(texel + ivec2(-2, -1));
    result.color[6] = sampleAt(texel + ivec2(-2, 1));
  }
  return result;
}

bool isInPair(int k, ivec2 texel) { return isLeftOfPair(texel) ? k != 1 && k != 7 : k != 2 && k != 8; }

Moments measure(Samples samples, vec3 boxed[9], bool isMember[9]) {
  // Moments about the pixel's own color: those about 0 cancel badly for bright colors (invariant 37).
  precise vec3 sum = vec3(0.0);
  precise vec3 sumOfSquares = vec3(0.0);
  precise float total = 0.0;
  const int kFirst = kIsVarying ? 0 : 4; // a member
  Moments result;
  result.lowest = boxed[kFirst];
  result.highest = boxed[kFirst];
  for (int k = 0; k < 9; ++k) {
    if (!isMember[k]) continue;
    precise float weight = momentWeight(k, samples.color[k], boxed[k]);
    precise vec3 difference = boxed[k] - boxed[4];
    total = total + weight;
    sum = sum + weight * difference;
    sumOfSquares = sumOfSquares + weight * (difference * difference);
    result.lowest = minimum(boxed[k], result.lowest);
    result.highest = maximum(boxed[k], result.highest);
  }
  precise vec3 first = sum / total;
  precise vec3 mean = boxed[4] + first;
  precise vec3 variance = sumOfSquares / total - first * first;
  result.mean = clamped(mean, result.lowest, result.highest);
  result.deviation = sqrt(maximum(variance, vec3(0.0)));
  return result;
}

/// The bounds of nine and of five, meeting in the middle (8.4).
Moments rounded(Moments nine, Moments five) {
  precise vec3 mean = 0.5 * (nine.mean + five.mean);
  precise vec3 lowest = 0.5 * (nine.lowest + five.lowest);
  precise vec3 highest = 0.5 * (nine.highest + five.highest);
  return Moments(mean, nine.deviation, lowest, highest);
}

/// Whether the shape has sample k around a render texel.
bool isInShape(int k, ivec2 texel) {
  bool isEven = frameNumber() % 2 == 0;
  if (kIsVarying) return isInX(k) && k != 4;
  if (kIsPairs) return isInPair(k, texel);
  if (kIsAlternate) return isEven ? isInCross(k) : isInX(k);
  return kIsSquare || (kNeighborhoodShape == kNeighborhoodShape_x ? isInX(k) : isInCross(k));
}

vec3[9] allToBox(Samples samples) {
  vec3 boxed[9];
  for (int k = 0; k < 9; ++k) boxed[k] = toBox(samples.color[k]);
  return boxed;
}

Moments measureSamples(Samples samples, vec3 boxed[9], ivec2 texel) {
  bool isMember[9];
  bool isCross[9];
  for (int k = 0; k < 9; ++k) {
    isCross[k] = isInCross(k);
    isMember[k] = isInShape(k, texel);
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
  float history = minimum(maximum(boxLuma(toBox(historyColor)), low), high);
  float largest = maximum(maximum(current, history), 0.15);
  precise float x = saturated((abs(current - history) / largest - 0.05) / 0.5);
  precise float growth = settings.neighborhoodContrastGrowth * ((x * x) * (3.0 - 2.0 * x));
  return hasHistory() ? growth : 0.0;
}

float gammaUsed(Moments moments, vec3 center, NeighborhoodInputs given, vec2 mask) {
  precise float gamma = settings.neighborhoodGamma;
  if (kNeighborhoodMotionGamma) { // 10.8
    float speed = given.speed;
    if (kNeighborhoodGammaSpeedIn == kNeighborhoodGammaSpeedIn_lines1080) speed = speedOfLines(given.speed);
    if (kNeighborhoodGammaSpeedIn == kNeighborhoodGammaSpeedIn_picture1080) speed = speedOfPicture(given.motion);
    precise float rest = saturated(1.0 - speed / settings.neighborhoodGammaSpeed);
    gamma = settings.neighborhoodGammaMoving + (gamma - settings.neighborhoodGammaMoving) * (rest * rest);
  }
  if (kNeighborhoodResolutionGamma) { // 10.9: of both γ that are chosen, not of what follows from colors
    precise float share = 1188.0 / resolveBlock.sizePx.y;
    gamma = gamma * minimum(maximum(share, 0.75), 1.0);
  }
  if (kNeighborhoodContrastGamma) gamma = gamma + contrastGrowth(moments, center, given.history);
  if (kNeighborhoodMaskRelax) gamma = gamma * (1.0 + 1.5 * maximum(mask.x, mask.y)); // 10.10
  return gamma;
}

/// Directions across which the hull is measured: three axes, six edges and four corners of a cube (10.12).
const vec3 kSlabs[13] = vec3[](vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1), vec3(1, 1, 0), vec3(1, -1, 0),
                               vec3(1, 0, 1), vec3(1, 0, -1), vec3(0, 1, 1), vec3(0, 1, -1), vec3(1, 1, 1),
                               vec3(1, 1, -1), vec3(1, -1, 1), vec3(1, -1, -1));
const bool kIsClipToHull = kRectifyMethod == kRectifyMethod_clipToHull;
const bool kIsClipToBoth = kRectifyMethod == kRectifyMethod_clipToBoth;
const bool kUsesSlabs = kIsClipToHull || kIsClipToBoth;
const int kSlabCount = kIsClipToHull ? 13 : (kIsClipToBoth ? 6 : 1); // those that nobody reads cost time to compile

/// Axes of the other space along those of the box's: of RGB Y, Co, Cg; of the others R, G, B (9.7). How long one is
/// does not matter.
vec3 otherAxis(int axis) {
  if (kIsRgb) return vec3[](vec3(1, 2, 1), vec3(1, 0, -1), vec3(-1, 2, -1))[axis];
  if (kSpaceColor == kSpaceColor_yCoCgLifting) return vec3[](vec3(2, 1, -1), vec3(2, 0, 1), vec3(2, -1, -1))[axis];
  if (kSpaceColor == kSpaceColor_yCbCr)
    return vec3[](vec3(1, 0, 1.5748), vec3(1, -0.18732427, -0.46812427), vec3(1, 1.8556, 0))[axis];
  return vec3[](vec3(1, 1, -1), vec3(1, 0, 1), vec3(1, -1, -1))[axis];
}

/// The first three are the box's own axes.
vec3 slabDirection(int slab) { return kIsClipToBoth && slab >= 3 ? otherAxis(slab - 3) : kSlabs[slab]; }

float across(vec3 direction, vec3 color) {
  precise float result = (direction.x * color.x + direction.y * color.y) + direction.z * color.z;
  return result;
}

const bool kIsSelect = kRectifyMethod == kRectifyMethod_select;
const int kSelectCount = kIsSelect ? 9 : 1;

/// The measured extremes, kept for what clamps to them first, those along the slabs, and the nine samples to choose
/// from, scene-linear, the pixel's own first.
struct Neighborhood {
  Box box;
  Moments moments;
  float slabLow[kSlabCount];
  float slabHigh[kSlabCount];
  vec3 nine[kSelectCount];
};

void measureSlabs(vec3 boxed[9], inout Neighborhood around) {
  for (int slab = 0; slab < kSlabCount; ++slab) {
    float low = across(slabDirection(slab), boxed[0]);
    float high = low;
    for (int k = 1; k < 9; ++k) {
      low = minimum(low, across(slabDirection(slab), boxed[k]));
      high = maximum(high, across(slabDirection(slab), boxed[k]));
    }
    around.slabLow[slab] = low;
    around.slabHigh[slab] = high;
  }
}

Box boundByMoments(Moments moments, float gamma) {
  precise vec3 reach = gamma * moments.deviation;
  precise vec3 below = moments.mean - reach;
  precise vec3 above = moments.mean + reach;
  Box box = Box(moments.lowest, moments.highest);
  if (kNeighborhoodBox == kNeighborhoodBox_variance) box = Box(below, above);
  if (kNeighborhoodBox == kNeighborhoodBox_intersection)
    box = Box(maximum(moments.lowest, below), minimum(moments.highest, above));
  return box;
}

/// The fault of a box that is measured in RGB: its two corners in box space, where the lower can be the higher.
Box boxOfCorners(Samples samples) {
  vec3 lowest = samples.color[0];
  vec3 highest = samples.color[0];
  for (int k = 1; k < 9; ++k) {
    lowest = minimum(lowest, samples.color[k]);
    highest = maximum(highest, samples.color[k]);
  }
  return Box(toBox(lowest), toBox(highest));
}

Neighborhood measureNeighborhood(Samples samples, ivec2 texel, vec3 currentFiltered, NeighborhoodInputs given) {
  vec3 boxed[9] = allToBox(samples);
  Moments moments;
  if (kIsVarying || kIsPairs) {
    Samples members = kIsVarying ? varyingTaps(texel, samples, given) : pairSamples(texel, samples);
    moments = measureSamples(members, allToBox(members), texel);
  } else {
    moments = measureSamples(samples, boxed, texel);
  }
  float gamma = gammaUsed(moments, boxed[4], given, samples.mask);
  Box box = boundByMoments(moments, gamma);
  if (kNeighborhoodChromaShrink && !kIsRgb) { // 10.6
    precise float extent = 0.125 * (moments.highest.x - moments.lowest.x);
    precise vec2 low = boxed[4].yz - extent;
    precise vec2 high = boxed[4].yz + extent;
    box = Box(vec3(box.lo.x, low), vec3(box.hi.x, high));
  }
  if (kFaultBoxCorners) box = boxOfCorners(samples);
  if (kNeighborhoodIncludeFiltered) {
    precise vec3 filteredColor = toBox(currentFiltered);
    box = Box(minimum(box.lo, filteredColor), maximum(box.hi, filteredColor));
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
  if (kUsesSlabs) measureSlabs(boxed, around);
  for (int i = 0; i < kSelectCount; ++i) around.nine[i] = samples.color[i == 0 ? 4 : (i <= 4 ? i - 1 : i)];
  return around;
}
