// A part of one intermediate as a picture for the screen. In: the layer, the color maps, ViewBlock; from the
// prelude kVisual and kVisual_<name>, kChannels (of the row), kAlone (the channel shown alone, or -1), kMap (row of the
// table of color maps), kMarksInvalid, kIsMinified. Constants, because a software rasterizer runs every branch. Out: sRGB, alpha: how much of the screen pixel the picture covers.
// Colors are linear Rec. 709 until the last line; averages are taken of what would be displayed.
#include "shared/ViewBlock.h"
#include "inspect/color_maps.glsl"
#include "inspect/visual_color.glsl"

layout(binding = 0) uniform sampler2DArray u_layer;

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

// The row's channels of a texel; what follows them is nothing of it.
vec4 rowAt(ivec2 texel) {
  vec4 value = texelFetch(u_layer, ivec3(texel, view.layer.x), 0);
  if (view.layer.y == 1) return value.yzwx;
  if (view.layer.y == 2) return value.zwxy;
  return view.layer.y == 3 ? value.wxyz : value;
}

// The mean over the part, every texel weighted by the area it has there.
vec3 meanColor(Part part) {
  if (!kIsMinified) return displayedColor(rowAt(ivec2(part.from)));
  ivec2 first = ivec2(floor(part.from)), last = ivec2(ceil(part.to)) - 1;
  vec3 sum = vec3(0.0);
  for (int y = first.y; y <= last.y; ++y) {
    float height = min(part.to.y, float(y + 1)) - max(part.from.y, float(y));
    for (int x = first.x; x <= last.x; ++x) {
      float width = min(part.to.x, float(x + 1)) - max(part.from.x, float(x));
      sum += displayedColor(rowAt(ivec2(x, y))) * (width * height);
    }
  }
  vec2 size = part.to - part.from;
  return sum / (size.x * size.y);
}

void main() {
  vec2 corner = floor(gl_FragCoord.xy);
  Part part = kIsMinified ? areaBelow(corner) : texelBelow(corner);
  bool isInside = all(lessThan(part.from, part.to));
  o_color = isInside ? vec4(encoded(meanColor(part)), part.covered) : vec4(0.0);
}
