// Programs compiled on another thread are found on disk and make the same bits; the thread ends cleanly.
#include "core/replay/BackgroundCompiler.h"

#include "tests/support/Paths.h"
#include "tests/support/ShaderFolder.h"
#include "tests/support/SmallInspector.h"

#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <iterator>

namespace fs = std::filesystem;

namespace {

using taa::allRows;
using taa::test::small::expectSame;
using taa::test::small::otherSettings;
using namespace std::chrono_literals;

class BackgroundCompilerTest : public taa::test::small::InspectorTest {
 protected:
  void SetUp() override {
    InspectorTest::SetUp();
    if (IsSkipped()) return;
    fs::remove_all(folder_);
    ::setenv("TAA_PROGRAM_CACHE", folder_.c_str(), 1);
  }
  void TearDown() override {
    ::setenv("TAA_PROGRAM_CACHE", "", 1);
    InspectorTest::TearDown();
  }
  std::ptrdiff_t kept() const {
    if (!fs::exists(folder_)) return 0;
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  }

  const fs::path folder_ = taa::test::temporaryFolder() / "compiled ahead";
};

} // namespace

TEST_F(BackgroundCompilerTest, LeavesOnDiskAllThatASwitchNeeds) {
  const auto inspector = opened();
  if (kept() == 0) GTEST_SKIP() << "this driver gives no programs away";
  inspector->views().watch({taa::IntermediateId::alpha});
  inspector->shot().seek(3);
  const std::ptrdiff_t before = kept();
  inspector->shot().prepareInBackground(otherSettings());
  ASSERT_TRUE(inspector->shot().waitUntilPrepared(60s));
  const std::ptrdiff_t after = kept();
  EXPECT_EQ(after, before + 2) << "the resolve that is shown, and the one that is replayed";
  inspector->shot().setSettings(otherSettings());
  inspector->shot().refine();
  EXPECT_EQ(kept(), after) << "none was missing";
  expectSame(inspector->views().images(allRows()), taa::test::small::fresh(otherSettings(), 3));
}

TEST_F(BackgroundCompilerTest, SaysNothingOfWhatDoesNotCompileAndGoesOn) {
  const auto inspector = opened();
  if (kept() == 0) GTEST_SKIP() << "this driver gives no programs away";
  const std::ptrdiff_t before = kept();
  {
    const taa::test::ShaderFolder folder;
    folder.write("taa/resolve.frag", "#error no more\n");
    inspector->shot().prepareInBackground(otherSettings());
    ASSERT_TRUE(inspector->shot().waitUntilPrepared(60s));
    EXPECT_EQ(kept(), before);
  }
  inspector->shot().prepareInBackground(otherSettings());
  ASSERT_TRUE(inspector->shot().waitUntilPrepared(60s));
  EXPECT_GT(kept(), before);
}

TEST_F(BackgroundCompilerTest, EndsWhileItCompiles) {
  taa::BackgroundCompiler compiler;
  EXPECT_TRUE(compiler.waitFor(0ms)) << "there is nothing to do";
  compiler.want({otherSettings(), {48, 27}, {}});
  compiler.want({taa::Settings{}, {64, 64}, {taa::IntermediateId::alpha}});
}
