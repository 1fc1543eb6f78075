// Compares the depth that a pixel's surface had with those that history keeps around its position (manual 12.1), and
// tells a thin feature that single frames miss from another surface (13.9). Depths in m, 0: the sky.

// What moves against what is known from the motion that history keeps.
const bool kTellsRest =
    kValidateDepth && (kValidateFlicker || kValidateDepthFootprint == kValidateDepthFootprint_readInMotion);
const bool kFindsFlicker = kValidateDepth && kValidateFlicker;

/// Whether `depth` is nearer than `other`; the sky is farther than anything.
bool isNearer(float depth, float other) { return depth != 0.0 && (other == 0.0 || depth < other); }

/// Difference of a stored depth to the expected one, relative to that; the sky matches only the sky.
float depthMismatch(float expected, float stored) {
  precise float relative = abs(expected - stored) / expected;
  bool isSky = expected == 0.0;
  bool wasSky = stored == 0.0;
  float mismatch = mix(mix(relative, 1.0, isSky || wasSky), 0.0, isSky && wasSky);
  if (kValidateDepthDirection == kValidateDepthDirection_nearer)
    mismatch = mix(0.0, mismatch, isNearer(stored, expected));
  return mismatch;
}

struct DepthMatch {
  float depth;    // m
  float mismatch; // relative
};

float storedDepth(ivec2 texel) { return historyAt(u_historySurface, texel).g; }

/// Whether a bilinear tap gives a weight to a texel.
bool isRead(ivec2 texel, vec2 position) {
  precise vec2 offset = abs((vec2(texel) + 0.5) - position);
  return offset.x < 1.0 && offset.y < 1.0;
}

/// Depths stored in 3×3 around a texel of history.
struct Around {
  ivec2 middle;
  float depth[9]; // m, row-major
};

Around storedAround(ivec2 middle) {
  Around around;
  around.middle = middle;
  for (int k = 0; k < 9; ++k) around.depth[k] = storedDepth(middle + ivec2(k % 3 - 1, k / 3 - 1));
  return around;
}

/// The first of the best in reading order, of all nine or of those that are read at a position.
DepthMatch bestMatch(float expected, Around around, vec2 position, bool isOfRead) {
  DepthMatch best = DepthMatch(0.0, 0.0);
  bool isFirst = true;
  for (int k = 0; k < 9; ++k) {
    if (isOfRead && !isRead(around.middle + ivec2(k % 3 - 1, k / 3 - 1), position)) continue;
    float mismatch = depthMismatch(expected, around.depth[k]);
    if (isFirst || mismatch < best.mismatch) best = DepthMatch(around.depth[k], mismatch);
    isFirst = false;
  }
  return best;
}

/// Change of view depth, m, along the surface between two opposite neighbors: the smaller step, and none where both are
/// nearer or both farther, for those steps lead to other surfaces.
float slopeBetween(float center, float a, float b) {
  const float kFarthest = 1e30; // m
  precise float toA = center - (a == 0.0 ? kFarthest : a);
  precise float toB = (b == 0.0 ? kFarthest : b) - center;
  bool goesOn = (toA > 0.0) == (toB > 0.0);
  return goesOn ? minimum(abs(toA), abs(toB)) : 0.0;
}

float viewDepthAt(ivec2 texel) { return viewDepth(texelAt(u_depth, texel).r); }

/// Mismatch that still counts as the same surface: jitter and dilation move a sample along its slope. `chosen`: the
/// dilated sample, whose depth is the one expected.
float allowedMismatch(ivec2 chosen, float expected) {
  float center = viewDepthAt(chosen);
  float x = slopeBetween(center, viewDepthAt(chosen - ivec2(1, 0)), viewDepthAt(chosen + ivec2(1, 0)));
  float y = slopeBetween(center, viewDepthAt(chosen - ivec2(0, 1)), viewDepthAt(chosen + ivec2(0, 1)));
  precise float slope = x + y;
  precise float sloped = settings.validateDepthTolerance + (settings.validateSlopeAllowance * slope) / expected;
  return mix(sloped, settings.validateDepthTolerance, expected == 0.0 || center == 0.0);
}

