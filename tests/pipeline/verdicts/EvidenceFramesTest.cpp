// What verdicts are made from is the same, bit for bit, drawn around a pixel's past and drawn whole.
#include "core/inspect/EvidenceFrames.h"

#include "core/measure/References.h"
#include "core/verdict/lineage/TwinStep.h"
#include "core/verdict/pixel/PixelError.h"
#include "core/verdict/pixel/PixelVerdict.h"
#include "tests/support/GlTest.h"
#include "tests/support/verdicts/SceneShot.h"

#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using namespace taa;

namespace {

constexpr glm::ivec2 kSizePx = test::kSceneShotPx;
constexpr int kSamples = 4;

/// Draws all of every frame.
class WholeEvidence : public EvidenceSource {
 public:
  explicit WholeEvidence(ShotPlayer& player) : player_(player), frames_(player, 0, progress_) {}
  PixelStep step(int frame, const glm::ivec2& pixel) override {
    return pixelStep(framesAt(frame), frames_.settings(), pixel);
  }
  twin::PixelRecord record(int frame, const glm::ivec2& pixel) override {
    return twin::resolvePixel(framesAt(frame), frames_.settings(), pixel.x, pixel.y);
  }
  const twin::Texels& reference(int frame) override {
    if (!means_.contains(frame)) {
      References references;
      references.refine(source(), {referenceRequest(request()), frame}, kSamples, {});
      means_[frame] = references.find({referenceRequest(request()), frame})->mean();
    }
    return means_[frame];
  }
  const twin::Texels& steps(int frame) override {
    if (!steps_.contains(frame)) {
      DrawnSurfaces last;
      steps_[frame] = startsHistory(player_.state(), frame)
                          ? firstSteps(drawSurfaces(source(), request(), frame), {0, 0, kSizePx.x, kSizePx.y})
                          : drawSteps(source(), request(), frame, last);
    }
    return steps_[frame];
  }

 private:
  const twin::Inputs& framesAt(int frame) { return frames_.at(frame, {{0, 0, kSizePx.x, kSizePx.y}}); }
  FrameSource& source() const { return *player_.state().frames; }
  FrameRequest request() const { return player_.state().request(0); }

  ShotPlayer& player_;
  Progress progress_;
  TwinFrames frames_;
  std::map<int, twin::Texels> means_, steps_;
};

/// All numbers of an error, in an order.
std::vector<double> numbersOf(const PixelError& error) {
  std::vector<double> numbers{error.resolved.x, error.reference.x, error.reference.y, error.reference.z};
  for (const ErrorOfFrame& entry : error.frames) {
    for (const glm::dvec3& part : entry.split) numbers.insert(numbers.end(), {part.x, part.y, part.z});
    for (const int number : {entry.frame, entry.pixel.x, entry.ghostPixel.y, entry.ghostObject})
      numbers.push_back(number);
  }
  return numbers;
}

/// Bit for bit: some rows have no value.
bool isSame(const twin::PixelRecord& a, const twin::PixelRecord& b) {
  return std::memcmp(a.data(), b.data(), sizeof(a)) == 0;
}

class EvidenceFramesTest : public test::GlTest {
 protected:
  void open(const std::string& source, const std::string& presetId, int frame) {
    references_.clear();
    player_.emplace(kSizePx);
    player_->open(test::sceneShot(source, presetId));
    player_->goTo(frame, {});
  }
  /// Of `frames` frames, `last` the latest.
  void expectErrorsOfWholes(const char* source, int last, int frames) {
    WholeEvidence whole(*player_);
    for (const glm::ivec2& pixel : {glm::ivec2(80, 45), glm::ivec2(0, 89), glm::ivec2(56, 84)}) {
      EvidenceFrames parts(*player_, references_, 0, {kSamples, kSamples}, progress_);
      const std::vector<SurfaceMoment> moments = parts.moments(last, pixel, frames);
      LineageOptions options;
      options.frames = frames;
      EXPECT_EQ(numbersOf(pixelError(parts, last, pixel, options)),
                numbersOf(pixelError(whole, last, pixel, options)))
          << source << " " << pixel.x;
      for (const SurfaceMoment& moment : moments)
        EXPECT_TRUE(
            isSame(parts.record(moment.frame, moment.pixel), whole.record(moment.frame, moment.pixel)));
    }
  }
  std::optional<ShotPlayer> player_; // made when the context is current
  References references_;
  Progress progress_;
};

} // namespace

TEST_F(EvidenceFramesTest, ErrorsAreThoseOfWholePictures) {
  const std::vector<std::pair<const char*, const char*>> shots{
      {"builtin:disocclusion", "unrectified"}, {"builtin:fan", "minimal"}, {"builtin:fog", "balanced"}};
  for (const auto& [source, presetId] : shots) {
    open(source, presetId, 12);
    expectErrorsOfWholes(source, 12, 9);
  }
}

