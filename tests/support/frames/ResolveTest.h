// A fixture that resolves synthetic frames.
#pragma once

#include "core/taa/TaaPass.h"
#include "tests/support/GlTest.h"
#include "tests/support/frames/SyntheticFrame.h"

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace taa::test {

using Exposed = std::map<IntermediateId, Image>;

/// Everything exposed, read back.
Exposed images(const ExposedRows& exposedRows);
/// Those of the resolve and of the output, in the table's order.
std::vector<Image> resolveRows(const Exposed& exposed);

/// Shares one TaaPass, hence its programs, among all tests of the process.
class ResolveTest : public GlTest {
 protected:
  void SetUp() override;
  static TaaPass& pass();

  static gl::Rect whole(const FrameShape& shape) { return {0, 0, shape.width, shape.height}; }
  /// The history after `images` were resolved on their own history, nothing exposed.
  static History resolve(const twin::Inputs& images, const FrameShape& shape, const Settings& settings,
                         ExposedRows* exposedRows = nullptr);
  /// Everything about that frame, by another pass than the shared one where that is given.
  static Exposed expose(const twin::Inputs& images, const FrameShape& shape, const Settings& settings,
                        TaaPass* other = nullptr);
  /// Resolves `images` and makes the result their history.
  static void advance(twin::Inputs& images, const FrameShape& shape, const Settings& settings);
  /// A still picture whose history are four others: their random colors, and all that the settings keep.
  static twin::Inputs rested(const FrameShape& shape, const Settings& settings, std::uint32_t seed);
};

/// Every stage switched off: center color, bilinear 32-bit history, nothing rectified or rejected, plain
/// blend with constant α, linear RGB boxes.
Settings bareSettings();

} // namespace taa::test
