// Stories of stages 3 and 4: the taps that history and this frame's color are means of.
#include "core/story/StoryText.h"

#include "core/base/Say.h"
#include "core/settings/Parameters.h"
#include "core/taa/twin/Color.h"

#include <array>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace taa::story {

std::string choiceLabel(std::string_view path, const Settings& settings) {
  const Parameter& row = parameter(path);
  return std::string(row.choices[static_cast<std::size_t>(row.get(settings))].label);
}

std::string weightedMean(const Teller& t, std::span<const float> weights, std::span<const float> values,
                         bool isDivided) {
  std::string sum, total;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    if (weights[k] == 0.0f) continue;
    const std::string weight = t.number(weights[k]);
    sum += (sum.empty() ? "" : " + ") + weight + " × " + t.number(values[k]);
    total += (total.empty() ? "" : " + ") + weight;
  }
  return isDivided ? "(" + sum + ") / (" + total + ")" : sum;
}

namespace {

/// Weights and reds of taps, and the range of those that bound the result.
struct Reds {
  std::vector<float> weights, values;
  float low = 0.0f, high = 0.0f;
  float sum = 0.0f;
};

Reds redsOf(const twin::Taps& taps) {
  Reds reds;
  reds.low = reds.high = taps.each[taps.middle].color.x;
  for (const twin::Taps::Tap& tap : taps.all()) {
    reds.weights.push_back(tap.weight);
    reds.values.push_back(tap.color.x);
    reds.sum += tap.weight;
    if (!tap.bounds) continue;
    reds.low = std::fmin(reds.low, tap.color.x);
    reds.high = std::fmax(reds.high, tap.color.x);
  }
  return reds;
}

std::string clamped(const Teller& t, const std::string& text, float low, float high) {
  return call("clamp", {text, t.number(low), t.number(high)});
}

std::string ending(const Teller& t, Id id) {
  return " = " + t.number(t.color(id).x);
}

/// By what history is read, and where.
std::string historyReadWords(const Teller& t, bool isEdge) {
  const glm::vec2 at = t.details().readPosition;
  const std::string fraction =
      t.tuple((at - 0.5f) - glm::vec2(std::floor(at.x - 0.5f), std::floor(at.y - 0.5f)));
  if (isEdge)
    return say<"Bilinear, for depth has an edge, at %1, %2 of a texel from the one before">(t.tuple(at),
                                                                                            fraction);
  return say<"%1 at %2, %3 of a texel from the one before">(choiceLabel("history.filter", t.settings()),
                                                            t.tuple(at), fraction);
}

RowStory rawStory(const Teller& t) {
  const HistorySettings& history = t.settings().history;
  const bool isEdge = t.value(Id::depthEdge) != 0.0f;
  const twin::Taps& taps = t.details().historyTaps;
  const std::string read = historyReadWords(t, isEdge);
  if (taps.count == 0) return {read, "", ""};
  if (taps.count == 1)
    return {say<"%1: one tap">(read), t.equals(t.tuple(taps.each[0].color), Id::historyRaw), ""};
  const Reds reds = redsOf(taps);
  const std::string words =
      say<"%1: %2 taps, their weights are %3 together">(read, taps.count, t.number(reds.sum));
  const bool isPlain = isEdge || history.filter == HistoryFilter::Bilinear;
  const bool isDivided = !isPlain && history.filter != HistoryFilter::CatmullRom5AsPrinted &&
                         history.filter != HistoryFilter::CatmullRom5Corners;
  std::string text = weightedMean(t, reds.weights, reds.values, isDivided);
  if (!isPlain && isOn(history.dering)) text = clamped(t, text, reds.low, reds.high);
  if (!isPlain) text = call("max", {text, "0"});
  return {words, text + ending(t, Id::historyRaw), "R"};
}

std::string edgeWords(const Teller& t) {
  if (!isOn(t.settings().history.bilinearAtEdges)) return say<"off">();
  return t.value(Id::depthEdge) != 0.0f ? say<"an edge in depth: read by one bilinear tap">()
                                        : say<"no edge in depth: the filter is used">();
}

RowStory historyStory(Id id, const Teller& t) {
  if (t.details().isFirst) return {say<"there is no history yet">(), "", ""};
  if (id == Id::depthEdge) return {edgeWords(t), "", ""};
  if (id == Id::historyRawLength && t.settings().history.length == LengthFrom::PixelAsPrinted)
    return {say<"as many frames' worth of samples were stored in this pixel, whatever it showed">(), "", ""};
  if (id == Id::historyRawLength && t.settings().history.length == LengthFrom::Bilinear)
    return {say<"as many frames' worth of samples were stored around %1, by bilinear interpolation">(
                t.tuple(t.details().readPosition)),
            "", ""};
  if (id == Id::historyRawLength)
    return {say<"as many frames' worth of samples were stored around %1">(t.tuple(t.details().readPosition)),
            "", ""};
  return rawStory(t);
}

/// Of the nine samples as they count, luma weighting put in.
twin::Taps currentTaps(const Teller& t) {
  twin::Taps taps;
  taps.middle = 4;
  const bool byLuma = isOn(t.settings().current.lumaWeighted);
  for (std::size_t k = 0; k < 9; ++k) {
    const glm::vec3& color = t.details().filterSamples[k];
    const float weight = t.details().filterWeights[k];
    taps.add(color, byLuma ? weight / (1.0f + twin::weightLuma(color, t.settings().space.luma)) : weight);
  }
  return taps;
}

/// A bilinear tap at `jitter` from the pixel's center.
std::string unjitterText(const Teller& t, const glm::vec2& jitter) {
  const int dx = jitter.x < 0.0f ? -1 : 1, dy = jitter.y < 0.0f ? -1 : 1;
  const float fx = std::fabs(jitter.x), fy = std::fabs(jitter.y);
  const auto red = [&](int x, int y) {
    const int place = 4 + x + 3 * y;
    return t.details().filterSamples[static_cast<std::size_t>(place)].x;
  };
  const std::array weights{(1.0f - fx) * (1.0f - fy), fx * (1.0f - fy), (1.0f - fx) * fy, fx * fy};
  const std::array values{red(0, 0), red(dx, 0), red(0, dy), red(dx, dy)};
  return weightedMean(t, weights, values, false);
}

RowStory upsampledStory(const Teller& t) {
  const UpsampleKernel chosen = t.settings().current.upsample;
  const std::array<glm::vec3, 9>& nine = t.details().filterSamples;
  const std::string kernel = choiceLabel("current.upsample", t.settings());
  const twin::Taps& taps = t.details().upsampleTaps;
  const Reds reds = redsOf(taps);
  if (taps.count == 0 || !(reds.sum > 1e-4f))
    return {say<"%1: the nearest sample, %2 px from the center">(kernel, t.tuple(t.details().sampleOffset)),
            t.number(nine[4].x), "R"};
  std::string text = weightedMean(t, reds.weights, reds.values);
  float low = nine[4].x, high = nine[4].x;
  for (const glm::vec3& sample : nine) low = std::fmin(low, sample.x), high = std::fmax(high, sample.x);
  const bool hasLobes = chosen != UpsampleKernel::Hdrp && chosen != UpsampleKernel::HdrpGaussian;
  if (hasLobes) text = clamped(t, text, low, high);
  return {say<"%1 over %2 samples of what was drawn smaller">(kernel, taps.count), call("max", {text, "0"}),
          "R"};
}

RowStory meanStory(const Teller& t, bool isBounded) {
  const Reds reds = redsOf(currentTaps(t));
  std::string mean = weightedMean(t, reds.weights, reds.values);
  if (isBounded) mean = clamped(t, mean, reds.low, reds.high);
  return {say<"%1 over the nine samples">(choiceLabel("current.filter", t.settings())),
          call("max", {mean, "0"}), "R"};
}

/// The color before it is sharpened: words, and what its red is.
RowStory filteredStory(const Teller& t) {
  const CurrentSettings& current = t.settings().current;
  if (isUpsampled(t.settings())) return upsampledStory(t);
  switch (current.filter) {
  case CurrentFilter::Center:
    return {say<"the sample as it is">(), t.number(t.details().filterSamples[4].x), "R"};
  case CurrentFilter::Unjitter:
    return {say<"read where the pixel's center landed">(), unjitterText(t, t.details().jitterPx), "R"};
  case CurrentFilter::UnjitterAsPrinted:
    return {say<"read on the other side of where the pixel's center landed">(),
            unjitterText(t, -t.details().jitterPx), "R"};
  case CurrentFilter::Mitchell:
  case CurrentFilter::CatmullRom:
  case CurrentFilter::Lanczos:
    return meanStory(t, isOn(current.dering));
  case CurrentFilter::Gaussian:
  case CurrentFilter::Tent:
  case CurrentFilter::Box:
  case CurrentFilter::BlackmanHarris:
  case CurrentFilter::DistanceAsPrinted:
  case CurrentFilter::MitchellAsPrinted:
  case CurrentFilter::BlackmanHarrisAsPrinted:
    break;
  }
  return meanStory(t, false);
}

RowStory currentStory(const Teller& t) {
  const CurrentSettings& current = t.settings().current;
  RowStory story = filteredStory(t);
  if (current.sharpen != CurrentSharpen::None) {
    const std::string f = t.number(t.details().unsharpened.x), s = t.number(current.sharpenAmount);
    std::string four;
    for (const std::size_t k : {1u, 3u, 5u, 7u})
      four += (four.empty() ? "" : " + ") + t.number(t.details().filterSamples[k].x);
    const bool isPrinted = current.sharpen == CurrentSharpen::LaplacianAsPrinted;
    story.words = say<"%1, then sharpened by the four around">(story.words);
    story.formula = call("max", {isPrinted ? "5 × " + s + " × " + f + " − " + s + " × (" + four + ")"
                                           : f + " − " + s + " × ((" + four + ") / 4 − " + f + ")",
                                 "0"});
  }
  story.formula += ending(t, Id::currentFiltered);
  return story;
}

RowStory filteredBoxStory(const Teller& t) {
  const std::string at = t.tuple(t.details().sampleOffset);
  return {t.value(Id::sampleConfidence) > 0.0f
              ? say<"the nearest sample lies in HDRP's box: %1 px from the pixel's center">(at)
              : say<"no sample lies in HDRP's box: the nearest is %1 px from the pixel's center">(at),
          "", ""};
}

RowStory bellStory(const Teller& t) {
  const glm::vec2 ratio = t.details().renderRatio, x = t.details().sampleOffset / ratio;
  const std::string bell = "2^(−0.5 × (" + call("length", {t.tuple(x)}) + " / 0.4)^2)";
  return {say<"how near the nearest sample lies, %1 px of the picture from the pixel's center">(t.tuple(x)),
          t.equals(call("min", {bell + " / (" + t.number(ratio.x) + " × " + t.number(ratio.y) + ")", "1"}),
                   Id::sampleConfidence),
          ""};
}

RowStory nearestStory(const Teller& t) {
  const glm::vec2 d = t.details().sampleOffset, ratio = t.details().renderRatio;
  const std::string near = "1 − (" + t.number(d.x * d.x) + " / " + t.number(ratio.x) + " + " +
                           t.number(d.y * d.y) + " / " + t.number(ratio.y) + ")";
  return {say<"how near the nearest sample lies, %1 px from the pixel's center, "
              "or all of it where it moves">(t.tuple(d)),
          t.equals(call("max", {call("clamp", {near, "0", "1"}), call("smooth", {t.number(Id::speed)})}),
                   Id::sampleConfidence),
          ""};
}

RowStory sumStory(const Teller& t) {
  std::string sum;
  for (const twin::Taps::Tap& tap : t.details().upsampleTaps.all())
    if (tap.weight != 0.0f) sum += (sum.empty() ? "" : " + ") + t.number(tap.weight);
  if (sum.empty()) return {say<"no sample is near enough">(), "", ""};
  return {say<"what the samples weigh together, the nearest %1 px from the pixel's center">(
              t.tuple(t.details().sampleOffset)),
          t.equals(call("clamp", {sum, "0", "1"}), Id::sampleConfidence), ""};
}

RowStory confidenceStory(const Teller& t) {
  if (!isUpsampled(t.settings())) return {say<"drawn at full size">(), "", ""};
  switch (t.settings().current.upsample) {
  case UpsampleKernel::SampleWeight:
    return nearestStory(t);
  case UpsampleKernel::Hdrp:
    return filteredBoxStory(t);
  case UpsampleKernel::HdrpGaussian:
    return bellStory(t);
  case UpsampleKernel::Lanczos2:
  case UpsampleKernel::Fsr2:
    break;
  }
  return sumStory(t);
}

} // namespace

RowStory filterStory(Id id, const Teller& t) {
  if (id == Id::currentFiltered) return currentStory(t);
  return id == Id::sampleConfidence ? confidenceStory(t) : historyStory(id, t);
}

} // namespace taa::story
