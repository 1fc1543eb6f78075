// Multi-part EXR: what is written reads back bit for bit, by name.
#include "core/io/FrameFile.h"

#include "core/base/Files.h"
#include "core/settings/Parameters.h"
#include "core/taa/ChannelNames.h"
#include "tests/support/ErrorOf.h"
#include "tests/support/Paths.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace fs = std::filesystem;
using taa::IntermediateId;
using taa::test::errorOf;

namespace {

/// Values of all magnitudes, with what a broken pixel can hold in front.
taa::Image oddImage(IntermediateId id, unsigned seed) {
  taa::Image image(7, 5, taa::intermediate(id).channels);
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> exponent(-30.0f, 30.0f);
  for (float& value : image.pixels) value = std::exp2(exponent(random)) * (random() % 2 ? 1.0f : -1.0f);
  const float odd[] = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -0.0f,
                       std::numeric_limits<float>::denorm_min(), std::numeric_limits<float>::max()};
  std::ranges::copy(odd, image.pixels.begin());
  return image;
}

bool sameBits(const taa::Image& a, const taa::Image& b) {
  return a.width == b.width && a.height == b.height && a.channels == b.channels &&
         std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(float)) == 0;
}

taa::FrameFile everything(const std::vector<std::string>& lanes) {
  taa::FrameFile frame{"builtin:fan", "still", "a driver", {}, {}};
  for (const std::string& name : lanes) {
    taa::FrameLane lane{name, {}, {}, {}};
    lane.info = {42, 0.7, 10, {0.25f, -0.125f}, false};
    for (int element = 0; element < 16; ++element)
      lane.block.clipFromWorld[element / 4][element % 4] = static_cast<float>(element);
    frame.lanes.push_back(lane);
    for (const taa::Intermediate& row : taa::kIntermediates)
      frame.parts.push_back({static_cast<int>(frame.lanes.size()) - 1, row.id,
                             oddImage(row.id, static_cast<unsigned>(frame.parts.size()))});
  }
  return frame;
}

fs::path exrPath(const std::string& name) {
  return taa::test::temporaryFolder() / (name + ".exr");
}

} // namespace

TEST(FrameFile, ReadsBackEveryPartBitForBit) {
  const taa::FrameFile frame = everything({""});
  writeFrameFile(exrPath("all"), frame);
  const std::vector<std::string> names = taa::partNames(exrPath("all"));
  ASSERT_EQ(names.size(), taa::kIntermediateCount);
  for (const taa::FramePart& part : frame.parts) {
    const taa::Intermediate& row = taa::intermediate(part.id);
    EXPECT_EQ(names[static_cast<std::size_t>(part.id)], row.name);
    const taa::Image read = taa::readPart(exrPath("all"), std::string(row.name), taa::channelNames(row, {}));
    EXPECT_TRUE(sameBits(read, part.image)) << row.name;
  }
}

TEST(FrameFile, PutsTheLaneBeforeTheName) {
  const taa::FrameFile frame = everything({"A", "B"});
  writeFrameFile(exrPath("lanes"), frame);
  const taa::Image b = taa::readPart(exrPath("lanes"), "B.motion",
                                     taa::channelNames(taa::intermediate(IntermediateId::motion), {}));
  EXPECT_TRUE(sameBits(
      b, frame.parts[taa::kIntermediateCount + static_cast<std::size_t>(IntermediateId::motion)].image));
  EXPECT_EQ(taa::readPartAttribute(exrPath("lanes"), "B.motion", "taa:lane"), "B");
}

TEST(FrameFile, CarriesHowTheFrameCameAbout) {
  taa::FrameFile frame = everything({""});
  taa::applyAssignment(frame.lanes[0].settings, "rectify.method=clamp");
  writeFrameFile(exrPath("attributes"), frame);
  const auto attribute = [](const std::string& name) {
    return taa::readPartAttribute(exrPath("attributes"), "alpha", "taa:" + name);
  };
  EXPECT_EQ(attribute("source"), "builtin:fan");
  EXPECT_EQ(attribute("camera"), "still");
  EXPECT_EQ(attribute("driver"), "a driver");
  EXPECT_EQ(attribute("frame"), "42");
  EXPECT_EQ(attribute("jitterIndex"), "10");
  EXPECT_EQ(attribute("jitterPx"), "0.25, -0.125");
  EXPECT_EQ(attribute("clipFromWorld"), "0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15");
  EXPECT_EQ(attribute("nothing"), "");
  taa::Settings settings;
  taa::fromJson(nlohmann::json::parse(attribute("settings")), settings);
  EXPECT_TRUE(settings == frame.lanes[0].settings);
}

TEST(FrameFile, NamesThePartsThereAre) {
  writeFrameFile(exrPath("names"), everything({""}));
  const std::string message = errorOf([] { taa::readPart(exrPath("names"), "velocity", {"X"}); });
  EXPECT_NE(message.find("no part \"velocity\""), std::string::npos) << message;
  EXPECT_NE(message.find("motion"), std::string::npos) << message;
}

TEST(FrameFile, NamesTheChannelsThereAre) {
  writeFrameFile(exrPath("channels"), everything({""}));
  const std::string message = errorOf([] { taa::readPart(exrPath("channels"), "color", {"Q"}); });
  EXPECT_NE(message.find("it has R, G, B"), std::string::npos) << message;
}

TEST(FrameFile, SaysWhyItCannotBeRead) {
  EXPECT_NE(errorOf([] { taa::partNames("/nowhere/a.exr"); }).find("/nowhere/a.exr"), std::string::npos);
  taa::writeFile(exrPath("broken"), "this is no picture");
  EXPECT_NE(errorOf([] { taa::partNames(exrPath("broken")); }).find("broken.exr"), std::string::npos);
}

TEST(FrameFile, LeavesNothingWhereItCannotBeWritten) {
  const fs::path path = taa::test::temporaryFolder() / "no folder" / "a.exr";
  EXPECT_NE(errorOf([&] { writeFrameFile(path, everything({""})); }).find(path.string()), std::string::npos);
  EXPECT_FALSE(fs::exists(path.parent_path()));
}

TEST(FrameFile, SaysOfADifferenceWhatItIsFrom) {
  taa::FrameFile frame{"builtin:fan", "still", "a driver", {}, {}};
  frame.lanes = {{"A", {}, {}, {}}, {"B", {}, {}, {}}};
  taa::applyAssignment(frame.lanes[1].settings, "rectify.method=none");
  const taa::Image image = oddImage(IntermediateId::alpha, 1);
  frame.parts.push_back(
      {0, IntermediateId::alpha, image, taa::FrameDifference{"preset:raw", IntermediateId::alpha, 1, 7}});
  EXPECT_EQ(partName(frame.lanes[0], frame.parts[0]), "A.alpha.difference");
  writeFrameFile(exrPath("difference"), frame);
  const auto attribute = [](const std::string& name) {
    return taa::readPartAttribute(exrPath("difference"), "A.alpha.difference", "taa:" + name);
  };
  EXPECT_EQ(attribute("comparedWith"), "preset:raw");
  EXPECT_EQ(attribute("otherRow"), "alpha");
  EXPECT_EQ(attribute("otherFrame"), "7");
  EXPECT_EQ(nlohmann::json::parse(attribute("otherSettings")), toJson(frame.lanes[1].settings));
  const taa::Intermediate& row = taa::intermediate(IntermediateId::alpha);
  EXPECT_TRUE(sameBits(taa::readPart(exrPath("difference"), "A.alpha.difference", taa::channelNames(row, {})),
                       image));
}