TEST_F(EvidenceFramesTest, ErrorsAreThoseOfWholePicturesWhereSurfacesAreDense) {
  for (const char* source : {"builtin:crowd", "builtin:foliage"}) {
    open(source, "balanced", 4);
    expectErrorsOfWholes(source, 4, 4);
  }
}

TEST_F(EvidenceFramesTest, MomentsAreFilledWithWhatTheirPixelsShow) {
  open("builtin:disocclusion", "unrectified", 9);
  WholeEvidence whole(*player_);
  EvidenceFrames parts(*player_, references_, 0, {kSamples, kSamples}, progress_);
  std::vector<SurfaceMoment> moments = parts.moments(9, {90, 50}, 16);
  ASSERT_GT(moments.size(), 2u) << "it was seen before";
  parts.fill(moments);
  for (const SurfaceMoment& moment : moments) {
    EXPECT_TRUE(isSame(moment.record, whole.record(moment.frame, moment.pixel))) << moment.frame;
    EXPECT_EQ(moment.reference, pixelColorAt(whole.reference(moment.frame), moment.pixel)) << moment.frame;
  }
}

TEST_F(EvidenceFramesTest, ReferencesAreKeptForTheNextPixel) {
  open("builtin:crowd", "balanced", 3);
  const glm::ivec2 pixel(80, 45);
  {
    EvidenceFrames first(*player_, references_, 0, {kSamples, kSamples}, progress_);
    first.reference(3).texel(pixel.x, pixel.y);
  }
  EXPECT_GT(references_.bytes(), 0u);
  const std::size_t bytes = references_.bytes();
  EvidenceFrames second(*player_, references_, 0, {kSamples, kSamples}, progress_);
  second.reference(3).texel(pixel.x + 1, pixel.y);
  EXPECT_EQ(references_.bytes(), bytes) << "nothing was drawn again";
  second.reference(3).texel(0, 0);
  EXPECT_GT(references_.bytes(), bytes);
}

TEST_F(EvidenceFramesTest, ReferencesThatAreThereAreNotDrawnInParts) {
  open("builtin:fan", "balanced", 2);
  const ReferenceKey key{referenceRequest(player_->state().request(0)), 2};
  references_.refine(*player_->state().frames, key, kSamples, {});
  const Image whole = references_.find(key)->mean();
  const std::size_t bytes = references_.bytes();
  EvidenceFrames frames(*player_, references_, 0, {kSamples, kSamples}, progress_);
  for (const glm::ivec2& pixel : {glm::ivec2(0, 0), glm::ivec2(77, 40), glm::ivec2(159, 89)})
    EXPECT_EQ(pixelColorAt(frames.reference(2), pixel), pixelColorAt(whole, pixel));
  EXPECT_EQ(references_.bytes(), bytes);
}

// From four sets of four samples, each the difference of means of the first samples.
TEST_F(EvidenceFramesTest, ReferencesSayHowFarTheyMayBeOff) {
  constexpr int kSet = 4, kAll = 4 * kSet;
  open("builtin:fan", "balanced", 2);
  const ReferenceKey key{referenceRequest(player_->state().request(0)), 2};
  std::vector<Image> means;
  for (int samples = kSet; samples <= kAll; samples += kSet)
    means.push_back(references_.meanOfFirst(*player_->state().frames, key, samples, {}));
  EvidenceFrames frames(*player_, references_, 0, {kAll, kAll}, progress_);
  double most = 0.0, least = 1.0;
  for (int x = 60; x < 100; ++x) {
    const glm::ivec2 pixel(x, 40);
    std::vector<glm::dvec3> sets;
    glm::dvec3 before(0.0), mean(0.0), squares(0.0);
    for (std::size_t set = 0; set < means.size(); ++set) {
      const glm::dvec3 sum = static_cast<double>(set + 1) * pixelColorAt(means[set], pixel);
      sets.push_back(shownValue(sum - before));
      before = sum;
      mean += sets.back() / 4.0;
    }
    for (const glm::dvec3& set : sets) squares += (set - mean) * (set - mean);
    double expected = 0.0;
    for (int channel = 0; channel < 3; ++channel)
      expected = std::max(expected, std::sqrt(squares[channel] / (4.0 * 3.0)));
    // Means are floats, and the curve of a screen is 13 times as steep where it is dark.
    EXPECT_NEAR(*frames.referenceError(2, pixel), expected, 2e-5) << x;
    most = std::max(most, expected);
    least = std::min(least, expected);
  }
  EXPECT_GT(most, 0.01) << "there is an edge";
  EXPECT_LT(least, 1e-3) << "and something flat";
}

TEST_F(EvidenceFramesTest, LittleIsDrawnForLittle) {
  open("builtin:crowd", "balanced", 3);
  FrameInputs drawn;
  FrameSource& source = *player_->state().frames;
  source.draw(referenceRequest(player_->state().request(0)), 3, drawn);
  const int whole = source.counts().drawn;
  EvidenceFrames frames(*player_, references_, 0, {kSamples, kSamples}, progress_);
  frames.reference(3).texel(80, 45);
  EXPECT_LT(source.counts().drawn, whole / 3);
}
