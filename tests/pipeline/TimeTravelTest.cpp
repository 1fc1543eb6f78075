// Frame n is a function: however it is reached and however much is looked at, the same bits, with every
// preset (manual, architecture–3).
#include "core/inspect/Inspector.h"

#include "core/base/Error.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"
#include "core/taa/twin/Stages.h"
#include "tests/support/CompareImages.h"
#include "tests/support/GlTest.h"
#include "tests/support/frames/Frames.h"
#include "tests/support/frames/ResolveTest.h"
#include "tests/support/frames/TwinInputs.h"
#include "tests/support/frames/Variants.h"

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace taa {
namespace {

constexpr int kWidth = 80;
constexpr int kHeight = 45;
constexpr int kFrame = 13; // not a round number: between checkpoints, whatever their distance

constexpr int kLanes = 4;

/// The presets in lots of as many as run beside each other; a last lot draws less than the picture, or
/// otherwise.
int lotCount() {
  return (static_cast<int>(wholePresets().size()) + kLanes - 1) / kLanes + 1;
}

std::vector<Settings> presetLanes(int lot) {
  std::vector<Settings> lanes;
  const std::vector<Preset>& presets = wholePresets();
  for (std::size_t i = 0; i < presets.size(); ++i)
    if (static_cast<int>(i) / kLanes == lot) lanes.push_back(presets[i].settings);
  if (lot < lotCount() - 1) return lanes;
  for (const auto& [id, scale] :
       {std::pair{"balanced", 0.5f}, std::pair{"donut", 0.5f}, std::pair{"hdrp-high", 0.67f}}) {
    lanes.push_back(preset(id).settings);
    lanes.back().inputs.renderScale = scale;
  }
  // What is drawn in another way, with a jitter that follows the camera over the frames before.
  lanes.push_back(preset("balanced").settings);
  for (const char* assignment : {"jitter.sequence=perpendicular", "jitter.projection=rightAsPrinted",
                                 "inputs.motion=objectsAsPrinted", "inputs.range=ldr"})
    applyAssignment(lanes.back(), assignment);
  return lanes;
}

/// Every intermediate of every lane; resolved, history length and dilated depth are the next frame's history.
std::vector<Image> everything(Inspector& inspector) {
  std::vector<Image> pictures;
  for (int lane = 0; lane < inspector.shot().laneCount(); ++lane) {
    for (Image& picture : inspector.views().images(allRows(), lane)) pictures.push_back(std::move(picture));
  }
  return pictures;
}

/// The first picture in which two moments differ, and where; empty when none does.
std::string difference(const std::vector<Image>& a, const std::vector<Image>& b) {
  if (a.size() != b.size()) return "different numbers of pictures";
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::string where = test::difference(a[i], b[i]);
    if (where.empty()) continue;
    return std::string(kResolveRows[i % kResolveRowCount].name) + " of lane " +
           std::to_string(i / kResolveRowCount) + ": " + where;
  }
  return {};
}

bool agree(const std::vector<Image>& a, const std::vector<Image>& b) {
  return std::ranges::equal(a, b,
                            [](const Image& one, const Image& other) { return test::agree(one, other); });
}

void play(Inspector& inspector, int frame) {
  while (inspector.shot().frame() < frame) inspector.shot().seek(inspector.shot().frame() + 1);
}

/// One Inspector at a time, for each brings its own context.
class TimeTravel : public test::GlTest {
 protected:
  explicit TimeTravel(std::string scene) : scene_(std::move(scene)) {}

  void open(Inspector& inspector, const std::vector<Settings>& lanes) const {
    inspector.shot().setSize(kWidth, kHeight);
    inspector.shot().open("builtin:" + scene_);
    inspector.shot().setLanes(lanes);
  }

  /// All of a frame, from an inspector that keeps nothing and went straight there.
  std::vector<Image> soughtAtOnce(const std::vector<Settings>& lanes, int frame) const {
    Inspector inspector;
    inspector.shot().setCheckpointBudget(0);
    open(inspector, lanes);
    inspector.shot().seek(frame);
    EXPECT_TRUE(inspector.shot().isExact());
    return everything(inspector);
  }

 private:
  std::string scene_;
};

/// Parameters: a built-in scene and a lot of presets.
class TimeTravelOfPresetsTest : public TimeTravel,
                                public testing::WithParamInterface<std::tuple<std::string, int>> {
 protected:
  TimeTravelOfPresetsTest() : TimeTravel(std::get<0>(GetParam())) {}
  const std::vector<Settings> lanes = presetLanes(std::get<1>(GetParam()));
};

TEST_P(TimeTravelOfPresetsTest, PlayingSeekingAndSteppingBackGiveTheSameBitsInEveryLane) {
  const std::vector<Image> expected = soughtAtOnce(lanes, kFrame);
  const std::vector<Image> next = soughtAtOnce(lanes, kFrame + 1);
  EXPECT_FALSE(agree(expected, next)); // frames differ at all
  Inspector inspector;
  open(inspector, lanes);
  EXPECT_EQ(inspector.shot().laneCount(), static_cast<int>(lanes.size()));
  play(inspector, kFrame);
  EXPECT_EQ(difference(everything(inspector), expected), "") << "played";
  play(inspector, kFrame + 5);
  for (int frame = kFrame + 4; frame >= kFrame; --frame) inspector.shot().seek(frame);
  EXPECT_EQ(difference(everything(inspector), expected), "") << "stepped back";
  inspector.shot().seek(kFrame + 1);
  EXPECT_EQ(difference(everything(inspector), next), "") << "and on again";
  inspector.shot().seek(40);
  inspector.shot().seek(kFrame);
  EXPECT_EQ(difference(everything(inspector), expected), "") << "sought from behind";
  inspector.shot().seek(0);
  inspector.shot().seek(kFrame);
  EXPECT_EQ(difference(everything(inspector), expected), "") << "sought from the start";
}

TEST_P(TimeTravelOfPresetsTest, ALaneIsWhatItIsAlone) {
  const std::vector<Image> together = soughtAtOnce(lanes, kFrame);
  std::vector<Image> alone;
  for (const Settings& settings : lanes) {
    for (Image& picture : soughtAtOnce({settings}, kFrame)) alone.push_back(std::move(picture));
  }
  EXPECT_EQ(difference(together, alone), "");
}

TEST_P(TimeTravelOfPresetsTest, AfterNewSettingsRefiningAndSeekingMakeItExact) {
  const std::vector<Image> balanced = soughtAtOnce({preset("balanced").settings}, kFrame);
  for (const Settings& other : lanes) {
    if (other == preset("balanced").settings) continue;
    const std::vector<Image> refined = soughtAtOnce({other}, kFrame);
    Inspector inspector;
    open(inspector, {preset("balanced").settings});
    inspector.shot().seek(kFrame);
    inspector.shot().setSettings(other);
    EXPECT_FALSE(inspector.shot().isExact());
    EXPECT_FALSE(agree(everything(inspector), refined)); // new settings on old history
    inspector.shot().refine();
    EXPECT_TRUE(inspector.shot().isExact());
    EXPECT_EQ(difference(everything(inspector), refined), "")
        << ::testing::PrintToString(differences(other, {})) << ", refined";
    inspector.shot().setSettings(preset("balanced").settings);
    inspector.shot().refine();
    inspector.shot().seek(kFrame - 3); // checkpoints of other settings must not be used
    inspector.shot().seek(kFrame);
    EXPECT_TRUE(inspector.shot().isExact());
    EXPECT_EQ(difference(everything(inspector), balanced), "")
        << ::testing::PrintToString(differences(other, {})) << " and back";
  }
}

TEST_P(TimeTravelOfPresetsTest, LookingChangesNothingOverThirtyTwoFramesOfEveryPreset) {
  const std::vector<IntermediateId> history{IntermediateId::resolved, IntermediateId::historyLength,
                                            IntermediateId::dilatedDepth};
  // Plays 32 frames; what is left as history after each, when asked to look, and everything at the end.
  const auto playWatching = [&](const std::vector<IntermediateId>& watched, bool looks) {
    std::vector<Image> seen;
    Inspector inspector;
    open(inspector, lanes);
    inspector.views().watch(watched);
    for (int frame = 0; frame < 32; ++frame) {
      inspector.shot().seek(frame);
      for (int lane = 0; looks && lane < inspector.shot().laneCount(); ++lane) {
        inspector.probes().probe(frame, frame, lane);
        inspector.views().picture(IntermediateId::motion, {}, {}, 40, 40, lane);
        for (Image& image : inspector.views().images(history, lane)) seen.push_back(std::move(image));
      }
    }
    return std::pair(std::move(seen), everything(inspector));
  };
  const auto blind = playWatching({}, false);
  const auto glancing = playWatching({IntermediateId::clipAmount}, true);
  const auto staring = playWatching(allRows(), true);
  ASSERT_EQ(glancing.first.size(), staring.first.size());
  for (std::size_t i = 0; i < glancing.first.size(); ++i) {
    ASSERT_EQ(test::difference(glancing.first[i], staring.first[i]), "") << "picture " << i;
  }
  EXPECT_EQ(difference(blind.second, glancing.second), "");
  EXPECT_EQ(difference(blind.second, staring.second), "");
}

/// Parameter: a part of the random combinations.
class TimeTravelOfCombinationsTest : public TimeTravel, public testing::WithParamInterface<std::size_t> {
 protected:
  TimeTravelOfCombinationsTest() : TimeTravel("fan") {}
};

/// What is left to the next frame, of all lanes.
std::vector<Image> left(Inspector& inspector) {
  std::vector<Image> pictures;
  for (int lane = 0; lane < inspector.shot().laneCount(); ++lane)
    for (const IntermediateId id :
         {IntermediateId::resolved, IntermediateId::historyLength, IntermediateId::dilatedDepth})
      pictures.push_back(inspector.views().image(id, lane));
  return pictures;
}

TEST_P(TimeTravelOfCombinationsTest, SeekingIsPlayingInEveryRandomCombination) {
  const std::vector<test::Variant> all = test::partOf(test::randomCombinations(), GetParam());
  for (std::size_t first = 0; first < all.size(); first += kLanes) {
    std::vector<Settings> lanes;
    std::string names;
    for (std::size_t i = first; i < std::min(first + kLanes, all.size()); ++i) {
      lanes.push_back(all[i].settings);
      names += "\n" + all[i].name;
    }
    Inspector inspector;
    inspector.shot().setCheckpointBudget(0);
    open(inspector, lanes);
    play(inspector, 5);
    const std::vector<Image> played = left(inspector);
    inspector.shot().seek(7);
    inspector.shot().seek(0);
    inspector.shot().seek(5);
    const std::vector<Image> sought = left(inspector);
    for (std::size_t i = 0; i < played.size(); ++i)
      EXPECT_EQ(test::difference(played[i], sought[i]), "") << "lane " << i / 3 << " of" << names;
  }
}

/// What the frame after the inspector's will be resolved on, from what can be looked at: into `twin`.
void keepHistory(Inspector& inspector, twin::Inputs& twin) {
  Image color(kWidth, kHeight, 4), surface(kWidth, kHeight, 2);
  const Image resolved = inspector.views().image(IntermediateId::resolved);
  const Image length = inspector.views().image(IntermediateId::historyLength);
  const Image depth = inspector.views().image(IntermediateId::dilatedDepth);
  const glm::vec4 depthTerms = inspector.views().inputs().block.depthTerms;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      test::setColor(color, x, y, glm::vec3(resolved.texel(x, y)));
      surface.at(x, y)[0] = length.at(x, y)[0];
      surface.at(x, y)[1] = twin::viewDepth(depth.at(x, y)[0], depthTerms);
    }
  }
  twin.historyColor = color;
  twin.historySurface = surface;
  twin.historyMotion = inspector.views().image(IntermediateId::dilatedMotion);
}

