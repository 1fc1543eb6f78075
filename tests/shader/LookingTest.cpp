// Looking changes nothing: the resolve gives the same bits whatever is exposed, and exposes the same bits
// whatever else it does.
#include "core/base/Error.h"
#include "tests/support/CompareImages.h"
#include "tests/support/ShaderFolder.h"
#include "tests/support/frames/ResolveTest.h"
#include "tests/support/frames/Variants.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

using taa::ExposedRows;
using taa::History;
using taa::IntermediateId;
using taa::test::crop;
using taa::test::difference;
using taa::test::FrameShape;
using taa::test::Variant;

class LookingTest : public taa::test::ResolveTest {
 protected:
  static void expectSame(const History& actual, const History& expected, const std::string& what) {
    EXPECT_EQ(difference(actual.color.download(), expected.color.download()), "") << "color, " << what;
    EXPECT_EQ(difference(actual.surface.download(), expected.surface.download()), "") << "surface, " << what;
  }

  // Watched: nothing, one row, six (the most that have targets of their own), everything.
  static std::vector<std::vector<IntermediateId>> watches(std::size_t first) {
    std::vector<std::vector<IntermediateId>> watches(3);
    for (std::size_t i = 0; i < 6; ++i)
      watches[i == 0 ? 0 : 1].push_back(static_cast<IntermediateId>((first + 5 * i) % taa::kResolveRowCount));
    watches[1].push_back(watches[0][0]);
    watches[2] = taa::allRows();
    return watches;
  }
};

class LookingAtVariants : public LookingTest, public testing::WithParamInterface<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(Part, LookingAtVariants, testing::Range(std::size_t{0}, taa::test::kParts));

TEST_P(LookingAtVariants, ChangesNothing) {
  auto seed = static_cast<std::uint32_t>(GetParam());
  for (const Variant& variant : taa::test::partOf(taa::test::presetsAndChoices(), GetParam())) {
    const FrameShape shape = taa::test::shapeFor(variant.settings);
    const taa::twin::Inputs frame = taa::test::randomFrame(shape, ++seed, true);
    const History bare = resolve(frame, shape, variant.settings);
    for (const auto& watched : {watches(seed)[1], watches(seed)[2]}) {
      ExposedRows exposedRows(watched, whole(shape));
      expectSame(resolve(frame, shape, variant.settings, &exposedRows), bare,
                 std::to_string(watched.size()) + " watched, " + variant.name);
    }
  }
}

TEST_P(LookingAtVariants, ChangesNothingInRandomCombinations) {
  for (const Variant& variant : taa::test::partOf(taa::test::randomCombinations(), GetParam())) {
    const FrameShape shape = taa::test::shapeFor(variant.settings);
    const taa::twin::Inputs frame = taa::test::randomFrame(shape, 11, true);
    ExposedRows exposedRows(taa::allRows(), whole(shape));
    expectSame(resolve(frame, shape, variant.settings, &exposedRows), resolve(frame, shape, variant.settings),
               variant.name);
  }
}

TEST_F(LookingTest, ShowsTheSameWhetherItIsAloneOrPacked) {
  const FrameShape shape;
  const taa::twin::Inputs frame = taa::test::randomFrame(shape, 7, true);
  const taa::test::Exposed all = expose(frame, shape, {});
  for (std::size_t first = 0; first < taa::kResolveRowCount; first += 6) {
    std::vector<IntermediateId> watched;
    for (std::size_t row = first; row < std::min(first + 6, taa::kResolveRowCount); ++row)
      watched.push_back(static_cast<IntermediateId>(row));
    ExposedRows exposedRows(watched, whole(shape));
    resolve(frame, shape, {}, &exposedRows);
    for (const IntermediateId id : watched)
      EXPECT_EQ(difference(exposedRows.image(id), all.at(id)), "") << taa::intermediate(id).name;
  }
}

