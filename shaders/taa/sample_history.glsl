// Reads the accumulated picture between its pixels (manual §6). In: the pixel, its previous position in px, and this
// frame's depth around it.
// Out: scene-linear color, not negative, history length N there; all 0 without history.

struct HistorySample {
  vec3 color;
  float historyLength;  // N
  vec2 position; // px, where it was read: the history position when that is sane
};

/// The stored color of a texel: outside of the picture that of its edge, or black (5.4).
vec3 storedColor(ivec2 texel) {
  vec3 color = historyAt(u_historyColor, texel).rgb;
  if (kHistoryBorder == kHistoryBorder_edge) return color;
  bool isIn = texel.x >= 0 && texel.y >= 0 && texel.x < int(resolveBlock.sizePx.x) && texel.y < int(resolveBlock.sizePx.y);
  return mix(vec3(0.0), color, bvec3(isIn));
}

/// The four texels around x (px), mixed by their distance.
vec3 bilinearHistory(vec2 x) {
  precise vec2 base = floor(x - 0.5);
  precise vec2 f = x - (base + 0.5);
  ivec2 first = ivec2(base);
  precise vec3 topLeft = storedColor(first);
  precise vec3 topRight = storedColor(first + ivec2(1, 0));
  precise vec3 bottomLeft = storedColor(first + ivec2(0, 1));
  precise vec3 bottomRight = storedColor(first + 1);
  precise vec3 top = topLeft + f.x * (topRight - topLeft);
  precise vec3 bottom = bottomLeft + f.x * (bottomRight - bottomLeft);
  precise vec3 result = top + f.y * (bottom - top);
  return storable(result);
}

/// Mixed color of two texels of the history.
vec3 historyPair(ivec2 first, ivec2 second, float share) {
  precise vec3 a = storedColor(first);
  precise vec3 b = storedColor(second);
  precise vec3 result = a + share * (b - a);
  return result;
}

/// Weights of the four texels of an axis at fraction f between the middle two.
struct CubicWeights {
  vec2 w0, w1, w2, w3;
};

CubicWeights catmullRomWeights(vec2 f) { // 6.2
  precise vec2 w0 = f * (-0.5 + f * (1.0 - 0.5 * f));
  precise vec2 w1 = 1.0 + (f * f) * (-2.5 + 1.5 * f);
  precise vec2 w2 = f * (0.5 + f * (2.0 - 1.5 * f));
  precise vec2 w3 = (f * f) * (-0.5 + 0.5 * f);
  return CubicWeights(w0, w1, w2, w3);
}

CubicWeights sharpnessWeights(vec2 f) { // 6.5
  float c = settings.historySharpness;
  precise vec2 w0 = ((-c * f + 2.0 * c) * f - c) * f;
  precise vec2 w1 = ((2.0 - c) * f - (3.0 - c)) * (f * f) + 1.0;
  precise vec2 w2 = ((-(2.0 - c) * f + (3.0 - 2.0 * c)) * f + c) * f;
  precise vec2 w3 = (c * f - c) * (f * f);
  return CubicWeights(w0, w1, w2, w3);
}

vec2 mitchellNear(vec2 x) {
  precise vec2 result = ((7.0 * x - 12.0) * (x * x) + 16.0 / 3.0) / 6.0;
  return result;
}

vec2 mitchellFar(vec2 x) {
  precise vec2 cubic = (((-7.0 / 3.0) * x + 12.0) * x - 20.0) * x;
  precise vec2 result = (cubic + 32.0 / 3.0) / 6.0;
  return result;
}

/// (x² − 1)(x² − 4)³/64, the polynomial near Lanczos 2 of FSR2 and Filament (6.7).
vec2 lanczos(vec2 x) {
  precise vec2 squared = x * x;
  squared = vec2(minimum(squared.x, 4.0), minimum(squared.y, 4.0));
  precise vec2 a = squared - 1.0;
  precise vec2 b = squared - 4.0;
  precise vec2 result = ((a * b) * (b * b)) / 64.0;
  return result;
}

