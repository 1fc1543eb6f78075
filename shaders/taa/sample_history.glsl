// Reads the accumulated picture between its pixels (catalogue §6). In: the pixel, its previous position in px.
// Out: scene-linear color, not negative, history length N and stored depths there; all 0 without history.

struct HistorySample {
  vec3 color;
  float frames;    // N
  float depths[4]; // view depths in m of the four texels around, row-major
};

/// The four texels around x (px), mixed by their distance, clamped to the edge.
vec3 historyBilinear(vec2 x) {
  precise vec2 u = vec2(lesser(x.x, resolveBlock.sizePx.x), lesser(x.y, resolveBlock.sizePx.y)) - 0.5;
  u = vec2(greater(u.x, 0.0), greater(u.y, 0.0));
  precise vec2 base = floor(u);
  precise vec2 f = u - base;
  ivec2 first = ivec2(base);
  precise vec3 topLeft = texelAt(u_historyColor, first).rgb;
  precise vec3 topRight = texelAt(u_historyColor, first + ivec2(1, 0)).rgb;
  precise vec3 bottomLeft = texelAt(u_historyColor, first + ivec2(0, 1)).rgb;
  precise vec3 bottomRight = texelAt(u_historyColor, first + 1).rgb;
  precise vec3 top = topLeft + f.x * (topRight - topLeft);
  precise vec3 bottom = bottomLeft + f.x * (bottomRight - bottomLeft);
  precise vec3 result = top + f.y * (bottom - top);
  return sanitized(result);
}

/// Mixed color of two texels of the history.
vec3 historyPair(ivec2 first, ivec2 second, float share) {
  precise vec3 a = texelAt(u_historyColor, first).rgb;
  precise vec3 b = texelAt(u_historyColor, second).rgb;
  precise vec3 result = a + share * (b - a);
  return result;
}

/// Catmull-Rom from five bilinear taps, corners left out, divided by the sum of weights (6.4, Jimenez 2016). The
/// taps share twelve texels.
vec3 historyCatmullRom5(vec2 x) {
  precise vec2 corner = floor(x - 0.5);
  precise vec2 f = x - (corner + 0.5);
  precise vec2 w0 = f * (-0.5 + f * (1.0 - 0.5 * f));
  precise vec2 w1 = 1.0 + (f * f) * (-2.5 + 1.5 * f);
  precise vec2 w2 = f * (0.5 + f * (2.0 - 1.5 * f));
  precise vec2 w3 = (f * f) * (-0.5 + 0.5 * f);
  precise vec2 w12 = w1 + w2;
  precise vec2 share = w2 / w12;
  ivec2 t = ivec2(corner);
  precise vec3 top = historyPair(t, t + ivec2(1, 0), share.x);
  precise vec3 bottom = historyPair(t + ivec2(0, 1), t + ivec2(1, 1), share.x);
  precise vec3 middle = top + share.y * (bottom - top);
  middle = sanitized(middle);
  precise vec3 above = sanitized(historyPair(t + ivec2(0, -1), t + ivec2(1, -1), share.x));
  precise vec3 left = sanitized(historyPair(t + ivec2(-1, 0), t + ivec2(-1, 1), share.y));
  precise vec3 right = sanitized(historyPair(t + ivec2(2, 0), t + ivec2(2, 1), share.y));
  precise vec3 below = sanitized(historyPair(t + ivec2(0, 2), t + ivec2(1, 2), share.x));
  precise float wAbove = w12.x * w0.y;
  precise float wLeft = w0.x * w12.y;
  precise float wMiddle = w12.x * w12.y;
  precise float wRight = w3.x * w12.y;
  precise float wBelow = w12.x * w3.y;
  precise float sum = (((wAbove + wLeft) + wMiddle) + wRight) + wBelow;
  // Differences to the middle, so that a constant stays exactly constant.
  precise vec3 weighted = (((above - middle) * wAbove + (left - middle) * wLeft) + (right - middle) * wRight) +
                          (below - middle) * wBelow;
  precise vec3 result = middle + weighted / sum;
  if (kHistoryDering) { // 6.9
    precise vec3 lowest = lesser(lesser(lesser(lesser(above, left), middle), right), below);
    precise vec3 highest = greater(greater(greater(greater(above, left), middle), right), below);
    result = bounded(result, lowest, highest);
  }
  return sanitized(result); // negative lobes would never recover (6.10)
}

HistorySample readHistory(vec2 position) {
  HistorySample result;
  if (kHistoryFilter == kHistoryFilter_bilinear) result.color = historyBilinear(position);
  if (kHistoryFilter == kHistoryFilter_catmullRom5) result.color = historyCatmullRom5(position);
  precise vec2 corner = floor(position - 0.5);
  ivec2 first = ivec2(corner);
  ivec2 nearest = ivec2(floor(position)) - first;
  for (int k = 0; k < 4; ++k) {
    ivec2 offset = ivec2(k % 2, k / 2);
    vec2 surface = texelAt(u_historySurface, first + offset).rg;
    if (k == 0 || offset == nearest) result.frames = surface.r;
    result.depths[k] = surface.g;
  }
  return result;
}

HistorySample sampleHistory(ivec2 pixel, vec2 historyPosition) {
  // Far away, or NaN: anywhere will do, for it is off the screen.
  bool isNear = historyPosition.x >= -1e6 && historyPosition.x <= 1e6 && historyPosition.y >= -1e6 &&
                historyPosition.y <= 1e6;
  precise vec2 position = isNear ? historyPosition : vec2(pixel) + 0.5;
  HistorySample result = HistorySample(vec3(0.0), 0.0, float[4](0.0, 0.0, 0.0, 0.0));
  if (hasHistory()) result = readHistory(position);
  expose_historyRaw(result.color);
  expose_historyRawLength(result.frames);
  return result;
}
