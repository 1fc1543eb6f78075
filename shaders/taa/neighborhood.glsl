// Bounds the colors around the pixel by a box (catalogue §8, §10). In: scene-linear samples and filtered color.
// Out: box space.

struct Box {
  vec3 lo;
  vec3 hi;
};

const bool kIsSquare = kNeighborhoodShape == kNeighborhoodShape_square3x3;

Box boundNeighborhood(Samples samples, vec3 currentFiltered) {
  const float kCount = kIsSquare ? 9.0 : 5.0;
  // Moments about the pixel's own color: those about 0 cancel badly for bright colors (invariant 37).
  precise vec3 center = toBox(samples.color[4]);
  precise vec3 sum = vec3(0.0);
  precise vec3 sumOfSquares = vec3(0.0);
  precise vec3 lowest = center;
  precise vec3 highest = center;
  for (int k = 0; k < 9; ++k) {
    bool isInCross = k == 4 || k % 2 == 1;
    if (!kIsSquare && !isInCross) continue;
    precise vec3 color = toBox(samples.color[k]);
    precise vec3 difference = color - center;
    sum = sum + difference;
    sumOfSquares = sumOfSquares + difference * difference;
    lowest = lesser(color, lowest);
    highest = greater(color, highest);
  }
  precise vec3 mean = center + sum / kCount;
  mean = bounded(mean, lowest, highest);
  precise vec3 first = sum / kCount;
  precise vec3 variance = sumOfSquares / kCount - first * first;
  precise vec3 deviation = sqrt(greater(variance, vec3(0.0)));

  precise vec3 reach = settings.neighborhoodGamma * deviation;
  precise vec3 below = mean - reach;
  precise vec3 above = mean + reach;
  Box box = Box(lowest, highest);
  if (kNeighborhoodBox == kNeighborhoodBox_variance) box = Box(below, above);
  if (kNeighborhoodBox == kNeighborhoodBox_intersection)
    box = Box(greater(lowest, below), lesser(highest, above));
  if (kNeighborhoodIncludeFiltered) {
    precise vec3 filteredColor = toBox(currentFiltered);
    box = Box(lesser(box.lo, filteredColor), greater(box.hi, filteredColor));
  }
  expose_neighborhoodMean(mean);
  expose_neighborhoodDeviation(deviation);
  expose_neighborhoodMin(lowest);
  expose_neighborhoodMax(highest);
  expose_boxMin(box.lo);
  expose_boxMax(box.hi);
  return box;
}
