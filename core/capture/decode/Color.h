// Planes of color in a capture's conventions, in this program's and back.
#pragma once

#include "core/base/Image.h"
#include "core/capture/format/Manifest.h"

#include <string>

namespace taa::capture {

/// Whether planes of color are taken as light that they are stored in 256 steps of: what is dark would have
/// few of them, and who stores so encodes for a screen. `hasEightBits` of the values.
bool isLinearInSteps(const Manifest& manifest, bool hasEightBits);
/// A sentence about that.
std::string linearInSteps();

class ColorDecoder {
 public:
  /// Of a plane of color: what RGBA8_SRGB says of itself is done by who reads and writes it, whatever the
  /// conventions say. Throws Error where the frame's preExposure is needed and cannot be one.
  ColorDecoder(const Manifest& manifest, const CapturedFrame& frame, PlaneKind kind);

  /// In place; four channels, of which the last one stays.
  void decode(Image& color) const;
  void encode(Image& color) const;

 private:
  bool isSrgb_ = false;
  double exposure_ = 1.0;
};

} // namespace taa::capture
