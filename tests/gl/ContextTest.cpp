// The GL context of the core's own.
#include "core/gl/Context.h"

#include "tests/support/GlTest.h"

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
