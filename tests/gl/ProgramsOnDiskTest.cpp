// Programs that are kept on disk are taken from there, and compiled where what is there is of no use.
#include "core/base/Files.h"
#include "core/gl/Program.h"
#include "core/gl/ProgramBinaries.h"
#include "core/gl/RenderPass.h"
#include "tests/support/GlTest.h"
#include "tests/support/Paths.h"
#include "tests/support/ShaderFolder.h"

#include <cstdlib>
#include <filesystem>
#include <string>

namespace fs = std::filesystem;

namespace {

class ProgramsOnDiskTest : public taa::test::GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (IsSkipped()) return;
    fs::remove_all(folder_);
    ::setenv("TAA_PROGRAM_CACHE", folder_.c_str(), 1);
    shaders_.write("one.frag", "out float o_value;\nvoid main() { o_value = 1.0; }\n");
    shaders_.write("two.frag", "out float o_value;\nvoid main() { o_value = 2.0; }\n");
    EXPECT_EQ(drawn("one.frag"), 1.0f);
    if (!fs::exists(folder_)) GTEST_SKIP() << "this driver gives no programs away";
  }
  void TearDown() override {
    ::setenv("TAA_PROGRAM_CACHE", "", 1);
    GlTest::TearDown();
  }

  static float drawn(const std::string& path) {
    const taa::gl::Program program(taa::gl::ShaderSource("include/fullscreen.vert"),
                                   taa::gl::ShaderSource(path), path);
    const taa::gl::Texture target({2, 2}, taa::gl::Format::R32F, "drawn");
    const taa::gl::Framebuffer framebuffer({{&target}}, nullptr, "drawn");
    {
      taa::gl::RenderPass pass(framebuffer, {}, "drawn");
      pass.program(program);
      pass.drawFullscreen();
    }
    return target.download().pixels[3];
  }
  taa::gl::ProgramBinaries binaries() const {
    const taa::gl::Driver& driver = context().driver();
    return {folder_, driver.vendor + "\n" + driver.renderer + "\n" + driver.version + "\n"};
  }

  const fs::path folder_ = taa::test::temporaryFolder() / "kept";
  const taa::test::ShaderFolder shaders_;
};

} // namespace

TEST_F(ProgramsOnDiskTest, AreTakenFromThere) {
  const std::string one = taa::gl::ShaderSource("one.frag").text(),
                    two = taa::gl::ShaderSource("two.frag").text();
  EXPECT_EQ(drawn("two.frag"), 2.0f);
  ASSERT_TRUE(binaries().find(one));
  EXPECT_EQ(drawn("one.frag"), 1.0f);
  binaries().keep(one, *binaries().find(two)); // only who takes it from there draws this
  EXPECT_EQ(drawn("one.frag"), 2.0f);
}

TEST_F(ProgramsOnDiskTest, AreCompiledAndReplacedWhenAByteIsWrong) {
  const std::string one = taa::gl::ShaderSource("one.frag").text();
  const fs::path file = binaries().fileOf(one);
  std::string bytes = taa::readFile(file);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  taa::writeFile(file, bytes);
  ASSERT_FALSE(binaries().find(one));
  EXPECT_EQ(drawn("one.frag"), 1.0f);
  EXPECT_TRUE(binaries().find(one));
}

TEST_F(ProgramsOnDiskTest, AreNotKeptWhereThereIsNoFolder) {
  fs::remove_all(folder_);
  ::setenv("TAA_PROGRAM_CACHE", "", 1);
  EXPECT_EQ(drawn("one.frag"), 1.0f);
  EXPECT_FALSE(fs::exists(folder_));
}
