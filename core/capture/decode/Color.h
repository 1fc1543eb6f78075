// Planes of color in a capture's conventions, in this program's and back.
#pragma once

#include "core/base/Image.h"
#include "core/capture/format/Conventions.h"

namespace taa::capture {

class ColorDecoder {
 public:
  /// `preExposure` is used where the conventions say so. Throws Error where it cannot be one.
  ColorDecoder(const ColorConventions& conventions, double preExposure, int frame);

  /// In place; four channels, of which the last one stays.
  void decode(Image& color) const;
  void encode(Image& color) const;

 private:
  bool isSrgb_;
  double exposure_ = 1.0;
};

} // namespace taa::capture
