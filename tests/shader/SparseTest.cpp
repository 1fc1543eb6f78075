// A target of fewer texels than its region has pixels holds exactly what the full picture has there.
#include "tests/support/CompareImages.h"
#include "tests/support/frames/ResolveTest.h"
#include "tests/support/frames/Variants.h"

#include "core/settings/Parameters.h"

#include <algorithm>
#include <vector>

using taa::ExposedRows;
using taa::Image;
using taa::IntermediateId;
using taa::test::FrameShape;

namespace {

// The pixel in the middle of each texel's share of the region.
Image sampled(const Image& full, const taa::gl::Rect& region, const glm::ivec2& texels) {
  Image result(texels.x, texels.y, full.channels);
  for (int y = 0; y < texels.y; ++y)
    for (int x = 0; x < texels.x; ++x)
      std::copy_n(full.at(region.x + (2 * x + 1) * region.width / (2 * texels.x),
                          region.y + (2 * y + 1) * region.height / (2 * texels.y)),
                  full.channels, result.at(x, y));
  return result;
}

class SparseTest : public taa::test::ResolveTest {
 protected:
  static void expectSampled(const taa::Settings& settings, const std::vector<IntermediateId>& ids,
                            const taa::gl::Rect& region, const glm::ivec2& texels) {
    const FrameShape shape = taa::test::shapeFor(settings);
    const taa::twin::Inputs frame = taa::test::randomFrame(shape, 5, true);
    const taa::FrameInputs inputs = taa::test::upload(frame, shape);
    const taa::History previous = taa::test::uploadHistory(frame, shape);
    taa::History resolved;
    ExposedRows full(ids, whole(shape)), sparse(ids, region, texels);
    pass().resolve(inputs, &previous, settings, resolved, &full);
    pass().expose(inputs, &previous, resolved, settings, sparse);
    for (const IntermediateId id : ids) {
      const Image expected = sampled(full.image(id), region, texels);
      EXPECT_EQ(taa::test::difference(sparse.image(id), expected), "") << taa::intermediate(id).name;
    }
  }
};

} // namespace

TEST_F(SparseTest, HasTheFullPicturesTexelsOfEveryRow) {
  expectSampled({}, taa::allRows(), {0, 0, 97, 61}, {24, 15});
}

TEST_F(SparseTest, HasThemOfFewRowsAsTargets) {
  expectSampled({}, {IntermediateId::alpha, IntermediateId::resolved, IntermediateId::output}, {0, 0, 97, 61},
                {24, 15});
}

TEST_F(SparseTest, HasThemOfAPartOfThePictureAndWhereItIsLarger) {
  expectSampled({}, {IntermediateId::motion, IntermediateId::output}, {11, 7, 40, 30}, {24, 13});
  expectSampled({}, {IntermediateId::motion, IntermediateId::output}, {90, 50, 7, 11}, {20, 22});
}

TEST_F(SparseTest, HasThemOfAPictureThatIsDrawnSmaller) {
  taa::Settings settings;
  taa::parameter("inputs.renderScale").set(settings, 0.5);
  taa::parameter("output.motionBlur").set(settings, 1.0);
  expectSampled(settings, taa::allRows(), {0, 0, 97, 61}, {31, 19});
}
