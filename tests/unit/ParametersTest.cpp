// The parameter table: every field has its row, and every form a value takes reads back to the same bits.
#include "core/settings/Parameters.h"

#include "core/base/Error.h"
#include "core/settings/AssignmentWords.h"
#include "core/settings/Presets.h"
#include "tests/support/ErrorOf.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace taa {
namespace {

// A value of the row that differs from `value`.
double otherValue(const Parameter& row, double value) {
  if (row.kind == ParameterKind::Number) {
    const auto between = [&row](double part) {
      return static_cast<double>(static_cast<float>(row.minimum + part * (row.maximum - row.minimum)));
    };
    return value == between(0.25) ? between(0.75) : between(0.25);
  }
  return value == row.minimum ? row.minimum + 1 : row.minimum;
}

Settings everythingChanged() {
  Settings settings;
  for (const Parameter& row : parameters()) row.set(settings, otherValue(row, row.defaultValue()));
  return settings;
}

TEST(Parameters, AnAssignmentIsToldByTheLabelsOfItsTables) {
  EXPECT_EQ(assignmentWords("rectify.method=clipToFiltered"), "Rectify history ▸ Method: Clip to filtered");
  EXPECT_EQ(assignmentWords("validate.depth=on"), "Validate history ▸ Depth: on");
  EXPECT_EQ(assignmentWords("weight.alpha=0.5"), "Blend weight ▸ α: 0.5");
  EXPECT_EQ(assignmentWords("weight.alpha=0.071428575"), "Blend weight ▸ α: 0.07143");
  EXPECT_EQ(assignmentWords("fault.motionX=-1"), "Faults ▸ Motion x times: −1");
  EXPECT_THROW(assignmentWords("weight.none=1"), Error);
}

TEST(Parameters, HaveOneRowForEachFieldOfTheSettings) {
  ASSERT_EQ(sizeof(Settings), 4 * parameters().size());
  std::set<std::size_t> fields;
  for (const Parameter& row : parameters()) {
    Settings settings;
    std::array<std::uint32_t, sizeof(Settings) / 4> before{}, after{};
    std::memcpy(before.data(), &settings, sizeof(settings));
    row.set(settings, otherValue(row, row.get(settings)));
    std::memcpy(after.data(), &settings, sizeof(settings));
    for (std::size_t i = 0; i < before.size(); ++i)
      if (before[i] != after[i]) {
        EXPECT_TRUE(fields.insert(i).second) << row.path << " shares its field";
        EXPECT_EQ(row.field.offset, 4 * i) << row.path;
      }
    EXPECT_EQ(row.get(settings), otherValue(row, row.defaultValue())) << row.path;
  }
  EXPECT_EQ(fields.size(), parameters().size());
}

TEST(Parameters, AreDescribedCompletely) {
  std::set<std::string_view> paths;
  for (const Parameter& row : parameters()) {
    EXPECT_TRUE(paths.insert(row.path).second) << row.path;
    EXPECT_FALSE(row.label.empty() || row.tooltip.empty() || row.source.empty()) << row.path;
    EXPECT_LT(row.minimum, row.maximum) << row.path;
    EXPECT_GE(row.defaultValue(), row.minimum) << row.path;
    EXPECT_LE(row.defaultValue(), row.maximum) << row.path;
    EXPECT_EQ(row.kind == ParameterKind::Choice, !row.choices.empty()) << row.path;
    if (row.kind == ParameterKind::Choice) {
      EXPECT_EQ(row.maximum + 1, row.choices.size()) << row.path;
    }
    for (const Choice& choice : row.choices)
      EXPECT_FALSE(choice.id.empty() || choice.label.empty() || choice.explanation.empty()) << row.path;
    EXPECT_NO_THROW(isRelevant(row, Settings{})) << row.path;
  }
}

TEST(Parameters, StandInTheOrderOfTheStages) {
  for (std::size_t i = 1; i < parameters().size(); ++i)
    EXPECT_LE(parameters()[i - 1].stage, parameters()[i].stage) << parameters()[i].path;
}

TEST(Parameters, ReadBackFromTextAndJson) {
  const Settings settings = everythingChanged();
  Settings fromText, fromFile;
  for (const std::string& assignment : differences(settings, Settings{}))
    applyAssignment(fromText, assignment);
  fromJson(nlohmann::json::parse(toJson(settings).dump()), fromFile);
  EXPECT_TRUE(fromText == settings);
  EXPECT_TRUE(fromFile == settings);
  EXPECT_EQ(differences(settings, Settings{}).size(), parameters().size());
  EXPECT_TRUE(differences(settings, settings).empty());
}

TEST(Parameters, WriteNumbersAsPeopleDo) {
  EXPECT_EQ(valueText(parameter("weight.minimum"), 0.1f), "0.1");
  EXPECT_EQ(toJson(Settings{})["weight"]["minimum"].dump(), "0.1");
  EXPECT_EQ(valueText(parameter("jitter.period"), 16), "16");
  EXPECT_EQ(valueText(parameter("history.dering"), 1), "on");
}

TEST(Parameters, RefuseWhatTheyCannotTake) {
  Settings settings;
  for (const char* bad :
       {"rectify.method=klamp", "jitter.period=0", "jitter.period=1.5", "jitter.period=1025",
        "weight.alpha=nan", "weight.alpha=1.01", "weight.alpha=-0.1", "weight.alpha=", "weight.alpha=1x",
        "history.dering=maybe", "inputs.renderScale=0.49", "inputs.renderScale=1.01", "rectify.methd=clamp",
        "rectify.method", "=", ""})
    EXPECT_THROW(applyAssignment(settings, bad), Error) << bad;
  EXPECT_TRUE(settings == Settings{});
  for (const char* bad : {R"({"rectify":{"methd":"clamp"}})", R"({"weight":{"alpha":"0.1"}})",
                          R"({"weight":3})", "[]", R"({"blend":{"tone":"luma"},"history":{"dering":1}})"})
    EXPECT_THROW(fromJson(nlohmann::json::parse(bad), settings), Error) << bad;
  EXPECT_TRUE(settings == Settings{});
}

TEST(Parameters, NameWhatIsNearAnUnknownPath) {
  try {
    parameter("rectify.methd");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("rectify.method"), std::string::npos) << error.what();
  }
}

