// An export in pieces is the same as one at once, and does not hold everything.
#include "core/report/FrameExport.h"

#include "core/gl/Memory.h"
#include "core/inspect/Inspector.h"
#include "core/settings/Parameters.h"
#include "core/taa/ChannelNames.h"
#include "tests/support/GlTest.h"
#include "tests/support/Paths.h"

#include <cstring>
#include <filesystem>
#include <vector>

namespace taa {
namespace {

class FrameExportTest : public test::GlTest {};

constexpr int kWidth = 40, kHeight = 24;

TEST_F(FrameExportTest, WritesTheSameValuesAFewAtATimeAsAllAtOnce) {
  Settings other;
  applyAssignment(other, "rectify.method=clamp");
  Inspector inspector;
  inspector.shot().setSize(kWidth, kHeight);
  inspector.shot().setLanes({Settings{}, other});
  inspector.shot().open("builtin:text");
  inspector.shot().seek(2);
  const std::vector<IntermediateId> ids{IntermediateId::resolved, IntermediateId::alpha,
                                        IntermediateId::motion, IntermediateId::color,
                                        IntermediateId::historyRectified};
  FrameFile frame{"source", "camera", "driver", {}, {}};
  for (int lane = 0; lane < 2; ++lane)
    frame.lanes.push_back(
        {lane == 0 ? "A" : "B", inspector.shot().settings(lane), inspector.shot().info(lane), {}});
  const std::size_t before = gl::memoryInUse(), piece = 40 * kWidth * kHeight; // two or three at a time
  gl::resetMemoryPeak();
  const std::filesystem::path path = test::temporaryFolder() / "pieces.exr";
  exportFrame(inspector, frame, ids, path, piece);
  EXPECT_LE(gl::memoryPeak(), before + piece);
  EXPECT_GT(gl::memoryPeak(), before);
  for (int lane = 0; lane < 2; ++lane) {
    const std::vector<Image> expected = inspector.views().images(ids, lane);
    for (std::size_t index = 0; index < ids.size(); ++index) {
      const Intermediate& row = intermediate(ids[index]);
      const Image read = readPart(path, partName(frame.lanes[std::size_t(lane)], row.id),
                                  channelNames(row, frame.lanes[std::size_t(lane)].settings.space));
      ASSERT_EQ(read.pixels.size(), expected[index].pixels.size()) << row.name;
      EXPECT_EQ(
          std::memcmp(read.pixels.data(), expected[index].pixels.data(), read.pixels.size() * sizeof(float)),
          0)
          << row.name << " of lane " << lane;
    }
  }
}

} // namespace
} // namespace taa
