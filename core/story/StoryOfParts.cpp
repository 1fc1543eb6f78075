// What parts of the error and verdicts over history say of a pixel.
#include "core/base/Say.h"
#include "core/story/StoryText.h"
#include "core/taa/twin/Color.h"
#include "core/taa/twin/Known.h"

#include <string>

namespace taa::story {

namespace {

std::string partWords(Id id) {
  switch (id) {
  case Id::errorGhost:
    return say<"of history of something else: what was in front, or a place beside the surface">();
  case Id::errorLag:
    return say<"of what has changed on the surface since history was made">();
  case Id::errorBlur:
    return say<"of reading history between its pixels">();
  case Id::errorAliasing:
    return say<"of the samples of single frames">();
  case Id::errorOlder:
    return say<"from before the frames that are followed">();
  default: // rectification
    return say<"that no other part has: of rectification, mixing and rounding">();
  }
}

// What is left of the error is known where the reference is.
std::string remainderFormula(const Teller& t) {
  if (!twin::isKnown(t.probed.record, Id::reference)) return {};
  std::string text =
      t.number(twin::luma(t.color(Id::resolved))) + " − " + t.number(twin::luma(t.color(Id::reference)));
  for (const Id part : {Id::errorGhost, Id::errorLag, Id::errorBlur, Id::errorAliasing, Id::errorOlder}) {
    const float value = t.value(part);
    if (value != 0.0f) text += (value > 0.0f ? " − " : " + ") + t.number(value > 0.0f ? value : -value);
  }
  return t.equals(text, Id::errorRectification);
}

RowStory partStory(Id id, const Teller& t) {
  const float value = t.value(id);
  const std::string words = value > 0.0f   ? say<"brighter by the error %1">(partWords(id))
                            : value < 0.0f ? say<"darker by the error %1">(partWords(id))
                                           : say<"no error %1">(partWords(id));
  return {words, id == Id::errorRectification ? remainderFormula(t) : "", ""};
}

std::string historyVerdictWords(int verdict) {
  switch (verdict) {
  case 1:
    return say<"history was off by more than two steps of the screen, and was rejected or pulled">();
  case 2:
    return say<"history was off by more than two steps of the screen, and was kept">();
  case 3:
    return say<"history was as it should be, and was rejected or pulled">();
  default:
    return say<"history was as it should be and was kept, or there was none">();
  }
}

std::string geometryVerdictWords(int verdict) {
  switch (verdict) {
  case 1:
    return say<"history was of something else, and was rejected">();
  case 2:
    return say<"history was of something else, and was not rejected">();
  case 3:
    return say<"history was of this surface, and was rejected">();
  default:
    return say<"history was of this surface and was not rejected, or there was none">();
  }
}

} // namespace

RowStory partsStory(Id id, const Teller& t) {
  if (!twin::isKnown(t.probed.record, id)) return {say<"it is not measured yet">(), "", ""};
  const int category = static_cast<int>(t.value(id));
  if (id == Id::verdictMap) return {historyVerdictWords(category), "", ""};
  if (id == Id::geometryVerdict) return {geometryVerdictWords(category), "", ""};
  return partStory(id, t);
}

} // namespace taa::story
