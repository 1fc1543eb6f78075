// What a value looks like, by the row's visual (core/taa/Intermediates.h). In: the value as it is stored. Out: linear
// Rec. 709, 0 to 1.
#include "shared/ViewBlock.h"
#include "inspect/color_maps.glsl"

const float kNoPrevious = 65504.0;         // motion of what has no previous position
const float kLogRangeMin = 1.0 / 1024.0; // a logarithmic range that starts at 0 starts at this share of its end
const vec3 kSkyColor = vec3(0.347, 0.474, 0.693); // the depth of what is infinitely far: in no color map
const vec3 kNeutral = vec3(0.373248);      // gray as light as the cyclic map: kCyclicLightness cubed
const float kTurn = 6.283185307;           // radians

bool isNaN(float value) {
  return (floatBitsToUint(value) & 0x7fffffffu) > 0x7f800000u;
}

bool isInfinite(float value) {
  return (floatBitsToUint(value) & 0x7fffffffu) == 0x7f800000u;
}

// Red for NaN, green for infinite, blue for negative colors; alpha 0 when there is nothing to mark.
vec4 mark(vec4 value) {
  bool hasNaN = false, hasInfinite = false, hasNegative = false;
  for (int channel = 0; channel < kChannels; ++channel) {
    hasNaN = hasNaN || isNaN(value[channel]);
    hasInfinite = hasInfinite || isInfinite(value[channel]);
    hasNegative = hasNegative || value[channel] < 0.0;
  }
  if (hasNaN) return vec4(1.0, 0.0, 0.0, 1.0);
  if (hasInfinite) return vec4(0.0, 1.0, 0.0, 1.0);
  if (hasNegative && kVisual == kVisual_Color) return vec4(0.0, 0.0, 1.0, 1.0);
  return vec4(0.0);
}

float ranged(float value) {
  return unit((value - view.range.x) / view.range.y);
}

// The value farthest from 0 in the range: where signed values reach the ends of their map.
float extent() {
  return max(abs(view.range.x), abs(view.range.x + view.range.y));
}

vec3 shownChannels(vec3 color) {
  return vec3(view.channels.x != 0 ? color.r : 0.0, view.channels.y != 0 ? color.g : 0.0,
              view.channels.z != 0 ? color.b : 0.0);
}

float channelAlone(vec3 value) {
  return value[max(kAlone, 0)];
}

// Light: linear, so that gray alone is as light as the channel.
vec3 lightColor(vec3 value) {
  vec3 exposed = value * view.range.z;
  vec3 color = vec3(ranged(exposed.r), ranged(exposed.g), ranged(exposed.b));
  if (kAlone < 0) return shownChannels(color);
  float alone = channelAlone(color);
  return kMap == kGray ? vec3(alone) : mapColor(kMap, alone);
}

vec3 depthColor(float value) {
  if (value == 0.0) return kSkyColor;
  float high = view.range.x + view.range.y;
  float low = max(view.range.x, high * kLogRangeMin);
  return mapColor(kMap, log2(value / low) / log2(high / low));
}

// 0 is always in the middle of the map.
vec3 signedColor(float value) {
  return mapColor(kMap, 0.5 + 0.5 * value / extent());
}

// Direction as hue, length as saturation; black where there is no previous position.
vec3 vectorColor(vec2 value) {
  if (value.x == kNoPrevious || value.y == kNoPrevious) return vec3(0.0);
  if (kAlone >= 0) return signedColor(channelAlone(vec3(value, 0.0)));
  vec2 shown = shownChannels(vec3(value, 0.0)).xy;
  float saturation = unit(length(shown) / extent());
  if (saturation == 0.0) return kNeutral;
  return kNeutral + saturation * (mapColor(kCyclic, atan(shown.y, shown.x) / kTurn) - kNeutral);
}

// Shares of the range as they are: half way is byte 128 on the screen.
vec3 shareColor(vec3 share) {
  vec3 shares = vec3(unit(share.x), unit(share.y), unit(share.z));
  return kAlone >= 0 ? mapColor(kMap, channelAlone(shares)) : decoded(shownChannels(shares));
}

vec3 indexColor(float value) {
  return kMap == kCategorical ? categoryColor(int(value)) : mapColor(kMap, ranged(value));
}

// The shown channel that differs most, with its sign.
float mostDifferent(vec4 value) {
  if (kChannels == 1) return value.x;
  float most = 0.0;
  for (int channel = 0; channel < min(kChannels, 3); ++channel)
    if (view.channels[channel] != 0 && !(abs(value[channel]) <= abs(most))) most = value[channel];
  return most;
}

vec3 displayedColor(vec4 value) {
  if (kMarksInvalid) {
    vec4 marked = mark(value);
    if (marked.a > 0.0) return marked.rgb;
  }
  if (kIsDifference) return signedColor(mostDifferent(value));
  if (kVisual == kVisual_Color || kVisual == kVisual_Box) return lightColor(value.rgb);
  if (kVisual == kVisual_Depth) return depthColor(value.x);
  if (kVisual == kVisual_Signed) return signedColor(value.x);
  if (kVisual == kVisual_Vector) return vectorColor(value.xy);
  if (kVisual == kVisual_Position) return shareColor(vec3(value.xy / view.sizePx, 0.0));
  if (kVisual == kVisual_Normal) return shareColor((value.xyz - view.range.x) / view.range.y);
  if (kVisual == kVisual_Index) return indexColor(value.x);
  return mapColor(kMap, ranged(value.x)); // Scalar, Mask
}
