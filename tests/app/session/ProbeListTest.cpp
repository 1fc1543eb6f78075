// Several probes: set, numbered, made active, moved, followed and removed by mouse and keys.
#include "app/session/ProbeList.h"

#include "app/panels/ProbePanel.h"
#include "app/views/ViewArea.h"
#include "app/views/ViewPanel.h"
#include "app/views/Viewport.h"
#include "app/widgets/bars/ProbeBar.h"
#include "app/widgets/parameters/SegmentedButtons.h"
#include "tests/app/WindowFixture.h"

#include <QToolButton>
#include <QTreeView>

#include <cstddef>
#include <utility>

using namespace taa;
using namespace taa::app;

namespace {

class ProbeWindow : public test::FakeWindow {
 protected:
  void rightClick(glm::ivec2 pixel, Qt::KeyboardModifiers modifiers = {}) {
    Viewport* viewport = window.views()->view(0)->viewport();
    const glm::dvec2 place = screenFromPicture(viewport->transform(), glm::dvec2(pixel) + 0.5);
    QTest::mouseClick(viewport, Qt::RightButton, modifiers, QPointF(place.x, place.y).toPoint());
    settle();
  }
};

} // namespace

TEST(ProbeList, KeepTheirResultsWhenOthersAreRemoved) {
  ProbeList probes;
  for (const int x : {1, 2, 3}) EXPECT_TRUE(probes.add({.pixel = {x, 0}}));
  for (const int x : {3, 1, 2})
    EXPECT_TRUE(probes.take({.probe = {.pixel = {x, 0}}, .spot = {}, .x = x, .around = {}}));
  EXPECT_EQ(probes.active(), 2);
  EXPECT_TRUE(probes.setActive(1));
  EXPECT_TRUE(probes.remove(0));
  EXPECT_EQ(probes.active(), 0) << "the same probe";
  EXPECT_EQ(probes.result(0)->x, 2);
  EXPECT_EQ(probes.result(1)->x, 3);
  EXPECT_FALSE(probes.take({.probe = {.pixel = {1, 0}}, .spot = {}, .around = {}})) << "it came too late";
  EXPECT_TRUE(probes.add({.pixel = {2, 0}}) == false && probes.count() == 2) << "one a place";
}

TEST(ProbeList, OfSurfacesStayWhereTheyAreWhenTheSceneGoes) {
  ProbeList probes;
  probes.add({.pixel = {4, 4}, .follow = Follow::Surface, .frame = 2});
  ProbeResult result{.probe = probes.all()[0], .spot = {.pixel = {9, 5}}, .around = {}};
  result.probe.anchor = SurfaceAnchor{.object = 7};
  probes.take(std::move(result));
  EXPECT_EQ(probes.pixel(0), glm::ivec2(9, 5));
  EXPECT_TRUE(probes.forgetSurfaces());
  EXPECT_EQ(probes.all()[0], (Probe{.pixel = {9, 5}}));
}

TEST_F(ProbeWindow, AreSetWithShiftAndChosenByNumber) {
  rightClick({10, 5});
  rightClick({20, 6}, Qt::ShiftModifier);
  rightClick({30, 7}, Qt::ShiftModifier);
  ASSERT_EQ(renderer->last<request::SetProbes>().all.size(), 3u);
  EXPECT_EQ(session.probes().active(), 2);
  key(Qt::Key_N, Qt::ControlModifier);
  EXPECT_EQ(session.probes().pixel(), glm::ivec2(10, 5));
  ASSERT_TRUE(session.probes().result());
  EXPECT_EQ(session.probes().result()->x, 10);
  QTest::mouseClick(window.probe()->bar()->button(1), Qt::LeftButton);
  EXPECT_EQ(session.probes().pixel(), glm::ivec2(20, 6));
  rightClick({21, 8});
  EXPECT_EQ(renderer->last<request::SetProbes>().all[1].pixel, glm::ivec2(21, 8))
      << "without Shift the active one moves";
  key(Qt::Key_Escape);
  EXPECT_EQ(session.probes().all().size(), 2u);
  EXPECT_EQ(session.probes().pixel(), glm::ivec2(30, 7)) << "the next one takes its number";
  key(Qt::Key_Escape, Qt::ShiftModifier);
  EXPECT_TRUE(renderer->last<request::SetProbes>().all.empty());
  EXPECT_FALSE(window.probe()->table()->isVisible());
}

TEST_F(ProbeWindow, FollowsASurfaceOutOfThePicture) {
  rightClick({60, 5});
  key(Qt::Key_F, Qt::ControlModifier | Qt::AltModifier);
  EXPECT_EQ(window.probe()->bar()->follow()->current(), 1);
  session.seek(3);
  settle();
  EXPECT_EQ(session.probes().pixel(), glm::ivec2(63, 5));
  ASSERT_EQ(session.probes().marks().size(), 1u);
  EXPECT_EQ(session.probes().marks()[0].pixel, glm::ivec2(63, 5));
  session.seek(4);
  settle();
  EXPECT_TRUE(session.probes().marks().empty());
  EXPECT_EQ(window.probe()->summary(), "The surface is off screen in this frame");
  session.seek(1);
  settle();
  EXPECT_EQ(session.probes().pixel(), glm::ivec2(61, 5));
  QTest::mouseClick(window.probe()->bar()->follow(), Qt::LeftButton, {},
                    window.probe()->bar()->follow()->segment(0).center());
  session.seek(3);
  settle();
  EXPECT_EQ(session.probes().pixel(), glm::ivec2(61, 5)) << "stays where it was when it was told to";
}

TEST_F(ProbeWindow, AreNineAtMost) {
  for (int probe = 0; probe < kMaxProbes + 1; ++probe) {
    rightClick({2 * probe + 1, 3}, Qt::ShiftModifier);
  }
  EXPECT_EQ(session.probes().all().size(), static_cast<std::size_t>(kMaxProbes));
  key(Qt::Key_P, Qt::ShiftModifier);
  EXPECT_EQ(session.probes().all().size(), static_cast<std::size_t>(kMaxProbes));
}
