// What the values of an engine's output say by themselves: some that are no number, and too few steps.
#pragma once

#include "core/doctor/frames/DoctorFrame.h"

#include <glm/vec2.hpp>

#include <cstddef>

namespace taa::doctor {

/// Over all frames that have an output.
struct OutputValues {
  int frames = 0;
  int spoiledFrames = 0;        ///< with pixels that are no number though nothing around is none in color
  std::size_t most = 0;         ///< of such pixels in a frame …
  int mostFrame = 0;            ///< … that frame …
  glm::ivec2 mostPixel{0};      ///< … and one of them
  int firstFrame = -1;          ///< the first with such; below 0: there is none
  std::size_t values = 0;       ///< between 0 and 1, of all channels of all frames
  std::size_t inSteps = 0;      ///< of these: whole numbers of 1/255
  std::size_t colorInSteps = 0; ///< values of the frames' own colors that are so
  std::size_t colorValues = 0;  ///< of how many
  std::size_t beyond = 0;       ///< values above 1
  // Of pixels without motion:
  std::size_t resting = 0; ///< values that the current color wants otherwise by one to three steps
  std::size_t stuck = 0;   ///< of these: exactly those of the frame before

  /// `before`: null at the start of history.
  void add(const DoctorFrame& frame, const DoctorFrame* before);

  bool keepsNan() const;
  /// Whether all of the output is in steps of 8 bits, though colors are not.
  bool isOfFewBits() const;

 private:
  /// Of a value of the output: that of the frame's color and that of the output before, NaN where they are
  /// not known or the pixel does not rest.
  void addValue(float value, float color, float before);
  void addSpoiled(int frame, std::size_t pixels, const glm::ivec2& pixel);
};

} // namespace taa::doctor
