// Lineages of a shot's pixels: the response that the GPU's resolve has to an impulse, and the same figures
// however the frames are reached.
#include "core/inspect/verdicts/LineageOfShot.h"

#include "core/base/Error.h"
#include "core/io/FrameJson.h"
#include "core/settings/Presets.h"
#include "core/verdict/lineage/LineageWords.h"
#include "tests/support/ErrorOf.h"
#include "tests/support/Paths.h"
#include "tests/support/Process.h"
#include "tests/support/SmallInspector.h"
#include "tests/support/frames/Frames.h"
#include "tests/support/frames/LineageShot.h"
#include "tests/support/frames/ResolveTest.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

using namespace taa;
using taa::test::LineageShot;

namespace {

constexpr glm::ivec2 kPixel{30, 11}; // where the fan spins
constexpr int kFrame = 9;

class LineageOfShotTest : public test::small::InspectorTest {};
class LineageResponse : public test::ResolveTest {
 protected:
  /// Frames of the fan, resolved by the GPU.
  static LineageShot shot(const Settings& settings) {
    test::Player player("builtin:fan", "still", test::small::kWidth, test::small::kHeight, settings);
    std::vector<twin::Inputs> frames;
    for (int frame = 0; frame <= kFrame; ++frame) {
      player.draw();
      frames.push_back(test::twinInputs(player.inputs(), nullptr));
    }
    return {std::move(frames), settings, [](const twin::Inputs& frame, const Settings& used) {
              const test::FrameShape shape =
                  test::shapeFor(used, {test::small::kWidth, test::small::kHeight, used.inputs.precision});
              const History left = resolve(frame, shape, used);
              return test::LeftHistory{left.color.download(), left.surface.download()};
            }};
  }
};

/// All numbers of a lineage.
std::vector<double> numbersOf(const Lineage& lineage) {
  std::vector<double> numbers{lineage.weight, lineage.rectified, lineage.older,
                              lineage.pruned, lineage.variance,  lineage.radiusPx};
  for (const LineageFrame& entry : lineage.frames)
    for (const double number : {entry.weight, entry.rectified, entry.place.x, entry.place.y, entry.spreadPx,
                                entry.color.y, entry.own.y, static_cast<double>(entry.object)})
      numbers.push_back(number);
  for (const FootprintSample& sample : lineage.samples)
    for (const double number :
         {static_cast<double>(sample.frame), sample.offset.x, sample.offset.y, sample.weight})
      numbers.push_back(number);
  return numbers;
}

} // namespace

// The sparks of the scene are as bright as 40; 32-bit floats of a dozen frames are off by some 10⁻⁶ of that.
TEST_F(LineageResponse, IsWhatTheGpuMakesOfAnImpulse) {
  Settings settings = test::bareSettings();
  settings.inputs.precision = Precision::Full;
  LineageShot frames = shot(settings);
  const Lineage lineage = lineageOf(frames, kFrame, kPixel, {kFrame + 1, 0.0, 0.0});
  const glm::vec3 resolved = frames.resolved(kPixel);
  int seen = 0;
  for (const int frame : {9, 8, 6, 3, 0}) {
    const auto heaviest =
        std::ranges::max_element(lineage.samples, {}, [frame](const FootprintSample& sample) {
          return sample.frame == frame ? sample.weight : -1.0;
        });
    const glm::ivec2 at = heaviest->texel;
    const LineageShot::Change poison = [at](const glm::ivec2& texel) {
      return glm::vec3(texel == at ? 4.0f : 0.0f);
    };
    const glm::dvec3 response = glm::dvec3(frames.resolvedWith(frame, poison, kPixel) - resolved);
    const glm::dvec3 predicted = test::predictedResponse(lineage, frame, poison);
    EXPECT_EQ(predicted.x, 4.0 * heaviest->weight);
    seen += predicted.x > 0.05 ? 1 : 0;
    for (int channel = 0; channel < 3; ++channel)
      EXPECT_NEAR(response[channel], predicted[channel], 2e-5) << "frame " << frame;
  }
  EXPECT_GE(seen, 4) << "the impulses are seen";
}

TEST_F(LineageResponse, OfTheShotIsThatOfItsFrames) {
  if (!isExact()) GTEST_SKIP() << "this driver rounds its own way";
  const Settings settings; // balanced
  LineageShot frames = shot(settings);
  const Lineage expected = lineageOf(frames, kFrame, kPixel);
  Inspector inspector;
  inspector.shot().setSize(test::small::kWidth, test::small::kHeight);
  inspector.shot().open("builtin:fan");
  inspector.shot().setCamera("still");
  EXPECT_EQ(numbersOf(inspector.lineage().of(kFrame, kPixel)), numbersOf(expected));
}

