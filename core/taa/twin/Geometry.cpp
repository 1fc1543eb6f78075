// Stage 6, validate history: objects, classes, normals and motion of now and of what history was of.
#include "core/taa/twin/Color.h"
#include "core/taa/twin/Stages.h"
#include "core/taa/twin/Upsample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace taa::twin {
namespace {

/// 3×3 around the texel at the position.
std::array<glm::vec4, 9> around(const Inputs& inputs, const Texels& stored, const glm::vec2& position) {
  const glm::ivec2 middle(static_cast<int>(std::floor(position.x)), static_cast<int>(std::floor(position.y)));
  std::array<glm::vec4, 9> texels{};
  for (int k = 0; k < 9; ++k) {
    const glm::ivec2 texel = clampedToPicture(middle + glm::ivec2(k % 3 - 1, k / 3 - 1), inputs);
    texels[static_cast<std::size_t>(k)] = stored.texel(texel.x, texel.y);
  }
  return texels;
}

float cosineOf(const glm::vec3& a, const glm::vec3& b) {
  if (a == glm::vec3(0.0f) && b == glm::vec3(0.0f)) return 1.0f; // both the sky
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

float speedOf(const glm::vec2& v) {
  const float speed = std::sqrt(v.x * v.x + v.y * v.y);
  return speed <= kNoPreviousPosition ? speed : kNoPreviousPosition;
}

float changeOf(const glm::vec2& now, const glm::vec2& then, VelocityTest test) {
  if (now.x == kNoPreviousPosition || then.x == kNoPreviousPosition) return 0.0f;
  if (test == VelocityTest::Length) return std::fabs(speedOf(now) - speedOf(then));
  return speedOf(now - then);
}

} // namespace

Geometry geometryOf(const Inputs& inputs, const DilatedMotion& dilated, const glm::ivec2& drawn) {
  const glm::ivec2 chosen = drawn + dilated.offset;
  const glm::vec4 normal = inputs.normal.texel(chosen.x, chosen.y);
  return {inputs.objectId.texel(chosen.x, chosen.y).x, normal.w, glm::vec3(normal), dilated.motion};
}

GeometryMatch compareGeometry(const Inputs& inputs, const Settings& settings, const Geometry& own,
                              const glm::vec2& readPosition) {
  GeometryMatch match;
  if (inputs.historyColor.empty()) return match;
  const ValidateSettings& validate = settings.validate;
  if ((validate.object == Switch::On || validate.objectClass == Switch::On) &&
      !inputs.historyObject.empty()) {
    const auto stored = around(inputs, inputs.historyObject, readPosition);
    match.isSameObject = std::ranges::any_of(stored, [&](const glm::vec4& s) { return s.x == own.object; });
    match.isSameClass =
        std::ranges::any_of(stored, [&](const glm::vec4& s) { return s.y == own.objectClass; });
    const glm::ivec2 nearest = clampedToPicture(
        {static_cast<int>(std::floor(readPosition.x)), static_cast<int>(std::floor(readPosition.y))}, inputs);
    match.object = match.isSameObject ? own.object : inputs.historyObject.texel(nearest.x, nearest.y).x;
  }
  if (validate.normal == Switch::On && !inputs.historyNormal.empty()) {
    match.normalAgreement = -1.0f;
    for (const glm::vec4& stored : around(inputs, inputs.historyNormal, readPosition)) {
      const float cosine = cosineOf(own.normal, glm::vec3(stored));
      if (!(cosine > match.normalAgreement)) continue;
      match.normalAgreement = cosine;
      match.normal = glm::vec3(stored);
    }
  }
  const bool comparesMotion =
      validate.velocity != VelocityTest::None || settings.weight.velocityChange == Switch::On;
  if (comparesMotion && !inputs.historyMotion.empty()) {
    match.velocityChange = std::numeric_limits<float>::infinity();
    for (const glm::vec4& stored : around(inputs, inputs.historyMotion, readPosition)) {
      const float change = changeOf(own.motion, glm::vec2(stored), validate.velocity);
      if (!(change < match.velocityChange)) continue;
      match.velocityChange = change;
      match.motion = glm::vec2(stored);
    }
  }
  return match;
}

Divergence motionDivergence(const Inputs& inputs, const WeightSettings& settings, const glm::ivec2& drawn) {
  Divergence result;
  if (settings.divergence == Switch::Off) return result;
  const auto squaredLength = [](const glm::vec2& v) {
    const float length = v.x * v.x + v.y * v.y;
    return length >= 0.0f ? length : 0.0f; // NaN is no motion
  };
  const auto motionAt = [&inputs](const glm::ivec2& place) {
    const glm::ivec2 texel = clampedToDrawn(place, inputs);
    return pictureMotion(inputs, glm::vec2(inputs.motion.texel(texel.x, texel.y)));
  };
  const glm::vec2 own = motionAt(drawn);
  result.fastest = squaredLength(own);
  for (int k = 0; k < 9; ++k) {
    const glm::vec2 other = motionAt(drawn + glm::ivec2(k % 3 - 1, k / 3 - 1));
    if (other.x == kNoPreviousPosition) continue;
    const float faster =
        squaredLength(other) > squaredLength(own) ? squaredLength(other) : squaredLength(own);
    const float along = (other.x * own.x + other.y * own.y) / faster;
    if (along < result.least) result.least = along;
    if (squaredLength(other) > result.fastest) result.fastest = squaredLength(other);
  }
  if (squaredLength(own) > 1e-4f)
    result.value =
        saturated(1.0f - result.least) * saturated(std::sqrt(result.fastest) / settings.divergenceSpeed);
  return result;
}

} // namespace taa::twin
