// The ghosts of builtin:disocclusion are found, explained and corrected by the steps that the manual counts
// (window.md): the worst pixel, its verdict, the first remedy.
#include "core/inspect/Inspector.h"
#include "core/settings/Presets.h"
#include "tests/support/GlTest.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

using taa::Inspector;
using taa::IntermediateId;
using taa::Settings;
using taa::VerdictKind;

namespace {

constexpr int kFrame = 64, kSamples = 8;

class GhostWalk : public taa::test::GlTest {
 protected:
  void open(const std::string& preset) {
    inspector_ = std::make_unique<Inspector>();
    inspector_->shot().setSize(480, 270);
    inspector_->shot().setSettings(taa::preset(preset).settings);
    inspector_->shot().open("builtin:disocclusion");
    inspector_->shot().seek(kFrame);
    inspector_->reference().refine(kSamples);
  }
  glm::ivec2 worstPixel() {
    return inspector_->worst().next(IntermediateId::resolved, 0, {}, taa::WorstStep::Pixel).worst.pixel;
  }
  taa::PixelVerdict verdictOn(const glm::ivec2& pixel) {
    return inspector_->verdicts().of({.frame = kFrame, .pixel = pixel}).verdict;
  }
  taa::Remedy firstRemedy(const glm::ivec2& pixel, const taa::PixelVerdict& verdict) {
    taa::VerdictAnswer answer;
    answer.verdict = verdict;
    const taa::RemedyAnswer remedies =
        inspector_->verdicts().remedies({.frame = kFrame, .pixel = pixel}, answer);
    return remedies.best.empty() ? taa::Remedy{} : remedies.best.front().remedy;
  }
  void apply(const Settings& settings) {
    inspector_->shot().setSettings(settings);
    inspector_->shot().seek(kFrame);
  }

 private:
  std::unique_ptr<Inspector> inspector_;
};

} // namespace

// What lies beside a silhouette follows the motion of what is before it, and reads what that came from.
TEST_F(GhostWalk, OfANeighborsMotionIsMendedByItsOwn) {
  constexpr glm::ivec2 kBesideBoard{188, 101};
  open("balanced");
  const taa::PixelVerdict verdict = verdictOn(kBesideBoard);
  ASSERT_EQ(verdict.kind, VerdictKind::Ghost);
  const taa::Remedy remedy = firstRemedy(kBesideBoard, verdict);
  EXPECT_EQ(remedy.changes, std::vector<std::string>{"dilate.method=none"});
  apply(remedy.settings);
  EXPECT_EQ(verdictOn(kBesideBoard).kind, VerdictKind::None);
}

TEST_F(GhostWalk, TheWorstPixelOfTrustedHistoryIsAGhostThatTheFirstRemedyMends) {
  open("unrectified");
  const glm::ivec2 pixel = worstPixel();
  const taa::PixelVerdict verdict = verdictOn(pixel);
  ASSERT_EQ(verdict.kind, VerdictKind::Ghost);
  const taa::Remedy remedy = firstRemedy(pixel, verdict);
  ASSERT_FALSE(remedy.changes.empty());
  apply(remedy.settings);
  EXPECT_EQ(verdictOn(pixel).kind, VerdictKind::None) << remedy.changes.front();
}