/// Parameters: a built-in scene, and how large it is drawn.
class ProbeTest : public TimeTravel, public testing::WithParamInterface<std::tuple<std::string, float>> {
 protected:
  ProbeTest() : TimeTravel(std::get<0>(GetParam())) {}
};

TEST_P(ProbeTest, ProbeIsPictureIsTwin) {
  Settings settings = preset("balanced").settings;
  settings.inputs.renderScale = std::get<1>(GetParam());
  Inspector inspector;
  open(inspector, {settings});
  inspector.shot().seek(kFrame - 1);
  twin::Inputs history;
  keepHistory(inspector, history);
  inspector.shot().seek(kFrame);
  const std::vector<Image> pictures = everything(inspector);
  twin::Inputs twin = test::twinInputs(inspector.views().inputs(), nullptr);
  twin.historyColor = history.historyColor;
  twin.historySurface = history.historySurface;
  twin.historyMotion = history.historyMotion;
  EXPECT_EQ(test::differenceFromTwin(twin, settings, pictures, inspector.shot().driver().isSoftware), "");
  for (int i = 0; i < 40; ++i) { // scattered over the picture, a corner among them
    const int x = i * 37 % kWidth;
    const int y = i * 23 % kHeight;
    const PixelRecord record = inspector.probes().probe(x, y);
    const PixelRecord middle = inspector.probes().probeAround(x, y, 1)[4];
    for (std::size_t row = 0; row < kResolveRowCount; ++row) {
      EXPECT_EQ(record[row], pictures[row].texel(x, y)) << kResolveRows[row].name;
      EXPECT_EQ(middle[row], record[row]) << kResolveRows[row].name;
    }
  }
  EXPECT_THROW(inspector.probes().probe(kWidth, 0), Error);
}

