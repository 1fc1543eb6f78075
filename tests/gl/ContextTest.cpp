// The GL context of the core's own.
#include "core/gl/Context.h"

#include "tests/support/GlTest.h"

#include <optional>
#include <string>

using ContextTest = taa::test::GlTest;

TEST_F(ContextTest, NamesTheDriver) {
  const taa::gl::Driver& driver = context().driver();
  EXPECT_FALSE(driver.renderer.empty());
  EXPECT_TRUE(driver.version.starts_with("4.")) << driver.version;
  EXPECT_GE(driver.maxTextureSize, 16384) << "what GL 4.5 promises";
}

TEST_F(ContextTest, StartsWithoutAnError) {
  EXPECT_NO_THROW(taa::gl::checkErrors("nothing"));
  EXPECT_TRUE(context().takeMessages().empty());
}

TEST(KnownFault, RefusesZinkOfOldMesaAndNothingElse) {
  const auto fault =
      taa::gl::knownFault("zink (llvmpipe (LLVM 15.0.6, 256 bits))", "4.6 (Core Profile) Mesa 22.3.6");
  ASSERT_TRUE(fault);
  EXPECT_NE(fault->find("Mesa 22.3.6"), std::string::npos) << *fault;
  EXPECT_FALSE(taa::gl::knownFault("zink Vulkan 1.4(llvmpipe (LLVM 19.1.7) (LAVAPIPE))",
                                   "4.6 (Core Profile) Mesa 25.0.7-2"));
  EXPECT_FALSE(taa::gl::knownFault("llvmpipe (LLVM 15.0.6, 256 bits)", "4.5 (Core Profile) Mesa 22.3.6"));
  EXPECT_FALSE(taa::gl::knownFault("NVIDIA H200", "4.5.0 NVIDIA 570.10"));
}
