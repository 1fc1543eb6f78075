// Probes that follow surfaces: where they are is a function of the frame, and what they show is their
// surface.
#include "tests/support/SmallInspector.h"

#include <glm/geometric.hpp>

#include <cstddef>
#include <vector>

using namespace taa;
using ProbeSpotTest = taa::test::small::InspectorTest;

namespace {

Probe onSurface(Inspector& inspector, glm::ivec2 pixel) {
  return inspector.probes().anchored({pixel, Follow::Surface, inspector.shot().frame(), {}});
}

} // namespace

TEST_F(ProbeSpotTest, StartInTheMiddleOfTheirPixel) {
  auto inspector = opened();
  for (const int frame : {0, 7})
    for (const glm::ivec2 pixel :
         {glm::ivec2(5, 5), glm::ivec2(30, 11), glm::ivec2(24, 20), glm::ivec2(40, 2)}) {
      inspector->shot().seek(frame);
      const Probe probe = onSurface(*inspector, pixel);
      const ProbeSpot spot = inspector->probes().spot(probe);
      EXPECT_EQ(spot.state, ProbeState::Seen);
      // At an edge the sample lies on a surface that does not cover the middle.
      EXPECT_LT(glm::distance(spot.position, glm::vec2(pixel) + 0.5f), 0.75f) << pixel.x << ' ' << pixel.y;
    }
}

// The steps a probe makes are the motion vectors of its surface, whether it turns, deforms or stands.
TEST_F(ProbeSpotTest, MoveAsTheMotionOfTheirSurface) {
  int compared = 0;
  for (const char* source : {"builtin:fan", "builtin:foliage", "builtin:crowd"}) {
    Inspector inspector;
    inspector.shot().setSize(160, 90);
    inspector.shot().open(source);
    inspector.shot().seek(4);
    std::vector<Probe> probes;
    std::vector<glm::vec2> before;
    for (int index = 0; index < 12; ++index) {
      probes.push_back(onSurface(inspector, {20 + 40 * (index % 4), 20 + 25 * (index / 4)}));
      before.push_back(inspector.probes().spot(probes.back()).position);
    }
    for (int frame = 5; frame < 8; ++frame) {
      inspector.shot().seek(frame);
      for (std::size_t index = 0; index < probes.size(); ++index) {
        const ProbeSpot spot = inspector.probes().spot(probes[index]);
        const twin::PixelRecord record = inspector.probes().probe(spot.pixel.x, spot.pixel.y);
        const auto seen = static_cast<int>(twin::at(record, IntermediateId::objectId).x);
        const bool isOwn = spot.state == ProbeState::Seen && seen == probes[index].anchor->object;
        const glm::vec2 step = spot.position - before[index];
        before[index] = spot.position;
        if (!isOwn) continue;
        const glm::vec2 motion(twin::at(record, IntermediateId::motion));
        EXPECT_LT(glm::distance(step, motion), 0.05f + 0.15f * glm::length(motion))
            << source << " probe " << index << " frame " << frame;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 80);
}

TEST_F(ProbeSpotTest, AreWhereTheyAreHoweverTheFrameWasReached) {
  auto inspector = opened();
  inspector->shot().seek(3);
  const Probe probe = onSurface(*inspector, {30, 11});
  std::vector<glm::vec2> forward;
  for (int frame = 3; frame < 12; ++frame) {
    inspector->shot().seek(frame);
    forward.push_back(inspector->probes().spot(probe).position);
  }
  const Probe again = inspector->probes().anchored({{30, 11}, Follow::Surface, 3, {}});
  EXPECT_EQ(again, probe) << "looked up from another frame";
  for (int frame = 11; frame >= 3; --frame) {
    inspector->shot().seek(frame);
    EXPECT_EQ(inspector->probes().spot(again).position, forward[static_cast<std::size_t>(frame - 3)]);
  }
}

TEST_F(ProbeSpotTest, SayWhenTheirSurfaceIsHiddenOrGone) {
  auto inspector = opened();
  int hidden = 0;
  inspector->shot().seek(0);
  std::vector<Probe> probes;
  for (int x = 8; x < 40; x += 2) probes.push_back(onSurface(*inspector, {x, 11}));
  for (int frame = 1; frame < 30; ++frame) {
    inspector->shot().seek(frame);
    for (const Probe& probe : probes) {
      const ProbeSpot spot = inspector->probes().spot(probe);
      const auto record = inspector->probes().probe(spot.pixel.x, spot.pixel.y);
      if (spot.state != ProbeState::Hidden) continue;
      ++hidden;
      EXPECT_LT(twin::at(record, IntermediateId::depthView).x, spot.viewDepth);
    }
  }
  EXPECT_GT(hidden, 0) << "the blades of the fan sweep over the wall";
  Probe lost = probes.front();
  lost.anchor->object = 10000;
  EXPECT_EQ(inspector->probes().spot(lost).state, ProbeState::Gone);
}

TEST_F(ProbeSpotTest, OfTheScreenStay) {
  auto inspector = opened();
  inspector->shot().seek(9);
  const ProbeSpot spot = inspector->probes().spot(inspector->probes().anchored({.pixel = {3, 4}}));
  EXPECT_EQ(spot.pixel, glm::ivec2(3, 4));
  EXPECT_EQ(spot.state, ProbeState::Seen);
  EXPECT_EQ(inspector->probes().spot({.pixel = {300, 4}}).state, ProbeState::OffScreen);
}
