#include "core/verdict/lineage/LineageWords.h"

#include "core/base/Say.h"
#include "core/story/StoryText.h"

#include <cmath>
#include <cstddef>

namespace taa {

namespace {

/// Shares below it are not worth a word.
constexpr double kWorthSaying = 5e-4;

std::string worthSentence(const Lineage& lineage) {
  const std::string text =
      say<"worth %1 equal frames, N says %2; noise of single samples keeps %3 of its variance">(
          numberText(lineage.effectiveFrames, 3), numberText(lineage.historyLength, 3),
          story::percentText(lineage.variance));
  return lineage.rectified < kWorthSaying ? text : say<"%1, besides what rectification brings in">(text);
}

std::string partsSentence(const Lineage& lineage) {
  std::string text = lineage.frames.size() == 1
                         ? say<"%1 samples of this frame">(story::percentText(lineage.weight))
                         : say<"%1 samples of the last %2 frames">(story::percentText(lineage.weight),
                                                                   lineage.frames.size());
  const auto add = [&text](double share, const std::string& words) {
    if (std::fabs(share) >= kWorthSaying) text += ", " + words;
  };
  add(lineage.rectified, say<"%1 put there by rectification">(story::percentText(lineage.rectified)));
  add(lineage.older, say<"%1 older">(story::percentText(lineage.older)));
  add(lineage.pruned, say<"%1 in pixels that hardly count">(story::percentText(lineage.pruned)));
  add(lineage.blank, say<"%1 of nothing">(story::percentText(lineage.blank)));
  return text;
}

std::string placeSentence(const Lineage& lineage) {
  const LineageFrame& first = lineage.frames.back();
  return say<"its samples lie %1 px around its center; in frame %2 they were read around %3, over %4 px">(
      numberText(lineage.radiusPx, 3), first.frame, story::tupleText(glm::vec2(first.place)),
      numberText(first.spreadPx, 3));
}

} // namespace

std::vector<std::string> lineageSentences(const Lineage& lineage) {
  return {worthSentence(lineage), partsSentence(lineage), placeSentence(lineage)};
}

} // namespace taa
