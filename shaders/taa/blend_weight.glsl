// Decides α, the weight of the current frame, from its terms (manual §13): a base, damping factors, a floor, motion
// added to it, the time a frame takes, and more where history is invalid. In: what the stages before found. Out: α, 0
// to 1, and that of each channel.

/// What the terms look at.
struct WeightInputs {
  vec3 current; // scene-linear, filtered
  vec3 history; // scene-linear, rectified
  vec3 rawHistory;
  Box box;
  DilatedMotion dilated;
  float speed;          // px
  float historyLength;         // N of the rectified history
  float velocityChange; // px
  float divergence;     // 0 to 1
  vec2 mask;            // reactive, responsive
  float confidence;     // κ
  bool isFrozen;        // nothing of the current frame is taken
  bool isFlicker;       // its depth differs, and it is the same
};

struct Weights {
  float alpha;
  vec3 channels; // α of red, green and blue
};

const bool kHasChannelWeights = kWeightSource == kWeightSource_contrastPerChannel;

/// 1 where current and history have the same luma, squared (13.10); source 001 takes that of colors compressed by their
/// largest channel (13.12).
float lumaLikeness(WeightInputs x) {
  const bool kIsCompressed = kWeightSource != kWeightSource_lumaDifference;
  precise float current = weightLuma(kIsCompressed ? compressMax(x.current) : x.current);
  precise float history = weightLuma(kIsCompressed ? compressMax(x.history) : x.history);
  float largest = maximum(maximum(current, history), 0.2);
  precise float likeness = 1.0 - abs(current - history) / largest;
  precise float squared = likeness * likeness;
  return squared;
}

/// Weight of the current frame by the size of the box against the pixel's luma (13.14).
float contrastWeight(WeightInputs x) {
  float divisor = maximum(boxLuma(toBox(x.current)), 1e-5);
  precise float contrast = abs(boxLuma(x.box.hi) - boxLuma(x.box.lo)) / divisor;
  precise float weight = 1.0 - (0.25 + 0.6 * saturated(contrast));
  return weight;
}

/// The same of one channel, by the nine scene-linear samples (13.14, 14.2).
vec3 channelWeights(Samples samples, vec3 current) {
  vec3 lowest = samples.color[0];
  vec3 highest = samples.color[0];
  for (int k = 1; k < 9; ++k) {
    lowest = minimum(lowest, samples.color[k]);
    highest = maximum(highest, samples.color[k]);
  }
  precise vec3 contrast = (highest - lowest) / maximum(current, vec3(1e-5));
  precise vec3 weight = 1.0 - (0.25 + 0.6 * vec3(saturated(contrast.r), saturated(contrast.g), saturated(contrast.b)));
  return weight;
}

/// Bevy's confidence (manual §16): 10 more in each frame without motion, else 1.
float confidenceAfter(float before, vec2 motion) {
  precise vec2 distances = abs(motion);
  bool isKnown = distances.x <= kNoPreviousPosition && distances.y <= kNoPreviousPosition; // NaN moves
  precise float farther = isKnown ? maximum(distances.x, distances.y) : kNoPreviousPosition;
  bool isStill = farther < 0.01;
  precise float grown = before + 10.0;
  return isStill ? grown : 1.0;
}

float confidenceWeight(WeightInputs x) {
  precise float weight = 1.0 / confidenceAfter(x.historyLength, x.dilated.motion);
  return minimum(maximum(weight, settings.weightSourceMin), settings.weightSourceMax);
}

float baseWeight(WeightInputs x) {
  precise float base = settings.weightAlpha;
  if (kWeightSource == kWeightSource_historyLength) base = 1.0 / (x.historyLength + 1.0);
  if (kWeightSource == kWeightSource_lumaDifference || kWeightSource == kWeightSource_lumaDifferenceCompressed)
    base = settings.weightSourceMax + lumaLikeness(x) * (settings.weightSourceMin - settings.weightSourceMax);
  if (kWeightSource == kWeightSource_lumaDifferenceAsPrinted) base = lumaLikeness(x); // manual §26, D1
  if (kWeightSource == kWeightSource_contrast || kHasChannelWeights) base = contrastWeight(x);
  if (kWeightSource == kWeightSource_confidence) base = confidenceWeight(x);
  if (kWeightSource == kWeightSource_depth) { // 13.8
    base = 0.025 + (settings.weightAlpha - 0.025) * sqrt(x.dilated.depth);
    base = x.dilated.depth == 0.0 ? 1.0 : base;
  }
  return base;
}

/// Least that is left of α: no more than a source gives by itself, but 1/(N+1) is raised to it.
float minWeight(float base) {
  if (kWeightSource == kWeightSource_historyLength) return settings.weightMinimum;
  return minimum(base, settings.weightMinimum);
}

/// Luma of a compressed color with Godot's weights, those of Rec. 601, and its floor.
float godotLuma(vec3 color) {
  precise vec3 c = reinhardChannel(color);
  precise float result = (0.299 * c.r + 0.587 * c.g) + 0.114 * c.b;
  return maximum(result, 0.0001);
}

