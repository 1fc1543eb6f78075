// OKLab (B. Ottosson, 2020): lightness 0 to 1, green to red, blue to yellow, as eyes tell colors apart.
#pragma once

#include <glm/vec3.hpp>

namespace taa {

/// Of linear Rec. 709.
glm::vec3 okLabOf(const glm::vec3& linear);
/// Linear Rec. 709, clamped to what a screen can show.
glm::vec3 linearOfOkLab(const glm::vec3& lab);

} // namespace taa
