// Decides α, the weight of the current frame, from its terms (catalogue §13): a base, calming factors, a floor, motion
// joined to it, and more where history is invalid. In: what the stages before found. Out: α, 0 to 1.

/// What the terms look at.
struct WeightInputs {
  vec3 current; // scene-linear, filtered
  vec3 history; // scene-linear, rectified
  vec3 rawHistory;
  Box box;
  DilatedMotion dilated;
  float speed;          // px
  float frames;         // N of the rectified history
  float velocityChange; // px
  float divergence;     // 0 to 1
  vec2 mask;            // reactive, responsive
  float confidence;     // κ
};

const bool kUsesLumaDifference = kWeightSource == kWeightSource_lumaDifference ||
                                 kWeightSource == kWeightSource_lumaDifferenceAsPrinted;

/// 1 where current and history have the same luma, squared (13.10).
float lumaLikeness(WeightInputs x) {
  precise float current = luma(x.current);
  precise float history = luma(x.history);
  float largest = greater(greater(current, history), 0.2);
  precise float likeness = 1.0 - abs(current - history) / largest;
  precise float squared = likeness * likeness;
  return squared;
}

/// Weight of the current frame by the size of the box against the pixel's luma (13.14).
float contrastWeight(WeightInputs x) {
  float divisor = greater(boxLuma(toBox(x.current)), 1e-5);
  precise float contrast = abs(boxLuma(x.box.hi) - boxLuma(x.box.lo)) / divisor;
  precise float weight = 1.0 - (0.25 + 0.6 * saturated(contrast));
  return weight;
}

float baseWeight(WeightInputs x) {
  precise float base = settings.weightAlpha;
  if (kWeightSource == kWeightSource_historyLength) base = 1.0 / (x.frames + 1.0);
  if (kWeightSource == kWeightSource_lumaDifference)
    base = settings.weightMost + lumaLikeness(x) * (settings.weightLeast - settings.weightMost);
  if (kWeightSource == kWeightSource_lumaDifferenceAsPrinted) base = lumaLikeness(x); // §26, D1
  if (kWeightSource == kWeightSource_contrast) base = contrastWeight(x);
  if (kWeightSource == kWeightSource_depth) { // 13.8
    base = 0.025 + (settings.weightAlpha - 0.025) * sqrt(x.dilated.depth);
    base = x.dilated.depth == 0.0 ? 1.0 : base;
  }
  return base;
}

/// Least that is left of α: no more than a source gives by itself, but 1/(N+1) is raised to it.
float leastWeight(float base) {
  if (kWeightSource == kWeightSource_historyLength) return settings.weightMinimum;
  return lesser(base, settings.weightMinimum);
}

/// Less where luma differs (13.11).
float lumaFlickerFactor(WeightInputs x) {
  precise float current = luma(x.current);
  precise float history = luma(x.history);
  precise float rest = 1.0 - abs(current - history) / (0.001 + greater(current, history));
  precise float factor = rest * rest;
  return kWeightLumaFlicker && hasHistory() ? factor : 1.0;
}

float boxWidth(Box box) {
  precise float width = boxLuma(box.hi) - boxLuma(box.lo);
  return width > 0.0 ? width : 0.0;
}

/// Less where history, before it is rectified, lies near a wall of the box (13.13, Karis 2014).
float nearClampFactor(WeightInputs x) {
  float history = boxLuma(toBox(x.rawHistory));
  precise float toLow = abs(history - boxLuma(x.box.lo));
  precise float toHigh = abs(history - boxLuma(x.box.hi));
  float toWall = lesser(toLow, toHigh);
  precise float sum = toWall + boxWidth(x.box);
  precise float factor = sum > 0.0 ? toWall / sum : 1.0;
  return kWeightNearClamp && hasHistory() ? factor : 1.0;
}

/// Less where the box is large against history (13.15).
float historyContrastFactor(WeightInputs x) {
  float history = boxLuma(toBox(x.history));
  precise float factor = history > 0.0 ? 1.0 / (1.0 + boxWidth(x.box) / history) : 1.0;
  return kWeightHistoryContrast && hasHistory() ? factor : 1.0;
}

/// Less where the mask says that the box was widened (13.18, Donut).
float relaxFactor(WeightInputs x) {
  precise float factor = 1.0 / (1.0 + 0.5 * greater(x.mask.x, x.mask.y));
  return kNeighborhoodMaskRelax ? factor : 1.0;
}

