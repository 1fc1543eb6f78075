// How the planes of a written capture are stored: as the engine of its conventions stores them.
#pragma once

#include "core/capture/format/Conventions.h"
#include "core/capture/format/Manifest.h"

#include <span>
#include <string_view>

namespace taa {

/// What an engine stores of a frame. This program's own lose nothing; see CaptureFormats::format().
struct EngineFormats {
  std::string_view like; ///< id of a capture::StartingPoint
  capture::RawFormat color, motion, depth;
};

/// One for each starting point, in their order.
std::span<const EngineFormats> engineFormats();

class CaptureFormats {
 public:
  /// `hasHalfColor`, `hasHalfOutput`: what color and motion, and the resolved picture are kept as here.
  /// Throws Error where there is no starting point `like`.
  CaptureFormats(std::string_view like, const capture::Conventions& conventions, bool hasHalfColor,
                 bool hasHalfOutput);

  /// Of planes in the conventions that were said.
  capture::RawFormat format(capture::PlaneKind kind) const;

 private:
  EngineFormats formats_;
  capture::RawFormat output_;
};

} // namespace taa
