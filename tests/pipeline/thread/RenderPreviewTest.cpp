// What a change of settings shows before the whole picture is there.
#include "tests/support/RenderRecorder.h"

#include <algorithm>
#include <vector>

using taa::IntermediateId;
using taa::Settings;
using taa::ViewResult;
using taa::test::onThread::kHeight;
using taa::test::onThread::kWidth;
using taa::test::onThread::viewOf;

namespace {

class RenderPreviewTest : public taa::test::onThread::RenderThreadTest {
 protected:
  void SetUp() override {
    RenderThreadTest::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    // Its program exposes all rows at few pixels.
    thread->post(taa::request::SetProbes{{taa::Probe{.pixel = {4, 4}}}, 0});
    thread->post(taa::request::SetViews{{viewOf(IntermediateId::resolved)}});
    thread->post(taa::request::Seek{3});
    thread->waitUntilIdle();
    recorder.clear();
  }
  /// With another α everywhere.
  static Settings other(float alpha = 0.5f) {
    Settings settings;
    settings.weight.minimum = alpha;
    return settings;
  }
  /// What a change shows until all is done.
  std::vector<ViewResult> shownBy(const Settings& settings) {
    recorder.clear();
    thread->post(taa::request::SetSettings{settings});
    thread->waitUntilIdle();
    return shown();
  }
  bool previews(const Settings& settings) {
    return std::ranges::any_of(shownBy(settings), &ViewResult::isPreview);
  }
  std::vector<ViewResult> shown() {
    return recorder.read([&] { return recorder.all<ViewResult>(); });
  }
};

} // namespace

// The picture is as small as a preview may be: both are the same, on the history that the frame has.
TEST_F(RenderPreviewTest, ComesFirstAndIsWhatThePictureShowsThere) {
  thread->post(taa::request::SetPreviews{0.0});
  const std::vector<ViewResult> pictures = shownBy(other());
  ASSERT_GE(pictures.size(), 2u);
  EXPECT_TRUE(pictures[0].isPreview);
  EXPECT_FALSE(pictures[0].exact);
  EXPECT_TRUE(pictures[0].values.empty());
  EXPECT_FALSE(pictures[1].isPreview);
  EXPECT_EQ(pictures[0].picture.width, kWidth);
  EXPECT_EQ(pictures[0].picture.height, kHeight);
  EXPECT_EQ(pictures[0].picture.rgba, pictures[1].picture.rgba);
  EXPECT_FALSE(pictures.back().isPreview);
  EXPECT_TRUE(pictures.back().exact);
}

// A part of the picture that is enlarged has its place.
TEST_F(RenderPreviewTest, ShowsThePartThatAViewShows) {
  taa::ViewRequest view = viewOf(IntermediateId::alpha);
  view.transform = {.origin = {5.5f, 3.25f}, .zoom = 4.0f};
  thread->post(taa::request::SetViews{{view}});
  thread->waitUntilIdle();
  thread->post(taa::request::SetPreviews{0.0});
  const std::vector<ViewResult> pictures = shownBy(other());
  ASSERT_GE(pictures.size(), 2u);
  EXPECT_TRUE(pictures[0].isPreview);
  EXPECT_EQ(pictures[0].picture.rgba, pictures[1].picture.rgba);
}

TEST_F(RenderPreviewTest, ComesOnlyWhereItIsAskedForAndTheResolveTakesLong) {
  EXPECT_FALSE(previews(other(0.5f)));
  thread->post(taa::request::SetPreviews{1e9});
  EXPECT_FALSE(previews(other(0.6f)));
  thread->post(taa::request::SetPreviews{0.0});
  EXPECT_TRUE(previews(other(0.7f)));
}

// What has to be compiled or drawn first is not there at once; what is shown of the picture is made of that.
TEST_F(RenderPreviewTest, LeavesOutWhatIsNotThereAtOnce) {
  thread->post(taa::request::SetPreviews{0.0});
  Settings compiled;
  compiled.rectify.method = taa::RectifyMethod::None;
  EXPECT_FALSE(previews(compiled));
  Settings drawn; // by a program that is there
  drawn.jitter.period += 1;
  EXPECT_FALSE(previews(drawn));
  drawn.weight.minimum = 0.5f;
  EXPECT_TRUE(previews(drawn));
  thread->post(taa::request::SetViews{{viewOf(IntermediateId::output)}});
  thread->waitUntilIdle();
  drawn.weight.minimum = 0.6f;
  EXPECT_FALSE(previews(drawn));
}

// Settings that are overtaken never come; where what follows is what was in force, the picture comes back.
TEST_F(RenderPreviewTest, GivesWayToWhatWasInForce) {
  thread->post(taa::request::Seek{2});
  thread->waitUntilIdle();
  const std::vector<ViewResult> before = shown();
  ASSERT_FALSE(before.empty());
  recorder.clear();
  recorder.on<ViewResult>([&](const ViewResult& result) {
    if (result.isPreview) thread->post(taa::request::SetSettings{{}});
  });
  thread->post(taa::request::SetPreviews{0.0});
  thread->post(taa::request::SetSettings{other()});
  thread->waitUntilIdle();
  const std::vector<ViewResult> pictures = shown();
  ASSERT_EQ(pictures.size(), 2u);
  EXPECT_TRUE(pictures[0].isPreview);
  EXPECT_NE(pictures[0].picture.rgba, before.back().picture.rgba);
  EXPECT_TRUE(pictures[1].exact);
  EXPECT_EQ(pictures[1].picture.rgba, before.back().picture.rgba);
}