/// The least that the mask asks for (13.18, 21.4).
float maskWeight(WeightInputs x) {
  precise float responsive = settings.weightMaskAlpha * greater(x.mask.x, x.mask.y);
  if (kWeightMask == kWeightMask_responsive) return responsive;
  if (kWeightMask == kWeightMask_reactive) return x.mask.x;
  return kWeightMask == kWeightMask_exclude && x.mask.y > 0.0 ? 1.0 : 0.0;
}

/// What motion adds (13.4 to 13.6).
float motionWeight(WeightInputs x) {
  precise float share = saturated(x.speed / settings.weightMotionSpeed);
  precise float squared = share * share;
  precise vec2 uv = x.dilated.motion / resolveBlock.sizePx;
  precise float asPrinted = uv.x * uv.x + uv.y * uv.y; // in fractions of the picture: §26, D11
  if (kWeightMotion == kWeightMotion_linear) return share;
  if (kWeightMotion == kWeightMotion_squared) return squared;
  return kWeightMotion == kWeightMotion_squaredAsPrinted ? saturated(asPrinted) : 0.0;
}

/// Least cosine of the motions of 3×3 with the pixel's, scaled down by the faster of the two (12.7, FSR2): 1 where all
/// move alike. `fastest`: the largest squared speed.
float leastAgreement(ivec2 texel, vec2 own, out float fastest) {
  fastest = squaredLength(own);
  precise float least = 1.0;
  for (int k = 0; k < 9; ++k) {
    vec2 other = pictureMotion(texelAt(u_motion, texel + ivec2(k % 3 - 1, k / 3 - 1)).rg);
    if (other.x == kNoPreviousPosition) continue;
    precise float along = (other.x * own.x + other.y * own.y) / greater(squaredLength(other), squaredLength(own));
    if (along < least) least = along;
    fastest = greater(fastest, squaredLength(other));
  }
  return least;
}

/// How far the motion around a render texel parts, 0 to 1; what hardly moves does not.
float motionDivergence(ivec2 texel) {
  if (!kWeightDivergence) return 0.0;
  vec2 own = pictureMotion(texelAt(u_motion, texel).rg);
  float fastest;
  precise float parted = saturated(1.0 - leastAgreement(texel, own, fastest));
  precise float divergence = parted * saturated(sqrt(fastest) / settings.weightDivergenceSpeed);
  return squaredLength(own) > 1e-4 ? divergence : 0.0;
}

/// a ⊔ b = 1 − (1 − a)(1 − b).
float joined(float a, float b) {
  precise float result = 1.0 - (1.0 - a) * (1.0 - b);
  return result;
}

/// Joins what motion adds (13.4 to 13.7, 12.7).
float movedWeight(WeightInputs x, float calmed) {
  float motion = motionWeight(x);
  float velocityChange = kWeightVelocityChange ? saturated(x.velocityChange / settings.weightVelocityChangeSpeed) : 0.0;
  float moved = calmed;
  if (kWeightMotion != kWeightMotion_none) moved = joined(moved, motion);
  if (kWeightVelocityChange) moved = joined(moved, velocityChange);
  if (kWeightDivergence) moved = joined(moved, x.divergence);
  expose_alphaMotion(motion);
  expose_alphaVelocityChange(velocityChange);
  expose_alphaDivergence(x.divergence);
  return moved;
}

float blendWeight(WeightInputs x, float invalid) {
  float base = baseWeight(x);
  float least = leastWeight(base);
  float lumaFlicker = lumaFlickerFactor(x);
  float nearClamp = nearClampFactor(x);
  float historyContrast = historyContrastFactor(x);
  float relax = relaxFactor(x);
  float mask = maskWeight(x);
  precise float calmed = base * lumaFlicker;
  calmed = calmed * nearClamp;
  calmed = calmed * historyContrast;
  calmed = calmed * relax;
  calmed = greater(calmed, least);
  calmed = calmed < 1.0 ? calmed : 1.0;
  precise float moved = movedWeight(x, calmed);
  if (kUpsampled) moved = moved * x.confidence; // §22: 0 keeps history as it is
  float alpha = greater(greater(moved, mask), invalid);
  expose_alphaBase(base);
  expose_alphaFloor(least);
  expose_alphaLumaFlicker(lumaFlicker);
  expose_alphaNearClamp(nearClamp);
  expose_alphaHistoryContrast(historyContrast);
  expose_alphaRelax(relax);
  expose_alphaMask(mask);
  expose_alphaInvalid(invalid);
  expose_alpha(alpha);
  return alpha;
}
