// Chooses where motion is read (catalogue §4). In: the pixel. Out: step to the chosen neighbor in px, its device
// depth, its motion in px.

struct DilatedMotion {
  vec2 offset;
  float depth;
  vec2 motion;
};

DilatedMotion dilateMotion(ivec2 pixel) {
  ivec2 chosen = pixel;
  float closest = texelAt(u_depth, pixel).r;
  if (kDilateMethod == kDilateMethod_closest3x3) {
    // Reversed depth: the largest is the closest. Ties, and sky all around, keep the pixel itself.
    for (int k = 0; k < 9; ++k) {
      if (k == 4) continue;
      ivec2 neighbor = clamped(pixel + ivec2(k % 3 - 1, k / 3 - 1));
      float depth = texelAt(u_depth, neighbor).r;
      if (depth > closest) {
        closest = depth;
        chosen = neighbor;
      }
    }
  }
  DilatedMotion result;
  result.offset = vec2(chosen - pixel);
  result.depth = closest;
  result.motion = texelAt(u_motion, chosen).rg;
  expose_dilatedOffset(result.offset);
  expose_dilatedDepth(result.depth);
  expose_dilatedMotion(result.motion);
  return result;
}
