// Stories of stage 9: the mix.
#include "core/story/StoryText.h"

#include "core/base/Say.h"
#include "core/taa/twin/Color.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <string>

namespace taa::story {

namespace {

/// A pixel and its diagonals among the nine samples, which a blurred restart is the mean of.
constexpr std::array<std::size_t, 5> kDiagonals{4, 0, 2, 6, 8};

RowStory toneStory(Id id, const Teller& t) {
  const ToneWeight tone = t.settings().blend.tone;
  if (tone != ToneWeight::Luma && tone != ToneWeight::LumaAsPrinted) return {say<"off">(), "", ""};
  if (id == Id::toneWeightHistory && t.details().isFirst) return {say<"there is no history yet">(), "", ""};
  const bool isCurrent = id == Id::toneWeightCurrent;
  const bool isBlurred = t.settings().blend.restart == Restart::Blurred && t.value(Id::alphaInvalid) >= 1.0f;
  glm::vec3 color = t.color(isCurrent ? Id::currentFiltered : Id::historyRectified);
  if (isCurrent && isBlurred) {
    color = glm::vec3(0.0f);
    for (const std::size_t k : kDiagonals) color += t.details().filterSamples[k] / 5.0f;
  }
  if (tone == ToneWeight::LumaAsPrinted) color = twin::compress(color, ToneSpace::MaxChannel);
  return {say<"bright colors count less">(),
          t.equals("1 / (1 + " +
                       t.number(static_cast<double>(twin::weightLuma(color, t.settings().space.luma))) + ")",
                   id),
          ""};
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
  const bool isTo16 = t.settings().blend.length == LengthRule::CountTo16;
  if (isTo16 && t.details().isFirst)
    return {say<"the first frame is not counted">(), t.equals("0", Id::historyLength), ""};
  if (isTo16 && (alpha < 1.0f || t.details().weighed.decays))
    return {say<"one more, and no more than 16">(),
            t.equals(call("min", {n + " + " + t.number(Id::sampleConfidence), "16"}), Id::historyLength), ""};
  if (alpha >= 1.0f) return {say<"history starts anew">(), t.equals("1", Id::historyLength), ""};
  switch (t.settings().blend.length) {
  case LengthRule::CountTo16:
    break;
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
    return {say<"equally weighted frames that would have as little noise">(),
            t.equals("1 / (" + a + "^2 + (1 − " + a + ")^2 / " + n + ")", Id::historyLength), ""};
  case LengthRule::VarianceAsPrinted:
    return {say<"the variance itself, as printed">(),
            t.equals(a + "^2 + (1 − " + a + ")^2 / " + n, Id::historyLength), ""};
  }
  return {};
}

bool isPerChannel(const Teller& t) {
  return t.settings().weight.source == AlphaSource::ContrastPerChannel;
}

/// Mixed with bounded highlights: each color divided by one more than its channel, or than its largest
/// channel, and taken back; or on another curve, whose way back is told in words. Where the largest bounds
/// all, a share in each channel is not told.
RowStory boundedStory(const Teller& t, const std::string& words) {
  const ToneWeight tone = t.settings().blend.tone;
  const bool isBounded = tone == ToneWeight::ReinhardChannel || tone == ToneWeight::MaxChannel;
  const auto red = [&](Id id) { return t.number(twin::compress(t.color(id), t.settings().blend).x); };
  const std::string past = red(Id::historyRectified);
  const std::string share =
      isPerChannel(t) ? t.number(t.color(Id::alphaChannels).x) : t.number(Id::blendFactor);
  const std::string mix = past + " + " + share + " × (" + red(Id::currentFiltered) + " − " + past + ")";
  const glm::vec3 mixed = twin::compress(mixedColor(t), t.settings().blend);
  if (!isBounded)
    return {say<"%1, mixed as the curve has them: %2; then taken back from it">(
                words, choiceLabel("blend.tone", t.settings())),
            mix + " = " + t.number(mixed.x), say<"R, as the curve has it">()};
  const std::string told = say<"%1, mixed with bounded highlights">(words);
  // With the largest channel bounding all, a share in each would move the bound itself.
  if (isPerChannel(t) && tone == ToneWeight::MaxChannel) return {told, "", ""};
  const float bound =
      tone == ToneWeight::MaxChannel ? std::fmax(mixed.x, std::fmax(mixed.y, mixed.z)) : mixed.x;
  return {told,
          storedText(t, "(" + mix + ") / (1 − " + t.number(bound) + ")", 0) + " = " +
              t.number(t.color(Id::resolved).x),
          "R"};
}

/// The mean of the pixel and its diagonals.
RowStory restartStory(const Teller& t) {
  std::string sum;
  for (const std::size_t k : kDiagonals)
    sum += (sum.empty() ? "" : " + ") + t.number(t.details().filterSamples[k].x);
  return {storedWords(t, say<"history starts with the mean of the pixel and its diagonals">()),
          storedText(t, "(" + sum + ") / 5", 0) + " = " + t.number(t.color(Id::resolved).x), "R"};
}

/// Mixed in each channel by its own α.
RowStory mixedChannelsStory(const Teller& t) {
  const ToneWeight tone = t.settings().blend.tone;
  std::string share = t.tuple(Id::alphaChannels);
  if (tone == ToneWeight::Luma || tone == ToneWeight::LumaAsPrinted) {
    const std::string current = share + " × " + t.number(Id::toneWeightCurrent);
    share = current + " / (" + current + " + (1 − " + share + ") × " + t.number(Id::toneWeightHistory) + ")";
  }
  const std::string history = t.tuple(Id::historyRectified);
  return {storedWords(t, say<"mixed in each channel by its own α">()),
          t.equals(storedText(t, history + " + " + share + " × (" + t.tuple(Id::currentFiltered) + " − " +
                                     history + ")"),
                   Id::resolved),
          ""};
}

/// Whether nothing of history is in the color.
bool isCurrentAlone(const Teller& t) {
  const glm::vec3 channels = t.color(Id::alphaChannels);
  return isPerChannel(t) ? std::fmin(channels.x, std::fmin(channels.y, channels.z)) >= 1.0f
                         : t.value(Id::blendFactor) >= 1.0f;
}

RowStory resolvedStory(const Teller& t) {
  const bool isBlurred = t.settings().blend.restart == Restart::Blurred && t.value(Id::alphaInvalid) >= 1.0f;
  if (isBlurred) return restartStory(t);
  if (isCurrentAlone(t))
    return {storedWords(t, say<"the current frame alone">()),
            t.equals(storedText(t, t.tuple(Id::currentFiltered)), Id::resolved), ""};
  const std::string words = storedWords(t, say<"%1 current, the rest history">(t.percent(Id::blendFactor)));
  if (twin::mixesCompressed(t.settings().blend.tone)) return boundedStory(t, words);
  if (isPerChannel(t)) return mixedChannelsStory(t);
  const std::string history = t.tuple(Id::historyRectified);
  return {words,
          t.equals(storedText(t, history + " + " + t.number(Id::blendFactor) + " × (" +
                                     t.tuple(Id::currentFiltered) + " − " + history + ")"),
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
  case Id::resolved:
    return resolvedStory(t);
  default: // no row of this stage
    return {};
  }
}

} // namespace taa::story
