// Inputs that are kept are those that would be drawn, to the bit, and are drawn once.
#include "tests/support/SmallInspector.h"

#include "tests/support/frames/Variants.h"

#include <cstddef>

namespace {

using taa::allRows;
using taa::Inspector;
using taa::Settings;
using taa::test::otherJitter;
using taa::test::small::expectSame;
using taa::test::small::fresh;
using taa::test::small::otherSettings;

constexpr std::size_t kPlenty = 64u << 20;

class KeptInputsTest : public taa::test::small::InspectorTest {};

/// Whether anything is drawn when the frame is made again with these settings.
bool isDrawnAgain(Inspector& inspector, const Settings& settings, int frame) {
  inspector.shot().setLanes({settings});
  inspector.shot().seek(frame);
  return inspector.shot().times().scene > 0.0;
}

Settings withAlpha(float alpha) {
  Settings settings;
  settings.weight.alpha = alpha;
  return settings;
}

} // namespace

TEST_F(KeptInputsTest, AreWhatIsDrawnAndDrawnOnce) {
  const auto inspector = opened();
  inspector->shot().setInputsBudget(kPlenty);
  inspector->shot().seek(6);
  EXPECT_FALSE(isDrawnAgain(*inspector, withAlpha(0.3f), 6));
  EXPECT_TRUE(isDrawnAgain(*inspector, otherJitter(), 6)) << "these are others";
  EXPECT_FALSE(isDrawnAgain(*inspector, Settings{}, 6));
  expectSame(inspector->views().images(allRows()), fresh({}, 6));
  inspector->shot().setLanes({Settings{}, otherSettings()});
  inspector->shot().seek(9);
  inspector->shot().seek(4);
  expectSame(inspector->views().images(allRows(), 1), fresh(otherSettings(), 4));
}

TEST_F(KeptInputsTest, AreNotThoseOfAnotherSizeOrSceneThatIsOpenedAnew) {
  const auto inspector = opened();
  inspector->shot().setInputsBudget(kPlenty);
  inspector->shot().setSize(inspector->shot().width() / 2, inspector->shot().height());
  EXPECT_TRUE(inspector->shot().times().scene > 0.0);
  inspector->shot().open(inspector->shot().source());
  EXPECT_TRUE(inspector->shot().times().scene > 0.0);
}

// Where there is room for two, three frames that are made in turn never find what they need.
TEST_F(KeptInputsTest, AreAsManyAsThereIsRoomFor) {
  const auto inspector = opened();
  inspector->shot().seek(2);
  EXPECT_TRUE(isDrawnAgain(*inspector, withAlpha(0.3f), 2)) << "unless told otherwise none are kept";
  const std::size_t bytes = taa::inputBytes({}, {inspector->shot().width(), inspector->shot().height()});
  for (const std::size_t frames : {2, 3}) {
    inspector->shot().setInputsBudget(0);
    inspector->shot().setInputsBudget(frames * bytes);
    EXPECT_TRUE(isDrawnAgain(*inspector, withAlpha(0.1f * float(frames) + 0.2f), 2));
    EXPECT_EQ(isDrawnAgain(*inspector, withAlpha(0.1f * float(frames) + 0.5f), 2), frames == 2);
  }
}
