// Faults of whole shots: history through a cut, lanes with and without faults, and frames as functions.
#include "core/settings/Faults.h"
#include "tests/support/SmallInspector.h"
#include "tests/support/frames/ResolveTest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

using namespace taa;
using taa::test::small::expectSame;
using taa::test::small::isSame;

namespace {

constexpr int kCut = 60; // of builtin:cut

class FaultsOfShotsTest : public taa::test::small::InspectorTest {
 protected:
  static Settings with(Fault fault) {
    Settings settings = test::bareSettings();
    inject(fault, settings);
    return settings;
  }
  static bool startsAnew(Inspector& inspector, int lane) {
    const Image lengths = inspector.views().image(IntermediateId::historyLength, lane);
    return std::ranges::all_of(lengths.pixels, [](float length) { return length == 1.0f; });
  }
};

} // namespace

// Motion is 0 at a cut, so that what is read as history is what was resolved before it, pixel by pixel.
TEST_F(FaultsOfShotsTest, HistoryGoesOnThroughACutInTheLaneThatIsToldTo) {
  auto inspector = opened({test::bareSettings(), with(Fault::NoResetAtCut)});
  inspector->shot().open("builtin:cut");
  inspector->shot().seek(kCut - 1);
  const Image before = inspector->views().image(IntermediateId::resolved, 1);
  EXPECT_TRUE(isSame(before, inspector->views().image(IntermediateId::resolved, 0))) << "it is no cut yet";
  inspector->shot().advance();
  EXPECT_TRUE(startsAnew(*inspector, 0));
  EXPECT_FALSE(startsAnew(*inspector, 1));
  const Image history = inspector->views().image(IntermediateId::historyRaw, 1);
  for (int y = 0; y < before.height; ++y)
    for (int x = 0; x < before.width; ++x)
      for (int channel = 0; channel < 3; ++channel)
        ASSERT_EQ(history.at(x, y)[channel], before.at(x, y)[channel]) << x << ", " << y;
  const std::vector<Image> played = inspector->views().images(allRows(), 1),
                           healthy = inspector->views().images(allRows(), 0);
  inspector->shot().seek(kCut + 4);
  inspector->shot().seek(kCut);
  expectSame(inspector->views().images(allRows(), 1), played);
  expectSame(inspector->views().images(allRows(), 0), healthy);
}

// Beside a lane with faults a healthy one has the bits that it has alone.
TEST_F(FaultsOfShotsTest, LeaveOtherLanesAsTheyAre) {
  constexpr int kFrame = 9;
  auto inspector = opened({Settings{}});
  inspector->shot().seek(kFrame);
  const std::vector<Image> alone = inspector->views().images(allRows());
  for (const Fault fault : {Fault::JitterNegated, Fault::MotionDoubled, Fault::DepthReversed, Fault::NanKept,
                            Fault::HistoryNotSwapped, Fault::ExposureStep}) {
    Settings faulty;
    inject(fault, faulty);
    inspector->shot().setLanes({Settings{}, faulty});
    inspector->shot().refine();
    expectSame(inspector->views().images(allRows(), 0), alone);
    EXPECT_FALSE(isSame(inspector->views().image(IntermediateId::resolved, 1),
                        alone[static_cast<std::size_t>(IntermediateId::resolved)]))
        << faultInfo(fault).id;
  }
}

// A frame that was played to has the bits of one that was sought.
TEST_F(FaultsOfShotsTest, StayFunctionsOfTheFrame) {
  constexpr int kFrame = 10;
  for (const Fault fault : {Fault::HistoryNotSwapped, Fault::NanKept, Fault::JitterLate, Fault::MotionLingers,
                            Fault::PreviousTwoFramesOld, Fault::HistoryReadJittered}) {
    auto inspector = opened({with(fault)});
    inspector->shot().setCheckpointBudget(0);
    inspector->shot().seek(kFrame);
    const std::vector<Image> sought = inspector->views().images(allRows());
    inspector->shot().seek(0);
    while (inspector->shot().frame() < kFrame) inspector->shot().advance();
    expectSame(inspector->views().images(allRows()), sought);
    EXPECT_TRUE(inspector->shot().areAllExact()) << faultInfo(fault).id;
  }
}