TEST(Parameters, KnowWhenTheyMatter) {
  Settings settings;
  applyAssignment(settings, "neighborhood.box=minMax");
  EXPECT_FALSE(isRelevant(parameter("neighborhood.gamma"), settings));
  applyAssignment(settings, "neighborhood.box=variance");
  EXPECT_TRUE(isRelevant(parameter("neighborhood.gamma"), settings));
  EXPECT_FALSE(isRelevant(parameter("weight.alpha"), settings));
  applyAssignment(settings, "validate.depth=off");
  EXPECT_FALSE(isRelevant(parameter("validate.depthTolerance"), settings));
  EXPECT_TRUE(isRelevant(parameter("current.variance"), settings));
  EXPECT_FALSE(isRelevant(parameter("current.upsample"), settings));
  applyAssignment(settings, "inputs.renderScale=0.75");
  EXPECT_FALSE(isRelevant(parameter("current.filter"), settings));
  EXPECT_FALSE(isRelevant(parameter("current.variance"), settings)) << "of a filter that is not relevant";
  EXPECT_TRUE(isRelevant(parameter("current.upsample"), settings));
}

TEST(Parameters, SayInATextWhenTheyMatter) {
  EXPECT_EQ(relevantWhen(parameter("taa.enabled")), "");
  EXPECT_EQ(relevantWhen(parameter("neighborhood.gamma")), "neighborhood.box=variance|intersection");
  EXPECT_EQ(relevantWhen(parameter("validate.depthTolerance")), "validate.depth=on");
  EXPECT_EQ(relevantWhen(parameter("current.upsample")), "inputs.renderScale<1");
  EXPECT_EQ(relevantWhen(parameter("current.filter")), "inputs.renderScale=1");
}

