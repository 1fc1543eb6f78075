// Decides α, the weight of the current frame: the largest of its terms (catalogue §13). In: history length N at
// the place history was read, reject reason. Out: α, 0 to 1.

float blendWeight(float historyFrames, int rejectReason) {
  precise float base = settings.weightAlpha;
  precise float least = 0.0;
  if (kWeightSource == kWeightSource_historyLength) {
    base = 1.0 / (historyFrames + 1.0);
    least = settings.weightMinimum;
  }
  precise float invalid = rejectReason != kRejectReason_kept ? 1.0 : 0.0;
  precise float alpha = greater(greater(base, least), invalid);
  expose_alphaBase(base);
  expose_alphaFloor(least);
  expose_alphaInvalid(invalid);
  expose_alpha(alpha);
  return alpha;
}