/// Particles, flip-books and blended layers are functions of the frame too.
class TimeTravelOfGlassTest : public TimeTravel {
 protected:
  TimeTravelOfGlassTest() : TimeTravel("glass") {}
};

TEST_F(TimeTravelOfGlassTest, PlayingAndSeekingGiveTheSameBits) {
  std::vector<Settings> lanes(3);
  lanes[0].inputs.blended = BlendedAs::BeforeWithMotion;
  lanes[0].inputs.mask = MaskSource::AutoReactive;
  lanes[0].weight.mask = MaskAlpha::Reactive;
  lanes[1].inputs.blended = BlendedAs::After;
  lanes[1].inputs.mask = MaskSource::Material;
  lanes[1].weight.mask = MaskAlpha::Responsive;
  lanes[2].inputs.blended = BlendedAs::Dithered;
  const std::vector<Image> expected = soughtAtOnce(lanes, kFrame);
  EXPECT_FALSE(agree(expected, soughtAtOnce(lanes, kFrame + 1)));
  Inspector inspector;
  open(inspector, lanes);
  play(inspector, kFrame);
  EXPECT_EQ(difference(everything(inspector), expected), "") << "played";
  inspector.shot().seek(kFrame + 9);
  inspector.shot().seek(kFrame);
  EXPECT_EQ(difference(everything(inspector), expected), "") << "sought from behind";
}

INSTANTIATE_TEST_SUITE_P(Part, TimeTravelOfCombinationsTest, testing::Range(std::size_t{0}, test::kParts));
INSTANTIATE_TEST_SUITE_P(Scenes, ProbeTest,
                         testing::Combine(testing::Values(std::string("fan"), std::string("fence")),
                                          testing::Values(1.0f, 0.5f)));
INSTANTIATE_TEST_SUITE_P(Fan, TimeTravelOfPresetsTest,
                         testing::Combine(testing::Values(std::string("fan")),
                                          testing::Range(0, lotCount())));
INSTANTIATE_TEST_SUITE_P(Fence, TimeTravelOfPresetsTest,
                         testing::Combine(testing::Values(std::string("fence")), testing::Values(0)));

} // namespace
} // namespace taa