// So that the question whether a row matters has an answer.
TEST(Parameters, UseRowsThatThereAreAndNotThemselves) {
  const auto expectRows = [](const Parameter& user, const Uses& uses) {
    for (const Field field : uses.all()) {
      EXPECT_EQ(std::ranges::count(parameters(), field, &Parameter::field), 1) << user.path;
      EXPECT_NE(field, user.field) << user.path;
    }
  };
  for (const Parameter& row : parameters()) {
    expectRows(row, row.uses);
    expectRows(row, row.usesOtherwise);
    for (const Choice& choice : row.choices) expectRows(row, choice.uses);
  }
}

TEST(Parameters, ReachTheShaderOrTheInputs) {
  const std::string before = glslPrelude(Settings{});
  const std::vector<std::byte> block = settingsBlock(Settings{});
  for (const Parameter& row : parameters()) {
    Settings settings;
    row.set(settings, otherValue(row, row.get(settings)));
    const bool program = row.effect == Effect::Program || row.effect == Effect::Storage ||
                         row.effect == Effect::Whole ||
                         row.path == "inputs.renderScale"; // through kUpsampled
    EXPECT_EQ(glslPrelude(settings) != before, program) << row.path;
    EXPECT_EQ(programKey(settings) != programKey(Settings{}), program) << row.path;
    EXPECT_EQ(settingsBlock(settings) != block, row.effect == Effect::Uniform) << row.path;
    EXPECT_EQ(!sameInputs(settings, Settings{}), row.effect == Effect::Inputs || row.effect == Effect::Whole)
        << row.path;
  }
  EXPECT_EQ(block.size() % 16, 0u);
}

TEST(Presets, OpenWithTheDefaultsAsBalanced) {
  ASSERT_FALSE(builtinPresets().empty());
  EXPECT_EQ(builtinPresets().front().id, "balanced");
  EXPECT_TRUE(builtinPresets().front().settings == Settings{})
      << ::testing::PrintToString(differences(builtinPresets().front().settings, Settings{}));
}