/// Less where luma differs (13.11), of compressed colors with Godot's divisor.
float lumaFlickerFactor(WeightInputs x) {
  if (!kWeightLumaFlicker) return 1.0;
  const bool kIsCompressed = kWeightFlickerScale == kWeightFlickerScale_compressed;
  precise float current = kIsCompressed ? godotLuma(x.current) : weightLuma(x.current);
  precise float history = kIsCompressed ? godotLuma(x.history) : weightLuma(x.history);
  float largest = maximum(current, history);
  precise float divisor = 0.001 + largest;
  if (kIsCompressed) divisor = maximum(largest, 1.001);
  precise float rest = 1.0 - abs(current - history) / divisor;
  precise float factor = rest * rest;
  return hasHistory() ? factor : 1.0;
}

float boxWidth(Box box) {
  precise float width = boxLuma(box.hi) - boxLuma(box.lo);
  return width > 0.0 ? width : 0.0;
}

/// Less where history, before it is rectified, lies near a wall of the box (13.13, Karis 2014).
float nearClampFactor(WeightInputs x) {
  if (!kWeightNearClamp) return 1.0;
  float history = boxLuma(toBox(x.rawHistory));
  precise float toLow = abs(history - boxLuma(x.box.lo));
  precise float toHigh = abs(history - boxLuma(x.box.hi));
  float toWall = minimum(toLow, toHigh);
  precise float sum = toWall + boxWidth(x.box);
  precise float factor = sum > 0.0 ? toWall / sum : 1.0;
  return hasHistory() ? factor : 1.0;
}

/// Less where the box is large against history (13.15).
float historyContrastFactor(WeightInputs x) {
  if (!kWeightHistoryContrast) return 1.0;
  float history = boxLuma(toBox(x.history));
  precise float factor = history > 0.0 ? 1.0 / (1.0 + boxWidth(x.box) / history) : 1.0;
  return hasHistory() ? factor : 1.0;
}

/// Less where the mask says that the box was widened (13.18, Donut).
float relaxFactor(WeightInputs x) {
  if (!kNeighborhoodMaskRelax) return 1.0;
  precise float factor = 1.0 / (1.0 + 0.5 * maximum(x.mask.x, x.mask.y));
  return factor;
}

/// The least that the mask asks for (13.18, 21.4).
float maskWeight(WeightInputs x) {
  if (kWeightMask == kWeightMask_off) return 0.0;
  precise float responsive = settings.weightMaskAlpha * maximum(x.mask.x, x.mask.y);
  if (kWeightMask == kWeightMask_responsive) return responsive;
  if (kWeightMask == kWeightMask_reactive) return x.mask.x;
  return kWeightMask == kWeightMask_exclude && x.mask.y > 0.0 ? 1.0 : 0.0;
}

/// Less the farther the sample lies from the pixel's center (7.7): always, only in motion, or, as Donut's (13.6), only
/// at rest.
float sampleDistanceFactor(WeightInputs x) {
  if (kWeightSampleDistance == kWeightSampleDistance_none) return 1.0;
  float factor = distanceFactor();
  float t = saturated(x.speed);
  precise float moving = (t * t) * (3.0 - 2.0 * t);
  if (kWeightSampleDistance == kWeightSampleDistance_parabola) factor = maximum(moving, factor);
  precise float inMotion = 1.0 + moving * (factor - 1.0);
  return kWeightSampleDistance == kWeightSampleDistance_gaussianMoving ? inMotion : factor;
}

/// Less where a single frame may miss what is there (13.9).
float flickerFactor(WeightInputs x) { return kFindsFlicker && x.isFlicker ? settings.weightFlickerShare : 1.0; }

