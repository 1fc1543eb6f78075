#include "core/verdict/lineage/LineageWords.h"

#include "core/base/Say.h"
#include "core/explanation/RowFormatter.h"

#include <cmath>
#include <cstddef>

namespace taa {

namespace {

/// Shares below it are not worth a word.
constexpr double kWorthSaying = 5e-4;

std::string worthSentence(const Lineage& lineage) {
  const std::string text = say<
      "averages as much as %1 equally weighted frames (the resolve counts N = %2); %3 of the noise variance of single samples is left">(
      numberText(lineage.effectiveFrames, 3), numberText(lineage.historyLength, 3),
      explanation::percentText(lineage.variance));
  return lineage.rectified < kWorthSaying ? text : say<"%1, besides what rectification brings in">(text);
}

std::string partsSentence(const Lineage& lineage) {
  std::string text = lineage.frames.size() == 1
                         ? say<"%1 samples of this frame">(explanation::percentText(lineage.weight))
                         : say<"%1 samples of the last %2 frames">(explanation::percentText(lineage.weight),
                                                                   lineage.frames.size());
  const auto add = [&text](double share, const std::string& words) {
    if (std::fabs(share) >= kWorthSaying) text += ", " + words;
  };
  add(lineage.rectified, say<"%1 replaced by clipping">(explanation::percentText(lineage.rectified)));
  add(lineage.older, say<"%1 older">(explanation::percentText(lineage.older)));
  add(lineage.pruned, say<"%1 in discarded small weights">(explanation::percentText(lineage.pruned)));
  add(lineage.blank, say<"%1 of nothing">(explanation::percentText(lineage.blank)));
  return text;
}

std::string placeSentence(const Lineage& lineage) {
  const LineageFrame& first = lineage.frames.back();
  return say<
      "its samples lie within %1 px (rms) of its center; in frame %2 history was gathered over %4 px around %3">(
      numberText(lineage.radiusPx, 3), first.frame, explanation::tupleText(glm::vec2(first.place)),
      numberText(first.spreadPx, 3));
}

} // namespace

std::vector<std::string> lineageSentences(const Lineage& lineage) {
  return {worthSentence(lineage), partsSentence(lineage), placeSentence(lineage)};
}

} // namespace taa
