// Parts of the error of sequences made by hand, each with one known cause.
#include "core/verdict/parts/ErrorParts.h"

#include "core/probe/SurfaceSteps.h"
#include "core/taa/twin/HistoryTaps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

using taa::ErrorPart;
using taa::ErrorParts;
using taa::FrameErrors;
using taa::Image;

namespace {

constexpr int kWide = 24, kHigh = 10;
constexpr float kAlpha = 0.25f; // its powers and products with sixteenths are exact
constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();
constexpr taa::HistorySettings kBilinear{taa::HistoryFilter::Bilinear, taa::Switch::Off,
                                         taa::Precision::Full};

using GrayAt = std::function<float(int x, int y)>;

Image gray(const GrayAt& value, int channels = 3) {
  Image image(kWide, kHigh, channels);
  for (int y = 0; y < kHigh; ++y)
    for (int x = 0; x < kWide; ++x)
      for (int channel = 0; channel < channels; ++channel) image.at(x, y)[channel] = value(x, y);
  return image;
}

/// A resolve without anything but the recursion itself: out = α·c + (1 − α)·h', with h' = `rectified` of h.
class Sequence {
 public:
  GrayAt reference = [](int, int) { return 0.5f; };
  GrayAt current;                             ///< empty: the reference
  GrayAt rectified;                           ///< empty: history as it was read
  float motion = 0.0f;                        ///< px a frame to the right, of surface and history position
  float historyOff = 0.0f;                    ///< px, of the history position from the surface
  std::function<bool(int x, int y)> isHidden; ///< before, so that it was not seen

  void start() {
    taa::PartsInputs now = inputs();
    now.resolved = now.current;
    add(std::move(now), nullptr);
  }

  void next() {
    taa::PartsInputs now = inputs();
    now.alpha = gray([](int, int) { return kAlpha; }, 1);
    now.depthEdge = Image(kWide, kHigh, 1);
    now.historyPosition = Image(kWide, kHigh, 2);
    now.steps = Image(kWide, kHigh, taa::kStepChannels);
    for (int y = 0; y < kHigh; ++y)
      for (int x = 0; x < kWide; ++x) {
        const float from = static_cast<float>(x) + 0.5f - motion;
        now.historyPosition.at(x, y)[0] = from + historyOff;
        now.historyPosition.at(x, y)[1] = static_cast<float>(y) + 0.5f;
        const bool isSeen = from >= 0.0f && from < float(kWide) && !(isHidden && isHidden(x, y));
        now.steps.at(x, y)[0] = isSeen ? motion : kNothing;
        now.steps.at(x, y)[1] = isSeen ? 0.0f : kNothing;
        const float read = rectified ? rectified(x, y) : readOf(now, x, y);
        for (int channel = 0; channel < 3; ++channel)
          now.resolved.at(x, y)[channel] = kAlpha * now.current.at(x, y)[channel] + (1.0f - kAlpha) * read;
      }
    const Image before = reference_;
    add(std::move(now), &before);
  }

  ErrorParts parts(std::size_t frames = 99, const taa::Progress& progress = {}) const {
    const std::size_t first = frames >= errors_.size() ? 0 : errors_.size() - frames;
    std::vector<const FrameErrors*> window;
    for (std::size_t k = first; k < errors_.size(); ++k) window.push_back(&errors_[k]);
    return taa::errorParts({window, first == 0}, kBilinear, progress);
  }
  const Image& error() const { return errors_.back().error; }

 private:
  taa::PartsInputs inputs() const {
    taa::PartsInputs now;
    now.reference = gray(reference);
    now.current = gray(current ? current : reference);
    now.resolved = Image(kWide, kHigh, 3);
    return now;
  }
  float readOf(const taa::PartsInputs& now, int x, int y) const {
    const float* place = now.historyPosition.at(x, y);
    float sum = 0.0f;
    const auto texels = taa::twin::historyTexels(kBilinear, {place[0], place[1]}, {kWide, kHigh});
    for (const auto& texel : texels.all()) sum += texel.weight * *resolved_.at(texel.at.x, texel.at.y);
    return sum;
  }
  void add(taa::PartsInputs now, const Image* before) {
    errors_.push_back(taa::frameErrors(now, before, kBilinear));
    resolved_ = std::move(now.resolved);
    reference_ = std::move(now.reference);
  }

  std::vector<FrameErrors> errors_;
  Image resolved_, reference_;
};

float meanOf(const Image& image) {
  double sum = 0.0;
  for (const float value : image.pixels) sum += std::fabs(static_cast<double>(value));
  return static_cast<float>(sum / static_cast<double>(image.pixels.size()));
}

void expectNothingBut(const ErrorParts& parts, std::initializer_list<ErrorPart> there, float tolerance) {
  for (std::size_t part = 0; part < taa::kErrorParts; ++part) {
    const bool isThere = std::ranges::find(there, static_cast<ErrorPart>(part)) != there.end();
    for (const float value : parts.images[part].pixels)
      if (!isThere) {
        ASSERT_LE(std::fabs(value), tolerance) << "part " << part;
      }
  }
}

bool isInMask(int x, int y) {
  return x >= 5 && x < 12 && y >= 2 && y < 6;
}

/// Any texture that repeats nothing, multiples of 1/16.
float texture(int x) {
  return static_cast<float>((x * 11 + x / 3 * 5 + 700) % 16) / 16.0f;
}

// Roundings of a window, each of values below 2.
constexpr float kRounding = 1e-6f;

} // namespace

