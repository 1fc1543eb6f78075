// Lineages of a shot's pixels: the response that the GPU's resolve has to an impulse, and the same figures
// however the frames are reached.
#include "core/inspect/LineageOfShot.h"
#include "core/base/NumberText.h"

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

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
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
  static std::vector<twin::Inputs> drawn(const std::string& source, const std::string& camera,
                                         const Settings& settings) {
    test::Player player(source, camera, test::small::kWidth, test::small::kHeight, settings);
    std::vector<twin::Inputs> frames;
    for (int frame = 0; frame <= kFrame; ++frame) {
      player.draw();
      frames.push_back(test::twinInputs(player.inputs(), nullptr));
    }
    return frames;
  }
  /// Resolved by the GPU.
  static LineageShot shot(std::vector<twin::Inputs> frames, const Settings& settings) {
    return {std::move(frames), settings, [](const twin::Inputs& frame, const Settings& used) {
              const test::FrameShape shape =
                  test::shapeFor(used, {test::small::kWidth, test::small::kHeight, used.inputs.precision});
              const History left = resolve(frame, shape, used);
              return test::LeftHistory{left.color.download(), left.surface.download()};
            }};
  }
  static LineageShot shotOfFan(const Settings& settings) {
    return shot(drawn("builtin:fan", "still", settings), settings);
  }
};

/// Nothing but sums, of 32-bit floats.
Settings sumsOnly() {
  Settings settings = test::bareSettings();
  settings.inputs.precision = Precision::Full;
  settings.weight.alpha = 0.1f;
  return settings;
}

/// By how much two pictures of sumsOnly() may differ beyond what `impulse` makes of them, as a part of it:
/// in each, a frame rounds a dozen times what is at most as large as the brightest color, and each frame
/// keeps nine tenths of what the one before was off by.
double roundedOff(const std::vector<twin::Inputs>& frames, double impulse) {
  float brightest = 0.0f;
  for (const twin::Inputs& frame : frames)
    brightest = std::max(brightest, std::ranges::max(frame.color.pixels));
  return 2.0 * 12.0 * 10.0 * std::exp2(-24.0) * (brightest + impulse) / impulse;
}

LineageShot::Change everywhere(float impulse) {
  return [impulse](const glm::ivec2&) { return glm::vec3(impulse); };
}

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
  LineageShot frames = shotOfFan(sumsOnly());
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

// Boards slide before a wall, and the camera goes around them.
TEST_F(LineageResponse, IsTheWeightOfEachFrameAndTexelWhileTheCameraMoves) {
  const Settings settings = sumsOnly();
  const std::vector<twin::Inputs> inputs = drawn("builtin:disocclusion", "orbit", settings);
  const double tolerance = roundedOff(inputs, 1.0);
  ASSERT_LT(tolerance, 1e-4);
  LineageShot frames = shot(inputs, settings);
  const std::vector<glm::ivec2> pixels{{8, 6}, {17, 14}, {24, 20}, {31, 8}, {41, 17}};
  for (const int frame : {9, 8, 5, 1, 0}) {
    const LineageShot raised = frames.with(frame, everywhere(1.0f));
    for (const glm::ivec2& pixel : pixels) {
      const Lineage lineage = lineageOf(frames, kFrame, pixel, {kFrame + 1, 0.0, 0.0});
      const LineageFrame& entry = lineage.frames.at(static_cast<std::size_t>(kFrame - frame));
      if (frame == 0) {
        EXPECT_GT(glm::distance(entry.place, glm::dvec2(pixel) + 0.5), 0.5) << "it moves";
        EXPECT_GT(entry.pixels, 30) << "over texels";
      }
      const auto heaviest =
          std::ranges::max_element(lineage.samples, {}, [frame](const FootprintSample& sample) {
            return sample.frame == frame ? sample.weight : -1.0;
          });
      EXPECT_GT(heaviest->weight, 50.0 * tolerance) << "the impulse is seen";
      const LineageShot::Change one = [at = heaviest->texel](const glm::ivec2& texel) {
        return glm::vec3(texel == at ? 1.0f : 0.0f);
      };
      const glm::dvec3 was(frames.resolved(pixel));
      const glm::dvec3 ofFrame = glm::dvec3(raised.resolved(pixel)) - was;
      const glm::dvec3 ofTexel = glm::dvec3(frames.resolvedWith(frame, one, pixel)) - was;
      for (int channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(ofFrame[channel], entry.weight, tolerance) << frame << ", " << pixel.x;
        EXPECT_NEAR(ofTexel[channel], heaviest->weight, tolerance) << frame << ", " << pixel.x;
      }
    }
  }
}

// A gray clamp keeps a change of history or ends it, where the lineage says that a share of it is left. The
// first frame has no box that would change with it. The impulse is so small that it lifts no history from
// below a box past its middle.
TEST_F(LineageResponse, IsNoGreaterThanTheWeightWhereHistoryIsClamped) {
  Settings settings = sumsOnly();
  settings.rectify.method = RectifyMethod::Clamp;
  std::vector<twin::Inputs> inputs = drawn("builtin:disocclusion", "orbit", settings);
  for (twin::Inputs& frame : inputs)
    for (int texel = 0; texel < frame.width() * frame.height(); ++texel) {
      float* color = frame.color.at(texel % frame.width(), texel / frame.width());
      color[0] = color[2] = color[1];
    }
  constexpr float kImpulse = 1.0f / 64.0f;
  const double tolerance = roundedOff(inputs, kImpulse);
  LineageShot frames = shot(std::move(inputs), settings);
  const LineageShot raised = frames.with(0, everywhere(kImpulse));
  int less = 0, seen = 0;
  for (int y = 2; y < test::small::kHeight; y += 3)
    for (int x = 3; x < test::small::kWidth; x += 3) {
      const Lineage lineage = lineageOf(frames, kFrame, {x, y}, {kFrame + 1, 0.0, 0.0});
      const double weight = lineage.frames.back().frame == 0 ? lineage.frames.back().weight : 0.0;
      const double response =
          (static_cast<double>(raised.resolved({x, y}).y) - frames.resolved({x, y}).y) / kImpulse;
      EXPECT_LE(response, weight + tolerance) << x << ", " << y;
      EXPECT_GE(response, -tolerance) << x << ", " << y;
      less += lineage.rectified > 0.0 && response < weight - 0.01 ? 1 : 0;
      seen += lineage.rectified > 0.0 && response > 0.01 ? 1 : 0;
    }
  EXPECT_GT(less, 20) << "clamps end it";
  EXPECT_GT(seen, 5) << "and keep it";
}

TEST_F(LineageResponse, OfTheShotIsThatOfItsFrames) {
  if (!isExact()) GTEST_SKIP() << "this driver rounds its own way";
  const Settings settings; // balanced
  LineageShot frames = shotOfFan(settings);
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
    const std::string weight = shortestText(static_cast<float>(entry.weight));
    EXPECT_EQ(lane["frames"][age]["weight"].dump(), weight);
    EXPECT_NE(text.out.find(" " + weight + " "), std::string::npos) << text.out;
  }
  EXPECT_EQ(lane["rectified"].get<float>(), static_cast<float>(lineage.rectified));
  for (const std::string& line : lineageSentences(lineage))
    EXPECT_NE(text.out.find(line + "\n"), std::string::npos) << text.out;
}