// What presets.md says of each peer, where the renderer has it.
// Techniques: 1.11.
TEST(Presets, ChooseWhatTheirPeersChoose) {
  const std::vector<std::pair<const char*, std::vector<const char*>>> peers{
      {"playdead",
       {"jitter.period=16", "dilate.method=closest3x3", "dilate.ties=first", "history.filter=bilinear",
        "current.filter=unjitter", "neighborhood.shape=rounded", "neighborhood.box=minMax", "space.color=rgb",
        "rectify.method=clipToCenter", "validate.offScreen=keep", "weight.source=lumaDifference",
        "weight.sourceMax=0.12", "weight.sourceMin=0.03", "history.precision=unorm8", "history.dither=on",
        "blend.tone=none", "output.motionBlur=on", "inputs.range=ldr",
        "inputs.motion=currentProjectionAsPrinted"}},
      {"ue4",
       {"jitter.period=8", "dilate.method=closestX2", "current.variance=0.22", "neighborhood.shape=rounded",
        "space.color=yCoCg", "rectify.method=clipToFiltered", "weight.alpha=0.04", "weight.nearClamp=on",
        "blend.tone=luma"}},
      {"raptor",
       {"jitter.period=2", "jitter.firstIndex=0", "inputs.motion=jitterDifferenceAsPrinted",
        "dilate.method=closest3x3AsPrinted", "history.filter=catmullRom9", "current.filter=mitchellAsPrinted",
        "rectify.method=clampThenClip", "space.color=rgb", "weight.source=lumaDifferenceAsPrinted",
        "blend.tone=lumaAsPrinted", "output.sharpen=lumaRatio", "output.amount=0.1"}},
      {"urp-verylow",
       {"dilate.method=none", "history.filter=bilinear", "neighborhood.shape=cross", "space.color=rgb",
        "rectify.method=clamp", "validate.offScreen=keep", "weight.alpha=0.1"}},
      {"urp-low", {"dilate.method=closestCross", "neighborhood.shape=cross", "validate.offScreen=reject"}},
      {"urp-medium",
       {"dilate.method=closest3x3", "history.filter=bilinear", "space.color=yCoCg",
        "neighborhood.box=intersection", "neighborhood.gamma=0.9", "rectify.method=clamp"}},
      {"urp-high", {"history.filter=catmullRom5", "current.filter=center", "rectify.method=clamp"}},
      {"urp-veryhigh",
       {"current.filter=gaussian", "current.variance=0.22", "current.jitterAware=on",
        "rectify.method=clipToCenter"}},
      {"hdrp-low",
       {"jitter.period=8", "dilate.method=closestXAsPrinted", "space.color=rgb", "neighborhood.shape=cross",
        "neighborhood.box=minMax", "validate.offScreen=margin", "weight.alpha=0.125",
        "output.sharpen=inResolve", "output.amount=0.5", "current.upsample=hdrp"}},
      {"hdrp-medium",
       {"history.filter=cubic5AsPrinted", "history.sharpness=0.35", "neighborhood.shape=cross",
        "neighborhood.gamma=1.5", "neighborhood.contrastGrowth=1.75", "neighborhood.gammaMoving=0.75",
        "neighborhood.gammaSpeed=50", "rectify.method=clipToCenter", "weight.alpha=0.125",
        "weight.motion=doubled", "weight.motionSpeed=50"}},
      {"hdrp-high",
       {"neighborhood.shape=square3x3", "current.filter=gaussian", "current.variance=0.22",
        "weight.motion=doubled", "weight.motionSpeed=50"}},
      {"hdrp-taau",
       {"inputs.renderScale=0.67", "jitter.period=18", "inputs.mipBias=-0.578", "current.upsample=hdrp",
        "neighborhood.shape=square3x3"}},
      {"filament",
       {"jitter.firstIndex=0", "inputs.motion=singleMatrix", "inputs.mipBias=-1",
        "history.filter=catmullRom5", "history.dering=on", "current.filter=lanczos", "current.dering=on",
        "current.upsample=lanczos2", "space.color=rgb", "neighborhood.shape=rounded",
        "rectify.method=clipToFiltered", "weight.alpha=0.12", "blend.tone=maxChannel"}},
      {"donut",
       {"jitter.sequence=msaa8", "dilate.method=longest3x3", "history.filter=catmullRom9",
        "neighborhood.box=variance", "neighborhood.gamma=1", "rectify.method=clamp", "weight.alpha=0.1",
        "weight.sampleDistance=parabola", "weight.minimum=0", "current.upsample=sampleWeight",
        "space.tone=pq", "blend.tone=pq", "history.border=black"}},
      {"intel",
       {"jitter.firstIndex=0", "dilate.method=longest3x3", "history.filter=catmullRom5Corners",
        "history.length=bilinear", "neighborhood.gamma=2", "neighborhood.gammaMoving=0.75",
        "neighborhood.gammaSpeed=128", "validate.depth=on", "validate.speedLimit=128", "rectify.method=clamp",
        "blend.restart=blurred", "weight.source=historyLength", "weight.motion=linear",
        "weight.motionSpeed=128", "blend.length=reciprocal", "output.sharpen=logarithm",
        "output.amount=0.5"}},
      {"miniengine",
       {"jitter.period=8", "jitter.firstIndex=0", "dilate.method=closestCross", "dilate.ties=first",
        "history.length=bilinear", "rectify.method=clipToCenter", "inputs.motion=singleMatrix",
        "validate.depth=on", "validate.speedLimit=64", "space.color=rgb", "neighborhood.shape=pairs",
        "neighborhood.box=minMax", "weight.motion=linear", "weight.motionSpeed=64",
        "blend.length=reciprocal"}},
      {"diligent",
       {"jitter.period=16", "dilate.method=closest3x3", "dilate.ties=first", "history.filter=catmullRom5",
        "history.length=bilinear", "space.color=rgb", "rectify.method=rayToCurrent", "rectify.maxSteps=10",
        "neighborhood.gamma=2.5", "neighborhood.gammaMoving=0.75", "neighborhood.gammaSpeed=4.21875",
        "neighborhood.gammaSpeedIn=lines1080", "weight.minimum=0.0625", "weight.motion=linear",
        "weight.motionSpeed=4.21875", "weight.motionSpeedIn=lines1080", "blend.length=reciprocal"}},
      {"godot",
       {"jitter.period=16",
        "dilate.method=farthest3x3",
        "dilate.ties=first",
        "dilate.upLeft=on",
        "history.filter=catmullRom9",
        "history.length=bilinear",
        "blend.length=countTo16",
        "space.tone=reinhardChannel",
        "space.color=yCoCg",
        "neighborhood.weights=boxLuma",
        "neighborhood.gammaMoving=0.4",
        "neighborhood.gammaSpeed=128",
        "neighborhood.gammaSpeedIn=picture1080",
        "neighborhood.resolutionGamma=on",
        "weight.minimum=0",
        "rectify.method=shrinkAxes",
        "weight.lumaFlicker=on",
        "weight.flickerScale=compressed",
        "validate.velocity=vector",
        "validate.velocityLimit=2.5",
        "validate.velocityGain=0.01",
        "validate.action=decay"}},
      {"fsr2",
       {"jitter.period=8", "dilate.method=closest3x3", "history.filter=lanczos", "space.color=yCoCg",
        "neighborhood.box=intersection", "neighborhood.gamma=1", "rectify.method=clampForget",
        "rectify.locks=on", "rectify.lockFrames=8", "rectify.instability=on", "weight.divergence=on",
        "inputs.mask=autoReactive", "weight.mask=reactive", "validate.depth=on", "blend.tone=maxChannel"}},
      {"bevy",
       {"jitter.period=8", "dilate.method=closestX2", "history.filter=catmullRom5AsPrinted",
        "space.tone=maxChannel", "space.color=yCoCgAsPrinted", "rectify.method=clipToCenter",
        "jitter.projection=columnAsPrinted", "history.length=pixelAsPrinted", "weight.source=confidence",
        "weight.sourceMax=0.1", "weight.sourceMin=0.015", "blend.length=confidence", "inputs.mipBias=-1"}},
      {"falcor",
       {"dilate.method=longest3x3", "history.filter=catmullRom9", "space.color=yCoCg",
        "neighborhood.box=variance", "rectify.method=clamp", "weight.alpha=0.1", "weight.nearClamp=on"}},
      {"raptor-corrected", // what manual §26 says of each defect, D1 to D19
       {"inputs.motion=objects", "dilate.method=closest3x3", "history.filter=catmullRom9",
        "current.filter=mitchell", "current.jitterAware=on", "rectify.method=clampThenClip",
        "weight.source=lumaDifferenceCompressed", "weight.sourceMax=0.12", "weight.sourceMin=0.03",
        "blend.tone=luma", "output.sharpen=lumaRatio", "output.amount=0.1"}},
      {"source000",
       {"jitter.period=16", "history.filter=catmullRom5", "current.lumaWeighted=on",
        "neighborhood.gamma=1.25", "rectify.method=clipToFiltered", "weight.alpha=0.1", "blend.tone=luma"}},
      {"source001",
       {"dilate.method=none", "history.filter=bilinear", "rectify.method=none", "validate.offScreen=keep",
        "weight.alpha=0.1"}},
      {"source002",
       {"dilate.method=closestX", "dilate.ties=last", "history.precision=full", "current.filter=unjitter",
        "space.color=yCoCg", "neighborhood.box=minMax", "neighborhood.unjitter=on",
        "rectify.method=clipToCenter", "weight.alpha=0.05", "weight.motion=added", "weight.motionSpeed=1.08",
        "weight.motionSpeedIn=picture1080", "blend.tone=whitePoint"}},
      {"source004",
       {"jitter.sequence=whiteNoise", "history.filter=bilinear", "rectify.method=none", "validate.depth=on",
        "validate.object=on", "validate.normal=on", "weight.source=historyLength", "blend.length=variance"}}};
  for (const auto& [id, assignments] : peers)
    for (const char* assignment : assignments) {
      Settings wanted = preset(id).settings;
      applyAssignment(wanted, assignment);
      EXPECT_TRUE(wanted == preset(id).settings) << id << " wants " << assignment;
    }
  EXPECT_EQ(std::ranges::count(builtinPresets(), "ours", &Preset::group), 7);
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(wholePresets(), "ours", &Preset::group)) +
                peers.size(),
            wholePresets().size());
}