/// Whether what history shows at a position, all that a bilinear tap reads, moved then as the pixel moves now: if it hid
/// the pixel's surface, it hides it still.
bool isAtRest(vec2 motion, vec2 position) {
  precise vec2 corner = floor(position - 0.5);
  bool result = true;
  for (int k = 0; k < 4; ++k) {
    ivec2 texel = ivec2(corner) + ivec2(k % 2, k / 2);
    if (!isRead(texel, position)) continue;
    precise vec2 change = motion - historyAt(u_historyMotion, texel).rg;
    if (!(speedOf(change) <= settings.validateRestLimit)) result = false;
  }
  return result;
}

/// Whether one sees at `depth` as far as `other`, but for what is allowed.
bool isAsFar(float depth, float other, float allowed) {
  precise float least = other * (1.0 - allowed);
  return depth == 0.0 || (other != 0.0 && depth >= least);
}

/// Whether what history shows, nearer than now, is thin: seen past two texels away on opposite sides. What one frame has
/// of a line a pixel wide is three texels wide once it is dilated; and beside its middle, 3×3 see past it.
bool wasThin(ivec2 middle, float expected, float allowed) {
  const ivec2 kAxes[4] = ivec2[](ivec2(1, 0), ivec2(0, 1), ivec2(1, 1), ivec2(1, -1));
  bool result = false;
  for (int axis = 0; axis < 4; ++axis) {
    bool isBefore = isAsFar(storedDepth(middle - 2 * kAxes[axis]), expected, allowed);
    bool isAfter = isAsFar(storedDepth(middle + 2 * kAxes[axis]), expected, allowed);
    if (isBefore && isAfter) result = true;
  }
  return result;
}

/// Whether what is there now, nearer than history, is thin: the pixel's own sample sees past it, or opposite neighbors'.
bool isThinNow(ivec2 texel, float stored, float allowed) {
  bool isSeenPast[9];
  for (int k = 0; k < 9; ++k)
    isSeenPast[k] = isAsFar(texelAt(u_previousDepth, texel + ivec2(k % 3 - 1, k / 3 - 1)).r, stored, allowed);
  return isSeenPast[4] || (isSeenPast[0] && isSeenPast[8]) || (isSeenPast[1] && isSeenPast[7]) ||
         (isSeenPast[2] && isSeenPast[6]) || (isSeenPast[3] && isSeenPast[5]);
}

struct DepthTest {
  bool isOther;   // another surface
  bool isFlicker; // the same, though its depth differs
};

/// `position`: where history is read, px.
DepthTest compareDepth(ivec2 texel, DilatedMotion dilated, vec2 position) {
  const bool kReads = kValidateDepthFootprint == kValidateDepthFootprint_readInMotion;
  ivec2 chosen = texel + ivec2(dilated.offset);
  ivec2 middle = ivec2(floor(position));
  float expected = texelAt(u_previousDepth, chosen).r;
  float allowed = allowedMismatch(chosen, expected);
  DepthMatch match = DepthMatch(0.0, 0.0);
  Around around = storedAround(middle);
  if (hasHistory()) match = bestMatch(expected, around, position, kReads);
  DepthTest test = DepthTest(match.mismatch > allowed, false);
  if (kTellsRest && test.isOther && keeps(kLayer_motion) && isAtRest(dilated.motion, position)) {
    if (kReads) match = bestMatch(expected, around, position, false);
    test.isOther = match.mismatch > allowed;
    if (kFindsFlicker && test.isOther)
      test.isFlicker = isNearer(match.depth, expected) ? wasThin(middle, expected, allowed)
                                                       : isThinNow(texel, match.depth, allowed);
    test.isOther = test.isOther && !test.isFlicker;
  }
  expose_depthExpected(expected);
  expose_historyDepth(match.depth);
  expose_depthMismatch(match.mismatch);
  expose_depthAllowed(allowed);
  return test;
}
