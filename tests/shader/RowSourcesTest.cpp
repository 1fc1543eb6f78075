// Rows that are read in place, are constant or stand for another have the bits that writing them gives.
#include "core/taa/RowSources.h"
#include "core/gl/Memory.h"
#include "tests/support/CompareImages.h"
#include "tests/support/frames/ResolveTest.h"
#include "tests/support/frames/Variants.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace taa {
namespace {

class RowSourcesTest : public test::ResolveTest {
 protected:
  /// Textures of a frame as it is drawn for these settings: masks and overlay only where they ask for them.
  static FrameInputs drawn(const twin::Inputs& images, const test::FrameShape& shape,
                           const Settings& settings) {
    FrameInputs inputs = test::upload(images, shape);
    if (settings.inputs.mask == MaskSource::None) inputs.mask = {};
    if (settings.inputs.blended != BlendedAs::After) inputs.overlay = {};
    return inputs;
  }

  /// That all rows have the same bits whether they are written or not, and so has the history; says of each
  /// row that was not written that it was met.
  static void expectSame(const test::Variant& variant, std::uint32_t seed, std::vector<bool>& met) {
    const Settings& settings = variant.settings;
    const test::FrameShape shape = test::shapeFor(settings);
    const twin::Inputs images = test::randomFrame(shape, seed, true);
    const FrameInputs inputs = drawn(images, shape, settings);
    const History previous = test::uploadHistory(images, shape);
    ExposedRows written(allRows(), whole(shape));
    const RowSources sources = rowSources(settings);
    ExposedRows looked(ExposedLayout(allRows(), sources), whole(shape));
    History one, other;
    pass().resolve(inputs, &previous, settings, one, &written);
    pass().resolve(inputs, &previous, settings, other, &looked);
    EXPECT_EQ(test::difference(one.color.download(), other.color.download()), "") << variant.name;
    EXPECT_EQ(test::difference(one.surface.download(), other.surface.download()), "") << variant.name;
    for (const Intermediate& row : kResolveRows) {
      if (sources.of(row.id) == RowSource{}) continue;
      met[static_cast<std::size_t>(row.id)] = true;
      EXPECT_EQ(test::difference(looked.image(row.id), written.image(row.id)), "")
          << row.name << ", " << variant.name;
    }
    // Those beside them, which other slots hold than before.
    for (const IntermediateId id : {IntermediateId::historyPosition, IntermediateId::neighborhoodMean,
                                    IntermediateId::rejectReason, IntermediateId::alphaChannels})
      EXPECT_EQ(test::difference(looked.image(id), written.image(id)), "")
          << intermediate(id).name << ", " << variant.name;
  }
};

class RowSourcesOfVariants : public RowSourcesTest, public testing::WithParamInterface<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(Part, RowSourcesOfVariants, testing::Range(std::size_t{0}, test::kParts));

TEST_P(RowSourcesOfVariants, AreWhatWritingGives) {
  std::vector<bool> met(kResolveRowCount, false);
  auto seed = static_cast<std::uint32_t>(GetParam());
  for (const test::Variant& variant : test::partOf(test::presetsAndChoices(), GetParam()))
    expectSame(variant, ++seed, met);
  EXPECT_GE(std::ranges::count(met, true), 20) << "many need not be written";
}

/// Settings in which rows are neither written nor what they are in the presets.
std::vector<test::Variant> fewStages() {
  Settings bare = test::bareSettings();
  bare.neighborhood.box = BoxKind::MinMax;
  Settings masked = bare;
  masked.inputs.mask = MaskSource::Material;
  masked.inputs.blended = BlendedAs::After;
  Settings small = masked;
  small.inputs.renderScale = 0.5f;
  return {{"bare", bare}, {"masked", masked}, {"small", small}};
}

TEST_F(RowSourcesTest, AreWhatWritingGivesWhereLittleIsDone) {
  std::vector<bool> met(kResolveRowCount, false);
  for (const test::Variant& variant : fewStages()) expectSame(variant, 5, met);
  using enum IntermediateId;
  for (const IntermediateId id :
       {reactive, overlay, overlayAlpha, dilatedOffset, dilatedDepth, dilatedMotion, depthExpected, boxMin,
        boxMax, historyRectified, clipAmount, alphaBase, alphaFloor, toneWeightCurrent, output})
    EXPECT_TRUE(met[static_cast<std::size_t>(id)]) << intermediate(id).name;
}

TEST_F(RowSourcesTest, ShowsThePartOfARowThatIsReadInPlace) {
  const test::FrameShape shape;
  const twin::Inputs images = test::randomFrame(shape, 3, false);
  const FrameInputs inputs = drawn(images, shape, {});
  ExposedRows looked(ExposedLayout({IntermediateId::normal, IntermediateId::objectId,
                                    IntermediateId::objectClass, IntermediateId::depth},
                                   rowSources({})),
                     whole(shape));
  History out;
  pass().resolve(inputs, nullptr, {}, out, &looked);
  const gl::Rect part{13, 7, 9, 5};
  for (const IntermediateId id : looked.watched()) {
    EXPECT_EQ(looked.image(id).channels, intermediate(id).channels);
    EXPECT_EQ(test::difference(looked.image(id, part),
                               test::crop(looked.image(id), part.x, part.y, part.width, part.height)),
              "");
  }
  EXPECT_EQ(&looked.texture(IntermediateId::depth), &inputs.depth);
  EXPECT_EQ(looked.firstChannel(IntermediateId::objectClass), 3);
}

TEST_F(RowSourcesTest, FollowsANumberWithoutNewTextures) {
  Settings settings;
  const gl::Rect picture{0, 0, 8, 8};
  ExposedRows looked(ExposedLayout(allRows(), rowSources(settings)), picture);
  const auto value = [&](IntermediateId id) { return looked.image(id).pixels[5]; };
  EXPECT_EQ(value(IntermediateId::boxGamma), settings.neighborhood.gamma);
  EXPECT_EQ(value(IntermediateId::alphaNearClamp), 1.0f);
  settings.neighborhood.gamma = 0.0f;
  const ExposedLayout next(allRows(), rowSources(settings));
  ASSERT_TRUE(looked.layout().hasSamePlaces(next));
  gl::failAllocationsAfter(0);
  looked.take(next);
  gl::failAllocationsAfter(-1);
  EXPECT_EQ(value(IntermediateId::boxGamma), 0.0f);
  EXPECT_EQ(value(IntermediateId::lock), 0.0f);
  EXPECT_EQ(value(IntermediateId::alphaNearClamp), 1.0f);
  settings.weight.nearClamp = Switch::On;
  EXPECT_FALSE(next.hasSamePlaces(ExposedLayout(allRows(), rowSources(settings))));
}

} // namespace
} // namespace taa