TEST(Presets, DifferFromEachOtherAndSayWhatTheyAre) {
  for (const Preset& row : builtinPresets()) {
    EXPECT_EQ(std::ranges::count(kPresetGroups, row.group, &PresetGroup::id), 1) << row.id;
    EXPECT_TRUE(row.description.ends_with('.')) << row.id;
    for (const Preset& other : builtinPresets())
      EXPECT_TRUE(&row == &other || !(row.settings == other.settings)) << row.id << " = " << other.id;
  }
}

/// A source's own order, as its text and code have it: what each rung sets besides those before.
/// Whole pipelines, which have settings of their own, stand by their ids.
struct SourceLadder {
  std::string group;
  std::vector<std::pair<std::string, std::string>> rungs; ///< preset, one assignment that it brings in
};

const std::vector<SourceLadder>& sourceLadders() {
  static const std::vector<SourceLadder> ladders{{"source000",
                                                  {{"source000-1", "weight.alpha=1"},
                                                   {"source000-2", "weight.alpha=0.1"},
                                                   {"source000-3", "reproject.method=motion"},
                                                   {"source000-4", "rectify.method=clamp"},
                                                   {"source000-5", "space.color=yCoCg"},
                                                   {"source000-6", "rectify.method=clipToCenter"},
                                                   {"source000-7", "neighborhood.box=variance"},
                                                   {"source000-8", "blend.tone=luma"},
                                                   {"source000-9", "current.filter=gaussian"},
                                                   {"source000-10", "dilate.method=closest3x3"},
                                                   {"source000-11", "history.filter=catmullRom5"},
                                                   {"source000-12", "validate.depth=on"},
                                                   {"source000-13", "weight.motion=squared"},
                                                   {"source000", "inputs.motion=objects"}}},
                                                 {"source001",
                                                  {{"source001-1", "weight.alpha=1"},
                                                   {"source001", "weight.alpha=0.1"},
                                                   {"source001-3", "dilate.method=closest3x3"},
                                                   {"source001-4", "history.filter=catmullRom9"},
                                                   {"source001-5", "current.filter=mitchell"},
                                                   {"source001-6", "rectify.method=clamp"},
                                                   {"source001-7", "rectify.method=clipToCenter"},
                                                   {"source001-8", "neighborhood.box=variance"},
                                                   {"source001-9", "rectify.method=clampThenClip"},
                                                   {"source001-10", "weight.source=contrastPerChannel"},
                                                   {"source001-11", "blend.tone=luma"},
                                                   {"source001-12", "weight.source=lumaDifferenceCompressed"},
                                                   {"raptor", "jitter.period=2"},
                                                   {"raptor-corrected", "jitter.period=4"},
                                                   {"source001-15", "inputs.mipBias=-0.25"},
                                                   {"source001-16", "inputs.unjitterTextures=on"},
                                                   {"source001-17", "inputs.noise=blueNoise"}}},
                                                 {"source002",
                                                  {{"source002-1", "weight.alpha=1"},
                                                   {"source002-2", "weight.alpha=0.05"},
                                                   {"source002-3", "reproject.method=motion"},
                                                   {"source002-4", "validate.offScreen=reject"},
                                                   {"source002-5", "dilate.method=closestX"},
                                                   {"source002-6", "rectify.method=clamp"},
                                                   {"source002-7", "space.color=yCoCg"},
                                                   {"source002-8", "rectify.method=clipToCenter"},
                                                   {"source002-9", "weight.motion=added"},
                                                   {"source002-10", "current.filter=unjitter"},
                                                   {"source002-11", "blend.tone=whitePoint"},
                                                   {"source002", "current.sharpen=laplacianAsPrinted"}}},
                                                 {"source003",
                                                  {{"source003-1", "weight.alpha=1"},
                                                   {"source003-2", "weight.alpha=0.1"},
                                                   {"source003-3", "fault.keepsAtCuts=off"},
                                                   {"source003-4", "inputs.motion=objects"},
                                                   {"urp-verylow", "rectify.method=clamp"},
                                                   {"urp-low", "dilate.method=closestCross"},
                                                   {"urp-medium", "space.color=yCoCg"},
                                                   {"urp-high", "history.filter=catmullRom5"},
                                                   {"urp-veryhigh", "rectify.method=clipToCenter"},
                                                   {"source003-10", "dilate.method=longest3x3"},
                                                   {"source003-11", "space.tone=gamma"},
                                                   {"source003-12", "validate.class=on"},
                                                   {"source003-13", "output.sharpen=rcas"}}},
                                                 {"source004",
                                                  {{"source004-1", "weight.alpha=1"},
                                                   {"source004-2", "weight.source=historyLength"},
                                                   {"source004-3", "reproject.method=motion"},
                                                   {"source004-4", "validate.object=on"},
                                                   {"source004-5", "validate.normal=on"},
                                                   {"source004-6", "weight.source=historyLength"},
                                                   {"source004-7", "weight.minimum=0.1"},
                                                   {"source004", "blend.length=variance"},
                                                   {"source004-9", "weight.sampleDistance=gaussianMoving"}}}};
  return ladders;
}

