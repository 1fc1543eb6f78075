// What ghosts on scenes are said to be of, against the samples of the pixel's lineage: their colors and
// objects as they are drawn anew, and not what verdicts made of them.
#include "core/inspect/Inspector.h"
#include "core/settings/Presets.h"
#include "tests/support/GlTest.h"
#include "tests/support/capture/CapturedShot.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <string>

using taa::Inspector;
using taa::IntermediateId;

namespace {

constexpr glm::ivec2 kSizePx{240, 135};
constexpr int kFrame = 38, kSamples = 16, kPixels = 16;

/// How far the samples of each object, but of `own`, pull the pixel the error's way.
std::map<int, double> pullsOf(const taa::Lineage& lineage, const taa::PixelError& error, int own,
                              std::map<int, std::shared_ptr<const taa::capture::DecodedFrame>>& drawn,
                              taa::test::CapturedShot& shot) {
  std::map<int, double> pulls;
  for (const taa::FootprintSample& sample : lineage.samples) {
    auto& frame = drawn[sample.frame];
    if (!frame) frame = shot.frame(sample.frame);
    const auto index = static_cast<std::size_t>(sample.texel.y * kSizePx.x + sample.texel.x);
    const auto object = static_cast<int>(frame->objectId[index]);
    const glm::dvec3 color(glm::vec3(frame->color.texel(sample.texel.x, sample.texel.y)));
    if (object != own) pulls[object] += sample.weight * glm::dot(color - error.reference, error.error());
  }
  return pulls;
}

/// The object that pulls twice as far as any other, and at least half of the error; −1: none does.
int clearlyFirst(const std::map<int, double>& pulls, const glm::dvec3& error) {
  int first = -1;
  double most = 0.0, next = 0.0;
  for (const auto& [object, pull] : pulls) {
    if (pull > most) {
      next = most;
      most = pull;
      first = object;
    } else {
      next = std::max(next, pull);
    }
  }
  return most >= 2.0 * next && most >= 0.5 * glm::dot(error, error) ? first : -1;
}

/// Of the worst ghosts of a scene; returns how many of them are clear.
int expectNamed(const std::string& source) {
  const taa::Settings settings = taa::preset("unrectified").settings;
  Inspector inspector;
  inspector.shot().setSize(kSizePx.x, kSizePx.y);
  inspector.shot().setSettings(settings);
  inspector.shot().open(source);
  inspector.shot().seek(kFrame);
  inspector.reference().makeRows({IntermediateId::errorGhost}, kSamples);
  taa::test::CapturedShot shot(source, kSizePx, settings, kFrame + 1);
  std::map<int, std::shared_ptr<const taa::capture::DecodedFrame>> drawn;
  const taa::Image objects = inspector.views().image(IntermediateId::objectId);
  int clear = 0;
  for (const taa::WorstPixel& worst :
       inspector.worst().of({.row = IntermediateId::errorGhost, .count = kPixels, .apartPx = 6})) {
    const taa::VerdictAnswer answer = inspector.verdicts().of({.frame = kFrame, .pixel = worst.pixel});
    if (answer.verdict.kind != taa::VerdictKind::Ghost || !answer.verdict.causeObject) continue;
    const int own = static_cast<int>(*objects.at(worst.pixel.x, worst.pixel.y));
    const taa::Lineage lineage = inspector.lineage().of(kFrame, worst.pixel);
    const int object = clearlyFirst(pullsOf(lineage, answer.error, own, drawn, shot), answer.error.error());
    if (object < 0) continue;
    ++clear;
    EXPECT_EQ(*answer.verdict.causeObject, object)
        << source << " " << worst.pixel.x << ", " << worst.pixel.y << ": " << answer.sentence;
  }
  return clear;
}

} // namespace

class GhostsOnScenesTest : public taa::test::GlTest {};

TEST_F(GhostsOnScenesTest, AreOfTheObjectWhoseSamplesAreSeenInThem) {
  int clear = 0;
  for (const char* source : {"builtin:fan", "builtin:disocclusion", "builtin:foliage"})
    clear += expectNamed(source);
  EXPECT_GE(clear, 12) << "else little was tested";
}
