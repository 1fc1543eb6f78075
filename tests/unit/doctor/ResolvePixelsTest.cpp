// Which pixels tell of a resolve, in painted frames whose silhouettes are known by their geometry.
#include "core/doctor/resolve/ResolvePixels.h"

#include "tests/support/doctor/PaintedResolve.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace taa::doctor {
namespace {

/// Pixels beside which there is both the board and what is behind it.
std::set<std::pair<int, int>> silhouettesOf(const DoctorFrame& frame) {
  std::set<std::pair<int, int>> out;
  const auto isBoard = [&](int x, int y) {
    return frame.objectId[static_cast<std::size_t>(y) * frame.luma.width + x] == test::kBoardId;
  };
  for (int y = 1; y + 1 < frame.luma.height; ++y)
    for (int x = 1; x + 1 < frame.luma.width; ++x) {
      int boards = 0;
      for (int i = 0; i < 9; ++i) boards += isBoard(x + i % 3 - 1, y + i / 3 - 1) ? 1 : 0;
      if (boards > 0 && boards < 9) out.insert({x, y});
    }
  return out;
}

std::vector<glm::ivec2> silhouettePixels(float boardPx) {
  test::PaintedShot shot;
  shot.boardPx = {static_cast<double>(boardPx), 0.0};
  const std::vector<DoctorFrame> frames = test::resolvedFrames(shot, 4, {});
  return resolvePixels({frames[3], frames[2], {}, 3}, PixelSet::Silhouettes, 10000);
}

} // namespace

TEST(ResolvePixels, AreNearlyAllOfTheRimsThatMoveOtherwise) {
  test::PaintedShot shot;
  shot.boardPx = {0.125, 0.0};
  const std::set<std::pair<int, int>> silhouettes = silhouettesOf(test::resolvedFrames(shot, 4, {})[3]);
  const std::vector<glm::ivec2> pixels = silhouettePixels(0.125f);
  ASSERT_GT(silhouettes.size(), 200u);
  for (const glm::ivec2& pixel : pixels) EXPECT_TRUE(silhouettes.contains({pixel.x, pixel.y}));
  std::set<std::pair<int, int>> found;
  for (const glm::ivec2& pixel : pixels) found.insert({pixel.x, pixel.y});
  EXPECT_EQ(found.size(), pixels.size()) << "none twice";
  EXPECT_GE(found.size() * 20, silhouettes.size() * 19);
}

TEST(ResolvePixels, AreNoRimsThatMoveAsWhatIsBehindThem) {
  EXPECT_TRUE(silhouettePixels(0.0625f).empty());
}

} // namespace taa::doctor