TEST_F(LineageOfShotTest, IsTheSameHoweverItsFramesAreReached) {
  auto inspector = opened();
  inspector->shot().seek(kFrame);
  const std::vector<Image> before = inspector->views().images(allRows());
  const std::vector<double> shown = numbersOf(inspector->lineage().of(kFrame, kPixel));
  const std::vector<double> ofOther = numbersOf(inspector->lineage().of(12, {20, 15}));
  test::small::expectSame(inspector->views().images(allRows()), before);
  EXPECT_EQ(inspector->shot().frame(), kFrame);
  inspector->shot().setCheckpointBudget(0);
  inspector->shot().seek(20);
  EXPECT_EQ(numbersOf(inspector->lineage().of(kFrame, kPixel)), shown);
  EXPECT_EQ(numbersOf(inspector->lineage().of(12, {20, 15})), ofOther);
}

TEST_F(LineageOfShotTest, IsThatOfItsLane) {
  auto inspector = opened({Settings{}, test::small::otherSettings()});
  const std::vector<double> ofLane = numbersOf(inspector->lineage().of(kFrame, kPixel, 1));
  inspector->shot().setLanes({test::small::otherSettings()});
  EXPECT_EQ(numbersOf(inspector->lineage().of(kFrame, kPixel)), ofLane);
}

TEST_F(LineageOfShotTest, PartsSumUpInPresetsOfAllKindsAndColorsToThePixel) {
  auto inspector = opened();
  for (const char* id : {"balanced", "unrectified", "bevy", "godot", "hdrp-taau", "fsr2", "raptor", "off"}) {
    inspector->shot().setSettings(preset(id).settings);
    inspector->shot().seek(kFrame);
    const Lineage lineage = inspector->lineage().of(kFrame, kPixel, 0, {6, 1e-4, 1e-4});
    EXPECT_NEAR(lineage.weight + lineage.rectified + lineage.older + lineage.pruned + lineage.blank, 1.0,
                1e-12)
        << id;
    const glm::vec3 resolved(
        twin::at(inspector->probes().probe(kPixel.x, kPixel.y), IntermediateId::resolved));
    glm::dvec3 sum = lineage.rest;
    for (const LineageFrame& entry : lineage.frames) sum += entry.color + entry.own;
    for (int channel = 0; channel < 3; ++channel)
      EXPECT_NEAR(sum[channel], resolved[channel], isExact() ? 1e-9 : 1e-2) << id;
  }
}

TEST_F(LineageOfShotTest, StopsWhenItIsToldToAndSaysWhatThereIsNot) {
  auto inspector = opened();
  inspector->shot().seek(kFrame);
  int told = 0;
  const Progress stop = [&told](std::string_view, int, int) { return ++told < 3; };
  EXPECT_THROW(inspector->lineage().of(kFrame, kPixel, 0, {}, stop), Cancelled);
  EXPECT_EQ(told, 3);
  EXPECT_EQ(inspector->lineage().of(kFrame, kPixel).frames.size(), 10u) << "and goes on";
  EXPECT_EQ(test::errorOf([&] {
              inspector->lineage().of(kFrame, {48, 3});
            }),
            "pixel (48, 3) lies outside the picture of 48 × 27 pixels");
  EXPECT_NE(test::errorOf([&] { inspector->lineage().of(999, kPixel); }).find("there is no frame 999"),
            std::string::npos);
}

TEST_F(LineageOfShotTest, TheCommandPrintsItsFiguresAsTextAndJson) {
  const std::vector<std::string> call{test::binary("taa-batch").string(),
                                      "lineage",
                                      "builtin:fan",
                                      "--size",
                                      "48x27",
                                      "--frame",
                                      "9",
                                      "--pixel",
                                      "30,11",
                                      "--frames",
                                      "4"};
  std::vector<std::string> asJson = call;
  asJson.emplace_back("--json");
  const test::ProcessResult text = test::runProcess(call), json = test::runProcess(asJson);
  ASSERT_EQ(text.exitCode, 0) << text.err;
  ASSERT_EQ(json.exitCode, 0) << json.err;
  auto inspector = opened();
  const Lineage lineage = inspector->lineage().of(kFrame, kPixel, 0, {.frames = 4});
  const nlohmann::json lane = nlohmann::json::parse(json.out)["lanes"][0];
  EXPECT_EQ(lane["headline"], nlohmann::json(lineageSentences(lineage)));
  ASSERT_EQ(lane["frames"].size(), lineage.frames.size());
  EXPECT_EQ(lane["samples"].size(), lineage.samples.size());
  for (std::size_t age = 0; age < lineage.frames.size(); ++age) {
    const LineageFrame& entry = lineage.frames[age];
    EXPECT_EQ(lane["frames"][age]["frame"], entry.frame);
    const std::string weight = floatText(static_cast<float>(entry.weight));
    EXPECT_EQ(lane["frames"][age]["weight"].dump(), weight);
    EXPECT_NE(text.out.find(" " + weight + " "), std::string::npos) << text.out;
  }
  EXPECT_EQ(lane["rectified"].get<float>(), static_cast<float>(lineage.rectified));
  for (const std::string& line : lineageSentences(lineage))
    EXPECT_NE(text.out.find(line + "\n"), std::string::npos) << text.out;
}
