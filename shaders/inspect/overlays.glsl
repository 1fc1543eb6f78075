// What is laid over a picture: hatches over clipped values, arrows, numbers of reasons. In: values as they are stored, positions in screen
// px. All lengths are units of view.above.w screen px.
#include "inspect/visual_color.glsl"

const int kAbove = 1; // bits of clippedEnds()
const int kBelow = 2;
const float kHatchPeriod = 6.0; // units
const float kHatchWidth = 2.0;

int ends(float value, float low, float high) {
  return (value > high ? kAbove : 0) | (value < low ? kBelow : 0);
}

int signedEnds(float value) {
  return ends(value, -extent(), extent());
}

// At which ends of the range a shown channel lies beyond it.
int clippedEnds(vec4 value) {
  float low = view.range.x, high = view.range.x + view.range.y;
  if (kIsDifference) return signedEnds(mostDifferent(value));
  if (kVisual == kVisual_Signed) return signedEnds(value.x);
  if (kVisual == kVisual_Depth) return value.x == 0.0 ? 0 : ends(value.x, low, high);
  if (kVisual == kVisual_Scalar) return ends(value.x, low, high);
  if (kVisual == kVisual_Vector) {
    if (value.x == kNoPrevious || value.y == kNoPrevious) return 0;
    if (kAlone >= 0) return signedEnds(channelAlone(vec3(value.xy, 0.0)));
    return length(shownChannels(vec3(value.xy, 0.0)).xy) > extent() ? kAbove : 0;
  }
  if (kVisual != kVisual_Color && kVisual != kVisual_Box) return 0; // without a range
  int found = 0;
  for (int channel = 0; channel < 3; ++channel)
    if (view.channels[channel] != 0) found |= ends(value[channel] * view.range.z, low, high);
  return found;
}

// Where there is no value.
vec3 checkers(vec2 corner) {
  vec2 cell = floor(corner / (view.nothing.z * view.above.w));
  return vec3(mod(cell.x + cell.y, 2.0) < 1.0 ? view.nothing.x : view.nothing.y);
}

// Rising lines over what is above the range, falling ones over what is below it.
vec3 hatched(vec3 color, int clipped, vec2 corner) {
  vec2 at = floor(corner / view.above.w);
  bool rises = mod(at.x + at.y, kHatchPeriod) < kHatchWidth;
  bool falls = mod(at.x - at.y, kHatchPeriod) < kHatchWidth;
  if ((clipped & kAbove) != 0 && rises) return view.above.rgb;
  if ((clipped & kBelow) != 0 && falls) return view.below.rgb;
  return color;
}

// How far `at` (units from the arrow's middle) lies outside an arrow of half length `reach` along `along`: 0 inside.
float outsideArrow(vec2 at, vec2 along, float reach) {
  const float kHalfShaft = 0.75, kHead = 6.0;
  float forward = dot(at, along), aside = abs(at.x * along.y - at.y * along.x);
  float head = min(kHead, reach);
  float shaft = max(max(-reach - forward, forward - (reach - head)), aside - kHalfShaft);
  float tip = max(max(reach - head - forward, forward - reach), aside - 0.5 * (reach - forward));
  return max(min(shaft, tip), 0.0);
}

// The arrow of a vector over a color: white with a dark edge; a dot where there is nearly no length.
vec3 withArrow(vec3 color, vec2 value, vec2 at, float cell) {
  const float kDot = 1.0, kEdge = 1.0;
  if (value.x == kNoPrevious || value.y == kNoPrevious || isNaN(value.x + value.y)) return color;
  float size = length(value); // infinite ones have no direction to show
  if (isInfinite(size)) return color;
  float reach = view.arrows.z * min(cell, view.arrows.y) * min(size / extent(), 1.0);
  float outside = reach < view.arrows.w ? max(length(at) - kDot, 0.0) : outsideArrow(at, value / size, reach);
  if (outside == 0.0) return vec3(1.0);
  return outside <= kEdge ? vec3(0.0) : color;
}

// The digits 0 to 9: five rows of three bits, the upper left one the highest.
const int kDigits[10] = int[](0x7B6F, 0x2C97, 0x73E7, 0x73CF, 0x5BC9, 0x79CF, 0x79EF, 0x7249, 0x7BEF, 0x7BCF);
const float kMinNumbered = 12.0; // units a texel has at least to hold a digit

// A digit on a dark plate in the upper left corner of a texel that is `zoom` screen px wide; `at`: px from its corner.
vec3 numbered(vec3 color, int digit, vec2 at, float zoom) {
  float unit = view.above.w;
  if (zoom < kMinNumbered * unit) return color;
  float size = zoom < 24.0 * unit ? unit : 2.0 * unit;
  ivec2 cell = ivec2(floor(at / size)) - 2;
  if (any(lessThan(cell, ivec2(-1))) || cell.x > 3 || cell.y > 5) return color;
  bool isInside = all(greaterThanEqual(cell, ivec2(0))) && cell.x < 3 && cell.y < 5;
  bool isSet = isInside && ((kDigits[clamp(digit, 0, 9)] >> (14 - 3 * cell.y - cell.x)) & 1) != 0;
  return isSet ? vec3(1.0) : vec3(0.0);
}
