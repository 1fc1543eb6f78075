// Stories of stage 9: the mix.
#include "core/inspect/StoryText.h"

#include "core/taa/reference/Color.h"

#include <array>
#include <cstddef>

namespace taa::story {

namespace {

/// A pixel and its diagonals among the nine samples, which a blurred restart is the mean of.
constexpr std::array<std::size_t, 5> kDiagonals{4, 0, 2, 6, 8};

RowStory toneStory(Id id, const Teller& t) {
  const ToneWeight tone = t.settings().blend.tone;
  if (tone != ToneWeight::Luma && tone != ToneWeight::LumaAsPrinted) return {"not asked for", "", ""};
  const bool isCurrent = id == Id::toneWeightCurrent;
  const bool isBlurred = t.settings().blend.restart == Restart::Blurred && t.value(Id::alphaInvalid) >= 1.0f;
  glm::vec3 color = t.color(isCurrent ? Id::currentFiltered : Id::historyRectified);
  if (isCurrent && isBlurred) {
    color = glm::vec3(0.0f);
    for (const std::size_t k : kDiagonals) color += t.details().filterSamples[k] / 5.0f;
  }
  if (tone == ToneWeight::LumaAsPrinted) color = reference::compress(color, ToneSpace::MaxChannel);
  return {"bright colors count less",
          t.equals("1 / (1 + " + t.number(static_cast<double>(reference::luma(color))) + ")", id), ""};
}

RowStory factorStory(const Teller& t) {
  const ToneWeight tone = t.settings().blend.tone;
  const std::string alpha = t.number(Id::alpha);
  const bool isWeighted = tone == ToneWeight::Luma || tone == ToneWeight::LumaAsPrinted;
  if (!isWeighted || t.value(Id::alpha) >= 1.0f) return {"α itself", t.equals(alpha, Id::blendFactor), ""};
  const std::string current = alpha + " × " + t.number(Id::toneWeightCurrent);
  return {"α with the tone weights",
          t.equals(current + " / (" + current + " + (1 − " + alpha + ") × " +
                       t.number(Id::toneWeightHistory) + ")",
                   Id::blendFactor),
          ""};
}

RowStory lengthStory(const Teller& t) {
  const float alpha = t.value(Id::alpha);
  const std::string a = t.number(Id::alpha), n = t.number(Id::historyKeptLength);
  if (alpha >= 1.0f) return {"history starts anew", t.equals("1", Id::historyLength), ""};
  switch (t.settings().blend.length) {
  case LengthRule::Count:
    return {"one more, by how much the samples say",
            t.equals(n + " + " + t.number(Id::sampleConfidence), Id::historyLength), ""};
  case LengthRule::Reciprocal:
    if (!(alpha > 1e-6f)) return {"as before", "", ""};
    return {"as many as α stands for",
            t.equals(call("max", {t.number(Id::sampleConfidence) + " / " + a, "1"}), Id::historyLength), ""};
  case LengthRule::Confidence:
    return {"ten more where it stands still, else 1",
            t.equals(t.value(Id::historyLength) > t.value(Id::historyKeptLength) ? n + " + 10" : "1",
                     Id::historyLength),
            ""};
  case LengthRule::Variance:
    return {"frames that would be as calm when averaged",
            t.equals("1 / (" + a + "^2 + (1 − " + a + ")^2 / " + n + ")", Id::historyLength), ""};
  case LengthRule::VarianceAsPrinted:
    return {"the variance itself, as printed",
            t.equals(a + "^2 + (1 − " + a + ")^2 / " + n, Id::historyLength), ""};
  }
  return {};
}

/// The mean of the pixel and its diagonals.
RowStory restartStory(const Teller& t, const std::string& stored) {
  std::string sum;
  for (const std::size_t k : kDiagonals)
    sum += (sum.empty() ? "" : " + ") + t.number(t.details().filterSamples[k].x);
  return {"history starts with the mean of the pixel and its diagonals" + stored,
          "(" + sum + ") / 5 = " + t.number(t.color(Id::resolved).x), "R"};
}

/// Mixed with bounded highlights. A share of its own in each channel is not told.
RowStory boundedStory(const Teller& t, const std::string& words) {
  const ToneSpace space = t.settings().blend.tone == ToneWeight::ReinhardChannel ? ToneSpace::ReinhardChannel
                                                                                 : ToneSpace::MaxChannel;
  const auto red = [&](Id id) { return t.number(reference::compress(t.color(id), space).x); };
  const std::string past = red(Id::historyRectified);
  const bool isPerChannel = t.settings().weight.source == AlphaSource::ContrastPerChannel;
  const std::string share = isPerChannel ? t.number(t.color(Id::alphaChannels).x) : t.number(Id::blendFactor);
  // With the largest channel bounding all, a share in each would move the bound itself.
  const bool isShort = !isPerChannel || space == ToneSpace::ReinhardChannel;
  return {words + ", mixed with bounded highlights",
          isShort ? past + " + " + share + " × (" + red(Id::currentFiltered) + " − " + past +
                        ") = " + red(Id::resolved)
                  : "",
          isShort ? kBoundedRed : ""};
}

/// Mixed in each channel by its own α.
RowStory channelsStory(const Teller& t, const std::string& stored) {
  const ToneWeight tone = t.settings().blend.tone;
  std::string share = t.tuple(Id::alphaChannels);
  if (tone == ToneWeight::Luma || tone == ToneWeight::LumaAsPrinted) {
    const std::string current = share + " × " + t.number(Id::toneWeightCurrent);
    share = current + " / (" + current + " + (1 − " + share + ") × " + t.number(Id::toneWeightHistory) + ")";
  }
  const std::string history = t.tuple(Id::historyRectified);
  return {"mixed in each channel by its own α" + stored,
          t.equals(history + " + " + share + " × (" + t.tuple(Id::currentFiltered) + " − " + history + ")",
                   Id::resolved),
          ""};
}

RowStory resolvedStory(const Teller& t) {
  const float factor = t.value(Id::blendFactor);
  const ToneWeight tone = t.settings().blend.tone;
  const Precision precision = t.settings().history.precision;
  const std::string stored = precision == Precision::Unorm8    ? ", rounded to the 8 bits it is stored with"
                             : precision == Precision::Unorm10 ? ", rounded to the 10 bits it is stored with"
                                                               : "";
  const std::string words = t.percent(static_cast<double>(factor)) + " current, the rest history" + stored;
  const bool isBlurred = t.settings().blend.restart == Restart::Blurred && t.value(Id::alphaInvalid) >= 1.0f;
  if (isBlurred) return restartStory(t, stored);
  if (factor >= 1.0f)
    return {"the current frame alone" + stored, t.equals(t.tuple(Id::currentFiltered), Id::resolved), ""};
  if (tone == ToneWeight::ReinhardChannel || tone == ToneWeight::MaxChannel) return boundedStory(t, words);
  if (t.settings().weight.source == AlphaSource::ContrastPerChannel) return channelsStory(t, stored);
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
