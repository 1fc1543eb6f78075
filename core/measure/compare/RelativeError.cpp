#include "core/measure/compare/RelativeError.h"

#include <cassert>

namespace taa {

double relativeError(const glm::vec3& picture, const glm::vec3& reference) {
  double sum = 0.0;
  for (int channel = 0; channel < 3; ++channel) {
    const double is = picture[channel], should = reference[channel];
    sum += (is - should) * (is - should) / (should * should + kRelativeEpsilon);
  }
  return sum / 3.0;
}

double relativeMse(const Image& picture, const Image& reference) {
  assert(picture.width == reference.width && picture.height == reference.height && !picture.empty());
  double sum = 0.0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      sum += relativeError(glm::vec3(picture.texel(x, y)), glm::vec3(reference.texel(x, y)));
  return sum / (double(picture.width) * double(picture.height));
}

} // namespace taa
