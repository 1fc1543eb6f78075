// Several probes: pinned, numbered, made active, moved, followed and removed by mouse and keys.
#include "app/session/Pins.h"

#include "app/panels/ProbePanel.h"
#include "app/views/ViewArea.h"
#include "app/views/ViewPanel.h"
#include "app/views/Viewport.h"
#include "app/widgets/bars/PinBar.h"
#include "app/widgets/parameters/SegmentedButtons.h"
#include "tests/app/WindowFixture.h"

#include <QToolButton>
#include <QTreeView>

#include <cstddef>
#include <utility>

using namespace taa;
using namespace taa::app;

namespace {

class PinWindow : public test::FakeWindow {
 protected:
  void rightClick(glm::ivec2 pixel, Qt::KeyboardModifiers modifiers = {}) {
    Viewport* viewport = window.views()->view(0)->viewport();
    const glm::dvec2 place = screenFromPicture(viewport->transform(), glm::dvec2(pixel) + 0.5);
    QTest::mouseClick(viewport, Qt::RightButton, modifiers, QPointF(place.x, place.y).toPoint());
    settle();
  }
};

} // namespace

TEST(Pins, KeepTheirResultsWhenOthersAreRemoved) {
  Pins pins;
  for (const int x : {1, 2, 3}) EXPECT_TRUE(pins.add({.pixel = {x, 0}}));
  for (const int x : {3, 1, 2})
    EXPECT_TRUE(pins.take({.pin = {.pixel = {x, 0}}, .spot = {}, .x = x, .around = {}}));
  EXPECT_EQ(pins.active(), 2);
  EXPECT_TRUE(pins.setActive(1));
  EXPECT_TRUE(pins.remove(0));
  EXPECT_EQ(pins.active(), 0) << "the same probe";
  EXPECT_EQ(pins.result(0)->x, 2);
  EXPECT_EQ(pins.result(1)->x, 3);
  EXPECT_FALSE(pins.take({.pin = {.pixel = {1, 0}}, .spot = {}, .around = {}})) << "it came too late";
  EXPECT_TRUE(pins.add({.pixel = {2, 0}}) == false && pins.count() == 2) << "one a place";
}

TEST(Pins, OfSurfacesStayWhereTheyAreWhenTheSceneGoes) {
  Pins pins;
  pins.add({.pixel = {4, 4}, .follow = Follow::Surface, .frame = 2});
  ProbeResult result{.pin = pins.all()[0], .spot = {.pixel = {9, 5}}, .around = {}};
  result.pin.anchor = SurfaceAnchor{.object = 7};
  pins.take(std::move(result));
  EXPECT_EQ(pins.pixel(0), glm::ivec2(9, 5));
  EXPECT_TRUE(pins.forgetSurfaces());
  EXPECT_EQ(pins.all()[0], (ProbePin{.pixel = {9, 5}}));
}

TEST_F(PinWindow, AreSetWithShiftAndChosenByNumber) {
  rightClick({10, 5});
  rightClick({20, 6}, Qt::ShiftModifier);
  rightClick({30, 7}, Qt::ShiftModifier);
  ASSERT_EQ(renderer->probes.pins.size(), 3u);
  EXPECT_EQ(session.probes().activePin(), 2);
  key(Qt::Key_N, Qt::ControlModifier);
  EXPECT_EQ(session.probes().pick(), glm::ivec2(10, 5));
  ASSERT_TRUE(session.probes().probe());
  EXPECT_EQ(session.probes().probe()->x, 10);
  QTest::mouseClick(window.probe()->pins()->button(1), Qt::LeftButton);
  EXPECT_EQ(session.probes().pick(), glm::ivec2(20, 6));
  rightClick({21, 8});
  EXPECT_EQ(renderer->probes.pins[1].pixel, glm::ivec2(21, 8)) << "without Shift the active one moves";
  key(Qt::Key_Escape);
  EXPECT_EQ(session.probes().pins().size(), 2u);
  EXPECT_EQ(session.probes().pick(), glm::ivec2(30, 7)) << "the next one takes its number";
  key(Qt::Key_Escape, Qt::ShiftModifier);
  EXPECT_TRUE(renderer->probes.pins.empty());
  EXPECT_FALSE(window.probe()->table()->isVisible());
}

TEST_F(PinWindow, FollowsASurfaceOutOfThePicture) {
  rightClick({60, 5});
  key(Qt::Key_F, Qt::ControlModifier | Qt::AltModifier);
  EXPECT_EQ(window.probe()->pins()->follow()->current(), 1);
  session.seek(3);
  settle();
  EXPECT_EQ(session.probes().pick(), glm::ivec2(63, 5));
  ASSERT_EQ(session.probes().pinMarks().size(), 1u);
  EXPECT_EQ(session.probes().pinMarks()[0].pixel, glm::ivec2(63, 5));
  session.seek(4);
  settle();
  EXPECT_TRUE(session.probes().pinMarks().empty());
  EXPECT_EQ(window.probe()->summary(), "The surface is off screen in this frame");
  session.seek(1);
  settle();
  EXPECT_EQ(session.probes().pick(), glm::ivec2(61, 5));
  QTest::mouseClick(window.probe()->pins()->follow(), Qt::LeftButton, {},
                    window.probe()->pins()->follow()->segment(0).center());
  session.seek(3);
  settle();
  EXPECT_EQ(session.probes().pick(), glm::ivec2(61, 5)) << "stays where it was when it was told to";
}

TEST_F(PinWindow, AreNineAtMost) {
  for (int pin = 0; pin < kMaxPins + 1; ++pin) {
    rightClick({2 * pin + 1, 3}, Qt::ShiftModifier);
  }
  EXPECT_EQ(session.probes().pins().size(), static_cast<std::size_t>(kMaxPins));
  key(Qt::Key_P, Qt::ShiftModifier);
  EXPECT_EQ(session.probes().pins().size(), static_cast<std::size_t>(kMaxPins));
}
