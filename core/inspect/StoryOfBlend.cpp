// Stories of stage 9: the mix.
#include "core/inspect/StoryText.h"

#include "core/base/Say.h"
#include "core/taa/reference/Color.h"

#include <array>
#include <cstddef>
#include <string>

namespace taa::story {

namespace {

/// A pixel and its diagonals among the nine samples, which a blurred restart is the mean of.
constexpr std::array<std::size_t, 5> kDiagonals{4, 0, 2, 6, 8};

RowStory toneStory(Id id, const Teller& t) {
  const ToneWeight tone = t.settings().blend.tone;
  if (tone != ToneWeight::Luma && tone != ToneWeight::LumaAsPrinted) return {say<"not asked for">(), "", ""};
  const bool isCurrent = id == Id::toneWeightCurrent;
  const bool isBlurred = t.settings().blend.restart == Restart::Blurred && t.value(Id::alphaInvalid) >= 1.0f;
  glm::vec3 color = t.color(isCurrent ? Id::currentFiltered : Id::historyRectified);
  if (isCurrent && isBlurred) {
    color = glm::vec3(0.0f);
    for (const std::size_t k : kDiagonals) color += t.details().filterSamples[k] / 5.0f;
  }
  if (tone == ToneWeight::LumaAsPrinted) color = reference::compress(color, ToneSpace::MaxChannel);
  return {say<"bright colors count less">(),
          t.equals("1 / (1 + " + t.number(static_cast<double>(reference::luma(color))) + ")", id), ""};
}

RowStory factorStory(const Teller& t) {
  const ToneWeight tone = t.settings().blend.tone;
  const std::string alpha = t.number(Id::alpha);
  const bool isWeighted = tone == ToneWeight::Luma || tone == ToneWeight::LumaAsPrinted;
  if (!isWeighted || t.value(Id::alpha) >= 1.0f)
    return {say<"α itself">(), t.equals(alpha, Id::blendFactor), ""};
  const std::string current = alpha + " × " + t.number(Id::toneWeightCurrent);
  return {say<"α with the tone weights">(),
          t.equals(current + " / (" + current + " + (1 − " + alpha + ") × " +
                       t.number(Id::toneWeightHistory) + ")",
                   Id::blendFactor),
          ""};
}

RowStory lengthStory(const Teller& t) {
  const float alpha = t.value(Id::alpha);
  const std::string a = t.number(Id::alpha), n = t.number(Id::historyKeptLength);
  if (alpha >= 1.0f) return {say<"history starts anew">(), t.equals("1", Id::historyLength), ""};
  switch (t.settings().blend.length) {
  case LengthRule::Count:
    return {say<"one more, by how much the samples say">(),
            t.equals(n + " + " + t.number(Id::sampleConfidence), Id::historyLength), ""};
  case LengthRule::Reciprocal:
    if (!(alpha > 1e-6f)) return {say<"as before">(), "", ""};
    return {say<"as many as α stands for">(),
            t.equals(call("max", {t.number(Id::sampleConfidence) + " / " + a, "1"}), Id::historyLength), ""};
  case LengthRule::Confidence:
    return {say<"ten more where it stands still, else 1">(),
            t.equals(t.value(Id::historyLength) > t.value(Id::historyKeptLength) ? n + " + 10" : "1",
                     Id::historyLength),
            ""};
  case LengthRule::Variance:
    return {say<"frames that would be as calm when averaged">(),
            t.equals("1 / (" + a + "^2 + (1 − " + a + ")^2 / " + n + ")", Id::historyLength), ""};
  case LengthRule::VarianceAsPrinted:
    return {say<"the variance itself, as printed">(),
            t.equals(a + "^2 + (1 − " + a + ")^2 / " + n, Id::historyLength), ""};
  }
  return {};
}

/// `words`, and what storing the color does to it.
std::string storedWords(const Teller& t, const std::string& words) {
  const Precision precision = t.settings().history.precision;
  const int bits = precision == Precision::Unorm8 ? 8 : precision == Precision::Unorm10 ? 10 : 0;
  return bits == 0 ? words : say<"%1, rounded to the %2 bits it is stored with">(words, bits);
}

/// The mean of the pixel and its diagonals.
RowStory restartStory(const Teller& t) {
  std::string sum;
  for (const std::size_t k : kDiagonals)
    sum += (sum.empty() ? "" : " + ") + t.number(t.details().filterSamples[k].x);
  return {storedWords(t, say<"history starts with the mean of the pixel and its diagonals">()),
          "(" + sum + ") / 5 = " + t.number(t.color(Id::resolved).x), "R"};
}

/// Mixed with bounded highlights: each color divided by one more than its channel, or than its largest
/// channel; or on another curve. Where the largest bounds all, a share in each channel is not told.
RowStory boundedStory(const Teller& t, const std::string& words) {
  const ToneWeight tone = t.settings().blend.tone;
  const bool isBounded = tone == ToneWeight::ReinhardChannel || tone == ToneWeight::MaxChannel;
  const auto red = [&](Id id) { return t.number(reference::compress(t.color(id), t.settings().blend).x); };
  const std::string past = red(Id::historyRectified);
  const bool isPerChannel = t.settings().weight.source == AlphaSource::ContrastPerChannel;
  const std::string share = isPerChannel ? t.number(t.color(Id::alphaChannels).x) : t.number(Id::blendFactor);
  // With the largest channel bounding all, a share in each would move the bound itself.
  const bool isShort = !isPerChannel || tone != ToneWeight::MaxChannel;
  return {isBounded
              ? say<"%1, mixed with bounded highlights">(words)
              : say<"%1, mixed as the curve has them: %2">(words, choiceLabel("blend.tone", t.settings())),
          isShort ? past + " + " + share + " × (" + red(Id::currentFiltered) + " − " + past +
                        ") = " + red(Id::resolved)
                  : "",
          !isShort    ? ""
          : isBounded ? say<"R, its highlights bounded">()
                      : say<"R, as the curve has it">()};
}

/// Mixed in each channel by its own α.
RowStory channelsStory(const Teller& t) {
  const ToneWeight tone = t.settings().blend.tone;
  std::string share = t.tuple(Id::alphaChannels);
  if (tone == ToneWeight::Luma || tone == ToneWeight::LumaAsPrinted) {
    const std::string current = share + " × " + t.number(Id::toneWeightCurrent);
    share = current + " / (" + current + " + (1 − " + share + ") × " + t.number(Id::toneWeightHistory) + ")";
  }
  const std::string history = t.tuple(Id::historyRectified);
  return {storedWords(t, say<"mixed in each channel by its own α">()),
          t.equals(history + " + " + share + " × (" + t.tuple(Id::currentFiltered) + " − " + history + ")",
                   Id::resolved),
          ""};
}

RowStory resolvedStory(const Teller& t) {
  const float factor = t.value(Id::blendFactor);
  const ToneWeight tone = t.settings().blend.tone;
  const std::string words = storedWords(t, say<"%1 current, the rest history">(t.percent(Id::blendFactor)));
  const bool isBlurred = t.settings().blend.restart == Restart::Blurred && t.value(Id::alphaInvalid) >= 1.0f;
  if (isBlurred) return restartStory(t);
  if (factor >= 1.0f)
    return {storedWords(t, say<"the current frame alone">()),
            t.equals(t.tuple(Id::currentFiltered), Id::resolved), ""};
  if (reference::mixesCompressed(tone)) return boundedStory(t, words);
  if (t.settings().weight.source == AlphaSource::ContrastPerChannel) return channelsStory(t);
  const std::string history = t.tuple(Id::historyRectified);
  return {words,
          t.equals(history + " + " + t.number(Id::blendFactor) + " × (" + t.tuple(Id::currentFiltered) +
                       " − " + history + ")",
                   Id::resolved),
          ""};
}

} // namespace

RowStory blendStory(Id id, const Teller& t) {
  switch (id) {
  case Id::toneWeightCurrent:
  case Id::toneWeightHistory:
    return toneStory(id, t);
  case Id::blendFactor:
    return factorStory(t);
  case Id::historyLength:
    return lengthStory(t);
  default:
    return resolvedStory(t);
  }
}

} // namespace taa::story