/// What motion adds to α (13.4 to 13.6).
float motionWeight(WeightInputs x, float alpha) {
  if (kWeightMotion == kWeightMotion_none) return 0.0;
  float speed = x.speed;
  if (kWeightMotionSpeedIn == kWeightMotionSpeedIn_lines1080) speed = speedOfLines(x.speed);
  if (kWeightMotionSpeedIn == kWeightMotionSpeedIn_picture1080) speed = speedOfPicture(x.dilated.motion);
  precise float share = saturated(speed / settings.weightMotionSpeed);
  precise float squared = share * share;
  precise vec2 uv = x.dilated.motion / resolveBlock.sizePx;
  precise float asPrinted = uv.x * uv.x + uv.y * uv.y; // in fractions of the picture: manual §26, D11
  if (kWeightMotion == kWeightMotion_linear || kWeightMotion == kWeightMotion_added) return share;
  if (kWeightMotion == kWeightMotion_squared) return squared;
  precise float twice = 2.0 * alpha;
  precise float added = share * (minimum(twice, 1.0) - alpha);
  if (kWeightMotion == kWeightMotion_doubled) return added;
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
    precise float along = (other.x * own.x + other.y * own.y) / maximum(squaredLength(other), squaredLength(own));
    if (along < least) least = along;
    fastest = maximum(fastest, squaredLength(other));
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

/// 1 − (1 − a)(1 − b), as the blend mode "screen" mixes.
float screen(float a, float b) {
  precise float result = 1.0 - (1.0 - a) * (1.0 - b);
  return result;
}

/// α for the time this frame took: 1 − (1 − α)^(Δt/Δt₀), the exponent in eighths (13.19). Whole powers and square roots
/// are exact, pow is not.
float byFrameRate(float alpha) {
  if (!kWeightFrameRate) return alpha;
  int eighths = eighthsOfFrame();
  precise float kept = 1.0 - alpha;
  precise float power = 1.0;
  for (int whole = 0; whole < eighths / 8; ++whole) power = power * kept;
  precise float root = kept;
  for (int bit = 4; bit > 0; bit /= 2) {
    root = sqrt(root);
    if ((eighths & bit) != 0) power = power * root;
  }
  precise float result = 1.0 - power;
  return eighths == 8 ? alpha : result;
}

struct Damping { // factors
  float lumaFlicker, nearClamp, historyContrast, relax, sampleDistance, flicker;
};

struct Composed {
  float least;
  float motion;         // added by it
  float velocityChange; // added by its change
  float alpha;  // for the time of the frame
};

/// α with what motion adds to it.
float movedWeight(float alpha, float motion) {
  precise float added = alpha + motion;
  precise float below = maximum(alpha - 0.025, 0.0); // lerp(α − 0.025, 1, ‖v‖²)
  if (kWeightMotion == kWeightMotion_none) return alpha;
  if (kWeightMotion == kWeightMotion_squaredAsPrinted) return screen(below, motion);
  if (kWeightMotion == kWeightMotion_doubled) return added;
  return kWeightMotion == kWeightMotion_added ? minimum(added, 1.0) : screen(alpha, motion);
}

Composed compose(WeightInputs x, float base, Damping damping) {
  Composed result;
  result.least = minWeight(base);
  precise float damped = base * damping.lumaFlicker;
  damped = damped * damping.nearClamp;
  damped = damped * damping.historyContrast;
  damped = damped * damping.relax;
  damped = damped * damping.sampleDistance;
  damped = maximum(damped, result.least);
  damped = minimum(damped, 1.0);
  if (kFindsFlicker) damped = damped * damping.flicker;
  result.motion = motionWeight(x, damped);
  result.velocityChange = kWeightVelocityChange ? saturated(x.velocityChange / settings.weightVelocityChangeSpeed) : 0.0;
  precise float moved = movedWeight(damped, result.motion);
  if (kWeightVelocityChange) moved = screen(moved, result.velocityChange);
  if (kWeightDivergence) moved = screen(moved, x.divergence);
  result.alpha = byFrameRate(moved);
  return result;
}

/// α of what was composed: by κ (manual §22, 0 keeps history as it is), and no less than mask and invalid history ask
/// for, or more by as much as is rejected where N decays as well;
/// without TAA only the current frame counts.
float wholeWeight(WeightInputs x, Composed terms, float mask, float invalid) {
  if (!kTaaEnabled) return 1.0;
  precise float alpha = kUpsampled ? terms.alpha * x.confidence : terms.alpha;
  precise float raised = maximum(alpha, mask) + invalid;
  if (x.isFrozen) return 0.0;
  return kDecays ? minimum(raised, 1.0) : maximum(maximum(alpha, mask), invalid);
}

Weights blendWeight(WeightInputs x, Samples samples, float invalid) {
  float base = baseWeight(x);
  Damping damping = Damping(lumaFlickerFactor(x), nearClampFactor(x), historyContrastFactor(x),
                            relaxFactor(x), sampleDistanceFactor(x), flickerFactor(x));
  Composed terms = compose(x, base, damping);
  float mask = maskWeight(x);
  float alpha = wholeWeight(x, terms, mask, invalid);
  Weights result = Weights(alpha, vec3(alpha));
  if (kHasChannelWeights) {
    vec3 bases = channelWeights(samples, x.current);
    for (int channel = 0; channel < 3; ++channel)
      result.channels[channel] = wholeWeight(x, compose(x, bases[channel], damping), mask, invalid);
  }
  expose_alphaBase(base);
  expose_alphaFloor(terms.least);
  expose_alphaLumaFlicker(damping.lumaFlicker);
  expose_alphaNearClamp(damping.nearClamp);
  expose_alphaHistoryContrast(damping.historyContrast);
  expose_alphaRelax(damping.relax);
  expose_alphaSampleDistance(damping.sampleDistance);
  expose_alphaFlicker(damping.flicker);
  expose_alphaMotion(terms.motion);
  expose_alphaVelocityChange(terms.velocityChange);
  expose_alphaDivergence(x.divergence);
  expose_alphaFrameRate(terms.alpha);
  expose_alphaMask(mask);
  expose_alphaInvalid(invalid);
  expose_alpha(alpha);
  expose_alphaChannels(result.channels);
  return result;
}
