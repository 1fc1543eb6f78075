// History restarted at frames of the shot: empty there as after a cut, what is drawn as without it, and frame
// n a function all the same.
#include "core/base/Error.h"
#include "core/scene/builtin/SceneSource.h"
#include "tests/support/SmallInspector.h"
#include "tests/support/frames/Frames.h"

#include <gtest/gtest.h>

#include <future>
#include <memory>
#include <utility>
#include <vector>

using namespace taa;
using taa::test::small::expectSame;
using taa::test::small::isSame;
using taa::test::small::kHeight;
using taa::test::small::kWidth;

namespace {

class RestartTest : public taa::test::small::InspectorTest {
 protected:
  static std::vector<Image> all(Inspector& inspector) { return inspector.views().images(allRows()); }
  static std::vector<float> reasons(Inspector& inspector) {
    return inspector.views().image(IntermediateId::rejectReason).pixels;
  }
  static bool isEmpty(Inspector& inspector) {
    constexpr float kNoHistory = 1.0f;
    return reasons(inspector) == std::vector<float>(std::size_t{kWidth} * kHeight, kNoHistory);
  }
};

} // namespace

// Techniques: 1.7.
TEST_F(RestartTest, HistoryIsEmptyThereAndWhatIsDrawnStays) {
  auto plain = opened();
  plain->shot().seek(7);
  const Image motion = plain->views().image(IntermediateId::motion),
              color = plain->views().image(IntermediateId::color);
  EXPECT_FALSE(isEmpty(*plain));
  plain->shot().setRestarts({7});
  EXPECT_TRUE(plain->shot().isExact()) << "nothing before it counts";
  EXPECT_TRUE(isEmpty(*plain));
  EXPECT_TRUE(plain->shot().info().startsHistory);
  EXPECT_TRUE(isSame(plain->views().image(IntermediateId::motion), motion)) << "no cut: things have moved";
  EXPECT_TRUE(isSame(plain->views().image(IntermediateId::color), color));
  for (const float length : plain->views().image(IntermediateId::historyLength).pixels)
    ASSERT_EQ(length, 1.0f);
  plain->shot().seek(8);
  EXPECT_FALSE(isEmpty(*plain));
  for (const float length : plain->views().image(IntermediateId::historyLength).pixels)
    ASSERT_LE(length, 2.0f);
}

// A history that is begun by hand at frame 7, by the pass alone.
TEST_F(RestartTest, FramesAfterItAreThoseOfAHistoryThatBeganThere) {
  const auto restarted = [] {
    auto inspector = opened();
    inspector->shot().setRestarts({7});
    inspector->shot().seek(10);
    return inspector->views().image(IntermediateId::resolved);
  };
  const Image is = std::async(std::launch::async, restarted).get(); // it has a context of its own
  const Settings settings;
  SceneRenderer renderer(std::make_shared<const Scene>(openScene("builtin:fan")));
  FrameRequest request{
      .camera = "still", .width = kWidth, .height = kHeight, .jitter = settings.jitter, .inputs = {}};
  request.camera = openScene("builtin:fan").shot.camera;
  TaaPass pass;
  test::Accumulator accumulator;
  FrameInputs inputs;
  for (int frame = 7; frame <= 10; ++frame) {
    renderer.draw(request, frame, inputs);
    if (frame == 7) inputs.info.startsHistory = true;
    accumulator.resolve(pass, inputs, settings);
  }
  const Image want = accumulator.history().color.download();
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      for (int channel = 0; channel < 3; ++channel)
        ASSERT_EQ(is.at(x, y)[channel], want.at(x, y)[channel]) << x << ", " << y;
}

TEST_F(RestartTest, SeekingPlayingAndSteppingBackGiveTheSameBits) {
  auto inspector = opened({Settings{}, test::small::otherSettings()});
  inspector->shot().setCheckpointBudget(0);
  inspector->shot().setRestarts({9, 5, 9, 0});
  EXPECT_EQ(inspector->shot().restarts(), (std::vector<int>{5, 9}));
  const auto both = [&] {
    std::vector<Image> pictures = inspector->views().images(allRows(), 0);
    for (Image& picture : inspector->views().images(allRows(), 1)) pictures.push_back(std::move(picture));
    return pictures;
  };
  const auto expectBoth = [&](const std::vector<Image>& want, const char* how) {
    const std::vector<Image> is = both();
    for (std::size_t i = 0; i < is.size(); ++i)
      ASSERT_TRUE(isSame(is[i], want[i])) << how << ", picture " << i;
  };
  inspector->shot().seek(11);
  const std::vector<Image> sought = both();
  inspector->shot().seek(0);
  while (inspector->shot().frame() < 11) inspector->shot().advance();
  expectBoth(sought, "played");
  inspector->shot().seek(13);
  inspector->shot().seek(11);
  expectBoth(sought, "stepped back");
  EXPECT_TRUE(inspector->shot().areAllExact());
}

TEST_F(RestartTest, TakenAwayEverythingIsAsBefore) {
  auto inspector = opened();
  inspector->shot().seek(9);
  const std::vector<Image> before = all(*inspector);
  inspector->shot().setRestarts({9});
  EXPECT_TRUE(isEmpty(*inspector));
  inspector->shot().setRestarts({});
  inspector->shot().refine();
  EXPECT_TRUE(inspector->shot().isExact());
  expectSame(all(*inspector), before);
  // One that lies before the frame on show: its history is not this frame's any more until it is made anew.
  inspector->shot().setRestarts({4});
  EXPECT_FALSE(inspector->shot().isExact());
  inspector->shot().refine();
  const std::vector<Image> restarted = all(*inspector);
  EXPECT_FALSE(isSame(restarted[static_cast<std::size_t>(IntermediateId::resolved)],
                      before[static_cast<std::size_t>(IntermediateId::resolved)]));
  inspector->shot().setRestarts({12}); // one goes, one comes after the frame
  inspector->shot().refine();
  expectSame(all(*inspector), before);
  inspector->shot().setRestarts({12, 14}); // nothing before changes
  EXPECT_TRUE(inspector->shot().isExact());
  expectSame(all(*inspector), before);
}

TEST_F(RestartTest, FramesThatAreNotThereAreNamedAndAnotherSceneHasNone) {
  auto inspector = opened();
  try {
    inspector->shot().setRestarts({3, 240});
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "cannot restart the history at frame 240: the shot has frames 0 to 239");
  }
  EXPECT_TRUE(inspector->shot().restarts().empty());
  inspector->shot().setRestarts({3});
  inspector->shot().open("builtin:fan");
  EXPECT_TRUE(inspector->shot().restarts().empty());
}
