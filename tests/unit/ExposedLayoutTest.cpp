// Where watched rows go, and the GLSL that puts them there.
#include "core/taa/ExposedLayout.h"

#include "core/settings/Presets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

using taa::allRows;
using taa::ExposedLayout;
using taa::ExposedSlot;
using taa::Intermediate;
using taa::IntermediateId;
using taa::kResolveRows;

namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

} // namespace

TEST(ExposedLayout, GivesAFewALayerEach) {
  const ExposedLayout layout({IntermediateId::motion, IntermediateId::alpha, IntermediateId::color,
                              IntermediateId::depth, IntermediateId::output});
  EXPECT_EQ(layout.ofResolve().size(), 4u);
  EXPECT_EQ(layout.ofOutput().size(), 1u);
  EXPECT_EQ(layout.slot(IntermediateId::alpha).layer, 1);
  EXPECT_EQ(layout.slot(IntermediateId::motion).channels, 2);
  EXPECT_EQ(layout.slot(IntermediateId::output).layer, 1) << "behind color";
  EXPECT_EQ(layout.layers(4), 2);
  EXPECT_FALSE(layout.holds(IntermediateId::alphaBase));
}

TEST(ExposedLayout, PacksManyWithoutOverlapAndWithLittleLeftOver) {
  const ExposedLayout layout(allRows());
  std::set<std::pair<int, int>> taken;
  int channels = 0;
  for (const ExposedSlot& slot : layout.ofResolve()) {
    EXPECT_EQ(slot.channels, 4);
    for (const ExposedSlot::Part& part : slot.parts)
      for (int channel = 0; channel < taa::intermediate(part.id).channels; ++channel, ++channels) {
        EXPECT_LT(part.first + channel, 4);
        EXPECT_TRUE(taken.emplace(slot.layer, part.first + channel).second)
            << taa::intermediate(part.id).name;
      }
  }
  EXPECT_LE(4 * layout.ofResolve().size(), static_cast<std::size_t>(channels) + 4);
  for (const Intermediate& row : kResolveRows) {
    EXPECT_TRUE(layout.holds(row.id));
    EXPECT_EQ(layout.slot(row.id).parts.empty(), false) << row.name;
  }
}

TEST(ExposedLayout, GivesTheFirstRunTheLatestStages) {
  const taa::Settings settings;
  const ExposedLayout layout(allRows(), taa::rowSources(settings));
  const std::size_t first = taa::kMaxTargets - taa::historyTargets(settings);
  ASSERT_GT(layout.ofResolve().size(), first);
  for (const ExposedSlot& slot : layout.ofResolve().subspan(first))
    for (const ExposedSlot::Part& part : slot.parts) {
      const taa::Stage stage = taa::intermediate(part.id).stage;
      EXPECT_TRUE(stage != taa::Stage::RectifyHistory && stage != taa::Stage::BlendWeight &&
                  stage != taa::Stage::Blend)
          << taa::intermediate(part.id).name << ": rectification and blending are not computed again";
    }
}

TEST(ExposedLayout, TakesFewRunsForAllRowsOfEveryPreset) {
  for (const taa::Preset& preset : taa::builtinPresets()) {
    const ExposedLayout layout(allRows(), taa::rowSources(preset.settings));
    const std::size_t slots = layout.ofResolve().size() + taa::historyTargets(preset.settings);
    const std::size_t runs = (slots + taa::kMaxTargets - 1) / taa::kMaxTargets;
    EXPECT_LE(runs, 3u) << preset.id << ": " << slots << " targets";
    for (const Intermediate& row : kResolveRows)
      EXPECT_TRUE(layout.held(row.id) || !layout.slot(row.id).parts.empty()) << row.name;
  }
}

