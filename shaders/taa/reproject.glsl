// Where the pixel was in the previous frame (catalogue §5). In: the pixel, its motion in px. Out: position in px
// of the previous picture, whether there is one, and whether it lies inside.

/// Motion that says there is no previous position: the largest half float.
const float kNoPreviousPosition = 65504.0;

struct Reprojection {
  vec2 position; // px
  bool hasPrevious;
  float onScreen; // 1 or 0
};

Reprojection reproject(ivec2 pixel, vec2 motion) {
  precise vec2 position = (vec2(pixel) + 0.5) - motion;
  Reprojection result;
  result.position = position;
  result.hasPrevious = motion.x != kNoPreviousPosition;
  // Written so that NaN is off the screen (5.1).
  bool isOnScreen = position.x >= 0.0 && position.x <= resolveBlock.sizePx.x && position.y >= 0.0 &&
                    position.y <= resolveBlock.sizePx.y;
  result.onScreen = isOnScreen ? 1.0 : 0.0;
  expose_historyPosition(result.position);
  expose_onScreen(result.onScreen);
  return result;
}
