// Pulls history that lies outside the box back to it (manual §11). In: scene-linear history and filtered
// color, neighborhood in box space, speed in px, how much of the correction is taken back. Out: scene-linear, and N;
// history inside the box comes out untouched, bit for bit.

struct Rectified {
  vec3 color;   // box space
  float amount; // how far it went: 0 kept, 1 all the way
};

float magnitude(vec3 x) {
  precise float result = sqrt((x.x * x.x + x.y * x.y) + x.z * x.z);
  return result;
}

/// The nearest point of the box (11.1); amount is relative to the way to the middle of the box.
Rectified clampToBox(vec3 history, Box box) {
  precise vec3 color = clamped(history, box.lo, box.hi);
  precise vec3 change = color - history;
  precise vec3 toTarget = 0.5 * (box.lo + box.hi) - history;
  precise float distanceToTarget = magnitude(toTarget);
  precise float amount = distanceToTarget == 0.0 ? 0.0 : magnitude(change) / distanceToTarget;
  return Rectified(color, amount);
}

/// Towards the middle of the box until its wall (11.2). Amount 0: not moved.
Rectified clipToCenter(vec3 history, Box box) {
  precise vec3 center = 0.5 * (box.lo + box.hi);
  precise vec3 extent = 0.5 * (box.hi - box.lo) + 1e-8; // a box may be flat
  precise vec3 difference = history - center;
  precise vec3 walls = abs(difference) / extent;
  precise float farthest = maximum(maximum(walls.x, walls.y), walls.z);
  precise vec3 color = center + difference / farthest;
  precise float amount = 1.0 - 1.0 / farthest;
  return Rectified(color, farthest > 1.0 ? amount : 0.0);
}

/// Share of the way at which each channel enters the box; 0 where it is inside.
vec3 entry(vec3 history, vec3 toTarget, vec3 lo, vec3 hi) {
  precise vec3 fromBelow = (lo - history) / toTarget;
  precise vec3 fromAbove = (hi - history) / toTarget;
  return mix(mix(vec3(0.0), fromAbove, greaterThan(history, hi)), fromBelow, lessThan(history, lo));
}

/// Towards the filtered current color until the box's wall (11.3, Karis 2014), never past the target.
Rectified clipToFiltered(vec3 history, Box box, vec3 currentFiltered) {
  precise vec3 target = clamped(toBox(currentFiltered), box.lo, box.hi);
  precise vec3 toTarget = target - history;
  vec3 entries = entry(history, toTarget, box.lo, box.hi);
  precise float amount = maximum(maximum(entries.x, entries.y), entries.z);
  precise vec3 color = history + toTarget * amount;
  return Rectified(mix(color, target, bvec3(amount >= 1.0)), mix(amount, 1.0, amount >= 1.0));
}

/// |value − history| against the way to `target`.
float shareToTarget(vec3 value, vec3 history, vec3 target) {
  precise vec3 change = value - history;
  precise vec3 toTarget = target - history;
  precise float distanceToTarget = magnitude(toTarget);
  precise float amount = distanceToTarget == 0.0 ? 0.0 : magnitude(change) / distanceToTarget;
  return amount;
}

/// Towards the mean, scaled to fit one axis after the other (11.5).
Rectified shrinkAxes(vec3 history, Box box, vec3 mean) {
  precise vec3 target = clamped(mean, box.lo, box.hi);
  precise vec3 rest = history - target;
  for (int axis = 0; axis < 3; ++axis) {
    precise float high = box.hi[axis] - target[axis];
    precise float low = box.lo[axis] - target[axis];
    if (rest[axis] > high) {
      rest = rest * (high / rest[axis]);
    } else if (rest[axis] < low) {
      rest = rest * (low / rest[axis]);
    }
  }
  precise vec3 color = target + rest;
  return Rectified(color, shareToTarget(color, history, target));
}

/// The min-max box first, then towards the middle of the other (10.5). Amount 0: not moved.
Rectified clampThenClip(vec3 history, Box box, Moments moments) {
  precise vec3 color = clamped(history, moments.lowest, moments.highest);
  Rectified clipped = clipToCenter(color, box);
  bool isKept = clipped.amount == 0.0;
  if (!isKept) color = clipped.color;
  precise vec3 center = 0.5 * (box.lo + box.hi);
  float amount = shareToTarget(color, history, center);
  return Rectified(color, amount);
}

/// Where the ray from history to the current color enters the box, unless that is too far (11.4).
Rectified rayToCurrent(vec3 history, Box box, vec3 currentFiltered) {
  precise vec3 toTarget = toBox(currentFiltered) - history;
  precise vec3 center = 0.5 * (box.lo + box.hi);
  precise vec3 extent = 0.5 * (box.hi - box.lo);
  precise float nearest = 1e9;
  for (int axis = 0; axis < 3; ++axis) {
    precise float wall = center[axis] - (toTarget[axis] > 0.0 ? extent[axis] : -extent[axis]);
    precise float hit = (wall - history[axis]) / toTarget[axis];
    if (toTarget[axis] != 0.0 && hit >= 0.0 && hit < nearest) nearest = hit;
  }
  precise vec3 color = history + toTarget * nearest;
  if (nearest > settings.rectifyMaxSteps) return Rectified(history, 0.0);
  return Rectified(color, minimum(nearest, 1.0));
}

