// Stage 6, validate history: objects, classes, normals and motion of now and of what history was of.
#include "core/taa/twin/Color.h"
#include "core/taa/twin/Instances.h"
#include "core/taa/twin/Stages.h"
#include "core/taa/twin/Upsample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace taa::twin {
namespace {

/// 3×3 around the texel at the position.
template <typename Real>
std::array<Vec4<Real>, 9> around(const Inputs& inputs, const Texels& stored, const Vec2<Real>& position) {
  const glm::ivec2 middle = texelOf(position);
  std::array<Vec4<Real>, 9> texels{};
  for (int k = 0; k < 9; ++k) {
    const glm::ivec2 texel = clampedToPicture(middle + glm::ivec2(k % 3 - 1, k / 3 - 1), inputs);
    texels[static_cast<std::size_t>(k)] = stored.texel(texel.x, texel.y);
  }
  return texels;
}

template <typename Real>
Real cosineOf(const Vec3<Real>& a, const Vec3<Real>& b) {
  if (a == Vec3<Real>(0.0f) && b == Vec3<Real>(0.0f)) return 1.0f; // both the sky
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

template <typename Real>
Real speedOf(const Vec2<Real>& v) {
  const Real speed = sqrt(v.x * v.x + v.y * v.y);
  return minimum(speed, kNoPreviousPosition);
}

template <typename Real>
Real changeOf(const Vec2<Real>& now, const Vec2<Real>& then, VelocityTest test) {
  if (now.x == kNoPreviousPosition || then.x == kNoPreviousPosition) return 0.0f;
  if (test == VelocityTest::Length) return fabs(speedOf(now) - speedOf(then));
  return speedOf(now - then);
}

} // namespace

template <typename Real>
GeometryOf<Real> geometryOf(const Inputs& inputs, const DilatedMotionOf<Real>& dilated,
                            const glm::ivec2& drawn) {
  const glm::ivec2 chosen = drawn + dilated.offset;
  const Vec4<Real> normal = read<Real>(inputs.normal, chosen);
  return {read<Real>(inputs.objectId, chosen).x, normal.w, Vec3<Real>(normal), dilated.motion};
}

template <typename Real>
GeometryMatchOf<Real> compareGeometry(const Inputs& inputs, const Settings& settings,
                                      const GeometryOf<Real>& own, const Vec2<Real>& readPosition) {
  GeometryMatchOf<Real> match;
  if (inputs.historyColor.empty()) return match;
  const ValidateSettings& validate = settings.validate;
  if ((validate.object == Switch::On || validate.objectClass == Switch::On) &&
      !inputs.historyObject.empty()) {
    const auto stored = around(inputs, inputs.historyObject, readPosition);
    match.isSameObject = std::ranges::any_of(stored, [&](const Vec4<Real>& s) { return s.x == own.object; });
    match.isSameClass =
        std::ranges::any_of(stored, [&](const Vec4<Real>& s) { return s.y == own.objectClass; });
    const glm::ivec2 nearest = clampedToPicture(texelOf(readPosition), inputs);
    match.object = match.isSameObject ? own.object : read<Real>(inputs.historyObject, nearest).x;
  }
  if (validate.normal == Switch::On && !inputs.historyNormal.empty()) {
    match.normalAgreement = -1.0f;
    for (const Vec4<Real>& stored : around(inputs, inputs.historyNormal, readPosition)) {
      const Real cosine = cosineOf(own.normal, Vec3<Real>(stored));
      if (!(cosine > match.normalAgreement)) continue;
      match.normalAgreement = cosine;
      match.normal = Vec3<Real>(stored);
    }
  }
  const bool comparesMotion =
      validate.velocity != VelocityTest::None || settings.weight.velocityChange == Switch::On;
  if (comparesMotion && !inputs.historyMotion.empty()) {
    match.velocityChange = std::numeric_limits<float>::infinity();
    for (const Vec4<Real>& stored : around(inputs, inputs.historyMotion, readPosition)) {
      const Real change = changeOf(own.motion, Vec2<Real>(stored), validate.velocity);
      if (!(change < match.velocityChange)) continue;
      match.velocityChange = change;
      match.motion = Vec2<Real>(stored);
    }
  }
  return match;
}

template <typename Real>
DivergenceOf<Real> motionDivergence(const Inputs& inputs, const WeightSettings& settings,
                                    const glm::ivec2& drawn) {
  DivergenceOf<Real> result;
  if (settings.divergence == Switch::Off) return result;
  const auto squaredLength = [](const Vec2<Real>& v) -> Real {
    const Real length = v.x * v.x + v.y * v.y;
    return length >= 0.0f ? length : 0.0f; // NaN is no motion
  };
  const auto motionAt = [&inputs](const glm::ivec2& place) {
    const glm::ivec2 texel = clampedToDrawn(place, inputs);
    return pictureMotion(inputs, Vec2<Real>(read<Real>(inputs.motion, texel)));
  };
  const Vec2<Real> own = motionAt(drawn);
  result.fastest = squaredLength(own);
  for (int k = 0; k < 9; ++k) {
    const Vec2<Real> other = motionAt(drawn + glm::ivec2(k % 3 - 1, k / 3 - 1));
    if (other.x == kNoPreviousPosition) continue;
    const Real faster = squaredLength(other) > squaredLength(own) ? squaredLength(other) : squaredLength(own);
    const Real along = (other.x * own.x + other.y * own.y) / faster;
    if (along < result.least) result.least = along;
    if (squaredLength(other) > result.fastest) result.fastest = squaredLength(other);
  }
  if (squaredLength(own) > 1e-4f)
    result.value = saturated(1.0f - result.least) *
                   saturated(sqrt(result.fastest) / number<Real>(settings.divergenceSpeed));
  return result;
}

#define TAA_GEOMETRY(Real)                                                                                   \
  template GeometryOf<Real> geometryOf(const Inputs& inputs, const DilatedMotionOf<Real>& dilated,           \
                                       const glm::ivec2& drawn);                                             \
  template GeometryMatchOf<Real> compareGeometry(const Inputs& inputs, const Settings& settings,             \
                                                 const GeometryOf<Real>& own,                                \
                                                 const Vec2<Real>& readPosition);                            \
  template DivergenceOf<Real> motionDivergence(const Inputs& inputs, const WeightSettings& settings,         \
                                               const glm::ivec2& drawn);
TAA_EACH_NUMBER(TAA_GEOMETRY)
#undef TAA_GEOMETRY

} // namespace taa::twin
