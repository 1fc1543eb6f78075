// Chooses where motion is read (catalogue §4). In: the pixel. Out: step to the chosen neighbor in px, its device
// depth, its motion in px.

struct DilatedMotion {
  vec2 offset;
  float depth;
  vec2 motion;
};

const bool kIsClosest3x3 = kDilateMethod == kDilateMethod_closest3x3;
const bool kIsClosestCross = kDilateMethod == kDilateMethod_closestCross;
const bool kIsClosestX = kDilateMethod == kDilateMethod_closestX;
const bool kIsLongest3x3 = kDilateMethod == kDilateMethod_longest3x3;
const bool kIsLongestCross = kDilateMethod == kDilateMethod_longestCross;
const bool kIsClosestX2 = kDilateMethod == kDilateMethod_closestX2;
const bool kIsClosestAsPrinted = kDilateMethod == kDilateMethod_closest3x3AsPrinted;

/// Whether neighbor k of 3×3 (row-major) is asked.
bool isCandidate(int k) {
  bool isDiagonal = k % 2 == 0 && k != 4;
  if (kIsClosestX) return isDiagonal;
  if (kIsClosestCross || kIsLongestCross) return k % 2 == 1;
  return k != 4;
}

ivec2 neighbor3x3(ivec2 pixel, int k) { return clamped(pixel + ivec2(k % 3 - 1, k / 3 - 1)); }

/// Reversed depth: the largest is the closest. Ties, and sky all around, keep the pixel itself.
ivec2 closestOf(ivec2 pixel, out float closest) {
  ivec2 chosen = pixel;
  closest = texelAt(u_depth, pixel).r;
  for (int k = 0; k < 9; ++k) {
    if (!isCandidate(k)) continue;
    ivec2 neighbor = neighbor3x3(pixel, k);
    float depth = texelAt(u_depth, neighbor).r;
    if (depth > closest) {
      closest = depth;
      chosen = neighbor;
    }
  }
  return chosen;
}

/// Diagonal neighbors two pixels away (4.4).
ivec2 closestOfWide(ivec2 pixel, out float closest) {
  ivec2 chosen = pixel;
  closest = texelAt(u_depth, pixel).r;
  for (int k = 0; k < 4; ++k) {
    ivec2 neighbor = clamped(pixel + ivec2(k % 2 == 0 ? -2 : 2, k / 2 == 0 ? -2 : 2));
    float depth = texelAt(u_depth, neighbor).r;
    if (depth > closest) {
      closest = depth;
      chosen = neighbor;
    }
  }
  return chosen;
}

/// The search starts from pixel (0, 0) at the far plane, and stays there when all is sky (§26, D4).
ivec2 closestAsPrinted(ivec2 pixel, out float closest) {
  ivec2 chosen = ivec2(0);
  closest = 0.0;
  for (int k = 0; k < 9; ++k) {
    ivec2 neighbor = neighbor3x3(pixel, k);
    float depth = texelAt(u_depth, neighbor).r;
    if (depth > closest) {
      closest = depth;
      chosen = neighbor;
    }
  }
  return chosen;
}

float squaredLength(vec2 motion) {
  precise float result = motion.x * motion.x + motion.y * motion.y;
  return result >= 0.0 ? result : 0.0; // NaN is no motion
}

/// The fastest (4.5); ties keep the pixel itself.
ivec2 longestOf(ivec2 pixel) {
  ivec2 chosen = pixel;
  float longest = squaredLength(texelAt(u_motion, pixel).rg);
  for (int k = 0; k < 9; ++k) {
    if (!isCandidate(k)) continue;
    ivec2 neighbor = neighbor3x3(pixel, k);
    float squared = squaredLength(texelAt(u_motion, neighbor).rg);
    if (squared > longest) {
      longest = squared;
      chosen = neighbor;
    }
  }
  return chosen;
}

DilatedMotion dilateMotion(ivec2 pixel) {
  DilatedMotion result;
  ivec2 chosen = pixel;
  if (kIsClosest3x3 || kIsClosestCross || kIsClosestX) {
    chosen = closestOf(pixel, result.depth);
  } else if (kIsClosestX2) {
    chosen = closestOfWide(pixel, result.depth);
  } else if (kIsClosestAsPrinted) {
    chosen = closestAsPrinted(pixel, result.depth);
  } else {
    if (kIsLongest3x3 || kIsLongestCross) chosen = longestOf(pixel);
    result.depth = texelAt(u_depth, chosen).r;
  }
  result.offset = vec2(chosen - pixel);
  result.motion = texelAt(u_motion, chosen).rg;
  expose_dilatedOffset(result.offset);
  expose_dilatedDepth(result.depth);
  expose_dilatedMotion(result.motion);
  return result;
}