CubicWeights mitchellWeights(vec2 f) { // 6.6
  precise vec2 x0 = 1.0 + f;
  precise vec2 x2 = 1.0 - f;
  precise vec2 x3 = 2.0 - f;
  return CubicWeights(mitchellFar(x0), mitchellNear(f), mitchellNear(x2), mitchellFar(x3));
}

CubicWeights lanczosWeights(vec2 f) { // 6.7
  precise vec2 x0 = 1.0 + f;
  precise vec2 x2 = 1.0 - f;
  precise vec2 x3 = 2.0 - f;
  return CubicWeights(lanczos(x0), lanczos(f), lanczos(x2), lanczos(x3));
}

const bool kIsCubic5AsPrinted = kHistoryFilter == kHistoryFilter_cubic5AsPrinted;
const bool kIsCubic5 = kHistoryFilter == kHistoryFilter_cubic5 || kIsCubic5AsPrinted;
const bool kHasSharpness = kHistoryFilter == kHistoryFilter_cubic || kIsCubic5;

CubicWeights cubicWeights(vec2 f) {
  if (kHasSharpness) return sharpnessWeights(f);
  if (kHistoryFilter == kHistoryFilter_mitchell) return mitchellWeights(f);
  if (kHistoryFilter == kHistoryFilter_lanczos) return lanczosWeights(f);
  return catmullRomWeights(f);
}

/// Five or nine bilinear taps in place of sixteen texels: the middle two of each axis are one tap.
const bool kIsCatmullRom5 = kHistoryFilter == kHistoryFilter_catmullRom5;
const bool kIsCatmullRom9 = kHistoryFilter == kHistoryFilter_catmullRom9;
const bool kIsCatmullRom5AsPrinted = kHistoryFilter == kHistoryFilter_catmullRom5AsPrinted;
const bool kIsCatmullRom5Corners = kHistoryFilter == kHistoryFilter_catmullRom5Corners;
const bool kIsFiveTaps = kIsCatmullRom5 || kIsCatmullRom5AsPrinted || kIsCatmullRom5Corners || kIsCubic5;

struct Taps {
  vec3 above, left, middle, right, below;
};

Taps historyTaps(ivec2 t, vec2 share) {
  precise vec3 top = historyPair(t, t + ivec2(1, 0), share.x);
  precise vec3 bottom = historyPair(t + ivec2(0, 1), t + ivec2(1, 1), share.x);
  precise vec3 middle = top + share.y * (bottom - top);
  return Taps(sanitized(historyPair(t + ivec2(0, -1), t + ivec2(1, -1), share.x)),
              sanitized(historyPair(t + ivec2(-1, 0), t + ivec2(-1, 1), share.y)), sanitized(middle),
              sanitized(historyPair(t + ivec2(2, 0), t + ivec2(2, 1), share.y)),
              sanitized(historyPair(t + ivec2(0, 2), t + ivec2(1, 2), share.x)));
}

vec3 historyTexel(ivec2 texel) { return sanitized(storedColor(texel)); }

/// Corners left out, divided by the sum of weights (6.4, Jimenez 2016); as printed it is not (6.4b). Or each corner
/// taken for the mean of the two taps beside it (6.4c): half of its weight goes to either.
vec3 fiveTaps(vec2 x) {
  precise vec2 corner = floor(x - 0.5);
  precise vec2 f = x - (corner + 0.5);
  CubicWeights w = cubicWeights(f);
  precise vec2 w12 = w.w1 + w.w2;
  precise vec2 share = w.w2 / w12;
  Taps taps = historyTaps(ivec2(corner), share);
  if (kIsCubic5AsPrinted) taps.right = historyTexel(ivec2(corner) + ivec2(2, -1)); // the row above: manual §26, D13
  precise vec2 beside = w12;
  if (kIsCatmullRom5Corners) {
    precise vec2 outer = w.w0 + w.w3;
    beside = w12 + 0.5 * outer;
  }
  precise float wAbove = beside.x * w.w0.y;
  precise float wLeft = w.w0.x * beside.y;
  precise float wMiddle = w12.x * w12.y;
  precise float wRight = w.w3.x * beside.y;
  precise float wBelow = beside.x * w.w3.y;
  precise float sum = (((wAbove + wLeft) + wMiddle) + wRight) + wBelow;
  // Differences to the middle, so that a constant stays exactly constant.
  precise vec3 weighted = (((taps.above - taps.middle) * wAbove + (taps.left - taps.middle) * wLeft) +
                           (taps.right - taps.middle) * wRight) +
                          (taps.below - taps.middle) * wBelow;
  precise vec3 result = taps.middle + (kIsCatmullRom5Corners ? weighted : weighted / sum);
  if (kIsCatmullRom5AsPrinted) {
    precise vec3 asPrinted = taps.middle * sum + weighted;
    result = asPrinted;
  }
  if (kHistoryDering) { // 6.9
    vec3 lowest = minimum(minimum(minimum(minimum(taps.above, taps.left), taps.middle), taps.right), taps.below);
    vec3 highest = maximum(maximum(maximum(maximum(taps.above, taps.left), taps.middle), taps.right), taps.below);
    result = clamped(result, lowest, highest);
  }
  return storable(result); // negative lobes would never recover (6.10)
}