TEST(Presets, ClimbInTheirSourcesOrder) {
  for (const SourceLadder& source : sourceLadders()) {
    const std::vector<const Preset*> ladder = ladderOf(source.group + "-1");
    ASSERT_EQ(ladder.size(), source.rungs.size()) << source.group;
    for (std::size_t i = 0; i < ladder.size(); ++i) {
      const auto& [id, assignment] = source.rungs[i];
      EXPECT_EQ(ladder[i]->id, id);
      EXPECT_EQ(ladderOf(id), ladder) << id;
      Settings wanted = ladder[i]->settings;
      applyAssignment(wanted, assignment);
      EXPECT_TRUE(wanted == ladder[i]->settings) << id << " has not " << assignment;
      if (i == 0) continue;
      Settings before = ladder[i - 1]->settings;
      applyAssignment(before, assignment);
      EXPECT_FALSE(before == ladder[i - 1]->settings)
          << ladder[i - 1]->id << " has " << assignment << " already";
    }
  }
  EXPECT_TRUE(ladderOf("balanced").empty());
  EXPECT_TRUE(ladderOf("ue4").empty());
  EXPECT_TRUE(ladderOf("no such preset").empty());
}

// Source 000 reprojects by the camera alone until its last chapter, which is all that its whole pipeline
// adds.
TEST(Presets, TheUnityBlogTakesUpObjectsLast) {
  EXPECT_EQ(differences(preset("source000").settings, preset("source000-11").settings),
            std::vector<std::string>{"inputs.motion=objects"});
}

