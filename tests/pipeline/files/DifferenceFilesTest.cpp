// Differences as files: in time along the motion, and between settings, against the rows of both sides that
// are exported by themselves and subtracted here.
#include "core/io/FrameFile.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"
#include "core/taa/ChannelNames.h"
#include "tests/support/GlTest.h"
#include "tests/support/Paths.h"
#include "tests/support/Process.h"

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace fs = std::filesystem;
using nlohmann::json;
using taa::Image;
using taa::Intermediate;
using taa::IntermediateId;
using taa::test::ProcessResult;

namespace {

constexpr int kWidth = 64, kHeight = 36, kFrame = 5;
const std::vector<IntermediateId> kRows{IntermediateId::resolved, IntermediateId::color,
                                        IntermediateId::alpha, IntermediateId::rejectReason};

ProcessResult batch(const std::string& command, const std::vector<std::string>& more) {
  std::vector<std::string> arguments{taa::test::binary("taa-batch").string(), command, "builtin:fan",
                                     "--size", "64x36"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return taa::test::runProcess(arguments);
}

std::vector<std::string> channelsOf(IntermediateId id) {
  return taa::channelNames(taa::intermediate(id), taa::preset("balanced").settings.space);
}

bool isSameFloat(float a, float b) {
  return (std::isnan(a) && std::isnan(b)) ||
         std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

/// One channel at a place between four texels: along x, then along y; texels beyond the border are those at
/// it.
float between(const Image& image, const glm::vec2& place, int channel) {
  const auto texel = [&](int x, int y) {
    return image.at(glm::clamp(x, 0, kWidth - 1), glm::clamp(y, 0, kHeight - 1))[channel];
  };
  const int x = static_cast<int>(std::floor(place.x - 0.5f)),
            y = static_cast<int>(std::floor(place.y - 0.5f));
  const float right = place.x - 0.5f - static_cast<float>(x), down = place.y - 0.5f - static_cast<float>(y);
  const auto mixed = [](float a, float b, float share) { return share == 0.0f ? a : a + share * (b - a); };
  return mixed(mixed(texel(x, y), texel(x + 1, y), right), mixed(texel(x, y + 1), texel(x + 1, y + 1), right),
               down);
}

/// Of the texel that a place lies in: reasons are no amounts.
float inTexel(const Image& image, const glm::vec2& place, int channel) {
  return image.at(glm::min(static_cast<int>(place.x), kWidth - 1),
                  glm::min(static_cast<int>(place.y), kHeight - 1))[channel];
}

bool isInside(const glm::vec2& place) {
  return place.x >= 0.0f && place.x <= kWidth && place.y >= 0.0f && place.y <= kHeight;
}

class DifferenceFilesTest : public taa::test::GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    folder_ = taa::test::temporaryFolder() / testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::remove_all(folder_);
  }
  /// Renders one frame into a folder of its own.
  fs::path rendered(const std::string& name, int frame, const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{"--frames", std::to_string(frame), "--out", (folder_ / name).string()};
    for (const IntermediateId id : kRows) {
      arguments.push_back("--emit");
      arguments.emplace_back(taa::intermediate(id).name);
    }
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProcessResult result = batch("render", arguments);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return folder_ / name / ("frame.000" + std::to_string(frame) + ".exr");
  }
  static Image row(const fs::path& file, IntermediateId id) {
    return taa::readPart(file, std::string(taa::intermediate(id).name), channelsOf(id));
  }
  static Image difference(const fs::path& file, IntermediateId id) {
    return taa::readPart(file, std::string(taa::intermediate(id).name) + ".difference", channelsOf(id));
  }

  fs::path folder_;
};

} // namespace

