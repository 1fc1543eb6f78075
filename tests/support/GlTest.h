// A fixture for tests that need GL: one context for the process, and no error reported by the driver.
#pragma once

#include "core/gl/Context.h"

#include <gtest/gtest.h>

namespace taa::test {

/// Skips its tests where no GL 4.5 context can be had, and fails them there when TAA_REQUIRE_GL is set.
/// A test also fails when the driver reported an error during it.
class GlTest : public testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;

  /// The context that is current during the test.
  static gl::Context& context();

  /// Whether results are to be expected bit for bit (llvmpipe) and not within the table's tolerances (a GPU).
  static bool isExact() { return context().driver().isExact; }
};

} // namespace taa::test