TEST(ExposedLayout, WritesWhatIsNowhereElse) {
  using enum IntermediateId;
  const taa::RowSources sources = taa::rowSources({});
  const ExposedLayout stored({resolved, historyLength, output}, sources);
  EXPECT_FALSE(stored.isWritten());
  EXPECT_FALSE(stored.needsInputs());
  const ExposedLayout drawn({color, objectClass}, sources);
  EXPECT_FALSE(drawn.isWritten());
  EXPECT_TRUE(drawn.needsInputs());
  EXPECT_EQ(drawn.firstChannel(objectClass), 3);
  const ExposedLayout off({lock, alphaMotion, alphaNearClamp}, sources);
  EXPECT_FALSE(off.needsInputs());
  EXPECT_EQ(off.layers(1), 2) << "one for 0, one for 1";
  EXPECT_NE(off.slot(lock).constant, off.slot(alphaNearClamp).constant);
  EXPECT_EQ(&off.slot(lock), &off.slot(alphaMotion));
}

TEST(ExposedLayout, WritesRowsThatAreEqualOnce) {
  using enum IntermediateId;
  const taa::RowSources sources = taa::rowSources({});
  const ExposedLayout both({alpha, alphaChannels}, sources);
  EXPECT_EQ(both.ofResolve().size(), 1u);
  EXPECT_EQ(&both.slot(alpha), &both.slot(alphaChannels));
  const ExposedLayout one({alpha}, sources);
  EXPECT_EQ(one.slot(alpha).channels, 1) << "nobody writes the other";
}

TEST(ExposedLayout, DefinesOneMacroForEveryRow) {
  for (const auto& watched : {std::vector<IntermediateId>{}, {IntermediateId::alpha}, allRows()}) {
    const ExposedLayout layout(watched);
    const auto slots = layout.ofResolve().first(std::min<std::size_t>(layout.ofResolve().size(), 6));
    for (const std::string& text :
         {taa::exposeAsTargets(slots, 2), taa::exposeAsTargets(layout.ofOutput(), 0)}) {
      for (const Intermediate& row : kResolveRows)
        EXPECT_EQ(count(text, "#define expose_" + std::string(row.name) + "(value)"), 1u) << row.name;
      EXPECT_EQ(count(text, "#define store_exposed()"), 1u);
    }
  }
}

TEST(ExposedLayout, WritesNothingButTheMacrosWhenNothingIsWatched) {
  const std::string text = taa::exposeAsTargets({}, 2);
  EXPECT_EQ(count(text, "\n"), kResolveRows.size() + 1);
  EXPECT_EQ(count(text, "(value)\n"), kResolveRows.size()) << "every macro is empty";
}

TEST(ExposedLayout, GivesTargetsBehindThoseOfTheHistory) {
  const ExposedLayout layout({IntermediateId::motion, IntermediateId::alpha, IntermediateId::color});
  const std::string text = taa::exposeAsTargets(layout.ofResolve(), 2);
  EXPECT_EQ(count(text, "layout(location = 2) out vec4 o_exposed0;"), 1u) << text;
  EXPECT_EQ(count(text, "layout(location = 3) out vec2 o_exposed1;"), 1u) << text;
  EXPECT_EQ(count(text, "layout(location = 4) out float o_exposed2;"), 1u) << text;
  EXPECT_EQ(count(text, "expose_color(value) o_exposed0.xyz = (value)\n"), 1u) << text;
  EXPECT_EQ(count(text, "expose_alpha(value) o_exposed2 = (value)\n"), 1u) << text;
  EXPECT_EQ(count(text, "imageStore"), 0u);
}

TEST(ExposedLayout, StoresEachSlotOnce) {
  const ExposedLayout layout(allRows());
  const std::string text = taa::exposeAsStores(layout.ofResolve());
  EXPECT_EQ(count(text, "imageStore"), layout.ofResolve().size());
  EXPECT_EQ(count(text, "layout(rgba32f, binding = 0) uniform writeonly image2DArray u_exposed;"), 1u);
  EXPECT_EQ(count(text, "#define store_exposed() imageStore"), 1u);
}
