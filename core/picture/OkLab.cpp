#include "core/picture/OkLab.h"

#include <glm/common.hpp>

#include <cmath>

namespace taa {

glm::vec3 okLabOf(const glm::vec3& linear) {
  const float l = std::cbrt(0.4122214708f * linear.x + 0.5363325363f * linear.y + 0.0514459929f * linear.z);
  const float m = std::cbrt(0.2119034982f * linear.x + 0.6806995451f * linear.y + 0.1073969566f * linear.z);
  const float s = std::cbrt(0.0883024619f * linear.x + 0.2817188376f * linear.y + 0.6299787005f * linear.z);
  return {0.2104542553f * l + 0.7936177850f * m - 0.0040720468f * s,
          1.9779984951f * l - 2.4285922050f * m + 0.4505937099f * s,
          0.0259040371f * l + 0.7827717662f * m - 0.8086757660f * s};
}

glm::vec3 linearOfOkLab(const glm::vec3& lab) {
  const float l = lab.x + 0.3963377774f * lab.y + 0.2158037573f * lab.z;
  const float m = lab.x - 0.1055613458f * lab.y - 0.0638541728f * lab.z;
  const float s = lab.x - 0.0894841775f * lab.y - 1.2914855480f * lab.z;
  const float l3 = l * l * l, m3 = m * m * m, s3 = s * s * s;
  return glm::clamp(glm::vec3(4.0767416621f * l3 - 3.3077115913f * m3 + 0.2309699292f * s3,
                              -1.2684380046f * l3 + 2.6097574011f * m3 - 0.3413193965f * s3,
                              -0.0041960863f * l3 - 0.7034186147f * m3 + 1.7076147010f * s3),
                    0.0f, 1.0f);
}

} // namespace taa
