// What channels are called: by the settings that made the values, in every file.
#include "core/taa/ChannelNames.h"

#include "core/io/FrameFile.h"
#include "core/io/FrameJson.h"
#include "core/report/TraceText.h"
#include "core/settings/Parameters.h"
#include "tests/support/Paths.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <set>
#include <string>
#include <string_view>
#include <vector>

using namespace taa;

namespace {

using Names = std::vector<std::string>;

/// Axes of the box of each space, by its id (manual §9).
Names axesOf(std::string_view space) {
  if (space == "rgb") return {"R", "G", "B"};
  return space == "yCbCr" ? Names{"Y", "Cb", "Cr"} : Names{"Y", "Co", "Cg"};
}

std::vector<Settings> settingsOfEachSpace() {
  std::vector<Settings> all;
  for (const Choice& choice : parameter("space.color").choices)
    applyAssignment(all.emplace_back(), "space.color=" + std::string(choice.id));
  return all;
}

std::string idOf(const Settings& settings) {
  return std::string(parameter("space.color").choices[static_cast<std::size_t>(settings.space.color)].id);
}

Names keysOf(const nlohmann::ordered_json& json) {
  Names names;
  for (const auto& [name, value] : json.items()) names.push_back(name);
  return names;
}

} // namespace

TEST(ChannelNames, AreAsManyAsChannelsInEverySpace) {
  for (const Settings& settings : settingsOfEachSpace())
    for (const Intermediate& row : kIntermediates) {
      const Names names = channelNames(row, settings.space);
      EXPECT_EQ(static_cast<int>(names.size()), row.channels) << row.name;
      EXPECT_EQ(std::set(names.begin(), names.end()).size(), names.size()) << row.name;
      if (row.visual == Visual::Box) {
        EXPECT_EQ(names, axesOf(idOf(settings))) << row.name;
      }
      if (row.visual == Visual::Color) {
        EXPECT_EQ(names, (Names{"R", "G", "B"})) << row.name;
      }
    }
}

TEST(ChannelNames, OfADifferenceAreThoseOfItsRow) {
  Intermediate row = intermediate(IntermediateId::boxMax);
  row.visual = Visual::Signed;
  EXPECT_EQ(channelNames(row, {ColorSpace::Rgb}), (Names{"R", "G", "B"}));
}

TEST(ChannelNames, InJsonAndCsvAreThoseOfTheSettings) {
  for (const Settings& settings : settingsOfEachSpace()) {
    const Names axes = axesOf(idOf(settings));
    EXPECT_EQ(keysOf(recordJson({}, settings.space)["boxMin"]), axes);
    std::vector<ProbeTrace> traces{{}};
    traces[0].trace.add(1, {});
    const std::vector<IntermediateId> rows{IntermediateId::neighborhoodMean};
    const nlohmann::ordered_json json = traceJson(traces, rows, settings.space);
    EXPECT_EQ(keysOf(json[0]["frames"][0]["values"]["neighborhoodMean"]), axes);
    const std::string first = "probe,frame,x,y,neighborhoodMean." + axes[0] + ",neighborhoodMean." + axes[1] +
                              ",neighborhoodMean." + axes[2] + "\n";
    EXPECT_TRUE(traceCsv(traces, rows, settings.space).starts_with(first)) << first;
    EXPECT_EQ(intermediateJson(intermediate(IntermediateId::boxMax))["channelsBySpace"][idOf(settings)],
              nlohmann::ordered_json(axes));
  }
}

TEST(ChannelNames, InFilesAreThoseOfEachLane) {
  FrameFile frame{"builtin:fan", "still", "a driver", {}, {}};
  for (const Settings& settings : settingsOfEachSpace()) {
    frame.parts.push_back({static_cast<int>(frame.lanes.size()), IntermediateId::boxMin, Image(2, 1, 3)});
    frame.parts.back().image.pixels = {1, 2, 3, 4, 5, 6};
    frame.lanes.push_back({idOf(settings), settings, {}, {}});
  }
  const auto path = test::temporaryFolder() / "spaces.exr";
  writeFrameFile(path, frame);
  for (const FrameLane& lane : frame.lanes)
    EXPECT_EQ(readPart(path, partName(lane, IntermediateId::boxMin), axesOf(lane.name)).pixels,
              frame.parts[0].image.pixels)
        << lane.name;
}

TEST(ChannelNames, OfARowAsSuchAreAllThatItCanHave) {
  EXPECT_EQ(channelNamesText(intermediate(IntermediateId::boxMin)), "R, G, B or Y, Co, Cg or Y, Cb, Cr");
  EXPECT_EQ(channelNamesText(intermediate(IntermediateId::motion)), "X, Y");
}