/// Towards the filtered current color until all slabs around the nine samples hold (9.7, 10.12). They are opened for
/// the target, which filters with negative weights put outside.
Rectified clipToSlabs(vec3 history, Neighborhood around, vec3 currentFiltered) {
  vec3 target = toBox(currentFiltered);
  precise vec3 toTarget = target - history;
  precise float amount = 0.0;
  for (int slab = 0; slab < kSlabCount; ++slab) {
    vec3 direction = slabDirection(slab);
    float end = across(direction, target);
    float low = minimum(around.slabLow[slab], end);
    float high = maximum(around.slabHigh[slab], end);
    vec3 entries = entry(vec3(across(direction, history)), vec3(across(direction, toTarget)), vec3(low), vec3(high));
    amount = maximum(amount, entries.x);
  }
  precise vec3 color = history + toTarget * amount;
  if (amount >= 1.0) return Rectified(target, 1.0);
  return Rectified(color, amount);
}

/// The one of the nine samples that is nearest to history, in box space (11.8): the pixel's own where others are no
/// nearer, else the first of those. Scene-linear, as it was drawn.
vec3 selected(vec3 history, Neighborhood around) {
  precise float nearest = 0.0;
  vec3 color = around.nine[0];
  for (int i = 0; i < kSelectCount; ++i) {
    precise vec3 toTarget = toBox(around.nine[i]) - history;
    precise float squared = (toTarget.x * toTarget.x + toTarget.y * toTarget.y) + toTarget.z * toTarget.z;
    if (i > 0 && !(squared < nearest)) continue;
    nearest = squared;
    color = around.nine[i];
  }
  return color;
}

const bool kIsClampForget = kRectifyMethod == kRectifyMethod_clampForget;
const bool kIsClampThenClip = kRectifyMethod == kRectifyMethod_clampThenClip;

Rectified rectifiedByMethod(vec3 history, Neighborhood around, vec3 currentFiltered) {
  Box box = around.box;
  if (kRectifyMethod == kRectifyMethod_clamp || kIsClampForget) return clampToBox(history, box);
  if (kRectifyMethod == kRectifyMethod_clipToCenter) return clipToCenter(history, box);
  if (kRectifyMethod == kRectifyMethod_clipToFiltered) return clipToFiltered(history, box, currentFiltered);
  if (kRectifyMethod == kRectifyMethod_shrinkAxes) return shrinkAxes(history, box, around.moments.mean);
  if (kIsClampThenClip) return clampThenClip(history, box, around.moments);
  if (kRectifyMethod == kRectifyMethod_rayToCurrent) return rayToCurrent(history, box, currentFiltered);
  if (kUsesSlabs) return clipToSlabs(history, around, currentFiltered);
  return Rectified(history, 0.0);
}

/// Whether history stays as it is, bit for bit.
bool isKept(vec3 history, Neighborhood around, Rectified rectified) {
  if (!hasHistory() || kRectifyMethod == kRectifyMethod_none) return true;
  if (kIsClampThenClip)
    return isInside(history, around.moments.lowest, around.moments.highest) && rectified.color == history;
  if (kUsesSlabs) return !(rectified.amount > 0.0);
  if (kRectifyMethod == kRectifyMethod_clipToCenter && rectified.amount == 0.0) return true;
  if (kRectifyMethod == kRectifyMethod_rayToCurrent && rectified.color == history) return true;
  return isInside(history, around.box.lo, around.box.hi);
}

/// Part of the correction that is applied (11.6, 13.9, 17.2).
float rectifyStrength(float speed, bool isFlicker) {
  if (kRectifyMethod == kRectifyMethod_none) return 0.0;
  precise float share = speed / settings.rectifyRestSpeed;
  precise float strength =
      settings.rectifyMinStrength + (1.0 - settings.rectifyMinStrength) * saturated(share * share);
  if (!kRectifyRelaxAtRest) strength = 1.0;
  if (kFindsFlicker && isFlicker) strength = strength * settings.rectifyFlickerStrength;
  return strength;
}

/// N of history that was moved: a tenth of what FSR2 accumulates, 0.1 of a mean weight of 0.74/12 a frame (11.7).
float lengthKept(float historyLength, float protection) {
  float forgotten = minimum(historyLength, 1.6216216);
  precise float result = forgotten + protection * (historyLength - forgotten);
  return result;
}

struct RectifiedHistory {
  vec3 color;   // scene-linear
  float historyLength; // N
};

/// `strength`: part of the correction that is applied; `held`: what is taken back of that.
RectifiedHistory rectifyHistory(HistorySample raw, Neighborhood around, vec3 currentFiltered, float strength,
                                float protection) {
  precise vec3 history = toBox(raw.color);
  Rectified rectified = rectifiedByMethod(history, around, currentFiltered);
  bool kept = isKept(history, around, rectified);
  precise vec3 corrected = storable(fromBox(rectified.color));
  precise float amount = rectified.amount;
  if (kIsSelect) { // inside the box as well, and not on the way through it
    corrected = selected(history, around);
    kept = !hasHistory() || corrected == raw.color;
    amount = 1.0;
  }
  if (kRectifyRelaxAtRest || (kFindsFlicker && strength < 1.0)) {
    corrected = raw.color + strength * (corrected - raw.color);
    amount = amount * strength;
  }
  if (kHolds) {
    corrected = corrected + protection * (raw.color - corrected);
    amount = amount * (1.0 - protection);
  }
  precise vec3 color = kept ? raw.color : corrected;
  float historyLength = kIsClampForget && !kept ? lengthKept(raw.historyLength, protection) : raw.historyLength;
  expose_historyRectified(color);
  expose_clipAmount(kept ? 0.0 : amount);
  expose_rectifyStrength(strength);
  expose_historyKeptLength(historyLength);
  return RectifiedHistory(color, historyLength);
}
