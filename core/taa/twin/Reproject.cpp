// Stage 2, reproject: pixel center minus motion, or the center itself.
#include "core/taa/twin/Color.h"
#include "core/taa/twin/Instances.h"
#include "core/taa/twin/Stages.h"

#include <cmath>

namespace taa::twin {
namespace {

/// In px of a picture of 1080 lines.
template <typename Real>
Real speedOfLines(Real speed, const glm::ivec2& picturePx) {
  return speed * (1080.0f / static_cast<float>(picturePx.y));
}

/// In 1080ths of the picture, across and down.
template <typename Real>
Real speedOfPicture(const Vec2<Real>& motionPx, const glm::ivec2& picturePx) {
  const Vec2<Real> share = motionPx / Vec2<Real>(picturePx);
  const Real length = sqrt(share.x * share.x + share.y * share.y);
  return 1080.0f * (length <= kNoPreviousPosition ? length : kNoPreviousPosition);
}

} // namespace

template <typename Real>
Real speedIn(SpeedUnit unit, Real speed, const Vec2<Real>& motionPx, const glm::ivec2& picturePx) {
  switch (unit) {
  case SpeedUnit::Pixels:
    break;
  case SpeedUnit::Lines1080:
    return speedOfLines(speed, picturePx);
  case SpeedUnit::Picture1080:
    return speedOfPicture(motionPx, picturePx);
  }
  return speed;
}

template <typename Real>
ReprojectionOf<Real> reproject(const Inputs& inputs, const ReprojectSettings& settings,
                               const Vec2<Real>& motionPx, const glm::ivec2& pixel,
                               const Vec2<Real>& readOff) {
  const bool isInPlace = settings.method == ReprojectMethod::InPlace;
  ReprojectionOf<Real> result;
  searched<Real>();
  result.noPrevious = !isInPlace && motionPx.x == kNoPreviousPosition;
  decided<Real>(IntermediateId::historyPosition);
  const Vec2<Real> center = Vec2<Real>(pixel) + 0.5f;
  const Vec2<Real> q = isInPlace ? center : (center - motionPx) + readOff;
  result.position = q;
  result.onScreen = q.x >= 0.0f && q.x <= static_cast<float>(inputs.outputWidth()) && q.y >= 0.0f &&
                    q.y <= static_cast<float>(inputs.outputHeight()); // NaN is off the screen
  decided<Real>(IntermediateId::onScreen);
  const Real speed = sqrt(motionPx.x * motionPx.x + motionPx.y * motionPx.y);
  result.speed = minimum(speed, kNoPreviousPosition); // NaN is the fastest
  return result;
}

#define TAA_REPROJECT(Real)                                                                                  \
  template ReprojectionOf<Real> reproject(const Inputs& inputs, const ReprojectSettings& settings,           \
                                          const Vec2<Real>& motionPx, const glm::ivec2& pixel,               \
                                          const Vec2<Real>& readOff);                                        \
  template Real speedIn(SpeedUnit unit, Real speed, const Vec2<Real>& motionPx, const glm::ivec2& picturePx);
TAA_EACH_NUMBER(TAA_REPROJECT)
#undef TAA_REPROJECT

} // namespace taa::twin
