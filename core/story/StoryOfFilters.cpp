// Stories of stages 3 and 4: the taps that history and this frame's color are means of.
#include "core/story/StoryText.h"

#include "core/base/Say.h"
#include "core/settings/Parameters.h"

#include <cmath>
#include <string>
#include <string_view>

namespace taa::story {

std::string choiceLabel(std::string_view path, const Settings& settings) {
  const Parameter& row = parameter(path);
  return std::string(row.choices[static_cast<std::size_t>(row.get(settings))].label);
}

namespace {

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

float weightSum(const twin::Taps& taps) {
  float sum = 0.0f;
  for (const twin::Taps::Tap& tap : taps.all()) sum += tap.weight;
  return sum;
}

RowStory rawStory(const Teller& t) {
  const twin::Taps& taps = t.details().historyTaps;
  const std::string read = historyReadWords(t, t.value(Id::depthEdge) != 0.0f);
  if (taps.count == 0) return {read, "", ""};
  if (taps.count == 1) return t.story(say<"%1: one tap">(read), Id::historyRaw);
  return {say<"%1: %2 taps, their weights are %3 together">(read, taps.count, t.number(weightSum(taps))),
          t.formula(Id::historyRaw), "R"};
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

std::string upsampledWords(const Teller& t) {
  const std::string kernel = choiceLabel("current.upsample", t.settings());
  const twin::Taps& taps = t.details().upsampleTaps;
  if (taps.count == 0 || !(weightSum(taps) > 1e-4f))
    return say<"%1: the nearest sample, %2 px from the center">(kernel, t.tuple(t.details().sampleOffset));
  return say<"%1 over %2 samples of what was drawn smaller">(kernel, taps.count);
}

/// Of the color before it is sharpened.
std::string filteredWords(const Teller& t) {
  if (isUpsampled(t.settings())) return upsampledWords(t);
  switch (t.settings().current.filter) {
  case CurrentFilter::Center:
    return say<"the sample as it is">();
  case CurrentFilter::Unjitter:
    return say<"read where the pixel's center landed">();
  case CurrentFilter::UnjitterAsPrinted:
    return say<"read on the other side of where the pixel's center landed">();
  case CurrentFilter::Mitchell:
  case CurrentFilter::CatmullRom:
  case CurrentFilter::Lanczos:
  case CurrentFilter::Gaussian:
  case CurrentFilter::Tent:
  case CurrentFilter::Box:
  case CurrentFilter::BlackmanHarris:
  case CurrentFilter::DistanceAsPrinted:
  case CurrentFilter::MitchellAsPrinted:
  case CurrentFilter::BlackmanHarrisAsPrinted:
    break;
  }
  return say<"%1 over the nine samples">(choiceLabel("current.filter", t.settings()));
}

RowStory currentStory(const Teller& t) {
  std::string words = filteredWords(t);
  if (t.settings().current.sharpen != CurrentSharpen::None)
    words = say<"%1, then sharpened by the four around">(words);
  return {words, t.formula(Id::currentFiltered), "R"};
}

RowStory filteredBoxStory(const Teller& t) {
  const std::string at = t.tuple(t.details().sampleOffset);
  return {t.value(Id::sampleConfidence) > 0.0f
              ? say<"the nearest sample lies in HDRP's box: %1 px from the pixel's center">(at)
              : say<"no sample lies in HDRP's box: the nearest is %1 px from the pixel's center">(at),
          "", ""};
}

std::string confidenceWords(const Teller& t) {
  const std::string offset = t.tuple(t.details().sampleOffset);
  switch (t.settings().current.upsample) {
  case UpsampleKernel::SampleWeight:
    return say<"how near the nearest sample lies, %1 px from the pixel's center, "
               "or all of it where it moves">(offset);
  case UpsampleKernel::HdrpGaussian:
    return say<"how near the nearest sample lies, %1 px of the picture from the pixel's center">(
        t.tuple(t.details().sampleOffset / t.details().renderRatio));
  case UpsampleKernel::Hdrp:
  case UpsampleKernel::Lanczos2:
  case UpsampleKernel::Fsr2:
    break;
  }
  return say<"what the samples weigh together, the nearest %1 px from the pixel's center">(offset);
}

RowStory confidenceStory(const Teller& t) {
  if (!isUpsampled(t.settings())) return {say<"drawn at full size">(), "", ""};
  if (t.settings().current.upsample == UpsampleKernel::Hdrp) return filteredBoxStory(t);
  return t.story(confidenceWords(t), Id::sampleConfidence);
}

} // namespace

RowStory filterStory(Id id, const Teller& t) {
  if (id == Id::currentFiltered) return currentStory(t);
  return id == Id::sampleConfidence ? confidenceStory(t) : historyStory(id, t);
}

} // namespace taa::story
