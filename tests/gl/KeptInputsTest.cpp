// Inputs that are kept are those that were drawn, to the bit, and drawing them again is saved.
#include "core/render/KeptInputs.h"

#include "core/capture/source/OpenSource.h"
#include "tests/support/GlTest.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>

namespace taa {
namespace {

constexpr int kWidth = 64, kHeight = 36;
constexpr std::size_t kPlenty = 64u << 20;

/// Counts what is drawn.
class CountedFrames final : public FrameSource {
 public:
  explicit CountedFrames(std::shared_ptr<FrameSource> source) : source_(std::move(source)) {}
  void draw(const FrameRequest& request, int frame, FrameInputs& out) override {
    ++drawn;
    source_->draw(request, frame, out);
  }
  FrameInfo info(const FrameRequest& request, int frame) const override {
    return source_->info(request, frame);
  }
  CameraState camera(const FrameRequest& request, int frame) const override {
    return source_->camera(request, frame);
  }
  void warmUp(const FrameRequest& request, const Progress& progress) override {
    source_->warmUp(request, progress);
  }
  const DrawCounts& counts() const override { return source_->counts(); }
  void reloadShaders() override { source_->reloadShaders(); }

  int drawn = 0;

 private:
  std::shared_ptr<FrameSource> source_;
};

class KeptInputsTest : public test::GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (IsSkipped()) return;
    frames_ = std::make_shared<CountedFrames>(openSource("builtin:glass").frames);
    request_.camera = "orbit";
    request_.width = kWidth;
    request_.height = kHeight;
    request_.inputs.mask = MaskSource::Opacity;
  }
  KeptInputs keptBy(const std::shared_ptr<InputsStore>& store) const { return {frames_, "glass", store}; }

  std::shared_ptr<CountedFrames> frames_;
  FrameRequest request_;
};

void expectSame(const FrameInputs& one, const FrameInputs& other) {
  const auto expectPixels = [](const gl::Texture& a, const gl::Texture& b) {
    ASSERT_EQ(static_cast<bool>(a), static_cast<bool>(b));
    if (a) {
      EXPECT_EQ(a.download().pixels, b.download().pixels);
    }
  };
  for (const auto member : {&FrameInputs::color, &FrameInputs::depth, &FrameInputs::motion,
                            &FrameInputs::normal, &FrameInputs::previousDepth, &FrameInputs::mask,
                            &FrameInputs::overlay, &FrameInputs::forwardCount, &FrameInputs::fog})
    expectPixels(one.*member, other.*member);
  EXPECT_EQ(one.objectId.downloadIntegers(), other.objectId.downloadIntegers());
  EXPECT_EQ(one.info.frame, other.info.frame);
  EXPECT_EQ(one.info.jitterPx, other.info.jitterPx);
  EXPECT_EQ(one.outputPx, other.outputPx);
}

} // namespace

TEST_F(KeptInputsTest, AreWhatWasDrawnAndDrawnOnce) {
  KeptInputs kept = keptBy(std::make_shared<InputsStore>(kPlenty));
  FrameInputs drawn, first, again;
  frames_->draw(request_, 7, drawn);
  frames_->drawn = 0;
  kept.draw(request_, 7, first);
  kept.draw(request_, 8, again); // other contents, and then
  kept.draw(request_, 7, again);
  EXPECT_EQ(frames_->drawn, 2);
  expectSame(drawn, first);
  expectSame(drawn, again);
  EXPECT_EQ(kept.counts().drawn, frames_->counts().drawn);
}

TEST_F(KeptInputsTest, AreOthersForAnotherRequestAndForOtherShaders) {
  KeptInputs kept = keptBy(std::make_shared<InputsStore>(kPlenty));
  FrameInputs out, plain;
  kept.draw(request_, 3, out);
  FrameRequest other = request_;
  other.inputs.mask = MaskSource::None;
  kept.draw(other, 3, out);
  EXPECT_FALSE(out.mask) << "nothing of the frame before is left";
  EXPECT_EQ(frames_->drawn, 2);
  kept.reloadShaders();
  kept.draw(other, 3, out);
  EXPECT_EQ(frames_->drawn, 3);
  other.part = gl::Rect{0, 0, 8, 8};
  kept.draw(other, 3, out);
  kept.draw(other, 3, out);
  EXPECT_EQ(frames_->drawn, 5) << "the rest of a part holds anything";
}

TEST_F(KeptInputsTest, AreThoseUsedLastAsFarAsThereIsRoom) {
  FrameInputs out;
  const auto probe = std::make_shared<InputsStore>(kPlenty);
  keptBy(probe).draw(request_, 0, out);
  const auto store = std::make_shared<InputsStore>(2 * probe->bytes());
  KeptInputs kept = keptBy(store);
  frames_->drawn = 0;
  for (const int frame : {0, 1, 0, 2, 0}) kept.draw(request_, frame, out); // 1 makes room for 2
  EXPECT_EQ(frames_->drawn, 3);
  kept.draw(request_, 1, out);
  EXPECT_EQ(frames_->drawn, 4);
  EXPECT_LE(store->bytes(), 2 * probe->bytes());
}

} // namespace taa
