// Stories of stage 9: the mix.
#include "core/story/StoryText.h"

#include "core/base/Say.h"
#include "core/taa/twin/Color.h"

#include <cmath>
#include <string>

namespace taa::story {

namespace {

RowStory toneStory(Id id, const Teller& t) {
  const ToneWeight tone = t.settings().blend.tone;
  if (tone != ToneWeight::Luma && tone != ToneWeight::LumaAsPrinted) return {say<"off">(), "", ""};
  if (id == Id::toneWeightHistory && t.details().isFirst) return {say<"there is no history yet">(), "", ""};
  return t.story(say<"bright colors count less">(), id);
}

RowStory factorStory(const Teller& t) {
  const ToneWeight tone = t.settings().blend.tone;
  const bool isWeighted = tone == ToneWeight::Luma || tone == ToneWeight::LumaAsPrinted;
  return t.story(isWeighted && t.value(Id::alpha) < 1.0f ? say<"α with the tone weights">()
                                                         : say<"α itself">(),
                 Id::blendFactor);
}

std::string lengthWords(const Teller& t) {
  const bool isNew = t.value(Id::alpha) >= 1.0f;
  const LengthRule rule = t.settings().blend.length;
  if (rule == LengthRule::CountTo16 && t.details().isFirst) return say<"the first frame is not counted">();
  if (isNew && !(rule == LengthRule::CountTo16 && t.details().weighed.decays))
    return say<"history starts anew">();
  switch (rule) {
  case LengthRule::CountTo16:
    return say<"one more, and no more than 16">();
  case LengthRule::Count:
    return say<"one more, by how much the samples say">();
  case LengthRule::Reciprocal:
    return t.value(Id::alpha) > 1e-6f ? say<"as many as α stands for">() : say<"as before">();
  case LengthRule::Confidence:
    return say<"ten more where it stands still, else 1">();
  case LengthRule::Variance:
    return say<"equally weighted frames that would have as little noise">();
  case LengthRule::VarianceAsPrinted:
    return say<"the variance itself, as printed">();
  }
  return {};
}

bool isPerChannel(const Teller& t) {
  return t.settings().weight.source == AlphaSource::ContrastPerChannel;
}

/// Mixed as a curve has the colors whose way back is told in words.
RowStory curveStory(const Teller& t, const std::string& words) {
  const auto red = [&](Id id) { return t.number(twin::compress(t.color(id), t.settings().blend).x); };
  const std::string past = red(Id::historyRectified);
  const std::string share =
      isPerChannel(t) ? t.number(t.color(Id::alphaChannels).x) : t.number(Id::blendFactor);
  const glm::vec3 mixed = twin::compress(mixedColor(t), t.settings().blend);
  return {say<"%1, mixed as the curve has them: %2; then taken back from it">(
              words, choiceLabel("blend.tone", t.settings())),
          past + " + " + share + " × (" + red(Id::currentFiltered) + " − " + past +
              ") = " + t.number(mixed.x),
          say<"R, as the curve has it">()};
}

/// Whether nothing of history is in the color.
bool isCurrentAlone(const Teller& t) {
  const glm::vec3 channels = t.color(Id::alphaChannels);
  return isPerChannel(t) ? std::fmin(channels.x, std::fmin(channels.y, channels.z)) >= 1.0f
                         : t.value(Id::blendFactor) >= 1.0f;
}

std::string mixWords(const Teller& t) {
  const bool isBlurred = t.settings().blend.restart == Restart::Blurred && t.value(Id::alphaInvalid) >= 1.0f;
  if (isBlurred) return say<"history starts with the mean of the pixel and its diagonals">();
  if (isCurrentAlone(t)) return say<"the current frame alone">();
  const bool isBounded = twin::mixesCompressed(t.settings().blend.tone);
  if (isPerChannel(t) && !isBounded) return say<"mixed in each channel by its own α">();
  return say<"%1 current, the rest history">(t.percent(Id::blendFactor));
}

RowStory resolvedStory(const Teller& t) {
  const ToneWeight tone = t.settings().blend.tone;
  const bool isBounded = tone == ToneWeight::ReinhardChannel || tone == ToneWeight::MaxChannel;
  std::string words = storedWords(t, mixWords(t));
  if (twin::mixesCompressed(tone) && !isCurrentAlone(t)) {
    if (!isBounded) return curveStory(t, words);
    words = say<"%1, mixed with bounded highlights">(words);
  }
  const Teller::Expression made = t.expression(Id::resolved);
  if (made.text.empty()) return {words, "", ""};
  if (made.channel < 0) return {words, t.equals(storedText(t, made.text), Id::resolved), ""};
  return {words,
          storedText(t, made.text, made.channel) + " = " + t.number(t.color(Id::resolved)[made.channel]),
          "R"};
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
    return t.story(lengthWords(t), id);
  case Id::resolved:
    return resolvedStory(t);
  default: // no row of this stage
    return {};
  }
}

} // namespace taa::story
