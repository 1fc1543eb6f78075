// Stories of stages 1 to 5: whose motion, where from, what history and this frame hold, and the box.
#include "core/inspect/StoryText.h"

#include "core/settings/Parameters.h"
#include "core/taa/reference/Color.h"

#include <array>
#include <cmath>
#include <vector>

namespace taa::story {

namespace {

std::string choiceLabel(std::string_view path, const Settings& settings) {
  const Parameter& row = parameter(path);
  return std::string(row.choices[static_cast<std::size_t>(row.get(settings))].label);
}

RowStory dilateStory(Id id, const Teller& t) {
  const glm::vec2 offset = t.pair(Id::dilatedOffset);
  const bool isOwn = offset == glm::vec2(0.0f);
  if (id == Id::dilatedOffset)
    return {isOwn ? "the pixel's own motion is used"
                  : "the motion of the neighbor at " + t.tuple(offset) +
                        " is used: " + choiceLabel("dilate.method", t.settings()),
            "", ""};
  const std::string whose = isOwn ? "of the pixel itself" : "of the neighbor at " + t.tuple(offset);
  if (id == Id::dilatedMotion && t.value(id) >= kNoPreviousPosition)
    return {"the surface was behind the previous camera", "", ""};
  return {(id == Id::dilatedDepth ? "depth " : "motion ") + whose, "", ""};
}

RowStory reprojectStory(Id id, const Teller& t) {
  const glm::vec2 motion = t.pair(Id::dilatedMotion), center = glm::vec2(t.probed.pixel) + 0.5f;
  if (motion.x >= kNoPreviousPosition) return {"there is no previous position", "", ""};
  if (id == Id::historyPosition)
    return {"the pixel's center less the motion", t.equals(t.tuple(center) + " − " + t.tuple(motion), id),
            ""};
  if (id == Id::onScreen) {
    const glm::ivec2& size = t.details().picturePx;
    const std::string picture = std::to_string(size.x) + " × " + std::to_string(size.y) + " px";
    return {t.tuple(t.pair(Id::historyPosition)) + " lies " + (t.value(id) != 0.0f ? "inside " : "outside ") +
                picture,
            "", ""};
  }
  return {"length of the motion", t.equals(call("length", {t.tuple(motion)}), id), ""};
}

RowStory historyStory(Id id, const Teller& t) {
  if (t.details().isFirst) return {"there is no history yet", "", ""};
  if (id == Id::depthEdge)
    return {!isOn(t.settings().history.bilinearAtEdges) ? "not asked for"
            : t.value(id) != 0.0f                       ? "an edge in depth: read by one bilinear tap"
                                                        : "no edge in depth: the filter is used",
            "", ""};
  const glm::vec2 at = t.details().readPosition;
  if (id == Id::historyRawLength)
    return {"as many frames' worth of samples were stored around " + t.tuple(at), "", ""};
  const glm::vec2 fraction = (at - 0.5f) - glm::vec2(std::floor(at.x - 0.5f), std::floor(at.y - 0.5f));
  return {choiceLabel("history.filter", t.settings()) + " at " + t.tuple(at) + ", " + t.tuple(fraction) +
              " of a texel from the one before",
          "", ""};
}

/// Weights of the nine samples as they count, luma weighting put in.
std::vector<float> filterWeights(const Teller& t) {
  std::vector<float> weights;
  for (std::size_t k = 0; k < 9; ++k) {
    const float weight = t.details().filterWeights[k];
    const bool byLuma = isOn(t.settings().current.lumaWeighted);
    weights.push_back(byLuma ? weight / (1.0f + reference::luma(t.details().filterSamples[k])) : weight);
  }
  return weights;
}

std::string weightedMean(const Teller& t, const std::vector<float>& weights,
                         const std::vector<float>& values) {
  std::string sum, total;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    if (weights[k] == 0.0f) continue;
    const std::string weight = t.number(static_cast<double>(weights[k]));
    sum += (sum.empty() ? "" : " + ") + weight + " × " + t.number(static_cast<double>(values[k]));
    total += (total.empty() ? "" : " + ") + weight;
  }
  return "(" + sum + ") / (" + total + ")";
}

RowStory currentStory(const Teller& t) {
  const CurrentSettings& current = t.settings().current;
  if (isUpsampled(t.settings()))
    return {choiceLabel("current.upsample", t.settings()) + " over the samples around, drawn smaller", "",
            ""};
  const std::string filter = choiceLabel("current.filter", t.settings());
  if (current.sharpen != CurrentSharpen::None)
    return {filter + ", then sharpened by the four around", "", ""};
  const bool isSingle = current.filter == CurrentFilter::Center;
  if (isSingle)
    return {"the sample as it is", t.equals(t.tuple(t.details().filterSamples[4]), Id::currentFiltered), ""};
  if (current.filter == CurrentFilter::Unjitter) return {"read where the pixel's center landed", "", ""};
  std::vector<float> reds;
  for (const glm::vec3& sample : t.details().filterSamples) reds.push_back(sample.x);
  std::string mean = weightedMean(t, filterWeights(t), reds);
  if (isOn(current.dering)) {
    float low = reds[4], high = reds[4];
    for (const float red : reds) low = std::fmin(low, red), high = std::fmax(high, red);
    const bool rings = current.filter == CurrentFilter::Mitchell ||
                       current.filter == CurrentFilter::CatmullRom ||
                       current.filter == CurrentFilter::Lanczos;
    if (rings)
      mean = call("clamp", {mean, t.number(static_cast<double>(low)), t.number(static_cast<double>(high))});
  }
  return {filter + " over the nine samples",
          call("max", {mean, "0"}) + " = " + t.number(static_cast<double>(t.color(Id::currentFiltered).x)),
          "R"};
}

/// The samples a shape takes, as numbers of the 3×3.
std::vector<std::size_t> setOf(bool cross, bool x) {
  std::vector<std::size_t> set;
  for (std::size_t k = 0; k < 9; ++k) {
    const bool isCorner = k % 2 == 0 && k != 4, isSide = k % 2 == 1;
    if (k == 4 || (!cross && !x) || (cross && isSide) || (x && isCorner)) set.push_back(k);
  }
  return set;
}

std::vector<std::size_t> setOf(const Teller& t) {
  const NeighborhoodShape shape = t.settings().neighborhood.shape;
  const bool alternates = shape == NeighborhoodShape::Alternate, isEven = t.probed.info.frame % 2 == 0;
  return setOf(shape == NeighborhoodShape::Cross || (alternates && isEven),
               shape == NeighborhoodShape::X || (alternates && !isEven));
}

/// Y or red of samples, and what each counts for the moments.
struct Set {
  std::vector<float> values, weights;
  bool isEqual = true;
};

Set samplesOf(const Teller& t, const std::vector<std::size_t>& chosen) {
  Set set;
  const MomentWeights kind = t.settings().neighborhood.weights;
  set.isEqual = kind == MomentWeights::Equal;
  constexpr float kByDistance[] = {1.0f, 0.47236655f, 0.22313016f}; // exp(−¾ r²), catalogue 10.7
  for (const std::size_t k : chosen) {
    set.values.push_back(t.details().neighborhood.samples[k].x);
    const int distance = k == 4 ? 0 : k % 2 == 1 ? 1 : 2;
    const glm::vec3 color = reference::fromBox(t.details().neighborhood.samples[k], t.settings().space);
    set.weights.push_back(kind == MomentWeights::Equal  ? 1.0f
                          : kind == MomentWeights::Luma ? 1.0f / (1.0f + reference::luma(color))
                                                        : kByDistance[distance]);
  }
  return set;
}

float meanOf(const Set& set) {
  double sum = 0, total = 0;
  for (std::size_t k = 0; k < set.values.size(); ++k) {
    sum += static_cast<double>(set.weights[k]) * static_cast<double>(set.values[k]);
    total += static_cast<double>(set.weights[k]);
  }
  return static_cast<float>(sum / total);
}

std::string list(const Teller& t, const std::vector<float>& values, const char* between) {
  std::string text;
  for (const float value : values)
    text += (text.empty() ? "" : between) + t.number(static_cast<double>(value));
  return text;
}

std::string meanText(const Teller& t, const Set& set) {
  if (!set.isEqual) return weightedMean(t, set.weights, set.values);
  return "(" + list(t, set.values, " + ") + ") / " + std::to_string(set.values.size());
}

std::string deviationText(const Teller& t, const Set& set) {
  const std::string mean = t.number(static_cast<double>(meanOf(set)));
  std::string sum, total;
  for (std::size_t k = 0; k < set.values.size(); ++k) {
    const std::string square = "(" + t.number(static_cast<double>(set.values[k])) + " − " + mean + ")^2";
    const std::string weight = t.number(static_cast<double>(set.weights[k]));
    sum += (k == 0 ? "" : " + ") + (set.isEqual ? square : weight + " × " + square);
    total += (k == 0 ? "" : " + ") + weight;
  }
  return "√((" + sum + ") / " + (set.isEqual ? std::to_string(set.values.size()) : "(" + total + ")") + ")";
}

RowStory momentStory(Id id, const Teller& t) {
  const std::vector<std::size_t> chosen = setOf(t);
  const Set set = samplesOf(t, chosen), five = samplesOf(t, setOf(true, false));
  const bool isRounded = t.settings().neighborhood.shape == NeighborhoodShape::Rounded;
  const auto rounded = [&](const std::string& all, const std::string& cross) {
    return isRounded ? "(" + all + " + " + cross + ") / 2" : all;
  };
  const auto first = [&](Id row) { return " = " + t.number(static_cast<double>(t.color(row).x)); };
  const std::string of = std::to_string(chosen.size()) + " samples" + (isRounded ? " and of the cross" : "");
  if (id == Id::neighborhoodMean)
    return {"mean of the " + of, rounded(meanText(t, set), meanText(t, five)) + first(id), t.channelName(0)};
  if (id == Id::neighborhoodDeviation)
    return {"spread of the " + std::to_string(chosen.size()) + " samples about their mean",
            deviationText(t, set) + first(id), t.channelName(0)};
  const std::string function = id == Id::neighborhoodMin ? "min" : "max";
  const auto extreme = [&](const Set& of_) { return function + "(" + list(t, of_.values, ", ") + ")"; };
  return {(function == "min" ? "smallest of the " : "largest of the ") + of,
          rounded(extreme(set), extreme(five)) + first(id), t.channelName(0)};
}

RowStory gammaStory(const Teller& t) {
  const NeighborhoodSettings& chosen = t.settings().neighborhood;
  const auto n = [&](float x) { return t.number(static_cast<double>(x)); };
  std::string text = n(chosen.gamma), words = "as chosen";
  if (isOn(chosen.motionGamma)) {
    text = n(chosen.gammaMoving) + " + (" + text + " − " + n(chosen.gammaMoving) + ") × clamp(1 − " +
           t.number(Id::speed) + " / " + n(chosen.gammaSpeed) + ", 0, 1)^2";
    words = "smaller by motion";
  }
  if (isOn(chosen.contrastGamma) && !t.details().isFirst) {
    const SpaceSettings& space = t.settings().space;
    const reference::Neighborhood& hood = t.details().neighborhood;
    const float half = 0.5f * reference::boxLuma(hood.deviation, space);
    const float mean = reference::boxLuma(hood.mean, space);
    const std::string current = n(reference::boxLuma(hood.samples[4], space));
    const std::string past = call("clamp", {n(reference::boxLuma(t.box(t.color(Id::historyRaw)), space)),
                                            n(mean) + " − " + n(half), n(mean) + " + " + n(half)});
    text += " + " + n(chosen.contrastGrowth) + " × smooth((|" + current + " − " + past + "| / " +
            call("max", {current, past, "0.15"}) + " − 0.05) / 0.5)";
    words += ", larger by contrast";
  }
  if (isOn(chosen.maskRelax)) {
    text =
        "(" + text + ") × (1 + 1.5 × " + n(std::fmax(t.value(Id::reactive), t.value(Id::responsive))) + ")";
    words += ", wider by the mask";
  }
  return {words, t.equals(text, Id::boxGamma), ""};
}

RowStory wallStory(Id id, const Teller& t) {
  const NeighborhoodSettings& chosen = t.settings().neighborhood;
  const bool isLow = id == Id::boxMin;
  const Id extreme = isLow ? Id::neighborhoodMin : Id::neighborhoodMax;
  const bool isShrunk = isOn(chosen.chromaShrink) && t.settings().space.color != ColorSpace::Rgb;
  const auto text = [&](const glm::vec3& v) {
    return isShrunk ? t.number(static_cast<double>(v.x)) : t.tuple(v);
  };
  const std::string moments = text(t.color(Id::neighborhoodMean)) + (isLow ? " − " : " + ") +
                              t.number(Id::boxGamma) + " × " + text(t.color(Id::neighborhoodDeviation));
  std::string wall = text(t.color(extreme)), words = "extreme of the samples";
  if (chosen.box == BoxKind::Variance) wall = moments, words = "γ deviations from the mean";
  if (chosen.box == BoxKind::Intersection) {
    wall = call(isLow ? "max" : "min", {wall, moments});
    words = "the narrower of the samples' extreme and γ deviations";
  }
  if (isOn(chosen.includeFiltered)) {
    wall = call(isLow ? "min" : "max", {wall, text(t.box(t.color(Id::currentFiltered)))});
    words += ", wide enough for the filtered color";
  }
  if (isShrunk) words += "; chroma an eighth of the luma range around the pixel";
  return {words, wall + " = " + text(t.color(id)), isShrunk ? t.channelName(0) : ""};
}

} // namespace

RowStory sampleStory(Id id, const Teller& t) {
  switch (intermediate(id).stage) {
  case Stage::DilateMotion:
    return dilateStory(id, t);
  case Stage::Reproject:
    return reprojectStory(id, t);
  case Stage::SampleHistory:
    return historyStory(id, t);
  default:
    break;
  }
  if (id == Id::currentFiltered) return currentStory(t);
  return {isUpsampled(t.settings()) ? "how near the samples lie to the pixel's center" : "drawn at full size",
          "", ""};
}

RowStory boxStory(Id id, const Teller& t) {
  if (id == Id::boxGamma) return gammaStory(t);
  if (id == Id::boxMin || id == Id::boxMax) return wallStory(id, t);
  return momentStory(id, t);
}

} // namespace taa::story