TEST(ErrorParts, SumUpToTheError) {
  Sequence all;
  all.motion = 0.3f;
  all.historyOff = 0.1f;
  all.start();
  for (int k = 1; k < 9; ++k) {
    all.reference = [k](int x, int y) { return texture(x - k) + 0.1f * static_cast<float>(y % 3 * k); };
    all.current = [k](int x, int y) { return texture(x - k + 1) * static_cast<float>((x + y) % 2); };
    all.isHidden = [k](int x, int) { return x % 7 == k; };
    if (k == 6) all.rectified = [](int x, int) { return 0.3f * static_cast<float>(x % 5); };
    all.next();
  }
  const ErrorParts parts = all.parts(6);
  for (std::size_t at = 0; at < all.error().pixels.size(); ++at) {
    double sum = 0.0;
    for (const Image& part : parts.images) sum += static_cast<double>(part.pixels[at]);
    // The remainder is rounded once.
    EXPECT_NEAR(sum, all.error().pixels[at],
                std::fabs(parts.at(ErrorPart::Rectification).pixels[at]) * 0x1p-24 + 1e-30);
  }
  for (const Image& part : parts.images) EXPECT_GT(meanOf(part), 1e-4f) << "else nothing was tested";
}

TEST(ErrorParts, OfAResolveThatOnlyMixesLeaveNothingToRectification) {
  Sequence mixed;
  mixed.motion = 0.375f;
  mixed.start();
  for (int k = 1; k < 12; ++k) {
    mixed.reference = [k](int x, int) { return texture(x - k); };
    mixed.current = [k](int x, int y) { return texture(x + y * k); };
    mixed.next();
  }
  for (const std::size_t frames : {3u, 7u, 12u}) {
    const taa::ErrorParts parts = mixed.parts(frames);
    for (const float value : parts.at(ErrorPart::Rectification).pixels)
      EXPECT_NEAR(value, 0.0f, kRounding) << frames;
  }
}

TEST(ErrorParts, AreLagExactlyWhereALightChanged) {
  Sequence light;
  light.start();
  light.next();
  light.reference = [](int x, int y) { return isInMask(x, y) ? 0.75f : 0.5f; };
  float left = 1.0f; // of history
  for (int k = 0; k < 3; ++k) {
    light.next();
    left *= 1.0f - kAlpha;
    const ErrorParts parts = light.parts();
    for (int y = 0; y < kHigh; ++y)
      for (int x = 0; x < kWide; ++x)
        EXPECT_EQ(*parts.at(ErrorPart::Lag).at(x, y), isInMask(x, y) ? -0.25f * left : 0.0f)
            << x << ", " << y;
    expectNothingBut(parts, {ErrorPart::Lag}, 0.0f);
  }
}

TEST(ErrorParts, AreAGhostExactlyWhereAnObjectHasBeen) {
  Sequence teleport;
  teleport.reference = [](int x, int y) { return isInMask(x, y) ? 1.0f : 0.25f; };
  teleport.start();
  teleport.next();
  const auto isNow = [](int x, int y) { return isInMask(x - 9, y); };
  teleport.reference = [&](int x, int y) { return isNow(x, y) ? 1.0f : 0.25f; };
  teleport.isHidden = [&](int x, int y) { return isInMask(x, y) || isNow(x, y); };
  teleport.next();
  teleport.isHidden = {};
  teleport.next();
  const ErrorParts parts = teleport.parts();
  constexpr float kLeft = (1.0f - kAlpha) * (1.0f - kAlpha);
  for (int y = 0; y < kHigh; ++y)
    for (int x = 0; x < kWide; ++x)
      EXPECT_EQ(*parts.at(ErrorPart::Ghost).at(x, y), isNow(x, y)      ? -0.75f * kLeft
                                                      : isInMask(x, y) ? 0.75f * kLeft
                                                                       : 0.0f)
          << x << ", " << y;
  expectNothingBut(parts, {ErrorPart::Ghost}, 0.0f);
}

TEST(ErrorParts, AreAGhostWhereHistoryWasReadBesideTheSurface) {
  const auto ghostOf = [](float off) {
    Sequence wrong;
    wrong.reference = [](int x, int) { return texture(x); };
    wrong.historyOff = off;
    wrong.start();
    wrong.next();
    return wrong.parts();
  };
  EXPECT_GT(meanOf(ghostOf(0.75f).at(ErrorPart::Ghost)), 0.05f);
  EXPECT_EQ(meanOf(ghostOf(0.5f).at(ErrorPart::Ghost)), 0.0f) << "within the pixel";
  EXPECT_GT(meanOf(ghostOf(0.5f).at(ErrorPart::Blur)), 0.05f);
}

