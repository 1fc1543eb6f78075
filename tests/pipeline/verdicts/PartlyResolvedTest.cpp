// Frames that are resolved around some pixels only hold there what whole frames hold, bit for bit.
#include "core/inspect/PartlyResolved.h"

#include "core/settings/Parameters.h"
#include "tests/support/GlTest.h"
#include "tests/support/verdicts/SceneShot.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include <initializer_list>
#include <map>
#include <string>
#include <utility>
#include <vector>

using namespace taa;

namespace {

constexpr int kFirst = 6, kLast = 13;
using Colors = std::map<int, glm::dvec3>;

Settings with(Settings settings, std::initializer_list<const char*> assignments) {
  for (const char* assignment : assignments) applyAssignment(settings, assignment);
  return settings;
}

class PartlyResolvedTest : public test::GlTest {
 protected:
  /// Of whole frames.
  static Colors wholeColors(ShotPlayer& player, HistoryHandle history, const Settings& settings,
                            const std::map<int, glm::ivec2>& wanted) {
    ShotState state = player.state();
    state.lanes = {settings};
    Colors colors;
    for (int frame = kFirst; frame <= kLast; ++frame) {
      ShownFrame made;
      player.maker().make(
          state, {.frame = frame, .previous = {history}, .active = {true}, .exposes = false, .inputs = {}},
          made);
      history = made.lanes[0].current;
      if (!wanted.contains(frame)) continue;
      const Image color = history->color.download({wanted.at(frame).x, wanted.at(frame).y, 1, 1});
      colors[frame] = glm::dvec3(color.at(0, 0)[0], color.at(0, 0)[1], color.at(0, 0)[2]);
    }
    return colors;
  }
};

} // namespace

TEST_F(PartlyResolvedTest, HoldsWhatWholeFramesHold) {
  const std::map<int, glm::ivec2> wanted{{10, {76, 44}}, {11, {77, 44}}, {12, {79, 45}}, {13, {80, 45}}};
  const std::vector<std::pair<const char*, const char*>> shots{{"builtin:disocclusion", "unrectified"},
                                                               {"builtin:fan", "balanced"},
                                                               {"builtin:fence", "fsr2"},
                                                               {"builtin:gallery", "hdrp-taau"},
                                                               {"builtin:cut", "raptor"},
                                                               {"builtin:crowd", "balanced"},
                                                               {"builtin:foliage", "sharp"}};
  for (const auto& [source, presetId] : shots) {
    ShotPlayer player(test::kSceneShotPx);
    player.open(test::sceneShot(source, presetId));
    TraceCursor cursor;
    const HistoryHandle before = player.makeInBackground(kFirst - 1, cursor, {}).lanes[0].current;
    const Settings own = player.settings(0);
    PartlyResolved parts(player.onlyLane(0), kFirst, wanted, {});
    for (const Settings& settings :
         {own, with(own, {"rectify.method=clipToFiltered", "validate.depth=on"}),
          with(own, {"reproject.method=inPlace"}), with(own, {"dilate.method=closestX2", "rectify.locks=on"}),
          with(own, {"history.filter=lanczos", "validate.offScreen=keep"})}) {
      const Colors expected = wholeColors(player, before, settings, wanted);
      EXPECT_EQ(parts.colors(player.maker().pass, before, settings, {}), expected) << source;
    }
  }
}

TEST_F(PartlyResolvedTest, ReachesAsFarAsMotionAndFilters) {
  FrameInputs inputs;
  fitInputs({.camera = "", .width = 64, .height = 40, .jitter = {}, .inputs = {}}, inputs);
  Image motion(64, 40, gl::channels(inputs.motion.format()));
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 64; ++x) motion.at(x, y)[0] = x < 32 ? 0.0f : 10.0f;
  inputs.motion.upload(motion);
  // Of what lies four texels around, 24 to 34, those from 32 on come from 22 to 24; seven px around that.
  EXPECT_EQ(historyReach(inputs, {28, 20, 3, 2}), (gl::Rect{15, 9, 24, 24}));
}