/// The corners too: equal to sixteen texels (6.3).
vec3 nineTaps(vec2 x) {
  precise vec2 corner = floor(x - 0.5);
  precise vec2 f = x - (corner + 0.5);
  CubicWeights w = catmullRomWeights(f);
  precise vec2 w12 = w.w1 + w.w2;
  precise vec2 share = w.w2 / w12;
  ivec2 t = ivec2(corner);
  Taps taps = historyTaps(t, share);
  vec3 colors[9] = vec3[9](historyTexel(t - 1), taps.above, historyTexel(t + ivec2(2, -1)), taps.left, taps.middle,
                           taps.right, historyTexel(t + ivec2(-1, 2)), taps.below, historyTexel(t + 2));
  float wx[3] = float[3](w.w0.x, w12.x, w.w3.x);
  float wy[3] = float[3](w.w0.y, w12.y, w.w3.y);
  precise float sum = 0.0;
  precise vec3 weighted = vec3(0.0);
  vec3 lowest = colors[0];
  vec3 highest = colors[0];
  for (int k = 0; k < 9; ++k) {
    precise float weight = wx[k % 3] * wy[k / 3];
    sum = sum + weight;
    weighted = weighted + (colors[k] - taps.middle) * weight;
    lowest = minimum(lowest, colors[k]);
    highest = maximum(highest, colors[k]);
  }
  precise vec3 result = taps.middle + weighted / sum;
  if (kHistoryDering) result = clamped(result, lowest, highest);
  return storable(result);
}

/// Sixteen texels with the weights of the chosen kernel (6.2, 6.5 to 6.7).
vec3 sixteenTexels(vec2 x) {
  precise vec2 corner = floor(x - 0.5);
  precise vec2 f = x - (corner + 0.5);
  CubicWeights w = cubicWeights(f);
  float wx[4] = float[4](w.w0.x, w.w1.x, w.w2.x, w.w3.x);
  float wy[4] = float[4](w.w0.y, w.w1.y, w.w2.y, w.w3.y);
  ivec2 t = ivec2(corner);
  precise vec3 middle = historyTexel(t);
  precise float sum = 0.0;
  precise vec3 weighted = vec3(0.0);
  vec3 lowest = middle;
  vec3 highest = middle;
  for (int k = 0; k < 16; ++k) {
    ivec2 cell = ivec2(k % 4, k / 4);
    precise vec3 color = historyTexel(t + cell - 1);
    precise float weight = wx[cell.x] * wy[cell.y];
    sum = sum + weight;
    weighted = weighted + (color - middle) * weight;
    // Lanczos keeps within the nearest four, as FSR2 does.
    bool isNearest = (cell.x == 1 || cell.x == 2) && (cell.y == 1 || cell.y == 2);
    if (kHistoryFilter == kHistoryFilter_lanczos && !isNearest) continue;
    lowest = minimum(lowest, color);
    highest = maximum(highest, color);
  }
  precise vec3 result = middle + weighted / sum;
  if (kHistoryDering) result = clamped(result, lowest, highest);
  return storable(result);
}

