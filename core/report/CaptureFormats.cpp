#include "core/report/CaptureFormats.h"

#include <algorithm>

namespace taa {

using capture::PlaneKind;
using capture::RawFormat;

namespace {

constexpr std::string_view kOwnFormats = "taa-inspector";

// WebGL's depth has 24 bits, Babylon's is view z in a half float, and Cycles' passes are 32-bit floats.
constexpr EngineFormats kEngineFormats[] = {
    {kOwnFormats, RawFormat::RGBA32F, RawFormat::RG32F, RawFormat::D32F},
    {"unreal", RawFormat::RGBA16F, RawFormat::RG16_UNORM, RawFormat::D32F},
    {"unity", RawFormat::RGBA16F, RawFormat::RG16F, RawFormat::D32F},
    {"godot", RawFormat::RGBA16F, RawFormat::RG16F, RawFormat::D32F},
    {"bevy", RawFormat::RGBA16F, RawFormat::RG16F, RawFormat::D32F},
    {"three", RawFormat::RGBA16F, RawFormat::RG16F, RawFormat::D24S8_GL},
    {"babylon", RawFormat::RGBA16F, RawFormat::RG16F, RawFormat::R16F},
    {"fsr", RawFormat::RGBA16F, RawFormat::RG16F, RawFormat::D32F},
    {"xess", RawFormat::RGBA16F, RawFormat::RG16F, RawFormat::D32F},
    {"streamline", RawFormat::RGBA16F, RawFormat::RG16F, RawFormat::D32F},
    {"metalfx", RawFormat::RGBA16F, RawFormat::RG16F, RawFormat::D32F},
    {"blender", RawFormat::RGBA32F, RawFormat::RG32F, RawFormat::R32F},
};

EngineFormats engineFormatsOf(std::string_view like) {
  const std::string_view id = capture::startingPoint(like).id;
  return *std::ranges::find(kEngineFormats, id, &EngineFormats::like);
}

bool isFixedPoint(RawFormat depth) {
  return depth == RawFormat::D24S8 || depth == RawFormat::D24S8_GL;
}

} // namespace

std::span<const EngineFormats> engineFormats() {
  return kEngineFormats;
}

CaptureFormats::CaptureFormats(std::string_view like, const capture::Conventions& conventions,
                               bool hasHalfColor, bool hasHalfOutput)
    : formats_(engineFormatsOf(like)), output_(formats_.color) {
  if (formats_.like == kOwnFormats) {
    if (hasHalfColor) formats_.color = RawFormat::RGBA16F;
    if (hasHalfColor) formats_.motion = RawFormat::RG16F;
    if (hasHalfOutput) output_ = RawFormat::RGBA16F;
  }
  // What was said besides can leave no room for the engine's own.
  const bool isUnreal = conventions.motion.encoding == capture::MotionEncoding::Unreal;
  if (isUnreal) formats_.motion = RawFormat::RG16_UNORM;
  if (!isUnreal && formats_.motion == RawFormat::RG16_UNORM) formats_.motion = RawFormat::RG16F;
  const bool isWindow = conventions.depth.kind == capture::DepthKind::Window;
  const bool isBelow0 = conventions.depth.range == capture::ClipRange::MinusOneToOne;
  if (isFixedPoint(formats_.depth) && (!isWindow || isBelow0 || conventions.depth.nothing > 1.0))
    formats_.depth = RawFormat::D32F;
}

RawFormat CaptureFormats::format(PlaneKind kind) const {
  switch (kind) {
  case PlaneKind::Color:
  case PlaneKind::Fog:
    return formats_.color;
  case PlaneKind::Motion:
    return formats_.motion;
  case PlaneKind::Depth:
    return formats_.depth;
  case PlaneKind::ObjectId:
    return RawFormat::R32_UINT;
  case PlaneKind::Mask:
    return RawFormat::RG8_UNORM;
  case PlaneKind::PreviousDepth:
    return RawFormat::R32F;
  case PlaneKind::Output:
    return output_;
  case PlaneKind::Reference:
    return RawFormat::RGBA32F;
  case PlaneKind::Normal:
  case PlaneKind::Overlay:
    break;
  }
  return RawFormat::RGBA16F;
}

} // namespace taa
