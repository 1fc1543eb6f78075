// Color maps, from the table that C++ fills (core/picture/ColorMap.h): the same arithmetic as taa::mapColor. All
// colors are linear Rec. 709.

layout(binding = 1) uniform sampler2D u_colorMaps; // one row a map

// Rows of the table: taa::ColorMap.
const int kGray = 0;
const int kCyclic = 4;
const int kCategorical = 5;
const int kEntries = 257;
const int kCategories = 10;

float srgbDecoded(float value) {
  return value <= 0.04045 ? value / 12.92 : pow((value + 0.055) / 1.055, 2.4);
}

float srgbEncoded(float value) {
  return value <= 0.0031308 ? 12.92 * value : 1.055 * pow(value, 1.0 / 2.4) - 0.055;
}

vec3 decoded(vec3 color) {
  return vec3(srgbDecoded(color.r), srgbDecoded(color.g), srgbDecoded(color.b));
}

vec3 encoded(vec3 color) {
  return vec3(srgbEncoded(color.r), srgbEncoded(color.g), srgbEncoded(color.b));
}

// Clamped to 0…1; 0 for NaN.
float unit(float value) {
  return value > 0.0 ? (value < 1.0 ? value : 1.0) : 0.0;
}

vec3 entry(int map, int index) {
  return texelFetch(u_colorMaps, ivec2(index, map), 0).rgb;
}

// The color of `value` (0 to 1) in a map.
vec3 mapColor(int map, float value) {
  float t = unit(map == kCyclic ? value - floor(value) : value);
  if (map == kCategorical) return entry(map, min(int(t * float(kCategories)), kCategories - 1));
  precise float position = t * float(kEntries - 1);
  int index = min(int(position), kEntries - 2);
  vec3 a = entry(map, index), b = entry(map, index + 1);
  precise vec3 color = a + (position - float(index)) * (b - a);
  return color;
}

// Number 0 has a color of its own, the others repeat.
vec3 categoryColor(int number) {
  int others = kCategories - 1;
  return entry(kCategorical, number == 0 ? 0 : 1 + ((number - 1) % others + others) % others);
}
