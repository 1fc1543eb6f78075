// What the window says about the picture on show: nothing before it is there, and nothing of another scene.
#include "app/commands/Flight.h"
#include "app/panels/MessagesBar.h"
#include "app/panels/PipelinePanel.h"
#include "app/panels/StatusLine.h"
#include "app/widgets/SectionHeader.h"
#include "app/widgets/bars/FlightBar.h"
#include "tests/app/WindowFixture.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

using namespace taa;
using namespace taa::app;

namespace {

class Truth : public taa::app::test::FakeWindow {
 protected:
  int thumbnailCount() const {
    const auto headers = window.pipeline()->findChildren<SectionHeader*>();
    return static_cast<int>(std::ranges::count_if(
        headers, [](const SectionHeader* header) { return !header->thumbnail().isNull(); }));
  }
};

} // namespace

TEST(StatusLineTest, CallsNoPictureExactBeforeItIsThere) {
  StatusLine line;
  EXPECT_EQ(line.badge(), "") << "nothing is open";
  Status status;
  status.frameCount = 10;
  status.shotVersion = 3;
  line.setStatus(status);
  EXPECT_EQ(line.badge(), "no picture yet");
  EXPECT_FALSE(line.showsBadge());
  line.setPicture(2);
  EXPECT_EQ(line.badge(), "no picture yet") << "that was of something else";
  line.setPicture(3);
  EXPECT_EQ(line.badge(), "history from these settings");
  status.shotVersion = 4;
  status.exact = false;
  status.inexactSince = {RequestKind::Flight};
  line.setStatus(status);
  EXPECT_EQ(line.badge(), "no history of this camera yet");
  EXPECT_TRUE(line.showsBadge());
  status.inexactSince = {RequestKind::Settings};
  line.setStatus(status);
  EXPECT_EQ(line.badge(), "history from old settings");
  status.inexactSince = {RequestKind::Settings, RequestKind::Camera};
  line.setStatus(status);
  EXPECT_EQ(line.badge(), "history from before several changes");
  status.exact = true;
  status.inexactSince = {};
  line.setStatus(status);
  EXPECT_EQ(line.badge(), "no picture yet") << "the one on show is of before";
  line.setPicture(4);
  EXPECT_EQ(line.badge(), "history from these settings");
}

TEST_F(Truth, TheBadgeWaitsForTheFirstPictureOfAScene) {
  EXPECT_EQ(window.statusLine()->badge(), "history from these settings");
  const auto views = std::exchange(renderer->all<request::SetViews>(), {});
  window.openSource("builtin:fence");
  settle();
  ASSERT_EQ(session.status().source, "builtin:fence");
  EXPECT_EQ(window.statusLine()->badge(), "no picture yet");
  renderer->post(views.back());
  settle();
  EXPECT_EQ(window.statusLine()->badge(), "history from these settings");
}

TEST_F(Truth, StagePicturesOfTheSceneBeforeAreNotShown) {
  ASSERT_GT(thumbnailCount(), 5);
  const std::uint64_t before = session.status().shotVersion;
  const auto sizes = std::exchange(renderer->all<request::SetThumbnails>(), {}); // none while it plays
  window.openSource("builtin:fence");
  settle();
  ASSERT_EQ(session.status().source, "builtin:fence");
  EXPECT_EQ(thumbnailCount(), 0);
  Thumbnail late{mainRows().front(), 0, {1, 1, {9, 9, 9, 255}}, before};
  renderer->tell(late);
  settle();
  EXPECT_EQ(thumbnailCount(), 0) << "it is of the scene before";
  late.shotVersion = session.status().shotVersion;
  renderer->tell(late);
  settle();
  EXPECT_EQ(thumbnailCount(), 1);
  renderer->post(sizes.back());
  settle();
  EXPECT_GT(thumbnailCount(), 5);
}

TEST_F(Truth, ARecordingSaysHowMuchOfItThereIs) {
  key(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
  renderer->status.recordedFrames = 91;
  renderer->status.framesPerSecond = 60.0;
  renderer->deliver();
  settle();
  EXPECT_TRUE(window.flightBar()->isVisible());
  EXPECT_TRUE(window.flightBar()->text().contains("Recording: 91 frames, 1.50 s"))
      << window.flightBar()->text().toStdString();
  renderer->post(request::AddCameraTrack{{"Recorded 1", 7, std::vector<CameraPose>(241)}});
  renderer->status.recordedFrames = 0;
  key(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_FALSE(window.flightBar()->text().contains("Recording"));
  EXPECT_TRUE(window.messages()->text().contains("Recorded 1 has 241 frames from frame 7 on, 4.00 s."))
      << window.messages()->text().toStdString();
}
