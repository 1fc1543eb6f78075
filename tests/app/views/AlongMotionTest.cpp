// The difference from the frame before along the motion: key, label, legend, hover, probe and session.
#include "app/models/ProbeModel.h"
#include "app/panels/ProbePanel.h"
#include "app/panels/StatusLine.h"
#include "tests/app/views/ViewsFixture.h"

#include <QJsonObject>
#include <QTest>

using namespace taa;
using namespace taa::app;

namespace {

class AlongMotionViewTest : public test::FakeViews {
 protected:
  void showDifference(int frame) {
    session.seek(frame);
    key(Qt::Key_D, Qt::ShiftModifier);
    settle();
  }
};

} // namespace

TEST_F(AlongMotionViewTest, AKeyShowsItAsADifference) {
  showDifference(20);
  EXPECT_EQ(view()->comparison().kind, OtherKind::AlongMotion);
  EXPECT_EQ(view()->showing(), Showing::Difference);
  ASSERT_TRUE(asked().other);
  EXPECT_TRUE(asked().other->alongMotion && asked().asDifference);
  EXPECT_EQ(asked().style.low, -asked().style.high) << "0 is in the middle";
  EXPECT_EQ(asked().style.map, ColorMap::Diverging);
  EXPECT_EQ(viewport()->label(true).toStdString(), "Resolved · balanced · frame 19 along the motion");
}

TEST_F(AlongMotionViewTest, TheFirstFrameSaysThatThereIsNoneBefore) {
  showDifference(0);
  EXPECT_EQ(viewport()->label(true).toStdString(), "Resolved · balanced · nothing: no frame before");
}

TEST_F(AlongMotionViewTest, HoverSaysWhereThereIsNothing) {
  showDifference(20);
  QTest::mouseMove(viewport(), placeOf({0, 0}));
  settle();
  EXPECT_TRUE(window.statusLine()->hover().contains("difference nothing: off screen"))
      << window.statusLine()->hover().toStdString();
  QTest::mouseMove(viewport(), placeOf({10, 3}));
  settle();
  EXPECT_FALSE(window.statusLine()->hover().contains("nothing"))
      << window.statusLine()->hover().toStdString();
}

TEST_F(AlongMotionViewTest, TheProbeSaysBothSidesAndTheDifference) {
  session.probes().setPixel(glm::ivec2(10, 3));
  showDifference(20);
  auto* panel = window.findChild<ProbePanel*>();
  ASSERT_TRUE(panel);
  const auto told = [panel] {
    return panel->model()->comparedText(IntermediateId::alpha, panel->comparison()).toStdString();
  };
  EXPECT_EQ(told(), "compared with motion:-1: frame 19: other 329, difference 1");
  view()->setComparison({});
  settle();
  EXPECT_EQ(told(), "");
}

TEST_F(AlongMotionViewTest, ASessionKeepsIt) {
  showDifference(20);
  const QJsonObject state = window.views()->state();
  view()->setComparison({});
  window.views()->setState(state);
  EXPECT_EQ(view()->comparison().kind, OtherKind::AlongMotion);
  EXPECT_EQ(view()->showing(), Showing::Difference);
}
