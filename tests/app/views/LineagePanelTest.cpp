// The samples that the probed pixel is made of: asked for while their page is open, drawn as bars, places and
// a way.
#include "app/panels/LineagePanel.h"

#include "app/panels/LowerArea.h"
#include "app/views/ViewArea.h"
#include "app/views/ViewPanel.h"
#include "app/views/Viewport.h"
#include "app/views/plots/FootprintView.h"
#include "app/views/plots/LineageBars.h"
#include "tests/app/WindowFixture.h"

#include <QSignalSpy>

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

using namespace taa;
using namespace taa::app;

namespace {

class LineagePage : public test::FakeWindow {
 protected:
  /// At frame 9, at pixel (20, 10).
  void open() {
    session.seek(9);
    session.probes().setPixel(glm::ivec2(20, 10));
    settle();
    key(Qt::Key_F7, Qt::ControlModifier);
  }
  const std::vector<PathPlace>& path() const { return window.views()->active()->viewport()->path(); }
};

} // namespace

TEST_F(LineagePage, AsksForSamplesOnlyWhileItIsOpen) {
  session.probes().setPixel(glm::ivec2(20, 10));
  settle();
  EXPECT_EQ(renderer->last<request::SetLineage>().frames, 0);
  EXPECT_TRUE(path().empty());
  open();
  EXPECT_TRUE(window.lineage()->isVisible());
  EXPECT_TRUE(window.lower()->shows(LowerPage::Lineage));
  EXPECT_EQ(renderer->last<request::SetLineage>().frames, kLineageFrames);
  EXPECT_EQ(path().size(), 10u) << "from frame 9 to frame 0";
  key(Qt::Key_F7, Qt::ControlModifier);
  EXPECT_EQ(renderer->last<request::SetLineage>().frames, 0);
  EXPECT_TRUE(path().empty()) << "nor is its way shown";
}

TEST_F(LineagePage, SaysWhatThePixelIsMadeOf) {
  open();
  const std::shared_ptr<const Lineage> lineage = window.lineage()->lineage();
  ASSERT_TRUE(lineage);
  EXPECT_TRUE(window.lineage()->summary().startsWith(
      "Pixel (20, 10) of frame 9\nAverages as much as 3 equally weighted frames (the resolve counts N = 1)"))
      << window.lineage()->summary().toStdString();
  EXPECT_EQ(path()[3], (PathPlace{{17.5, 10.5}, 0.0625}));
  const LineageBars* bars = window.lineage()->bars();
  const double whole = bars->barOf(lineage->frames[0]).height();
  EXPECT_GT(whole, 20.0);
  EXPECT_NEAR(bars->barOf(lineage->frames[1]).height(), 0.5 * whole, 1e-6);
  EXPECT_GT(bars->barOf(lineage->frames[0]).left(), bars->barOf(lineage->frames[1]).right())
      << "later: right";
  const FootprintView* footprint = window.lineage()->footprint();
  const QPointF center = footprint->pointOf({0.0, 0.0});
  EXPECT_GT(footprint->pointOf(lineage->samples[1].offset).x(), center.x()) << "of frame 8";
  EXPECT_GT(footprint->radiusOf(lineage->samples[0]), footprint->radiusOf(lineage->samples[1]));
}

TEST_F(LineagePage, ReadsABarUnderTheMouseAndGoesToItsFrame) {
  open();
  LineageBars* bars = window.lineage()->bars();
  const QPoint place = bars->barOf(window.lineage()->lineage()->frames[2]).center().toPoint();
  QTest::mouseMove(bars, place);
  settle();
  EXPECT_TRUE(bars->readout().contains("Frame 7: samples 0.125, rectification 0, 1 pixel"))
      << bars->readout().toStdString();
  QTest::mouseClick(bars, Qt::LeftButton, {}, place);
  settle();
  EXPECT_EQ(renderer->status.info.frame, 7);
  EXPECT_EQ(window.lineage()->lineage()->frame, 7) << "whose own samples come";
}

TEST_F(LineagePage, ADiskLeadsToItsFrame) {
  open();
  FootprintView* footprint = window.lineage()->footprint();
  const QPointF place = footprint->pointOf({0.25, 0.0});
  const std::optional<int> frame = footprint->frameAt(place);
  ASSERT_TRUE(frame);
  EXPECT_EQ(*frame % 2, 0);
  EXPECT_FALSE(footprint->frameAt(footprint->pointOf({0.0, 0.5})));
  QSignalSpy hovered(footprint, &FootprintView::hovered);
  QTest::mouseMove(footprint, place.toPoint());
  settle();
  EXPECT_EQ(hovered.count(), 1);
  QTest::mouseClick(footprint, Qt::LeftButton, {}, place.toPoint());
  settle();
  EXPECT_EQ(renderer->status.info.frame, *frame);
}

TEST_F(LineagePage, ShowsNothingOfAnotherPixelAndSaysWhatIsOld) {
  open();
  renderer->holdsBack = true;
  session.probes().setPixel(glm::ivec2(3, 4));
  settle();
  EXPECT_FALSE(window.lineage()->lineage());
  EXPECT_TRUE(path().empty());
  EXPECT_EQ(window.lineage()->summary(), "Its samples are being followed.");
  renderer->holdsBack = false;
  renderer->deliver();
  settle();
  EXPECT_EQ(path().size(), 10u);
  renderer->all<request::SetLineage>().clear(); // none of the next frame
  session.seek(12);
  settle();
  EXPECT_TRUE(path().empty()) << "it is the way to another frame";
  EXPECT_TRUE(window.lineage()->summary().startsWith("Pixel (3, 4) of frame 9, which is no longer on show"))
      << window.lineage()->summary().toStdString();
  session.probes().setPixel({});
  settle();
  EXPECT_TRUE(window.lineage()->summary().startsWith("Right-click a pixel"));
}

TEST_F(LineagePage, SaysThatTheProbeIsNotInThePicture) {
  open();
  const Probe probe = session.probes().all()[0];
  renderer->tell(LineageDelivery{probe, 9, nullptr, renderer->status.shotVersion});
  settle();
  EXPECT_EQ(window.lineage()->summary(), "The probe is not in the picture of frame 9.");
  EXPECT_TRUE(path().empty());
  renderer->tell(LineageDelivery{probe, 8, nullptr, renderer->status.shotVersion});
  settle();
  EXPECT_EQ(window.lineage()->summary(), "The probe is not in the picture of frame 8.");
}