/// Whether depth has an edge among the nine pixels around (6.8); the sky is far beyond everything.
bool hasDepthEdge(ivec2 texel) {
  float nearest = 1e30;
  float farthest = 0.0;
  for (int k = 0; k < 9; ++k) {
    float depth = viewDepth(texelAt(u_depth, texel + ivec2(k % 3 - 1, k / 3 - 1)).r);
    if (depth == 0.0) depth = 1e30;
    nearest = minimum(nearest, depth);
    farthest = maximum(farthest, depth);
  }
  precise float range = farthest - nearest;
  precise float limit = settings.historyEdgeDepth * farthest;
  return range > limit;
}

const bool kTakesEdges = kHistoryBilinearAtEdges && kHistoryFilter != kHistoryFilter_point &&
                         kHistoryFilter != kHistoryFilter_bilinear;

vec3 filteredHistory(vec2 x) {
  if (kHistoryFilter == kHistoryFilter_point) return historyTexel(ivec2(floor(x)));
  if (kHistoryFilter == kHistoryFilter_bilinear) return bilinearHistory(x);
  if (kIsFiveTaps) return fiveTaps(x);
  if (kIsCatmullRom9) return nineTaps(x);
  return sixteenTexels(x);
}

/// N of the four texels around, mixed by their distance (Godot).
float bilinearLength(vec2 position) {
  precise vec2 corner = floor(position - 0.5);
  precise vec2 f = position - (corner + 0.5);
  ivec2 first = ivec2(corner);
  float topLeft = historyAt(u_historySurface, first).r;
  float topRight = historyAt(u_historySurface, first + ivec2(1, 0)).r;
  float bottomLeft = historyAt(u_historySurface, first + ivec2(0, 1)).r;
  float bottomRight = historyAt(u_historySurface, first + 1).r;
  precise float top = topLeft + f.x * (topRight - topLeft);
  precise float bottom = bottomLeft + f.x * (bottomRight - bottomLeft);
  precise float result = top + f.y * (bottom - top);
  return result;
}

HistorySample readHistory(ivec2 pixel, vec2 position, bool isEdge) {
  HistorySample result;
  result.color = filteredHistory(position);
  if (kTakesEdges && isEdge) result.color = bilinearHistory(position);
  result.historyLength = historyAt(u_historySurface, ivec2(floor(position))).r;
  if (kHistoryLength == kHistoryLength_pixelAsPrinted) // manual §26, D15
    result.historyLength = historyAt(u_historySurface, pixel).r;
  if (kHistoryLength == kHistoryLength_bilinear) result.historyLength = bilinearLength(position);
  return result;
}

HistorySample sampleHistory(ivec2 pixel, ivec2 texel, vec2 historyPosition) {
  // Far away, or NaN: anywhere will do, for it is off the screen.
  bool isNear = historyPosition.x >= -1e6 && historyPosition.x <= 1e6 && historyPosition.y >= -1e6 &&
                historyPosition.y <= 1e6;
  precise vec2 position = isNear ? historyPosition : vec2(pixel) + 0.5;
  HistorySample result = HistorySample(vec3(0.0), 0.0, position);
  bool isEdge = false;
  if (kTakesEdges) isEdge = hasDepthEdge(texel);
  if (hasHistory()) result = readHistory(pixel, position, isEdge);
  result.position = position;
  expose_depthEdge(isEdge ? 1.0 : 0.0);
  expose_historyRaw(result.color);
  expose_historyRawLength(result.historyLength);
  return result;
}

const uint kNanBits = 0x7FC00000u;

bool isNanColor(vec3 color) { return any(greaterThan(floatBitsToUint(color) & 0x7FFFFFFFu, uvec3(0x7F800000u))); }

/// The fault that a color that is no number is kept: whether the sample is none, or one of nine texels of the history
/// around its position.
bool holdsNan(ivec2 texel, Reprojection reprojection) {
  bool isFound = isNanColor(texelAt(u_color, texel).rgb);
  if (!hasHistory() || reprojection.onScreen == 0.0) return isFound;
  ivec2 from = ivec2(floor(reprojection.position));
  for (int k = 0; k < 9; ++k)
    isFound = isFound || isNanColor(historyAt(u_historyColor, from + ivec2(k % 3 - 1, k / 3 - 1)).rgb);
  return isFound;
}
