// taa-batch where OpenGL cannot be had because of the environment: it says which variable is the cause.
#include "tests/support/GlTest.h"
#include "tests/support/Paths.h"
#include "tests/support/Process.h"

#include <gtest/gtest.h>

#include <string>

namespace {

taa::test::ProcessResult renderWith(const std::string& variable) {
  return taa::test::runProcess({"/usr/bin/env", variable, taa::test::binary("taa-batch").string(), "render",
                                "builtin:fan", "--size", "64x36", "--frames", "0", "--out",
                                (taa::test::temporaryFolder() / "noDriver").string()});
}

} // namespace

// libepoxy ends a process that calls what no driver has.
TEST(NoDriver, IsRefusedWhereEglFindsNone) {
  const auto result = renderWith("__EGL_VENDOR_LIBRARY_FILENAMES=/dev/null");
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_EQ(result.err,
            "taa-batch: cannot open a GL display: EGL finds no driver; "
            "__EGL_VENDOR_LIBRARY_FILENAMES=/dev/null in the environment is the cause: unset it\n");
}

using OldDriver = taa::test::GlTest;

TEST_F(OldDriver, IsRefusedWithTheVersionItOffersAndTheCause) {
  if (context().driver().version.find("Mesa") == std::string::npos) GTEST_SKIP() << "not a driver of Mesa";
  const auto result = renderWith("MESA_GL_VERSION_OVERRIDE=3.3");
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_EQ(result.err,
            "taa-batch: cannot draw: OpenGL 4.5 is needed, and the driver " + context().driver().renderer +
                " offers 3.3; MESA_GL_VERSION_OVERRIDE=3.3 in the environment is the cause: unset it\n");
}
