// This frame's color at the pixel's center, made from the jittered samples around it (catalogue §7). In and out:
// scene-linear.

/// Weight of sample k: computed once a frame from jitter and variance (see currentFilterWeights).
float currentWeight(int k) {
  vec4 lastRows = k < 6 ? resolveBlock.currentWeights1 : resolveBlock.currentWeights2;
  return (k < 3 ? resolveBlock.currentWeights0 : lastRows)[k % 3];
}

vec3 filterCurrent(Samples samples) {
  precise vec3 result = samples.color[4];
  if (kCurrentFilter == kCurrentFilter_gaussian) {
    precise float total = currentWeight(0);
    for (int k = 1; k < 9; ++k) total = total + currentWeight(k);
    // Differences to the center, so that a constant stays exactly constant.
    precise vec3 sum = currentWeight(0) * (samples.color[0] - samples.color[4]);
    for (int k = 1; k < 9; ++k)
      if (k != 4) sum = sum + currentWeight(k) * (samples.color[k] - samples.color[4]);
    result = samples.color[4] + sum / total;
    result = vec3(result.r >= 0.0 ? result.r : 0.0, result.g >= 0.0 ? result.g : 0.0,
                  result.b >= 0.0 ? result.b : 0.0);
  }
  expose_currentFiltered(result);
  return result;
}
