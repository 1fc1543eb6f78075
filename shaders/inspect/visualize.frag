// A part of one intermediate as a picture for the screen. In: the color maps, ViewBlock; from the prelude
// fetch_<name>(texel, layer) of the textures that are read (layer, minus, rejectReason, objectId), kVisual and
// kVisual_<name>, kChannels (of the row), kAlone (the channel shown alone, or -1), kMap (row of the table of color
// maps), kMarksInvalid, kIsAveraged, kIsDifference, kMarksClipped, kTintsRejected, kOutlines, kHasArrows, kIsPartial
// and kIsMinusPartial (the fourth channel says where there is no value), kHasVectors (the row's). Constants, because a
// software rasterizer runs every branch. Out: sRGB, alpha: how much of the screen pixel the picture covers.
// Colors are linear Rec. 709 until the last line; averages are taken of what would be displayed.
#include "shared/ViewBlock.h"
#include "inspect/color_maps.glsl"
#include "inspect/visual_color.glsl"
#include "inspect/overlays.glsl"

layout(location = 0) out vec4 o_color;

// The part of the picture that a screen pixel shows: below 1:1 the area under it, else the texel under its center.
struct Part {
  vec2 from, to; // px; empty outside the picture
  float covered; // share of the screen pixel
};

Part areaBelow(vec2 corner) {
  vec2 from = max(view.originPx + corner / view.range.w, vec2(0.0));
  vec2 to = min(view.originPx + (corner + 1.0) / view.range.w, view.sizePx);
  vec2 size = (to - from) * view.range.w;
  return Part(from, to, size.x * size.y);
}

Part texelBelow(vec2 corner) {
  vec2 texel = floor(view.originPx + (corner + 0.5) / view.range.w);
  bool isInside = all(greaterThanEqual(texel, vec2(0.0))) && all(lessThan(texel, view.sizePx));
  return Part(texel, texel + (isInside ? 1.0 : 0.0), 1.0);
}

// The channels from `first` on; what follows the row's is nothing of it.
vec4 fromChannel(vec4 value, int first) {
  if (first == 1) return value.yzwx;
  if (first == 2) return value.zwxy;
  return first == 3 ? value.wxyz : value;
}

vec4 rowAt(ivec2 texel) {
  vec4 value = fromChannel(fetch_layer(texel, view.layer.x), view.layer.y);
  if (kIsDifference) value -= fromChannel(fetch_minus(texel, view.layer.z), view.layer.w);
  return value;
}

// Whether there is no value, or no difference of what has no previous position.
bool isNothingAt(ivec2 texel) {
  if (kIsPartial && fetch_layer(texel, view.layer.x).w != 0.0) return true;
  if (kIsMinusPartial && fetch_minus(texel, view.layer.z).w != 0.0) return true;
  if (!kIsDifference || !kHasVectors) return false;
  vec2 now = fromChannel(fetch_layer(texel, view.layer.x), view.layer.y).xy;
  vec2 other = fromChannel(fetch_minus(texel, view.layer.z), view.layer.w).xy;
  return any(equal(now, vec2(kNoPrevious))) || any(equal(other, vec2(kNoPrevious)));
}

int rejectReasonAt(ivec2 texel) {
  vec4 value = fetch_rejectReason(texel, view.overlays.x);
  return int(fromChannel(value, view.overlays.y).x);
}

float objectAt(ivec2 texel) {
  return fromChannel(fetch_objectId(texel, view.overlays.z), view.overlays.w).x;
}

vec3 colorAt(ivec2 texel, inout int clipped) {
  if (isNothingAt(texel)) return checkers(gl_FragCoord.xy);
  vec4 value = rowAt(texel);
  vec3 color = displayedColor(value);
  if (kMarksClipped) clipped |= clippedEnds(value);
  if (kTintsRejected) {
    int reason = rejectReasonAt(texel);
    if (reason != 0) color += view.below.w * (categoryColor(reason) - color);
  }
  return color;
}

// The mean over the part, every texel weighted by the area it has there; `clipped`: ends that any of it lies beyond.
vec3 meanColor(Part part, inout int clipped) {
  if (!kIsAveraged) return colorAt(ivec2(part.from), clipped);
  ivec2 first = ivec2(floor(part.from)), last = ivec2(ceil(part.to)) - 1;
  vec3 sum = vec3(0.0);
  for (int y = first.y; y <= last.y; ++y) {
    float height = min(part.to.y, float(y + 1)) - max(part.from.y, float(y));
    for (int x = first.x; x <= last.x; ++x) {
      float width = min(part.to.x, float(x + 1)) - max(part.from.x, float(x));
      sum += colorAt(ivec2(x, y), clipped) * (width * height);
    }
  }
  vec2 size = part.to - part.from;
  return sum / (size.x * size.y);
}

ivec2 texelUnder(vec2 corner) {
  return ivec2(floor(view.originPx + (corner + 0.5) / view.range.w));
}

bool isAnotherObject(ivec2 texel, float object) {
  bool isInside = all(greaterThanEqual(texel, ivec2(0))) && all(lessThan(texel, ivec2(view.sizePx)));
  return isInside && objectAt(texel) != object;
}

// Dashes where the object one unit to the left or above is another one.
vec3 outlined(vec3 color, vec2 corner) {
  float unit = view.above.w;
  ivec2 here = clamp(texelUnder(corner), ivec2(0), ivec2(view.sizePx) - 1);
  float object = objectAt(here);
  bool isEdge = isAnotherObject(texelUnder(corner - vec2(unit, 0.0)), object) ||
                isAnotherObject(texelUnder(corner - vec2(0.0, unit)), object);
  if (!isEdge) return color;
  return mod(floor((corner.x + corner.y) / (4.0 * unit)), 2.0) < 1.0 ? vec3(1.0) : vec3(0.0);
}

// One arrow a cell of whole texels, so that it keeps its place in the picture: that of the texel in the middle.
vec3 pointed(vec3 color, vec2 corner) {
  float zoom = view.range.w;
  float texels = ceil(view.arrows.x * view.above.w / zoom);
  vec2 position = view.originPx + (corner + 0.5) / zoom;
  vec2 middle = (floor(position / texels) + 0.5) * texels;
  if (any(greaterThanEqual(middle, view.sizePx)) || isNothingAt(ivec2(middle))) return color;
  vec2 value = shownChannels(vec3(rowAt(ivec2(middle)).xy, 0.0)).xy;
  return withArrow(color, value, (position - middle) * zoom / view.above.w, texels * zoom / view.above.w);
}

// The number of the reason in each texel that is rejected, where it is large enough.
vec3 withReason(vec3 color, ivec2 texel, vec2 corner) {
  int reason = rejectReasonAt(texel);
  vec2 at = (view.originPx + (corner + 0.5) / view.range.w - vec2(texel)) * view.range.w;
  return reason == 0 ? color : numbered(color, reason, at, view.range.w);
}

void main() {
  vec2 corner = floor(gl_FragCoord.xy);
  Part part = kIsAveraged ? areaBelow(corner) : texelBelow(corner);
  if (!all(lessThan(part.from, part.to))) {
    o_color = vec4(0.0);
    return;
  }
  int clipped = 0;
  vec3 color = meanColor(part, clipped);
  if (kMarksClipped) color = hatched(color, clipped, corner);
  if (kTintsRejected && !kIsAveraged) color = withReason(color, ivec2(part.from), corner);
  if (kOutlines) color = outlined(color, corner);
  if (kHasArrows) color = pointed(color, corner);
  o_color = vec4(encoded(color), part.covered);
}
