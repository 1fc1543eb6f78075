// The pixel under other choices: the present one's row is the probe's, another's is what the resolve makes.
#include "tests/support/SmallInspector.h"

#include "core/settings/Presets.h"
#include "tests/support/Paths.h"
#include "tests/support/Process.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>
#include <vector>

using namespace taa;
using WhatIfTest = taa::test::small::InspectorTest;

namespace {

glm::vec3 resolvedAt(Inspector& inspector, const glm::ivec2& pixel) {
  return glm::vec3(twin::at(inspector.probes().probe(pixel.x, pixel.y), IntermediateId::resolved));
}

const std::vector<glm::ivec2> kPixels{{0, 0}, {30, 11}, {24, 20}, {47, 26}};

} // namespace

TEST_F(WhatIfTest, TheRowOfThePresentChoicesIsTheProbe) {
  if (!isExact()) GTEST_SKIP() << "this driver rounds its own way";
  for (const char* id : {"balanced", "fsr2", "karis2014", "performance"}) {
    const auto& presets = wholePresets();
    const auto found = std::ranges::find(presets, std::string(id), &Preset::id);
    if (found == presets.end()) continue;
    Settings settings = found->settings;
    settings.inputs.renderScale = 1.0f;
    auto inspector = opened({settings});
    inspector->shot().seek(9);
    for (const glm::ivec2& pixel : kPixels) {
      const glm::vec3 probed = resolvedAt(*inspector, pixel);
      int current = 0;
      for (const WhatIfRow& row : inspector->probes().whatIf(pixel.x, pixel.y)) {
        if (!row.isCurrent) continue;
        ++current;
        EXPECT_EQ(row.resolved, probed) << id << ": " << row.label << " at " << pixel.x << ' ' << pixel.y;
        EXPECT_EQ(row.difference, glm::vec3(0.0f));
      }
      EXPECT_GE(current, 3) << "rectification, box and filter";
    }
  }
}

TEST_F(WhatIfTest, AnotherRowIsWhatTheResolveMakesOfTheSameHistory) {
  if (!isExact()) GTEST_SKIP() << "this driver rounds its own way";
  auto inspector = opened();
  inspector->shot().seek(9);
  const Settings own = inspector->shot().settings();
  for (const Variant& variant : variantsOf(own)) {
    if (variant.group == WhatIfGroup::Preset) continue;
    const auto before = inspector->probes().whatIf(30, 11);
    const auto row = std::ranges::find_if(before, [&](const WhatIfRow& candidate) {
      return candidate.group == variant.group && candidate.id == variant.id;
    });
    ASSERT_NE(row, before.end());
    inspector->shot().setSettings(variant.settings); // answered on the history at hand
    EXPECT_EQ(row->resolved, resolvedAt(*inspector, {30, 11})) << variant.label;
    inspector->shot().setSettings(own);
  }
}

TEST_F(WhatIfTest, HasEveryChoiceAndSaysWhatDoesNotCount) {
  Settings settings;
  const std::vector<Variant> variants = variantsOf(settings);
  std::size_t expected = wholePresets().size() - 1; // all but that without TAA
  for (const char* path : {"rectify.method", "neighborhood.box", "history.filter"})
    expected += parameter(path).choices.size();
  EXPECT_EQ(variants.size(), expected);
  for (const Variant& variant : variants) {
    EXPECT_TRUE(sameInputs(variant.settings, settings)) << variant.label;
    if (variant.group != WhatIfGroup::Preset) {
      EXPECT_EQ(variant.note, "") << variant.label;
      EXPECT_EQ(variant.isCurrent, variant.settings == settings) << variant.label;
    }
  }
  EXPECT_TRUE(std::ranges::any_of(variants, [](const Variant& v) { return v.note.find("jitter") == 0; }));
}

TEST_F(WhatIfTest, IsPrintedByTheCommandLine) {
  const std::vector<std::string> command{test::binary("taa-batch").string(),
                                         "probe",
                                         "builtin:fan",
                                         "--frame",
                                         "5",
                                         "--pixel",
                                         "30,11",
                                         "--size",
                                         "48x27",
                                         "--what-if"};
  std::vector<std::string> asJson = command;
  asJson.emplace_back("--json");
  const test::ProcessResult result = test::runProcess(asJson);
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const auto lane = nlohmann::json::parse(result.out).at("lanes").at(0);
  EXPECT_EQ(lane.at("whatIf").size(), variantsOf({}).size());
  for (const auto& row : lane.at("whatIf"))
    if (row.at("current").get<bool>() && isExact()) {
      EXPECT_EQ(row.at("resolved"), lane.at("values").at("resolved"));
    }
  const std::string text = test::runProcess(command).out;
  EXPECT_NE(text.find("What if"), std::string::npos);
  EXPECT_NE(text.find("* Clip to filtered"), std::string::npos) << text;
}
