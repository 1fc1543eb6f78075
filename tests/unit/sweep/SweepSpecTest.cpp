// Files that say what a sweep goes over: read, or refused with a sentence that names what is wrong.
#include "core/sweep/SweepSpec.h"

#include "core/base/json/Json.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"
#include "tests/support/ErrorOf.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

using taa::Json;
using taa::Metric;
using taa::SweepSpec;
using taa::test::errorOf;

namespace {

/// The least that a file has to say.
Json smallest() {
  return {{"format", 1}, {"sources", {"builtin:fan"}}, {"frames", {4, 7}}};
}

SweepSpec read(const Json& json) {
  return taa::sweepSpecFromText(json.dump(), "it.json", "/folder");
}

SweepSpec withRange(const std::string& path, const Json& value) {
  Json json = smallest();
  json["parameters"][path] = value;
  return read(json);
}

std::vector<double> valuesOf(const std::string& path, const Json& value) {
  return withRange(path, value).ranges.at(0).values;
}

std::string refusal(const std::string& key, const Json& value) {
  Json json = smallest();
  json[key] = value;
  return errorOf([&] { read(json); });
}

void expectWords(const std::string& text, const std::vector<std::string>& words) {
  for (const std::string& word : words) EXPECT_NE(text.find(word), std::string::npos) << text;
}

} // namespace

TEST(SweepSpec, HasOnePointOfBalancedWhereItSaysNoMore) {
  const SweepSpec spec = read(smallest());
  EXPECT_EQ(spec.pointCount(), 1u);
  EXPECT_EQ(spec.settings.at(0).name, "balanced");
  EXPECT_EQ(spec.cameras, std::vector<std::string>{""});
  EXPECT_EQ(spec.first, 4);
  EXPECT_EQ(spec.last, 7);
  EXPECT_FALSE(spec.size);
  for (const taa::MetricInfo& info : taa::kMetrics)
    EXPECT_EQ(std::ranges::count(spec.metrics, info.metric) == 1,
              taa::overTimeOf(info.metric) != taa::OverTime::Parts && !info.isCostly)
        << info.id;
}

TEST(SweepSpec, ReadsAllThatIsThere) {
  Json json = smallest();
  json["sources"] = {"builtin:fan", "models/tree.glb", "/else/where"};
  json["settings"] = {"minimal", {{"name", "mine"}, {"preset", "fsr2"}, {"set", {"weight.minimum=0.25"}}}};
  json["set"] = {"inputs.mipBias=-1"};
  json["parameters"]["rectify.method"] = {"clamp", "none"};
  json["cameras"] = {"pan", "orbit"};
  json["size"] = {64, 36};
  json["metrics"] = {"flicker", "rmse", "psnr"};
  json["referenceSamples"] = 16;
  json["flickerFrames"] = 4;
  json["pareto"] = {"psnr", "flicker"};
  const SweepSpec spec = read(json);
  EXPECT_EQ(spec.pointCount(), 3u * 2u * 2u * 2u);
  EXPECT_EQ(spec.sources[0].path, "builtin:fan");
  EXPECT_EQ(spec.sources[1].name, "models/tree.glb");
  EXPECT_EQ(spec.sources[1].path, "/folder/models/tree.glb");
  EXPECT_EQ(spec.sources[2].path, "/else/where");
  taa::Settings mine = taa::preset("fsr2").settings;
  mine.weight.minimum = 0.25f;
  mine.inputs.mipBias = -1.0f;
  EXPECT_EQ(spec.settings[1].name, "mine");
  EXPECT_TRUE(spec.settings[1].settings == mine);
  EXPECT_EQ(spec.size, glm::ivec2(64, 36));
  EXPECT_EQ(spec.metrics, (std::vector<Metric>{Metric::Flicker, Metric::Rmse, Metric::Psnr}));
  EXPECT_EQ(spec.referenceSamples, 16);
  EXPECT_EQ(spec.flickerFrames, 4);
  EXPECT_EQ(spec.tradeOff, (std::array<Metric, 2>{Metric::Psnr, Metric::Flicker}));
}

TEST(SweepSpec, GoesFromOneEndToTheOtherInEvenSteps) {
  EXPECT_EQ(valuesOf("weight.minimum", {{"from", 0.25}, {"to", 0.75}, {"steps", 5}}),
            (std::vector<double>{0.25, 0.375, 0.5, 0.625, 0.75}));
  EXPECT_EQ(valuesOf("weight.minimum", {{"from", 1}, {"to", 0}, {"steps", 2}, {"scale", "linear"}}),
            (std::vector<double>{1.0, 0.0}));
}

TEST(SweepSpec, GoesByAFactor) {
  EXPECT_EQ(valuesOf("weight.alpha", {{"from", 0.0625}, {"to", 1}, {"steps", 5}, {"scale", "log"}}),
            (std::vector<double>{0.0625, 0.125, 0.25, 0.5, 1.0}));
}

TEST(SweepSpec, TakesWhatAParameterHoldsOfAValueAndEachOnce) {
  // 1, 1.5, 2, 2.5, 3, 3.5, 4: halves are rounded away from 0.
  EXPECT_EQ(valuesOf("jitter.period", {{"from", 1}, {"to", 4}, {"steps", 7}}),
            (std::vector<double>{1.0, 2.0, 3.0, 4.0}));
  EXPECT_EQ(valuesOf("weight.alpha", {0.1, 0.1, 0.2}),
            (std::vector<double>{static_cast<double>(0.1f), static_cast<double>(0.2f)}));
}

