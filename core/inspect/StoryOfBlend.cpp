// Stories of stages 9 and 10: the mix, and what is shown of it.
#include "core/inspect/StoryText.h"

#include "core/taa/reference/Color.h"

namespace taa::story {

namespace {

RowStory toneStory(Id id, const Teller& t) {
  const ToneWeight tone = t.settings().blend.tone;
  if (tone != ToneWeight::Luma && tone != ToneWeight::LumaAsPrinted) return {"not asked for", "", ""};
  const bool isCurrent = id == Id::toneWeightCurrent;
  const bool isBlurred = t.settings().blend.restart == Restart::Blurred && t.value(Id::alphaInvalid) >= 1.0f;
  if (isCurrent && isBlurred) return {"of the blurred color that history starts with", "", ""};
  glm::vec3 color = t.color(isCurrent ? Id::currentFiltered : Id::historyRectified);
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
    return {"ten more where it stands still, else 1", "", ""};
  case LengthRule::Variance:
    return {"frames that would be as calm when averaged",
            t.equals("1 / (" + a + "^2 + (1 − " + a + ")^2 / " + n + ")", Id::historyLength), ""};
  case LengthRule::VarianceAsPrinted:
    return {"the variance itself, as printed",
            t.equals(a + "^2 + (1 − " + a + ")^2 / " + n, Id::historyLength), ""};
  }
  return {};
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
  if (isBlurred) return {"history starts with the mean of the pixel and its diagonals", "", ""};
  if (factor >= 1.0f)
    return {"the current frame alone" + stored, t.equals(t.tuple(Id::currentFiltered), Id::resolved), ""};
  if (tone == ToneWeight::ReinhardChannel || tone == ToneWeight::MaxChannel)
    return {words + ", mixed with bounded highlights", "", ""};
  if (t.settings().weight.source == AlphaSource::ContrastPerChannel)
    return {"mixed in each channel by its own α", "", ""};
  const std::string history = t.tuple(Id::historyRectified);
  return {words,
          t.equals(history + " + " + t.number(Id::blendFactor) + " × (" + t.tuple(Id::currentFiltered) +
                       " − " + history + ")",
                   Id::resolved),
          ""};
}

RowStory outputStory(Id id, const Teller& t) {
  const OutputSettings& output = t.settings().output;
  if (id == Id::sharpenDetail)
    return {output.sharpen == Sharpen::None ? "not asked for"
            : t.value(id) >= 0              ? "made brighter"
                                            : "made darker",
            "", ""};
  if (id == Id::blurTrust) {
    if (!isOn(output.motionBlur)) return {"not asked for", "", ""};
    if (t.value(Id::speed) >= kNoPreviousPosition) return {"the motion is not known", "", ""};
    return {"fast surfaces are blurred along their motion",
            t.equals("1 − clamp((" + t.number(Id::speed) + " − 2) / 13, 0, 1)", id), ""};
  }
  const bool isSame =
      output.sharpen == Sharpen::None && !isOn(output.motionBlur) && t.value(Id::overlayAlpha) == 0.0f;
  if (isSame) return {"the resolved color as it is", t.equals(t.tuple(Id::resolved), id), ""};
  return {"the resolved color with what was done to it", "", ""};
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
  default:
    return outputStory(id, t);
  }
}

} // namespace taa::story