// A step has the number of its place, in the ladder and in its id, and is one change on top of a step before
// it.
TEST(Presets, CountTheirStepsByTheirPlaces) {
  for (const SourceLadder& source : sourceLadders()) {
    const std::vector<const Preset*> ladder = ladderOf(source.group + "-1");
    for (std::size_t i = 0; i < ladder.size(); ++i)
      if (ladder[i]->step > 0) {
        EXPECT_EQ(ladder[i]->step, static_cast<int>(i) + 1) << ladder[i]->id;
        EXPECT_EQ(ladder[i]->id, source.group + "-" + std::to_string(ladder[i]->step));
      }
  }
}

// Menus, the window's list and taa-batch all go by the same order, and the first nine have keys.
TEST(Presets, AreListedByGroupsAndTheFirstNineStayAtHand) {
  std::vector<std::string> groups;
  for (const Preset& row : builtinPresets()) {
    if (groups.empty() || groups.back() != row.group) groups.push_back(row.group);
    const PresetGroup* started = startedGroup(row);
    const bool starts =
        groups.size() > 1 && row.id == std::ranges::find(builtinPresets(), row.group, &Preset::group)->id;
    EXPECT_EQ(started != nullptr, starts) << row.id;
    EXPECT_TRUE(!started || started->id == row.group) << row.id;
  }
  ASSERT_EQ(groups.size(), kPresetGroups.size()) << "no group stands in two places";
  for (std::size_t i = 0; i < groups.size(); ++i) EXPECT_EQ(groups[i], kPresetGroups[i].id);
  for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(builtinPresets()[i].step, 0);
}

