// Finds history that rectification should leave alone, because what it shows is lost in most single frames: thin
// features, which are locked (manual 17.3, FSR2), and luma that comes and goes with the jitter (17.4, FSR2).

const bool kHolds = kRectifyLocks || kRectifyInstability;

// FSR2 compares sixth roots of luma: max/min < 1.05 is similar, min/max < 0.9 another shading.
const float kSimilarRatio = 1.340095640625; // 1.05⁶
const float kSameShading = 0.531441;        // 0.9⁶

/// Luma of the nine samples.
struct Lumas {
  float each[9];
  float mean;
};

Lumas lumasOf(Samples samples) {
  Lumas lumas;
  precise float sum = 0.0;
  for (int k = 0; k < 9; ++k) {
    lumas.each[k] = luma(samples.color[k]);
    sum = sum + lumas.each[k];
  }
  precise float mean = sum / 9.0;
  lumas.mean = mean;
  return lumas;
}

/// Whether the pixel is brighter or darker than all neighbors that are not similar, and part of no similar 2×2.
bool isThin(Lumas lumas) {
  float own = lumas.each[4];
  float lowest = 1e30;
  float highest = 0.0;
  bool isSimilar[9];
  isSimilar[4] = true;
  for (int k = 0; k < 9; ++k) {
    if (k == 4) continue;
    float other = lumas.each[k];
    precise float limit = kSimilarRatio * minimum(own, other);
    isSimilar[k] = maximum(own, other) < limit;
    if (isSimilar[k]) continue;
    lowest = minimum(other, lowest);
    highest = maximum(other, highest);
  }
  bool isPartOfBlock = (isSimilar[0] && isSimilar[1] && isSimilar[3]) ||
                       (isSimilar[1] && isSimilar[2] && isSimilar[5]) ||
                       (isSimilar[3] && isSimilar[6] && isSimilar[7]) || (isSimilar[5] && isSimilar[7] && isSimilar[8]);
  return (own > highest || own < lowest) && !isPartOfBlock;
}

/// Makes, ages and kills the pixel's lock, and keeps it. `stored`: life and luma where history is valid. Out: how much
/// of the correction it takes back.
float updateLock(Lumas lumas, vec2 stored, vec2 next) {
  precise float life = stored.x;
  precise float locked = stored.y == 0.0 ? lumas.mean : stored.y;
  precise float least = kSameShading * maximum(locked, lumas.mean);
  bool isChanged = minimum(locked, lumas.mean) < least;
  if (isThin(lumas)) {
    locked = lumas.mean;
    life = life != 0.0 ? 2.0 : 1.0;
  } else if (life <= 1.0) {
    locked = locked + 0.5 * (lumas.mean - locked);
  }
  if (isChanged) life = 0.0;
  precise float alive = 4.0 * saturated(life - 1.0);
  expose_lockLife(life);
  bool isLeaving = !(next.x >= 0.0 && next.x <= resolveBlock.sizePx.x && next.y >= 0.0 &&
                     next.y <= resolveBlock.sizePx.y);
  precise float aged = life - 1.0 / settings.rectifyLockFrames;
  keep_lock(vec2(isLeaving ? 0.0 : maximum(aged, 0.0), locked));
  return saturated(alive);
}

/// L/(1 + L) in whole steps of 255, so that 8 bits keep it exactly.
float lumaStep(float luma) {
  precise float stepped = floor((luma / (1.0 + luma)) * 255.0 + 0.5);
  return stepped;
}

/// `stored`: the last four steps of valid history, latest first. 1: luma was nearer before it was last.
float updateInstability(Lumas lumas, vec4 stored, float deviation) {
  float now = lumaStep(lumas.mean);
  precise vec4 differences = now - stored;
  precise vec4 distances = abs(differences);
  float nearest = distances.x;
  for (int k = 1; k < 4; ++k) {
    bool isAcross = differences[k] * differences.x < 0.0;
    if (!isAcross) nearest = minimum(distances[k], nearest);
  }
  precise float size = saturated(deviation / 0.1);
  precise float squared = size * size;
  precise float gate = (squared * squared) * squared;
  keep_lumas(vec4(now, stored.xyz) / 255.0);
  bool isPeriodic = distances.x >= 1.0 && nearest != distances.x && gate > 1.0 / 255.0;
  return isPeriodic && stored.z != 0.0 ? 1.0 : 0.0; // 0: not known yet
}

/// How much of the correction is taken back, 0 to 1.
float holdHistory(ivec2 pixel, Samples samples, Reprojection reprojection, HistorySample history, Moments moments,
                  Validity validity) {
  float lock = 0.0;
  float instability = 0.0;
  if (kHolds) {
    Lumas lumas = lumasOf(samples);
    bool isValid = hasHistory() && validity.reason == kRejectReason_kept;
    ivec2 texel = ivec2(floor(history.position));
    if (kRectifyLocks) {
      vec2 stored = keeps(kLayer_lock) && isValid ? historyAt(u_historyLock, texel).rg : vec2(0.0);
      precise vec2 center = vec2(pixel) + 0.5;
      precise vec2 next = center + (center - reprojection.position); // if it goes on as it came
      lock = updateLock(lumas, stored, next);
    }
    if (kRectifyInstability) {
      precise vec4 stored = historyAt(u_historyLumas, texel) * 255.0;
      stored = floor(stored + 0.5);
      if (!keeps(kLayer_lumas) || !isValid) stored = vec4(0.0);
      instability = updateInstability(lumas, stored, boxLuma(moments.deviation));
    }
  }
  if (!kRectifyLocks) {
    expose_lockLife(0.0);
  }
  expose_lock(lock);
  expose_instability(instability);
  precise float protection = maximum(lock, instability) * (1.0 - sqrt(samples.mask.x)); // 11.7: not what is reactive
  return protection;
}
