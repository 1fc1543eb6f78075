// Points of sweeps: their order, their parts, and what their numbers are a function of.
#include "core/sweep/SweepPoints.h"

#include "core/settings/Presets.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <set>
#include <string>
#include <vector>

using taa::SweepPoint;
using taa::SweepSpec;

namespace {

/// 2 sources × 1 camera × 2 settings × 3 values × 2 values.
SweepSpec spec() {
  return taa::sweepSpecFromText(R"({"format": 1, "frames": [2, 3], "sources": ["builtin:fan", "builtin:thin"],
    "settings": ["balanced", "minimal"], "metrics": ["rmse", "flicker"],
    "parameters": {"weight.minimum": [0.25, 0.5, 0.75], "rectify.method": ["clamp", "none"]}})",
                                "it", "");
}

std::string inputsOf(const SweepSpec& of, std::size_t index = 0) {
  return taa::SweepGround(of).inputs(of, taa::sweepPoint(of, index)).dump();
}

} // namespace

TEST(SweepPoints, GoOverTheLastRangeFirstAndTheSourcesLast) {
  const SweepSpec all = spec();
  ASSERT_EQ(all.pointCount(), 24u);
  // Ranges in the order of the table: rectify before weight.
  const SweepPoint second = taa::sweepPoint(all, 1);
  EXPECT_EQ(second.values, (std::vector<std::size_t>{0, 1}));
  const SweepPoint fourth = taa::sweepPoint(all, 3);
  EXPECT_EQ(fourth.values, (std::vector<std::size_t>{1, 0}));
  const SweepPoint last = taa::sweepPoint(all, 23);
  EXPECT_EQ(last.index, 23u);
  EXPECT_EQ(last.source, 1u);
  EXPECT_EQ(last.settings, 1u);
  EXPECT_EQ(last.values, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(taa::sweepPoint(all, 6).settings, 1u);
  EXPECT_EQ(taa::sweepPoint(all, 12).source, 1u);
}

TEST(SweepPoints, HaveTheirSettingsWithTheirValues) {
  const SweepSpec all = spec();
  taa::Settings expected = taa::preset("minimal").settings;
  applyAssignment(expected, "rectify.method=none");
  applyAssignment(expected, "weight.minimum=0.75");
  EXPECT_TRUE(taa::settingsOfPoint(all, taa::sweepPoint(all, 23)) == expected);
}

TEST(SweepPoints, AreSharedOutWithoutGapOrOverlap) {
  for (const std::size_t count : {1u, 2u, 3u, 7u, 40u}) {
    std::size_t end = 0;
    for (std::size_t index = 1; index <= count; ++index) {
      const taa::PointRange part = taa::pointsOfShard({index, count}, 24);
      EXPECT_EQ(part.first, end) << index << " of " << count;
      EXPECT_LE(part.end - part.first, 24 / count + 1);
      end = part.end;
    }
    EXPECT_EQ(end, 24u);
  }
}

// The published values of FNV-1a, 64 bits (Fowler, Noll, Vo).
TEST(SweepPoints, AreKnownByAPublishedDigest) {
  EXPECT_EQ(taa::digestOf(""), "cbf29ce484222325");
  EXPECT_EQ(taa::digestOf("a"), "af63dc4c8601ec8c");
  EXPECT_EQ(taa::digestOf("foobar"), "85944171f73967e8");
}

TEST(SweepPoints, DependOnAllThatTheyAreMadeFrom) {
  std::set<std::string> known;
  for (std::size_t index = 0; index < spec().pointCount(); ++index) known.insert(inputsOf(spec(), index));
  EXPECT_EQ(known.size(), spec().pointCount());
  const std::string first = inputsOf(spec());
  const auto changes = [&](auto change) {
    SweepSpec other = spec();
    change(other);
    return inputsOf(other) != first;
  };
  EXPECT_TRUE(changes([](SweepSpec& other) { other.last = 4; }));
  EXPECT_TRUE(changes([](SweepSpec& other) { other.size = {{64, 36}}; }));
  EXPECT_TRUE(changes([](SweepSpec& other) { other.cameras = {"pan"}; }));
  EXPECT_TRUE(changes([](SweepSpec& other) { other.metrics.pop_back(); }));
  EXPECT_TRUE(changes([](SweepSpec& other) { other.referenceSamples = 16; }));
  EXPECT_TRUE(changes([](SweepSpec& other) { other.flickerFrames = 8; }));
  EXPECT_TRUE(changes([](SweepSpec& other) { other.settings[0].settings.jitter.period = 3; }));
  // What it is called, and what other points there are, changes nothing.
  EXPECT_FALSE(changes([](SweepSpec& other) { other.settings[0].name = "another"; }));
  EXPECT_FALSE(changes([](SweepSpec& other) { other.sources.pop_back(); }));
}
