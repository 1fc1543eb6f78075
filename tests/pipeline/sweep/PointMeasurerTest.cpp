// Points that are measured one after the other: each as if it were the only one.
#include "core/sweep/PointMeasurer.h"

#include "core/sweep/SweepSpec.h"
#include "tests/support/ErrorOf.h"
#include "tests/support/GlTest.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <future>
#include <string>
#include <string_view>

namespace {

using nlohmann::ordered_json;
using taa::SweepSpec;

/// Two sources × two cameras × two values.
SweepSpec spec(const std::string& frames = "[2, 3]") {
  return taa::sweepSpecFromText(R"({"format": 1, "sources": ["builtin:fan", "builtin:thin"],
    "cameras": ["pan", "still"], "size": [48, 28], "metrics": ["rmse", "meanAlpha", "flicker"],
    "referenceSamples": 4, "flickerFrames": 2, "parameters": {"rectify.method": ["clamp", "none"]},
    "frames": )" + frames + "}",
                                "it", "");
}

ordered_json alone(const SweepSpec& of, std::size_t point) {
  const auto measure = [&] { return taa::PointMeasurer(of).measure(taa::sweepPoint(of, point), {}); };
  return std::async(std::launch::async, measure).get();
}

class PointMeasurerTest : public taa::test::GlTest {};

} // namespace

TEST_F(PointMeasurerTest, GivesTheSameNumbersWhateverWasMeasuredBefore) {
  const SweepSpec all = spec();
  const auto measureAll = [&] {
    taa::PointMeasurer measurer(all);
    for (const std::size_t point : {0u, 3u, 1u, 5u, 2u, 0u})
      EXPECT_EQ(measurer.measure(taa::sweepPoint(all, point), {}), alone(all, point)) << point;
  };
  std::async(std::launch::async, measureAll).get();
}

TEST_F(PointMeasurerTest, KeepsTheNumbersOfEachFrameAndTheirMean) {
  const ordered_json point = alone(spec(), 1);
  ASSERT_EQ(point["frames"].size(), 2u);
  EXPECT_EQ(point["frames"][0]["frame"], 2);
  for (const char* metric : {"rmse", "meanAlpha", "flicker"}) {
    const double first = point["frames"][0][metric], second = point["frames"][1][metric];
    EXPECT_DOUBLE_EQ(point["mean"][metric].get<double>(), (first + second) / 2.0) << metric;
  }
  EXPECT_FALSE(point["driver"].get<std::string>().empty());
}

TEST_F(PointMeasurerTest, SaysWhatAShotDoesNotHave) {
  const SweepSpec long_ = spec("[2, 100000]");
  const std::string frames = taa::test::errorOf([&] { alone(long_, 0); });
  EXPECT_NE(frames.find("there is no frame 100000"), std::string::npos) << frames;
  SweepSpec other = spec();
  other.cameras = {"gltf:absent"};
  const std::string camera = taa::test::errorOf([&] { alone(other, 0); });
  EXPECT_NE(camera.find("absent"), std::string::npos) << camera;
}

TEST_F(PointMeasurerTest, StopsWhenItIsTold) {
  const SweepSpec all = spec();
  const auto stopped = [&] {
    taa::PointMeasurer measurer(all);
    const auto stops = [](std::string_view, int, int) { return false; };
    EXPECT_THROW(measurer.measure(taa::sweepPoint(all, 0), stops), taa::Cancelled);
    EXPECT_EQ(measurer.measure(taa::sweepPoint(all, 0), {}), alone(all, 0))
        << "and goes on as if nothing was";
  };
  std::async(std::launch::async, stopped).get();
}
