// Chooses where motion is read (manual §4). In: the render texel of the pixel. Out: step to the chosen neighbor in
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
const bool kIsFarthest = kDilateMethod == kDilateMethod_farthest3x3;
/// Searches that start with nothing look at the pixel itself in its turn.
const bool kStartsEmpty = kIsAsPrinted || (kDilateTies == kDilateTies_first && !kIsLongest);

/// Whether neighbor k of 3×3 (row-major) is asked. The pixel itself is where the search starts, or one of them.
bool isCandidate(int k) {
  if (k == 4) return kStartsEmpty;
  if (kIsX) return k % 2 == 0;
  return !kIsCross || k % 2 == 1;
}

/// × may reach two pixels (4.4). May lie outside the picture. Raptor's loop goes column by column.
ivec2 neighborOf(ivec2 pixel, int k) {
  const int kReach = kIsClosestX2 ? 2 : 1;
  return pixel + kReach * (kIsAsPrinted ? ivec2(k / 3 - 1, k % 3 - 1) : ivec2(k % 3 - 1, k / 3 - 1));
}

/// Whether a depth takes the place of the one that was found so far. Reversed: the larger is the closer.
bool isPreferred(float depth, float found) {
  bool isBetter = kIsFarthest ? depth < found : depth > found;
  return isBetter || (kDilateTies == kDilateTies_last && depth == found);
}

/// What the search starts with: as printed the far plane (D4), or nothing, which every depth is preferred to.
float firstDepth(ivec2 pixel) {
  if (kIsAsPrinted) return 0.0;
  if (kStartsEmpty) return kIsFarthest ? 2.0 : -1.0;
  return texelAt(u_depth, pixel).r;
}

/// The closest or the farthest. Ties, and sky all around, keep the pixel itself unless chosen otherwise. As printed the
/// search starts from pixel (0, 0), and stays there when all is sky (manual §26, D4).
ivec2 findClosest(ivec2 pixel, out float closest) {
  ivec2 chosen = kIsAsPrinted ? ivec2(0) : pixel;
  closest = firstDepth(pixel);
  for (int k = 0; k < 9; ++k) {
    if (!isCandidate(k)) continue;
    ivec2 neighbor = neighborOf(pixel, k);
    float depth = texelAt(u_depth, neighbor).r;
    bool isChosen = isPreferred(depth, closest);
    closest = mix(closest, depth, isChosen);
    chosen = mix(chosen, neighbor, bvec2(isChosen));
  }
  return clampedToDrawn(chosen);
}

float squaredLength(vec2 motion) {
  precise float result = motion.x * motion.x + motion.y * motion.y;
  return result >= 0.0 ? result : 0.0; // NaN is no motion
}

/// The fastest (4.5); ties keep the pixel itself.
ivec2 findLongest(ivec2 pixel) {
  ivec2 chosen = pixel;
  float longest = squaredLength(texelAt(u_motion, pixel).rg);
  for (int k = 0; k < 9; ++k) {
    if (!isCandidate(k)) continue;
    ivec2 neighbor = clampedToDrawn(neighborOf(pixel, k));
    float squared = squaredLength(texelAt(u_motion, neighbor).rg);
    if (squared > longest) {
      longest = squared;
      chosen = neighbor;
    }
  }
  return chosen;
}

/// As HDRP prints it: with each diagonal goes the depth of the next one in this order (manual §26, D13). Its step()
/// holds for equal depths, so that from the first that is no farther on each next one is compared with itself, and
/// the last wins.
ivec2 findClosestXAsPrinted(ivec2 pixel, out float depth) {
  const ivec2 kSteps[4] = ivec2[](ivec2(1, 1), ivec2(-1, -1), ivec2(1, -1), ivec2(-1, 1));
  float depths[4];
  for (int k = 0; k < 4; ++k) depths[k] = texelAt(u_depth, clampedToDrawn(pixel + kSteps[k])).r;
  ivec2 chosen = pixel;
  float closest = texelAt(u_depth, pixel).r;
  for (int k = 0; k < 4; ++k) {
    if (depths[k] >= closest) {
      closest = depths[(k + 1) % 4];
      chosen = clampedToDrawn(pixel + kSteps[k]);
    }
  }
  depth = texelAt(u_depth, chosen).r;
  return chosen;
}

DilatedMotion dilateMotion(ivec2 pixel) {
  DilatedMotion result;
  ivec2 chosen = pixel;
  if (kIsLongest) chosen = findLongest(pixel);
  if (kIsLongest || kDilateMethod == kDilateMethod_none) {
    result.depth = texelAt(u_depth, chosen).r;
  } else if (kDilateMethod == kDilateMethod_closestXAsPrinted) {
    chosen = findClosestXAsPrinted(pixel, result.depth);
  } else {
    chosen = findClosest(pixel, result.depth);
  }
  if (kDilateUpLeft) { // Godot's tile has a border that it leaves out here
    chosen = clampedToDrawn(chosen - 1);
    result.depth = texelAt(u_depth, chosen).r;
  }
  result.offset = vec2(chosen - pixel);
  result.motion = pictureMotion(texelAt(u_motion, chosen).rg);
  expose_dilatedOffset(result.offset);
  expose_dilatedDepth(result.depth);
  expose_dilatedMotion(result.motion);
  return result;
}
