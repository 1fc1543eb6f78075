// Where the planes of a frame are faulty. In: depth, class and number of what the texel shows, without faults.
#include "shared/FaultBlock.h"

layout(binding = 1) uniform sampler2D u_depth;     // reversed, 0 = sky
layout(binding = 2) uniform sampler2D u_normal;    // alpha: class of the object
layout(binding = 3) uniform usampler2D u_objectId;

// FaultRegion.
const int kSky = 1;
const int kSurfaces = 2;
const int kStill = 3;
const int kMoving = 4;
const int kDeforming = 5;
const int kObject = 6;
const int kRectangle = 7;

bool isInRegion(ivec2 texel) {
  int region = fault.place.x;
  bool isSky = texelFetch(u_depth, texel, 0).r == 0.0;
  int kind = int(texelFetch(u_normal, texel, 0).a + 0.5); // ObjectClass
  vec2 center = vec2(texel) + 0.5;
  if (region == kSky) return isSky;
  if (region == kSurfaces) return !isSky;
  if (region == kStill) return !isSky && kind == 1;
  if (region == kMoving) return kind == 2;
  if (region == kDeforming) return kind >= 3;
  if (region == kObject) return texelFetch(u_objectId, texel, 0).r == uint(fault.place.y);
  if (region == kRectangle)
    return all(greaterThanEqual(center, fault.rectangle.xy)) && all(lessThan(center, fault.rectangle.zw));
  return true;
}