TEST(ErrorParts, AreAliasingAloneWhereNothingButTheSamplesMoves) {
  Sequence jittered;
  jittered.reference = [](int x, int) { return texture(x); };
  jittered.current = [](int x, int) { return texture(x + 1); };
  jittered.start();
  for (int k = 1; k < 10; ++k) {
    jittered.current = [k](int x, int) { return 0.5f * (texture(x + k % 3 - 1) + texture(x)); };
    jittered.next();
  }
  const ErrorParts parts = jittered.parts();
  expectNothingBut(parts, {ErrorPart::Aliasing}, kRounding);
  EXPECT_GT(meanOf(parts.at(ErrorPart::Aliasing)), 0.01f);
}

TEST(ErrorParts, AreBlurWhereAFilterThatBlursFollowsAStillTexture) {
  // The texture moves by half a pixel a frame, drawn exactly: in odd frames pixels show means of two.
  Sequence moving;
  moving.motion = 0.5f;
  const auto at = [](int frame) {
    return [frame](int x, int) {
      const int whole = x - frame / 2;
      return frame % 2 == 0 ? texture(whole) : 0.5f * (texture(whole) + texture(whole - 1));
    };
  };
  moving.reference = at(0);
  moving.start();
  for (int frame = 1; frame < 9; ++frame) {
    moving.reference = at(frame);
    moving.next();
  }
  const ErrorParts parts = moving.parts();
  float blur = 0.0f, rest = 0.0f;
  for (int y = 0; y < kHigh; ++y)
    for (int x = 10; x < kWide; ++x) { // what came in at the left had no history
      blur += std::fabs(*parts.at(ErrorPart::Blur).at(x, y));
      for (const ErrorPart part : {ErrorPart::Ghost, ErrorPart::Lag, ErrorPart::Aliasing, ErrorPart::Older})
        rest += std::fabs(*parts.at(part).at(x, y));
    }
  EXPECT_GT(blur, 1.0f);
  EXPECT_LT(rest, 0.02f * blur);
}

TEST(ErrorParts, TakeALineThatResamplingMayExplainForNoLag) {
  // A line a pixel wide at each phase, which a frame later fills a pixel.
  for (int phase = 1; phase < 16; ++phase) {
    Sequence line;
    const float f = static_cast<float>(phase) / 16.0f;
    line.reference = [f](int x, int) { return x == 8 ? 1.0f - f : x == 9 ? f : 0.0f; };
    line.start();
    line.motion = 1.0f - f;
    line.reference = [](int x, int) { return x == 9 ? 1.0f : 0.0f; };
    line.next();
    EXPECT_NEAR(*line.parts().at(ErrorPart::Lag).at(9, 4), 0.0f, kRounding) << phase;
    EXPECT_LT(*line.parts().at(ErrorPart::Blur).at(9, 4), -0.05f) << phase;
  }
}

TEST(ErrorParts, AreOlderByWhatTheFirstFrameCameWith) {
  Sequence poisoned;
  poisoned.current = [](int x, int y) { return isInMask(x, y) ? 1.0f : 0.5f; };
  poisoned.start();
  poisoned.current = {};
  for (int k = 0; k < 4; ++k) poisoned.next();
  const ErrorParts parts = poisoned.parts(3);
  const float left = std::pow(1.0f - kAlpha, 4.0f);
  for (int y = 0; y < kHigh; ++y)
    for (int x = 0; x < kWide; ++x)
      EXPECT_EQ(*parts.at(ErrorPart::Older).at(x, y), isInMask(x, y) ? 0.5f * left : 0.0f);
  expectNothingBut(parts, {ErrorPart::Older}, 0.0f);
  expectNothingBut(poisoned.parts(), {ErrorPart::Aliasing}, 0.0f); // from the first on it is known
}

TEST(ErrorParts, AreRectificationsByWhatItDid) {
  Sequence clipped;
  clipped.start();
  clipped.rectified = [](int x, int y) { return isInMask(x, y) ? 0.75f : 0.5f; };
  clipped.next();
  const ErrorParts parts = clipped.parts();
  for (int y = 0; y < kHigh; ++y)
    for (int x = 0; x < kWide; ++x)
      EXPECT_EQ(*parts.at(ErrorPart::Rectification).at(x, y),
                isInMask(x, y) ? (1.0f - kAlpha) * 0.25f : 0.0f);
  expectNothingBut(parts, {ErrorPart::Rectification}, 0.0f);
}

TEST(ErrorParts, AreTheSamplesWhereHistoryStarts) {
  Sequence first;
  first.current = [](int, int) { return 0.625f; };
  first.start();
  const ErrorParts parts = first.parts();
  expectNothingBut(parts, {ErrorPart::Aliasing}, 0.0f);
  for (const float value : parts.at(ErrorPart::Aliasing).pixels) EXPECT_EQ(value, 0.125f);
}

TEST(ErrorParts, StopWhenTheyAreTold) {
  Sequence three;
  for (int k = 0; k < 3; ++k) k == 0 ? three.start() : three.next();
  EXPECT_THROW(three.parts(99, [](std::string_view, int done, int) { return done < 2; }), taa::Cancelled);
}
