// Programs compiled on another thread are found on disk and make the same bits; the thread ends cleanly.
#include "core/replay/BackgroundCompiler.h"

#include "tests/support/Paths.h"
#include "tests/support/ShaderFolder.h"
#include "tests/support/SmallInspector.h"

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <thread>

namespace fs = std::filesystem;

namespace {

using taa::allRows;
using taa::test::small::expectSame;
using taa::test::small::otherSettings;
using namespace std::chrono_literals;

class BackgroundCompilerTest : public taa::test::small::InspectorTest {
 protected:
  void SetUp() override {
    // Mesa reads it when the first context is made.
    ::setenv("MESA_SHADER_CACHE_DIR", folder_.c_str(), 1);
    InspectorTest::SetUp();
  }

  /// Bytes that the driver keeps, once its own thread has written all.
  std::uintmax_t kept() const {
    std::uintmax_t before = 0, now = bytes();
    do {
      before = now;
      std::this_thread::sleep_for(200ms);
      now = bytes();
    } while (now != before);
    return now;
  }

  const fs::path folder_ = taa::test::temporaryFolder() / "compiled ahead";

 private:
  std::uintmax_t bytes() const {
    if (!fs::exists(folder_)) return 0;
    std::uintmax_t sum = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder_))
      if (entry.is_regular_file()) sum += entry.file_size();
    return sum;
  }
};

} // namespace

TEST_F(BackgroundCompilerTest, LeavesOnDiskAllThatASwitchNeeds) {
  const auto inspector = opened();
  const auto look = [&] {
    inspector->views().picture(taa::IntermediateId::alpha, {}, {}, taa::test::small::kWidth,
                               taa::test::small::kHeight);
  };
  inspector->views().watch({taa::IntermediateId::alpha});
  inspector->shot().seek(3);
  look();
  const std::uintmax_t before = kept();
  if (before == 0) GTEST_SKIP() << "this driver keeps no programs in the folder that it is told";
  inspector->shot().prepareInBackground(otherSettings());
  ASSERT_TRUE(inspector->shot().waitUntilPrepared(60s));
  const std::uintmax_t after = kept();
  EXPECT_GT(after, before);
  inspector->shot().setSettings(otherSettings());
  look();
  EXPECT_EQ(kept(), after) << "nothing was missing";
  inspector->shot().refine();
  expectSame(inspector->views().images(allRows()), taa::test::small::fresh(otherSettings(), 3));
}

TEST_F(BackgroundCompilerTest, SaysNothingOfWhatDoesNotCompileAndGoesOn) {
  const auto inspector = opened();
  const std::uintmax_t before = kept();
  if (before == 0) GTEST_SKIP() << "this driver keeps no programs in the folder that it is told";
  taa::Settings settings; // of no other test: the folder is that of the process
  taa::applyAssignment(settings, "history.filter=bilinear");
  {
    const taa::test::ShaderFolder folder;
    folder.write("taa/resolve.frag", "#error no more\n");
    inspector->shot().prepareInBackground(settings);
    ASSERT_TRUE(inspector->shot().waitUntilPrepared(60s));
    EXPECT_EQ(kept(), before);
  }
  inspector->shot().prepareInBackground(settings);
  ASSERT_TRUE(inspector->shot().waitUntilPrepared(60s));
  EXPECT_GT(kept(), before);
}

TEST_F(BackgroundCompilerTest, EndsWhileItCompiles) {
  taa::BackgroundCompiler compiler;
  EXPECT_TRUE(compiler.waitFor(0ms)) << "there is nothing to do";
  compiler.want({otherSettings(), {48, 27}, {}});
  compiler.want({taa::Settings{}, {64, 64}, {taa::IntermediateId::alpha}});
}
