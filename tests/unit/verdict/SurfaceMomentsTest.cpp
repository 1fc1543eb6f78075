// What a surface's last moments say by themselves, of moments made by hand.
#include "core/verdict/pixel/SurfaceMoments.h"

#include "core/verdict/pixel/PixelVerdict.h"

#include <gtest/gtest.h>

#include <cmath>
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

TEST(SurfaceMoments, CountSamplesBackToWhereThereWasNoHistoryOrItWasHidden) {
  std::vector<taa::SurfaceMoment> moments(9);
  EXPECT_EQ(taa::availableSamples(moments), 9u);
  moments[6].isUncovered = true;
  EXPECT_EQ(taa::availableSamples(moments), 9u) << "history was kept there";
  taa::twin::at(moments[6].record, taa::IntermediateId::alpha).x = 1.0f;
  EXPECT_EQ(taa::availableSamples(moments), 7u);
  taa::twin::at(moments[2].record, taa::IntermediateId::rejectReason).x = 1.0f;
  EXPECT_EQ(taa::availableSamples(moments), 3u);
}

TEST(SurfaceMoments, MeasureTheMeanOfSamplesAsAScreenShowsIt) {
  std::vector<taa::SurfaceMoment> moments(4);
  for (taa::SurfaceMoment& moment : moments) moment.reference = glm::dvec3(0.5);
  const auto set = [&](std::size_t at, float value) {
    taa::twin::at(moments[at].record, taa::IntermediateId::color) = {value, 0.5f, 0.5f, 0.0f};
  };
  constexpr float kColors[] = {0.9f, 0.1f, 0.9f, 0.5f};
  for (std::size_t at = 0; at < moments.size(); ++at) set(at, kColors[at]);
  EXPECT_NEAR(taa::errorOfMean(moments, 2, taa::IntermediateId::color), 0.0, 1e-7);
  // Of three: 0.5 + 0.4/3, by the curve of sRGB.
  EXPECT_NEAR(taa::errorOfMean(moments, 3, taa::IntermediateId::color),
              1.055 * (std::pow(0.5 + 0.4 / 3.0, 1 / 2.4) - std::pow(0.5, 1 / 2.4)), 1e-6);
}
