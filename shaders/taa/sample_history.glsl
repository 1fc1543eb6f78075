// Reads the accumulated picture between its pixels (catalogue §6). In: the pixel, its previous position in px.
// Out: scene-linear color, not negative, and the history length N there; both 0 when there is no history.

struct HistorySample {
  vec3 color;
  float frames;  // N
  vec2 position; // px, where it was read
};

/// The four texels around x (px), mixed by their distance, clamped to the edge.
vec3 historyBilinear(vec2 x) {
  precise vec2 u = vec2(lesser(x.x, resolveBlock.sizePx.x), lesser(x.y, resolveBlock.sizePx.y)) - 0.5;
  u = vec2(greater(u.x, 0.0), greater(u.y, 0.0));
  precise vec2 base = floor(u);
  precise vec2 f = u - base;
  ivec2 first = ivec2(base);
  ivec2 last = min(first + 1, ivec2(resolveBlock.sizePx) - 1);
  precise vec3 topLeft = texelFetch(u_historyColor, first, 0).rgb;
  precise vec3 topRight = texelFetch(u_historyColor, ivec2(last.x, first.y), 0).rgb;
  precise vec3 bottomLeft = texelFetch(u_historyColor, ivec2(first.x, last.y), 0).rgb;
  precise vec3 bottomRight = texelFetch(u_historyColor, last, 0).rgb;
  precise vec3 top = topLeft + f.x * (topRight - topLeft);
  precise vec3 bottom = bottomLeft + f.x * (bottomRight - bottomLeft);
  precise vec3 result = top + f.y * (bottom - top);
  return sanitized(result);
}

/// Catmull-Rom from five bilinear taps, corners left out, divided by the sum of weights (6.4, Jimenez 2016).
vec3 historyCatmullRom5(vec2 x) {
  precise vec2 center = floor(x - 0.5) + 0.5;
  precise vec2 f = x - center;
  precise vec2 w0 = f * (-0.5 + f * (1.0 - 0.5 * f));
  precise vec2 w1 = 1.0 + (f * f) * (-2.5 + 1.5 * f);
  precise vec2 w2 = f * (0.5 + f * (2.0 - 1.5 * f));
  precise vec2 w3 = (f * f) * (-0.5 + 0.5 * f);
  precise vec2 w12 = w1 + w2;
  precise vec2 p12 = center + w2 / w12;
  precise vec2 p0 = center - 1.0;
  precise vec2 p3 = center + 2.0;
  precise vec3 above = historyBilinear(vec2(p12.x, p0.y));
  precise vec3 left = historyBilinear(vec2(p0.x, p12.y));
  precise vec3 middle = historyBilinear(p12);
  precise vec3 right = historyBilinear(vec2(p3.x, p12.y));
  precise vec3 below = historyBilinear(vec2(p12.x, p3.y));
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

HistorySample sampleHistory(ivec2 pixel, vec2 historyPosition) {
  // Far away, or NaN: anywhere will do, for it is off the screen.
  bool isNear = historyPosition.x >= -1e6 && historyPosition.x <= 1e6 && historyPosition.y >= -1e6 &&
                historyPosition.y <= 1e6;
  precise vec2 position = isNear ? historyPosition : vec2(pixel) + 0.5;
  HistorySample result;
  result.position = position;
  result.color = vec3(0.0);
  result.frames = 0.0;
  if (hasHistory()) {
    if (kHistoryFilter == kHistoryFilter_bilinear) result.color = historyBilinear(position);
    if (kHistoryFilter == kHistoryFilter_catmullRom5) result.color = historyCatmullRom5(position);
    result.frames = texelFetch(u_historySurface, clamped(ivec2(floor(position))), 0).r;
  }
  expose_historyRaw(result.color);
  expose_historyRawLength(result.frames);
  return result;
}
