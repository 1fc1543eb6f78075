// Chooses where motion is read (catalogue §4). In: the render texel of the pixel. Out: step to the chosen neighbor in
// render px, its device depth, its motion in px of the picture.

struct DilatedMotion {
  vec2 offset;
  float depth;
  vec2 motion;
};

const bool kIsLongest = kDilateMethod == kDilateMethod_longest3x3 || kDilateMethod == kDilateMethod_longestCross;
const bool kIsClosestX2 = kDilateMethod == kDilateMethod_closestX2;
const bool kIsAsPrinted = kDilateMethod == kDilateMethod_closest3x3AsPrinted;
const bool kIsCross = kDilateMethod == kDilateMethod_closestCross || kDilateMethod == kDilateMethod_longestCross;
const bool kIsX = kDilateMethod == kDilateMethod_closestX || kIsClosestX2;

/// Whether neighbor k of 3×3 (row-major) is asked. The pixel itself is where the search starts.
bool isCandidate(int k) {
  if (kIsX) return k % 2 == 0 && k != 4;
  if (kIsCross) return k % 2 == 1;
  return k != 4 || kIsAsPrinted;
}

/// × may reach two pixels (4.4). May lie outside the picture.
ivec2 neighborOf(ivec2 pixel, int k) {
  const int kReach = kIsClosestX2 ? 2 : 1;
  return pixel + kReach * ivec2(k % 3 - 1, k / 3 - 1);
}

/// Reversed depth: the largest is the closest. Ties, and sky all around, keep the pixel itself. As printed the
/// search starts from pixel (0, 0) at the far plane, and stays there when all is sky (§26, D4).
ivec2 closestOf(ivec2 pixel, out float closest) {
  ivec2 chosen = kIsAsPrinted ? ivec2(0) : pixel;
  closest = kIsAsPrinted ? 0.0 : texelAt(u_depth, pixel).r;
  for (int k = 0; k < 9; ++k) {
    if (!isCandidate(k)) continue;
    ivec2 neighbor = neighborOf(pixel, k);
    float depth = texelAt(u_depth, neighbor).r;
    bool isCloser = depth > closest;
    closest = mix(closest, depth, isCloser);
    chosen = mix(chosen, neighbor, bvec2(isCloser));
  }
  return clamped(chosen);
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
    ivec2 neighbor = clamped(neighborOf(pixel, k));
    float squared = squaredLength(texelAt(u_motion, neighbor).rg);
    if (squared > longest) {
      longest = squared;
      chosen = neighbor;
    }
  }
  return chosen;
}

/// As HDRP prints it: with each diagonal goes the depth of the next one in this order (§26, D13).
ivec2 closestXAsPrinted(ivec2 pixel, out float depth) {
  const ivec2 kSteps[4] = ivec2[](ivec2(1, 1), ivec2(-1, -1), ivec2(1, -1), ivec2(-1, 1));
  float depths[4];
  for (int k = 0; k < 4; ++k) depths[k] = texelAt(u_depth, clamped(pixel + kSteps[k])).r;
  ivec2 chosen = pixel;
  float closest = texelAt(u_depth, pixel).r;
  for (int k = 0; k < 4; ++k) {
    if (depths[k] > closest) {
      closest = depths[(k + 1) % 4];
      chosen = clamped(pixel + kSteps[k]);
    }
  }
  depth = texelAt(u_depth, chosen).r;
  return chosen;
}

DilatedMotion dilateMotion(ivec2 pixel) {
  DilatedMotion result;
  ivec2 chosen = pixel;
  if (kIsLongest) chosen = longestOf(pixel);
  if (kIsLongest || kDilateMethod == kDilateMethod_none) {
    result.depth = texelAt(u_depth, chosen).r;
  } else if (kDilateMethod == kDilateMethod_closestXAsPrinted) {
    chosen = closestXAsPrinted(pixel, result.depth);
  } else {
    chosen = closestOf(pixel, result.depth);
  }
  result.offset = vec2(chosen - pixel);
  result.motion = pictureMotion(texelAt(u_motion, chosen).rg);
  expose_dilatedOffset(result.offset);
  expose_dilatedDepth(result.depth);
  expose_dilatedMotion(result.motion);
  return result;
}
