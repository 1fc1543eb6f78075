// Where the pixel was in the previous frame (manual §5), or the pixel itself where history is read in place. In: the
// pixel, its motion in px. Out: position in px of the previous picture, whether there is one, whether it lies inside,
// and the speed.

struct Reprojection {
  vec2 position; // px
  bool hasPrevious;
  float onScreen; // 1 or 0
  bool isOutside; // by the rule of validate.offScreen
  float speed;    // px a frame
};

/// Length of a motion; NaN counts as the fastest.
float speedOf(vec2 motion) {
  precise float speed = sqrt(motion.x * motion.x + motion.y * motion.y);
  precise float known = mix(kNoPreviousPosition, speed, speed <= kNoPreviousPosition);
  return known;
}

/// Speed in px of a picture of 1080 lines.
float speedOfLines(float speed) {
  precise float result = speed * (1080.0 / resolveBlock.sizePx.y);
  return result;
}

/// Speed in 1080ths of the picture, across and down.
float speedOfPicture(vec2 motion) {
  precise vec2 share = motion / resolveBlock.sizePx;
  precise float result = 1080.0 * speedOf(share);
  return result;
}

/// Whether the history position lies outside for the chosen rule. Written so that NaN does.
bool isOutside(vec2 position) {
  float margin = kValidateOffScreen == kValidateOffScreen_margin ? 0.5 : 0.0; // what a filter reads beyond (5.3)
  precise vec2 last = resolveBlock.sizePx - margin;
  bool isWithin = position.x >= margin && position.x <= last.x && position.y >= margin && position.y <= last.y;
  if (kValidateOffScreen == kValidateOffScreen_keep) return false;
  if (kValidateOffScreen == kValidateOffScreen_oneSided) return !(position.x > 0.0); // manual §26, D9
  return !isWithin;
}

Reprojection reproject(ivec2 pixel, vec2 motion) {
  const bool kIsInPlace = kReprojectMethod == kReprojectMethod_inPlace;
  precise vec2 center = vec2(pixel) + 0.5;
  precise vec2 position = center - motion;
  if (kFaultHistoryJitter) position = position + lastJitter() / resolveBlock.renderRatio; // as if it were jittered
  if (kIsInPlace) position = center;
  Reprojection result;
  result.position = position;
  result.hasPrevious = kIsInPlace || motion.x != kNoPreviousPosition;
  // Written so that NaN is off the screen (5.1).
  bool isOnScreen = position.x >= 0.0 && position.x <= resolveBlock.sizePx.x && position.y >= 0.0 &&
                    position.y <= resolveBlock.sizePx.y;
  result.onScreen = isOnScreen ? 1.0 : 0.0;
  result.isOutside = isOutside(position);
  result.speed = speedOf(motion);
  expose_historyPosition(result.position);
  expose_onScreen(result.onScreen);
  expose_speed(result.speed);
  return result;
}
