// Values and tables as JSON.
#include "core/io/FrameJson.h"
#include "core/base/NumberText.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

TEST(FrameJson, WritesTheShortestDecimalThatReadsBack) {
  EXPECT_EQ(taa::shortestText(0.1f), "0.1");
  EXPECT_EQ(taa::floatJson(0.1f).dump(), "0.1");
  EXPECT_EQ(taa::shortestText(-0.0f), "-0");
  std::mt19937 random(7);
  for (int count = 0; count < 10000; ++count) {
    const float value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    if (value - value != 0.0f) continue; // Inf and NaN: the next test
    const std::string text = taa::floatJson(value).dump();
    EXPECT_EQ(std::bit_cast<std::uint32_t>(std::strtof(text.c_str(), nullptr)),
              std::bit_cast<std::uint32_t>(value))
        << text;
    EXPECT_EQ(std::bit_cast<std::uint32_t>(nlohmann::json::parse(text).get<float>()),
              std::bit_cast<std::uint32_t>(value))
        << text;
  }
}

TEST(FrameJson, WritesWhatIsNoNumberAsText) {
  EXPECT_EQ(taa::floatJson(std::numeric_limits<float>::quiet_NaN()).dump(), "\"nan\"");
  EXPECT_EQ(taa::floatJson(std::numeric_limits<float>::infinity()).dump(), "\"inf\"");
  EXPECT_EQ(taa::floatJson(-std::numeric_limits<float>::infinity()).dump(), "\"-inf\"");
}

TEST(FrameJson, GivesEveryRowOfARecordItsChannels) {
  taa::twin::PixelRecord record{};
  taa::twin::at(record, taa::IntermediateId::motion) = {1.5f, -2.0f, 9.0f, 9.0f};
  const nlohmann::ordered_json json = taa::recordJson(record, {});
  EXPECT_EQ(json.size(), taa::kIntermediateCount);
  for (const taa::Intermediate& row : taa::kIntermediates)
    EXPECT_EQ(json[std::string(row.name)].size(), static_cast<std::size_t>(row.channels)) << row.name;
  EXPECT_EQ(json["motion"].dump(), R"({"X":1.5,"Y":-2.0})");
}

TEST(FrameJson, DescribesParametersByTheirKind) {
  for (const taa::Parameter& row : taa::parameters()) {
    const nlohmann::ordered_json json = taa::parameterJson(row);
    EXPECT_EQ(json.contains("choices"), row.kind == taa::ParameterKind::Choice) << row.path;
    EXPECT_EQ(json.contains("minimum"),
              row.kind == taa::ParameterKind::Integer || row.kind == taa::ParameterKind::Number)
        << row.path;
  }
}
