// Traces of probes: which frames are known, α back to where history started, and the text of it all.
#include "core/probe/PixelTrace.h"

#include "core/report/TraceText.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <vector>

using namespace taa;

namespace {

TraceSample sampleOf(float alpha, const glm::vec3& resolved, const glm::ivec2& pixel = {4, 5}) {
  TraceSample sample{pixel, {}};
  twin::at(sample.record, IntermediateId::alpha).x = alpha;
  twin::at(sample.record, IntermediateId::resolved) = glm::vec4(resolved, 0.0f);
  return sample;
}

} // namespace

TEST(PixelTrace, KnowsWhichFramesAreMissing) {
  PixelTrace trace;
  for (const int frame : {7, 2, 3}) trace.add(frame, sampleOf(0.5f, {}));
  EXPECT_EQ(missingFrames(trace, 1, 8), (std::vector{1, 4, 5, 6, 8}));
  EXPECT_EQ(missingFrames(trace, 2, 3), std::vector<int>());
  EXPECT_FALSE(trace.at(4));
  trace.add(7, sampleOf(0.25f, {}));
  EXPECT_EQ(twin::at(trace.at(7)->record, IntermediateId::alpha).x, 0.25f) << "the newest counts";
}

TEST(PixelTrace, GivesAlphasBackToWhereHistoryStarted) {
  PixelTrace trace;
  const float alphas[] = {0.5f, 1.0f, 0.5f, 0.25f, 0.125f};
  for (int frame = 0; frame < 5; ++frame) trace.add(frame, sampleOf(alphas[frame], {}));
  EXPECT_EQ(alphasUpTo(trace, 4, 100), (std::vector{1.0, 0.5, 0.25, 0.125}));
  EXPECT_EQ(alphasUpTo(trace, 4, 2), (std::vector{0.25, 0.125}));
  EXPECT_EQ(alphasUpTo(trace, 0, 100), (std::vector{0.5}));
  EXPECT_TRUE(alphasUpTo(trace, 9, 100).empty());
  trace.add(9, sampleOf(0.5f, {}));
  EXPECT_EQ(alphasUpTo(trace, 9, 100), (std::vector{0.5})) << "up to a gap";
}

TEST(PixelTrace, SamePlacesAskForTheSameValues) {
  const Probe probe{{4, 5}, Follow::Screen, 3, {}};
  EXPECT_TRUE(isSamePlace(probe, {{4, 5}, Follow::Screen, 9, {}}));
  EXPECT_FALSE(isSamePlace(probe, {{4, 6}, Follow::Screen, 3, {}}));
  EXPECT_FALSE(isSamePlace(probe, {{4, 5}, Follow::Surface, 3, {}}));
  const Probe surface{{4, 5}, Follow::Surface, 3, {}};
  EXPECT_TRUE(isSamePlace(surface, {{4, 5}, Follow::Surface, 3, SurfaceAnchor{2, {}, {}}}));
  EXPECT_FALSE(isSamePlace(surface, {{4, 5}, Follow::Surface, 4, {}}));
}

TEST(TraceText, WritesALineForEachFrameOfEachProbe) {
  std::vector<ProbeTrace> traces{{{{4, 5}, Follow::Screen, 0, {}}, {}},
                                 {{{6, 7}, Follow::Surface, 1, {}}, {}}};
  traces[0].trace.add(2, sampleOf(0.1f, {0.25f, 0.5f, 1.0f}));
  traces[0].trace.add(1, sampleOf(1.0f, {0.0f, 0.0f, 0.0f}));
  traces[1].trace.add(1, sampleOf(0.5f, {1.0f, 2.0f, 3.0f}, {9, 8}));
  const std::vector<IntermediateId> rows{IntermediateId::alpha, IntermediateId::resolved};
  EXPECT_EQ(traceCsv(traces, rows, {}), "probe,frame,x,y,alpha,resolved.R,resolved.G,resolved.B\n"
                                        "1,1,4,5,1,0,0,0\n"
                                        "1,2,4,5,0.1,0.25,0.5,1\n"
                                        "2,1,9,8,0.5,1,2,3\n");
  const nlohmann::ordered_json json = traceJson(traces, rows, {});
  ASSERT_EQ(json.size(), 2u);
  EXPECT_EQ(json[0]["frames"][1]["values"]["alpha"].dump(), "0.1");
  EXPECT_EQ(json[1]["follow"], "surface");
  EXPECT_EQ(json[1]["frames"][0]["pixel"].dump(), "[9,8]");
  EXPECT_EQ(json[1]["frames"][0]["values"]["resolved"]["B"].dump(), "3.0");
}