TEST(Presets, GoOnFromAnotherPreset) {
  const auto text = [](const std::string& base) {
    return R"({"format": 1, "id": "mine", "label": "Mine", "base": ")" + base +
           R"(", "settings": {"weight": {"alpha": 0.2}}})";
  };
  Settings expected = preset("source000").settings;
  expected.weight.alpha = 0.2f;
  EXPECT_TRUE(presetFromText(text("source000"), "test").settings == expected);
  EXPECT_THROW(presetFromText(text("nothing"), "test"), Error);
}

TEST(Presets, ReadTheNamesOfTheVersionBeforeWithANote) {
  const Preset row = presetFromText(
      R"({"format": 1, "id": "a", "label": "A", "settings": {"weight": {"most": 0.5, "alpha": 0.2}}})",
      "test");
  EXPECT_EQ(row.settings.weight.sourceMax, 0.5f);
  EXPECT_EQ(row.notes, std::vector<std::string>{"weight.most is called weight.sourceMax now"});
  for (const Preset& builtin : builtinPresets()) EXPECT_TRUE(builtin.notes.empty()) << builtin.id;
}

TEST(Presets, ReadBackFromTheirText) {
  for (const Preset& row : builtinPresets()) {
    const Preset again = presetFromText(presetToText(row), "test");
    EXPECT_EQ(again.id, row.id);
    EXPECT_FALSE(row.label.empty() || row.description.empty()) << row.id;
    EXPECT_TRUE(again.settings == row.settings) << row.id;
    EXPECT_TRUE(preset(row.id).settings == row.settings);
  }
}

TEST(Presets, RefuseUnknownNamesFieldsAndFormats) {
  EXPECT_THROW(preset("balancd"), Error);
  EXPECT_THROW(preset("/nowhere/mine.json"), Error);
  EXPECT_THROW(presetFromText("{", "test"), Error);
  EXPECT_THROW(presetFromText(R"({"format":2,"id":"a","label":"A","settings":{}})", "test"), Error);
  EXPECT_THROW(presetFromText(R"({"format":1,"id":"a","label":"A","settings":{},"extra":1})", "test"), Error);
  EXPECT_THROW(presetFromText(R"({"format":1,"label":"A","settings":{}})", "test"), Error);
}

TEST(Presets, SayWhichFieldIsWrong) {
  const auto refusal = [](const std::string& text) {
    return test::errorOf([&] { presetFromText(text, "mine.json"); });
  };
  const std::string start = "cannot read preset mine.json: ";
  EXPECT_EQ(refusal(R"({"format":1,"id":7,"label":"A","settings":{}})"), start + "\"id\" is not text");
  EXPECT_EQ(refusal(R"({"format":1,"id":"a","settings":{}})"), start + "the key \"label\" is missing");
  EXPECT_EQ(refusal("[]"), start + "what the file holds is not an object");
  EXPECT_EQ(refusal(R"({"format":1,"id":"a","label":"A","order":1e20,"settings":{}})"),
            start + "\"order\" wants a whole number from 0 to 1000");
}

} // namespace
} // namespace taa