TEST_F(LookingTest, ShowsInARegionWhatTheWholePictureHasThere) {
  const FrameShape shape;
  const taa::twin::Inputs frame = taa::test::randomFrame(shape, 8, true);
  const taa::test::Exposed all = expose(frame, shape, {});
  const taa::FrameInputs inputs = taa::test::upload(frame, shape);
  const History previous = taa::test::uploadHistory(frame, shape);
  const History resolved = resolve(frame, shape, {});
  const taa::gl::Rect regions[] = {
      {13, 7, 9, 5}, {0, 0, 1, 1}, {96, 60, 1, 1}, {40, 0, 57, 61}, {1, 0, 96, 61}}; // the last by targets
  for (const taa::gl::Rect& region : regions)
    for (const auto& watched : watches(3)) {
      ExposedRows exposedRows(watched, region);
      pass().expose(inputs, &previous, resolved, {}, exposedRows);
      for (const IntermediateId id : watched)
        EXPECT_EQ(difference(exposedRows.image(id),
                             crop(all.at(id), region.x, region.y, region.width, region.height)),
                  "")
            << taa::intermediate(id).name << " at " << region.x << ", " << region.y;
    }
}

// Techniques: 1.5.
TEST_F(LookingTest, ShowsAsResolvedWhatTheHistoryHolds) {
  for (const taa::Precision precision : {taa::Precision::Half, taa::Precision::Full}) {
    FrameShape shape;
    shape.history = precision;
    taa::Settings settings;
    settings.history.precision = precision;
    const taa::twin::Inputs frame = taa::test::randomFrame(shape, 9, true);
    const taa::test::Exposed all = expose(frame, shape, settings);
    taa::twin::Inputs next = frame;
    taa::test::downloadHistory(resolve(frame, shape, settings), next);
    taa::Image color(shape.width, shape.height, 3);
    taa::Image frames(shape.width, shape.height, 1);
    for (int y = 0; y < shape.height; ++y)
      for (int x = 0; x < shape.width; ++x) {
        std::copy_n(next.historyColor.at(x, y), 3, color.at(x, y));
        *frames.at(x, y) = next.historySurface.at(x, y)[0];
      }
    EXPECT_EQ(difference(all.at(IntermediateId::resolved), color), "");
    EXPECT_EQ(difference(all.at(IntermediateId::historyLength), frames), "");
  }
}

TEST_F(LookingTest, ExposedRowsKnowWhatTheyHold) {
  const ExposedRows exposedRows(
      {IntermediateId::alpha, IntermediateId::color, IntermediateId::depth, IntermediateId::color},
      {0, 0, 4, 4});
  EXPECT_EQ(exposedRows.watched(),
            (std::vector{IntermediateId::color, IntermediateId::depth, IntermediateId::alpha}));
  EXPECT_TRUE(exposedRows.holds(IntermediateId::depth));
  EXPECT_FALSE(exposedRows.holds(IntermediateId::motion));
  EXPECT_EQ(exposedRows.layer(IntermediateId::color), 0);
  EXPECT_EQ(exposedRows.layer(IntermediateId::depth), 0);
  EXPECT_EQ(exposedRows.layer(IntermediateId::alpha), 1);
  EXPECT_EQ(exposedRows.firstChannel(IntermediateId::alpha), 0);
  EXPECT_EQ(difference(exposedRows.image(IntermediateId::color), taa::Image(4, 4, 3)), "")
      << "cleared at first";
}

TEST_F(LookingTest, ABrokenShaderKeepsTheProgramsThatRun) {
  const FrameShape shape;
  const taa::twin::Inputs frame = taa::test::randomFrame(shape, 10, false);
  const taa::test::ShaderFolder folder;
  taa::TaaPass own;
  const taa::FrameInputs inputs = taa::test::upload(frame, shape);
  const History previous = taa::test::uploadHistory(frame, shape);
  History before, broken, changed;
  own.resolve(inputs, &previous, {}, before);

  folder.replace("taa/blend.glsl", "precise float currentWeight", "no float currentWeight");
  try {
    own.reloadShaders();
    FAIL() << "compiles";
  } catch (const taa::Error& error) {
    EXPECT_NE(std::string(error.what()).find("taa/blend.glsl:"), std::string::npos) << error.what();
  }
  own.resolve(inputs, &previous, {}, broken);
  expectSame(broken, before, "after a reload that failed");

  folder.replace("taa/blend.glsl", "no float currentWeight", "precise float currentWeight");
  folder.replace("taa/resolve.frag", "vec4(blended.color, 1.0)", "vec4(2.0)");
  own.reloadShaders();
  own.resolve(inputs, &previous, {}, changed);
  EXPECT_EQ(changed.color.download().pixels[0], 2.0f) << "the new shader runs";
}