TEST(SweepSpec, TakesChoicesAndSwitchesByNameOrAllOfThem) {
  EXPECT_EQ(valuesOf("validate.depth", {true, false}), (std::vector<double>{1.0, 0.0}));
  EXPECT_EQ(valuesOf("validate.depth", "all"), (std::vector<double>{0.0, 1.0}));
  const taa::Parameter& row = taa::parameter("rectify.method");
  EXPECT_EQ(valuesOf("rectify.method", "all").size(), row.choices.size());
  EXPECT_EQ(valuesOf("rectify.method", {"clamp"}), std::vector<double>{taa::parseValue(row, "clamp")});
}

TEST(SweepSpec, NamesAnUnknownKeyAndTheOneNearIt) {
  expectWords(refusal("parametres", Json::object()), {"it.json", "parametres", "parameters"});
  expectWords(refusal("settings", Json::array({{{"name", "a"}, {"presets", "fsr2"}}})),
              {"settings[0].presets", "preset"});
  expectWords(refusal("parameters", {{"weight.alpha", {{"from", 0}, {"to", 1}, {"step", 3}}}}),
              {"parameters.weight.alpha.step", "steps"});
  expectWords(refusal("parameters", {{"weight.alhpa", {0.1}}}), {"weight.alhpa", "weight.alpha"});
}

TEST(SweepSpec, RefusesValuesThatAParameterDoesNotHave) {
  expectWords(refusal("parameters", {{"weight.alpha", {0.1, 1.5}}}), {"weight.alpha", "1.5", "0 to 1"});
  expectWords(refusal("parameters", {{"weight.alpha", {{"from", 0}, {"to", 2}, {"steps", 3}}}}), {"\"2\""});
  expectWords(refusal("parameters", {{"weight.alpha", "all"}}), {"is a number"});
  expectWords(refusal("parameters", {{"rectify.method", {"clmap"}}}), {"clmap", "clamp"});
  expectWords(refusal("parameters", {{"rectify.method", {{"from", 0}, {"to", 1}, {"steps", 2}}}}),
              {"is no number"});
  expectWords(
      refusal("parameters", {{"weight.alpha", {{"from", 0}, {"to", 1}, {"steps", 2}, {"scale", "log"}}}}),
      {"above 0"});
  expectWords(refusal("parameters", {{"weight.alpha", {{"from", 0}, {"to", 1}, {"steps", 1}}}}),
              {"steps", "2 to 1000"});
}

TEST(SweepSpec, RefusesWhatItCannotMeasure) {
  expectWords(refusal("metrics", {"rsme"}), {"rsme", "rmse", "flicker"});
  expectWords(refusal("frames", {7, 4}), {"last frame is before the first"});
  expectWords(refusal("frames", {7}), {"\"frames\" wants [first, last]"});
  expectWords(refusal("frames", {-1, 4}), {"frames[0]", "0 to"});
  expectWords(refusal("size", {64, 70000}), {"size[1]"});
  expectWords(refusal("referenceSamples", 2), {"referenceSamples", "4 to 1024"});
  expectWords(refusal("pareto", {"psnr"}), {"two metrics"});
  expectWords(refusal("sources", Json::array()), {"\"sources\" is empty; name what to go over"});
  expectWords(refusal("settings", {"minimal", "minimal"}), {"two of", "minimal"});
  expectWords(refusal("format", 2), {"its format is 2, this program reads 1"});
  Json json = smallest();
  json["metrics"] = {"rmse", "psnr"};
  json["pareto"] = {"rmse", "flicker"};
  expectWords(errorOf([&] { read(json); }), {"flicker", "not among"});
  json = smallest();
  json["metrics"] = {"rmse"};
  json["referenceSamples"] = 0;
  expectWords(errorOf([&] { read(json); }), {"rmse needs a reference"});
}

TEST(SweepSpec, RefusesMoreThanItsLimits) {
  Json json = smallest();
  const Json thousand = {{"from", 0}, {"to", 1}, {"steps", 1000}};
  json["parameters"] = {{"weight.alpha", thousand},
                        {"weight.minimum", {{"from", 0}, {"to", 1}, {"steps", 100}}}};
  EXPECT_EQ(read(json).pointCount(), taa::kMaxSweepPoints);
  json["sources"] = {"builtin:fan", "builtin:thin"};
  expectWords(errorOf([&] { read(json); }), {"100000 points"});
  // All rows there are: the number of points fits no integer.
  for (const taa::Parameter& row : taa::parameters())
    if (row.kind == taa::ParameterKind::Number)
      json["parameters"][std::string(row.path)] = {
          {"from", row.minimum}, {"to", row.maximum}, {"steps", 1000}};
  expectWords(errorOf([&] { read(json); }), {"100000 points"});
  expectWords(refusal("cameras", std::vector<std::string>(1001, "pan")), {"cameras", "1001", "1000"});
  const std::string large(taa::kMaxSweepBytes + 1, ' ');
  expectWords(errorOf([&] { taa::sweepSpecFromText(large, "it.json", ""); }), {"it.json", "bytes"});
  expectWords(errorOf([] { taa::sweepSpecFromText("{\"format\": 1,", "it.json", ""); }),
              {"before it is whole"});
}

TEST(SweepSpec, TradesTheBestMeasureOfGhostsThereIsForFlicker) {
  EXPECT_EQ(taa::defaultTradeOff({Metric::Psnr, Metric::Rmse, Metric::Flicker, Metric::MeanAlpha})[1],
            Metric::Flicker);
  EXPECT_EQ(taa::defaultTradeOff({Metric::Psnr, Metric::Rmse, Metric::Flicker})[0], Metric::Rmse);
  EXPECT_EQ(taa::defaultTradeOff({Metric::MeanAlpha, Metric::Clipped}),
            (std::array<Metric, 2>{Metric::MeanAlpha, Metric::Clipped}));
  EXPECT_EQ(read(smallest()).tradeOff[1], Metric::Flicker);
}
