// What is shown: the resolved color sharpened, where it moves fast this frame blurred along its motion, and over it
// what was drawn without jitter, where kHasOverlay, and noise for the screen (manual §18, 14.4, 20.8, 21.1). In:
// pixel of the resolved picture, which may be larger than the inputs; the layer has their size.

layout(binding = 8) uniform sampler2D u_resolved; // scene-linear: History::color of this frame

/// The nine resolved colors around a pixel, 3×3 row-major, clamped to the edge.
Samples readResolved(ivec2 pixel) {
  vec2 texel = 1.0 / vec2(textureSize(u_resolved, 0));
  Samples samples;
  samples.mask = vec2(0.0); // of no concern here
  for (int k = 0; k < 9; ++k) {
    ivec2 neighbor = pixel + ivec2(k % 3 - 1, k / 3 - 1);
    samples.color[k] = textureLod(u_resolved, (vec2(neighbor) + 0.5) * texel, 0.0).rgb;
  }
  return samples;
}

/// Interleaved gradient noise (Jimenez 2014) that moves on each frame; 0 to 1.
float gradientNoise(ivec2 pixel) {
  float shift = float(frameNumber() % 64);
  precise vec2 place = vec2(pixel) + 5.588238 * shift;
  precise float slope = 0.06711056 * place.x + 0.00583715 * place.y;
  precise float steep = 52.9829189 * (slope - floor(slope));
  precise float noise = steep - floor(steep);
  return noise;
}

/// This frame between its texels, bilinear; position in render px.
vec3 currentAt(vec2 position) {
  precise vec2 corner = floor(position - 0.5);
  precise vec2 share = (position - 0.5) - corner;
  ivec2 first = ivec2(corner);
  precise vec3 c0 = sanitized(texelAt(u_color, first).rgb);
  precise vec3 c1 = sanitized(texelAt(u_color, first + ivec2(1, 0)).rgb);
  precise vec3 c2 = sanitized(texelAt(u_color, first + ivec2(0, 1)).rgb);
  precise vec3 c3 = sanitized(texelAt(u_color, first + ivec2(1, 1)).rgb);
  precise vec3 top = c0 + share.x * (c1 - c0);
  precise vec3 bottom = c2 + share.x * (c3 - c2);
  precise vec3 result = top + share.y * (bottom - top);
  return result;
}

/// The mean of seven taps along half the motion, px of the picture, started by the noise (14.4, Playdead).
vec3 blurredAlong(vec2 position, vec2 motion, float noise) {
  precise vec2 stepPx = (motion * resolveBlock.renderRatio) / 6.0; // from tap to tap: three on either side of the pixel
  precise float start = noise - 0.5;
  precise vec2 end = position + (start - 3.0) * stepPx;
  precise vec3 first = currentAt(end);
  precise vec3 sum = vec3(0.0);
  for (int tap = -2; tap <= 3; ++tap) {
    precise vec2 place = position + (start + float(tap)) * stepPx;
    sum = sum + (currentAt(place) - first);
  }
  precise vec3 result = first + sum / 7.0;
  return result;
}

/// Share of the resolved color by its speed. Where no motion is known there is nothing to blur along.
float blurTrust(float speed) {
  if (speed >= kNoPreviousPosition) return 1.0;
  precise float trust = 1.0 - saturated((speed - 2.0) / 13.0);
  return trust;
}

/// The color with this frame blurred along its motion over it, as little as the resolved color is to be trusted; and
/// that trust.
vec4 blurredByMotion(ivec2 pixel, ivec2 texel, vec3 sharp) {
  vec2 motion = dilateMotion(texel).motion;
  float trust = blurTrust(speedOf(motion));
  precise vec3 color = sharp;
  if (trust < 1.0) {
    precise vec2 position = (vec2(pixel) + 0.5) * resolveBlock.renderRatio; // render px
    precise vec3 blurred = blurredAlong(position, motion, gradientNoise(pixel));
    color = blurred + trust * (sharp - blurred);
  }
  return vec4(color, trust);
}

/// How much brighter than the resolved color the sharpened one is.
float detailOf(vec3 sharp, vec3 resolved) {
  precise float detail = luma(sharp) - luma(resolved);
  return detail;
}

/// With noise of a step of 8 bits, in square roots, which is near to what screens are sent (20.8).
vec3 dithered(vec3 color, ivec2 pixel) {
  precise vec3 root = sqrt(color) + triangularNoise(pixel) / 255.0;
  root = maximum(root, vec3(0.0));
  precise vec3 result = root * root;
  return storable(result);
}

void showOutput(ivec2 pixel) {
  Place place = placeOf(pixel);
  Samples resolved = readResolved(pixel);
  vec3 sharp = sharpen(resolved, place);
  vec4 shown = kTaaEnabled && kOutputMotionBlur ? blurredByMotion(pixel, place.texel, sharp) : vec4(sharp, 1.0);
  vec3 color = shown.rgb;
  if (kHasOverlay) {
    vec4 layer = texelAt(u_overlay, place.still);
    precise vec3 covered = color * (1.0 - layer.a) + layer.rgb;
    color = storable(covered);
  }
  if (kTaaEnabled && kOutputDither) color = dithered(color, pixel);
  expose_sharpenDetail(detailOf(sharp, resolved.color[4]));
  expose_blurTrust(shown.a);
  expose_output(color);
}
