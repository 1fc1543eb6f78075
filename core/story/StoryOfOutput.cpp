// Stories of stage 10 and of the reference: what is shown of the mix, and how far it is from what it should
// be.
#include "core/story/StoryText.h"

#include "core/base/Say.h"
#include "core/taa/twin/Color.h"
#include "core/taa/twin/Known.h"

#include <array>
#include <cmath>
#include <initializer_list>
#include <string>

namespace taa::story {

namespace {

/// Reds of the nine resolved colors, as sums of some of them.
struct Around {
  const Teller& t;

  float red(std::size_t k) const { return t.details().resolvedAround[k].x; }
  std::string text(std::size_t k) const { return t.number(red(k)); }
  std::string sum(std::initializer_list<std::size_t> places) const {
    std::string text_;
    for (const std::size_t k : places) text_ += (text_.empty() ? "" : " + ") + text(k);
    return "(" + text_ + ")";
  }
  std::string cross() const { return sum({1, 3, 5, 7}); }
  std::string corners() const { return sum({0, 2, 6, 8}); }
  std::string all() const { return sum({0, 1, 2, 3, 4, 5, 6, 7, 8}); }
};

std::string lumaRatioText(const Around& a, const std::string& k) {
  const auto& nine = a.t.details().resolvedAround;
  const float center = twin::luma(nine[4]);
  if (!(center > 1e-6f)) return a.text(4);
  std::string sum;
  for (const glm::vec3& color : nine) sum += (sum.empty() ? "" : " + ") + a.t.number(twin::luma(color));
  const std::string own = a.t.number(center);
  return a.text(4) + " × (1 − " + k + " × ((" + sum + ") / 9 − " + own + ") / " + own + ")";
}

std::string logarithmText(const Around& a, float amount) {
  const auto mean = [&](std::size_t one, std::size_t other) {
    return "√((1 + " + a.text(one) + ") × (1 + " + a.text(other) + "))";
  };
  const std::string center = "(1 + " + a.text(4) + ")";
  const std::string power = a.t.number(std::floor(amount * 256.0f + 0.5f) / 256.0f);
  return a.text(4) + " + " + center + " × ((" + center + " / √(" + mean(1, 7) + " × " + mean(3, 5) + "))^" +
         power + " − 1)";
}

/// Red of the sharpened color. RCAS sharpens with bounded highlights: its last factor takes that back.
std::string sharpenText(const Teller& t) {
  const OutputSettings& output = t.settings().output;
  const Around a{t};
  std::string c = a.text(4);
  const std::string k = t.number(output.amount);
  switch (output.sharpen) {
  case Sharpen::None:
    return c;
  case Sharpen::LumaRatio:
    return lumaRatioText(a, k);
  case Sharpen::Laplacian:
    return c + " − " + k + " × (" + a.cross() + " / 4 − " + c + ")";
  case Sharpen::Unsharp:
    return c + " − " + k + " × (" + a.all() + " / 9 − " + c + ")";
  case Sharpen::Rcas: {
    const auto bounded = twin::compressMax(t.details().resolvedAround);
    const float lobe = twin::rcasLobe(bounded, output.amount);
    const glm::vec3 sum = bounded[1] + bounded[3] + bounded[5] + bounded[7];
    const glm::vec3 sharp = (bounded[4] - lobe * sum) / (1.0f - 4.0f * lobe);
    const std::string l = t.number(lobe);
    std::string reds;
    for (const std::size_t place : {1u, 3u, 5u, 7u})
      reds += (reds.empty() ? "" : " + ") + t.number(bounded[place].x);
    return "(" + t.number(bounded[4].x) + " − " + l + " × (" + reds + ")) / (1 − 4 × " + l + ") / (1 − " +
           t.number(std::fmax(sharp.x, std::fmax(sharp.y, sharp.z))) + ")";
  }
  case Sharpen::InResolve: {
    const float mean = twin::meanInResolve(t.details().filterSamples).x;
    return c + " + 3 × " + k + " × " + call("max", {c + " − " + t.number(mean), "0"});
  }
  case Sharpen::Logarithm:
    return logarithmText(a, output.amount);
  case Sharpen::Reconstruct: {
    const std::string b = t.number(output.amount / 6.0f);
    return c + " + " + b + "^2 × (" + a.corners() + " − 4 × " + c + ") − " + b + " × (1 + 2 × " + b +
           ") × (" + a.cross() + " − 4 × " + c + ")";
  }
  case Sharpen::Mitchell:
    return c + " + ((" + a.corners() + " − 4 × " + c + ") + 16 × (" + a.cross() + " − 4 × " + c + ")) / 324";
  }
  return {};
}

/// Where nothing but sharpening was done.
RowStory sharpStory(const Teller& t) {
  const OutputSettings& output = t.settings().output;
  const std::string label = choiceLabel("output.sharpen", t.settings());
  const std::string words = output.sharpen == Sharpen::Mitchell
                                ? say<"the resolved color filtered: %1">(label)
                                : say<"the resolved color sharpened: %1">(label);
  std::string text = sharpenText(t);
  if (isOn(output.dering)) {
    float low = t.details().resolvedAround[0].x, high = low;
    for (const glm::vec3& color : t.details().resolvedAround)
      low = std::fmin(low, color.x), high = std::fmax(high, color.x);
    text = call("clamp", {text, t.number(low), t.number(high)});
  }
  return {words, call("max", {text, "0"}) + " = " + t.number(t.color(Id::output).x), "R"};
}

/// Before noise for the screen.
RowStory smoothStory(const Teller& t) {
  const OutputSettings& output = t.settings().output;
  const bool isCovered = t.value(Id::overlayAlpha) > 0.0f || t.color(Id::overlay) != glm::vec3(0.0f);
  const bool isBlurred = t.value(Id::blurTrust) < 1.0f;
  if (!isCovered && !isBlurred) {
    if (output.sharpen != Sharpen::None) return sharpStory(t);
    return {say<"the resolved color as it is">(), t.equals(t.tuple(Id::resolved), Id::output), ""};
  }
  const twin::ShownColor& shown = t.details().shown;
  std::string words =
      output.sharpen == Sharpen::None ? say<"the resolved color">() : say<"the sharpened color">();
  std::string text = t.tuple(shown.sharp);
  if (isBlurred) {
    const std::string fast = t.tuple(shown.fast);
    text = fast + " + " + t.number(Id::blurTrust) + " × (" + text + " − " + fast + ")";
    const std::string share = t.percent(1.0 - static_cast<double>(t.value(Id::blurTrust)));
    words = say<"%1, %2 blurred along its motion">(words, share);
  }
  if (isCovered) {
    text = "(" + text + ") × (1 − " + t.number(Id::overlayAlpha) + ") + " + t.tuple(Id::overlay);
    words = say<"%1, the overlay over it">(words);
  }
  return {words, t.equals(text, Id::output), ""};
}

RowStory shownStory(const Teller& t) {
  RowStory story = smoothStory(t);
  if (!isOn(t.settings().output.dither)) return story;
  const twin::ShownColor& shown = t.details().shown;
  const std::string root = "√(" + t.number(shown.smooth.x) + ") + " + t.number(shown.noise);
  return {say<"%1, and noise of a step of 8 bits for the screen">(story.words),
          call("max", {root, "0"}) + "^2 = " + t.number(t.color(Id::output).x), "R"};
}

RowStory detailStory(const Teller& t) {
  if (t.settings().output.sharpen == Sharpen::None) return {say<"off">(), "", ""};
  const float sharp = twin::luma(t.details().shown.sharp);
  const float before = twin::luma(t.details().resolvedAround[4]);
  const float detail = t.value(Id::sharpenDetail);
  return {detail > 0   ? say<"made brighter: luma of the sharpened color less that of the resolved one">()
          : detail < 0 ? say<"made darker: luma of the sharpened color less that of the resolved one">()
                       : say<"luma of the sharpened color is that of the resolved one">(),
          t.equals(t.number(sharp) + " − " + t.number(before), Id::sharpenDetail), ""};
}

RowStory trustStory(const Teller& t) {
  if (!isOn(t.settings().output.motionBlur)) return {say<"off">(), "", ""};
  if (t.value(Id::speed) >= kNoPreviousPosition) return {say<"the motion is not known">(), "", ""};
  return {t.value(Id::blurTrust) < 1.0f ? say<"fast surfaces are blurred along their motion">()
                                        : say<"not blurred: it is no faster than 2 px a frame">(),
          t.equals("1 − clamp((" + t.number(Id::speed) + " − 2) / 13, 0, 1)", Id::blurTrust), ""};
}

RowStory relativeStory(const glm::vec3& is, const glm::vec3& should, const Teller& t) {
  std::string sum;
  for (int i = 0; i < 3; ++i) {
    const std::string reference = t.number(should[i]);
    sum += sum.empty() ? "(" : " + ";
    sum += "(" + t.number(is[i]) + " − " + reference + ")^2 / (" + reference + "^2 + 0.01)";
  }
  return {say<"the squared difference over the reference's own square, the mean of red, green and blue">(),
          t.equals(sum + ") / 3", Id::relativeError), ""};
}

RowStory errorStory(Id id, const Teller& t) {
  if (!twin::isKnown(t.probed.record, Id::reference)) return {say<"there is no reference yet">(), "", ""};
  const glm::vec3 is = t.color(Id::output), should = t.color(Id::reference);
  switch (id) {
  case Id::reference:
    return {say<"the mean of the reference's samples of this instant">(), "", ""};
  case Id::referenceError: {
    const std::string words =
        t.value(id) > 0   ? say<"too bright: luma of the output less luma of the reference">()
        : t.value(id) < 0 ? say<"too dark: luma of the output less luma of the reference">()
                          : say<"as it should be: luma of the output less luma of the reference">();
    return {words, t.equals(t.number(twin::luma(is)) + " − " + t.number(twin::luma(should)), id), ""};
  }
  case Id::referenceErrorAbs: {
    std::array<std::string, 3> channels;
    for (int i = 0; i < 3; ++i)
      channels[static_cast<std::size_t>(i)] = "|" + t.number(is[i]) + " − " + t.number(should[i]) + "|";
    return {say<"the largest difference of red, green and blue">(), t.equals(call("max", channels), id), ""};
  }
  case Id::relativeError:
    return relativeStory(is, should, t);
  case Id::flip:
    return {t.value(id) == 0.0f ? say<"nothing of the difference is seen">()
                                : say<"what is seen of the difference from the reference here, of 1">(),
            "", ""};
  case Id::ssimMap:
    return {t.value(id) == 0.0f ? say<"its structure is that of the reference">()
                                : say<"how unlike the reference's structure it is, in 11 × 11 pixels">(),
            "", ""};
  default: // no error
    return {};
  }
}

RowStory engineStory(Id id, const Teller& t) {
  if (!twin::isKnown(t.probed.record, Id::engineOutput))
    return {say<"there is no output of an engine">(), "", ""};
  const glm::vec3 is = t.color(Id::resolved), other = t.color(Id::engineOutput);
  if (id == Id::engineOutput) return {say<"what the engine's own TAA made of this frame">(), "", ""};
  if (id == Id::engineDifference) {
    const std::string words =
        t.value(id) > 0
            ? say<"brighter than the engine's: luma of the resolved color less luma of its output">()
        : t.value(id) < 0
            ? say<"darker than the engine's: luma of the resolved color less luma of its output">()
            : say<"as bright as the engine's: luma of the resolved color less luma of its output">();
    return {words, t.equals(t.number(twin::luma(is)) + " − " + t.number(twin::luma(other)), id), ""};
  }
  std::array<std::string, 3> channels;
  for (int i = 0; i < 3; ++i)
    channels[static_cast<std::size_t>(i)] = "|" + t.number(is[i]) + " − " + t.number(other[i]) + "|";
  return {say<"the largest difference of red, green and blue">(), t.equals(call("max", channels), id), ""};
}

} // namespace

RowStory outputStory(Id id, const Teller& t) {
  if (overTime(id) == OverTime::Flicker) return flickerStory(id, t);
  if (overTime(id) == OverTime::Parts) return partsStory(id, t);
  if (isOfEngine(id)) return engineStory(id, t);
  if (isOfReference(id)) return errorStory(id, t);
  if (id == Id::sharpenDetail) return detailStory(t);
  return id == Id::blurTrust ? trustStory(t) : shownStory(t);
}

} // namespace taa::story
