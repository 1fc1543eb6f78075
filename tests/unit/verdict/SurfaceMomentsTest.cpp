// What a surface's last moments say by themselves, of moments made by hand.
#include "core/verdict/pixel/SurfaceMoments.h"

#include "core/verdict/pixel/PixelVerdict.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

using taa::IntermediateId;
using taa::SurfaceMoment;

namespace {

/// Truth is 0.25 as shown; every other moment shows 0.25 + `more`.
std::vector<SurfaceMoment> alternating(double more) {
  std::vector<SurfaceMoment> moments(8);
  for (std::size_t age = 0; age < moments.size(); ++age) {
    moments[age].reference = glm::dvec3(0.25);
    moments[age].resolved = glm::dvec3(age % 2 == 0 ? 0.25 : 0.25 + more);
  }
  return moments;
}

} // namespace

TEST(SurfaceMoments, TrembleByWhatTheyStandOutFromThoseBeside) {
  EXPECT_EQ(taa::flickerOf(alternating(0.0)), 0.0);
  const double step = taa::shownValue(glm::dvec3(0.35)).x - taa::shownValue(glm::dvec3(0.25)).x;
  EXPECT_NEAR(taa::flickerOf(alternating(0.1)), step, 1e-12);
  std::vector<SurfaceMoment> few = alternating(0.1);
  few.resize(5);
  EXPECT_EQ(taa::flickerOf(few), 0.0)
      << "three of them have both neighbors: a single moment could be all of it";
  std::vector<SurfaceMoment> moving = alternating(0.1);
  for (SurfaceMoment& moment : moving) moment.reference = moment.resolved;
  EXPECT_EQ(taa::flickerOf(moving), 0.0) << "as truth does";
  for (std::size_t age = 0; age < 8; ++age) { // an edge that passes once, as where a surface comes into sight
    std::vector<SurfaceMoment> once = alternating(0.0);
    once[age].resolved = glm::dvec3(0.1);
    EXPECT_EQ(taa::flickerOf(once), 0.0) << age;
  }
}

TEST(SurfaceMoments, AreAHighlightWhereAnythingIsBrighterThanWhite) {
  std::vector<SurfaceMoment> moments = alternating(0.1);
  EXPECT_FALSE(taa::isHighlight(moments));
  taa::twin::at(moments[3].record, IntermediateId::currentFiltered) = {0.1f, 1.5f, 0.1f, 0.0f};
  EXPECT_TRUE(taa::isHighlight(moments));
}

TEST(SurfaceMoments, WereBehindWhatIsNearerAndWasRejectedByDepth) {
  taa::twin::PixelRecord record{};
  taa::twin::at(record, IntermediateId::rejectReason).x = 4.0f; // depth
  taa::twin::at(record, IntermediateId::depthExpected).x = 5.0f;
  EXPECT_FALSE(taa::wasBehind(record)) << "the sky";
  taa::twin::at(record, IntermediateId::historyDepth).x = 3.0f;
  EXPECT_TRUE(taa::wasBehind(record));
  taa::twin::at(record, IntermediateId::historyDepth).x = 6.0f;
  EXPECT_FALSE(taa::wasBehind(record));
  taa::twin::at(record, IntermediateId::historyDepth).x = 3.0f;
  taa::twin::at(record, IntermediateId::rejectReason).x = 0.0f;
  EXPECT_FALSE(taa::wasBehind(record)) << "not rejected";
}
