#include "core/requests/RequestKinds.h"

#include "core/base/Say.h"

#include <algorithm>

namespace taa {

namespace {

/// A flown camera is one.
RequestKind plainKind(RequestKind kind) {
  const bool isCamera =
      kind == RequestKind::Flight || kind == RequestKind::Recording || kind == RequestKind::FlownCameras;
  return isCamera ? RequestKind::Camera : kind;
}

} // namespace

std::optional<RequestKind> onlyCause(const std::vector<RequestKind>& causes) {
  if (causes.empty()) return {};
  const RequestKind first = plainKind(causes.front());
  const bool isOne = std::ranges::all_of(causes, [&](RequestKind kind) { return plainKind(kind) == first; });
  return isOne ? std::optional(first) : std::nullopt;
}

std::string replayText(const std::vector<RequestKind>& causes) {
  if (causes.empty()) return say<"Replaying up to this frame">();
  switch (onlyCause(causes).value_or(RequestKind::None)) {
  case RequestKind::Settings:
    return say<"Replaying with the new settings">();
  case RequestKind::Lanes:
    return say<"Replaying with the settings to compare with">();
  case RequestKind::Camera:
    return say<"Replaying with the new camera">();
  case RequestKind::Size:
    return say<"Replaying at the new size">();
  case RequestKind::MotionModes:
    return say<"Replaying with the new motion of objects">();
  case RequestKind::Objects:
    return say<"Replaying with the objects that are drawn now">();
  case RequestKind::Classes:
    return say<"Replaying with the new classes of objects">();
  case RequestKind::Restarts:
    return say<"Replaying with the new starts of history">();
  case RequestKind::Shaders:
    return say<"Replaying with the new shaders">();
  case RequestKind::Source:
    return say<"Replaying the new scene">();
  default:
    return say<"Replaying after several changes">();
  }
}

} // namespace taa
