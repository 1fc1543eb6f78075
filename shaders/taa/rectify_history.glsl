// Pulls history that lies outside the box back to it (catalogue §11). In: scene-linear history and filtered
// color, box in box space. Out: scene-linear; history inside the box comes out untouched, bit for bit.

struct Rectified {
  vec3 color;   // box space
  float amount; // how far it went: 0 kept, 1 all the way
};

float lengthOf(vec3 x) {
  precise float result = sqrt((x.x * x.x + x.y * x.y) + x.z * x.z);
  return result;
}

/// The nearest point of the box (11.1); amount is relative to the way to the middle of the box.
Rectified clampHistory(vec3 history, Box box) {
  precise vec3 color = bounded(history, box.lo, box.hi);
  precise vec3 change = color - history;
  precise vec3 way = 0.5 * (box.lo + box.hi) - history;
  precise float wayLength = lengthOf(way);
  precise float amount = wayLength == 0.0 ? 0.0 : lengthOf(change) / wayLength;
  return Rectified(color, amount);
}

/// Towards the middle of the box until its wall (11.2). Amount 0: not moved.
Rectified clipToCenter(vec3 history, Box box) {
  precise vec3 center = 0.5 * (box.lo + box.hi);
  precise vec3 extent = 0.5 * (box.hi - box.lo) + 1e-8; // a box may be flat
  precise vec3 difference = history - center;
  precise vec3 walls = abs(difference) / extent;
  precise float farthest = greater(greater(walls.x, walls.y), walls.z);
  precise vec3 color = center + difference / farthest;
  precise float amount = 1.0 - 1.0 / farthest;
  return Rectified(color, farthest > 1.0 ? amount : 0.0);
}

/// Share of the way at which one channel enters the box; 0 where it is inside.
float entry(float history, float way, float lo, float hi) {
  precise float fromBelow = (lo - history) / way;
  precise float fromAbove = (hi - history) / way;
  return history < lo ? fromBelow : (history > hi ? fromAbove : 0.0);
}

/// Towards the filtered current color until the box's wall (11.3, Karis 2014), never past the target.
Rectified clipToFiltered(vec3 history, Box box, vec3 currentFiltered) {
  precise vec3 target = bounded(toBox(currentFiltered), box.lo, box.hi);
  precise vec3 way = target - history;
  precise vec3 entries =
      vec3(entry(history.x, way.x, box.lo.x, box.hi.x), entry(history.y, way.y, box.lo.y, box.hi.y),
           entry(history.z, way.z, box.lo.z, box.hi.z));
  precise float amount = greater(greater(entries.x, entries.y), entries.z);
  precise vec3 color = history + way * amount;
  if (amount >= 1.0) return Rectified(target, 1.0);
  return Rectified(color, amount);
}

vec3 rectifyHistory(vec3 historyColor, Box box, vec3 currentFiltered) {
  precise vec3 history = toBox(historyColor);
  Rectified rectified = Rectified(history, 0.0);
  if (kRectifyMethod == kRectifyMethod_clamp) rectified = clampHistory(history, box);
  if (kRectifyMethod == kRectifyMethod_clipToCenter) rectified = clipToCenter(history, box);
  if (kRectifyMethod == kRectifyMethod_clipToFiltered)
    rectified = clipToFiltered(history, box, currentFiltered);

  bool isKept = !hasHistory() || kRectifyMethod == kRectifyMethod_none || isInside(history, box.lo, box.hi) ||
                (kRectifyMethod == kRectifyMethod_clipToCenter && rectified.amount == 0.0);
  precise vec3 result = isKept ? historyColor : sanitized(fromBox(rectified.color));
  expose_historyRectified(result);
  expose_clipAmount(isKept ? 0.0 : rectified.amount);
  return result;
}
