// Opening a scene tells of every texture, and stops between them.
#include "core/gl/Memory.h"
#include "core/render/passes/SceneRenderer.h"
#include "core/scene/builtin/SceneSource.h"
#include "tests/support/GlTest.h"

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace taa {
namespace {

class TextureUploadTest : public test::GlTest {
 protected:
  const std::shared_ptr<const Scene> scene_ = std::make_shared<const Scene>(openScene("builtin:fan"));
};

struct Step {
  std::string what;
  int done = 0, total = 0;
};

TEST_F(TextureUploadTest, TellsOfEveryTextureAndOfItsMipLevels) {
  std::vector<Step> steps;
  const SceneRenderer renderer(scene_, [&](std::string_view what, int done, int total) {
    steps.push_back({std::string(what), done, total});
    return true;
  });
  std::erase_if(steps, [](const Step& step) {
    return step.what.find("textures") == std::string::npos && step.what.find("mip") == std::string::npos;
  });
  ASSERT_GE(steps.size(), 4u);
  EXPECT_EQ(steps.front().total * 2, static_cast<int>(steps.size()));
  for (std::size_t i = 0; i < steps.size(); ++i) {
    EXPECT_EQ(steps[i].what, i % 2 == 0 ? "Uploading textures" : "Making mip levels");
    EXPECT_EQ(steps[i].done, static_cast<int>(i / 2));
    EXPECT_EQ(steps[i].total, steps.front().total);
  }
}

TEST_F(TextureUploadTest, StopsBetweenTexturesAndKeepsNone) {
  const std::size_t before = gl::memoryInUse();
  gl::resetMemoryPeak();
  int uploads = 0;
  const auto stopAtSecond = [&](std::string_view what, int, int) {
    return what != "Uploading textures" || ++uploads < 2;
  };
  EXPECT_THROW(SceneRenderer(scene_, stopAtSecond), Cancelled);
  EXPECT_EQ(uploads, 2);
  EXPECT_GT(gl::memoryPeak(), before) << "the first one was there";
  EXPECT_EQ(gl::memoryInUse(), before);
}

} // namespace
} // namespace taa