TEST_F(DifferenceFilesTest, InTimeAreThoseOfBothFramesWarpedByHand) {
  const fs::path before = rendered("before", kFrame - 1, {});
  const fs::path now = rendered("now", kFrame, {"--emit", "historyPosition"});
  const fs::path file = rendered("difference", kFrame, {"--compare", "motion:-1"});
  EXPECT_EQ(taa::partNames(file).size(), kRows.size()) << "differences alone";
  const Image places = row(now, IntermediateId::historyPosition);
  int moved = 0, outside = 0;
  for (const IntermediateId id : kRows) {
    const Image own = row(now, id), there = row(before, id), written = difference(file, id);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const glm::vec2 place(places.at(x, y)[0], places.at(x, y)[1]);
        moved += place.x != static_cast<float>(x) + 0.5f ? 1 : 0;
        outside += isInside(place) ? 0 : 1;
        for (int channel = 0; channel < own.channels; ++channel) {
          const float other = !isInside(place)                     ? std::numeric_limits<float>::quiet_NaN()
                              : id == IntermediateId::rejectReason ? inTexel(there, place, channel)
                                                                   : between(there, place, channel);
          ASSERT_TRUE(isSameFloat(written.at(x, y)[channel], own.at(x, y)[channel] - other))
              << taa::intermediate(id).name << " at " << x << ", " << y;
        }
      }
  }
  EXPECT_GT(moved, 0) << "else nothing is tested";
  EXPECT_LT(outside, static_cast<int>(kRows.size()) * kWidth * kHeight);
  EXPECT_EQ(taa::readPartAttribute(file, "alpha.difference", "taa:comparedWith"), "motion:-1");
  EXPECT_EQ(taa::readPartAttribute(file, "alpha.difference", "taa:otherFrame"), "4");
}

TEST_F(DifferenceFilesTest, AreWhatTheProbePrints) {
  const fs::path file = rendered("difference", kFrame, {"--compare", "motion:-1"});
  for (const char* place : {"31,17", "20,11", "40,25"}) {
    const ProcessResult result = batch(
        "probe", {"--frame", std::to_string(kFrame), "--pixel", place, "--json", "--compare", "motion:-1"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const json report = json::parse(result.out);
    for (const IntermediateId id : kRows) {
      const Image written = difference(file, id);
      const std::string name(taa::intermediate(id).name);
      const json printed = report["lanes"][0]["compared"]["rows"][name]["difference"];
      const float* texel = written.at(report["pixel"][0], report["pixel"][1]);
      for (std::size_t channel = 0; channel < channelsOf(id).size(); ++channel) {
        if (printed.is_null()) {
          EXPECT_TRUE(std::isnan(texel[channel])) << name << " at " << place;
          continue;
        }
        EXPECT_EQ(printed[channelsOf(id)[channel]].get<float>(), texel[channel]) << name << " at " << place;
      }
    }
  }
}

TEST_F(DifferenceFilesTest, BetweenSettingsAreThoseOfBothRows) {
  const fs::path own = rendered("own", kFrame, {}), sharp = rendered("sharp", kFrame, {"--preset", "sharp"});
  const fs::path file =
      rendered("difference", kFrame, {"--compare", "preset:sharp", "--compare-as", "difference"});
  double sum = 0.0;
  for (const IntermediateId id : kRows) {
    const Image a = row(own, id), b = row(sharp, id), written = difference(file, id);
    ASSERT_EQ(written.pixels.size(), a.pixels.size());
    for (std::size_t index = 0; index < a.pixels.size(); ++index) {
      ASSERT_EQ(written.pixels[index], a.pixels[index] - b.pixels[index]) << taa::intermediate(id).name;
      sum += std::fabs(static_cast<double>(written.pixels[index]));
    }
  }
  EXPECT_GT(sum, 0.0) << "else nothing is tested";
  EXPECT_EQ(taa::readPartAttribute(file, "resolved.difference", "taa:otherFrame"), "5");
  const json others = json::parse(taa::readPartAttribute(file, "resolved.difference", "taa:otherSettings"));
  EXPECT_EQ(others, taa::toJson(taa::preset("sharp").settings));
}

TEST_F(DifferenceFilesTest, OfTheFirstFrameHaveNoNumbersInTime) {
  const fs::path file = rendered("difference", 0, {"--compare", "motion:-1"});
  for (const IntermediateId id : kRows)
    for (const float value : difference(file, id).pixels)
      ASSERT_TRUE(std::isnan(value)) << taa::intermediate(id).name;
  EXPECT_EQ(taa::readPartAttribute(file, "alpha.difference", "taa:otherFrame"), "");
}
