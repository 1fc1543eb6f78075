// The formulas of rows: those that the twin makes from how it made them, the few others by hand.
#include "core/base/Say.h"
#include "core/explanation/FormulaText.h"
#include "core/explanation/RowFormatter.h"
#include "core/taa/ChannelNames.h"
#include "core/taa/twin/Color.h"

#include <glm/common.hpp>

#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace taa::explanation {

namespace {

/// Of rows of many summands the first channel says it all.
bool isLong(Id id) {
  switch (id) {
  case Id::historyRaw:
  case Id::currentFiltered:
  case Id::neighborhoodMean:
  case Id::neighborhoodDeviation:
  case Id::neighborhoodMin:
  case Id::neighborhoodMax:
  case Id::alphaChannels:
    return true;
  default:
    return false;
  }
}

/// An expression of all channels, or of the first.
struct Expression {
  std::string text;
  int channel = -1; ///< all
};

Expression tracedExpression(Id id, const RowFormatter& t) {
  const FormulaStyle style{t.digits, id == Id::alpha, t.depth};
  if (!isLong(id))
    if (auto all = formulaText(*t.details().trace, id, style)) return {std::move(*all), -1};
  return {formulaText(*t.details().trace, id, 0, style), 0};
}

/// Nothing where it is no more than the number itself.
RowFormula formulaOf(const Expression& made, Id id, const RowFormatter& t) {
  if (made.channel < 0) {
    std::string text = t.equals(made.text, id);
    if (text == made.text + " = " + made.text) return {};
    return {std::move(text), ""};
  }
  const std::string value = t.number(twin::at(t.probed.record, id)[made.channel]);
  if (made.text == value) return {};
  return {made.text + " = " + value,
          channelNames(intermediate(id), t.settings().space)[static_cast<std::size_t>(made.channel)]};
}

RowFormula tracedFormula(Id id, const RowFormatter& t) {
  if (!isComputed(*t.details().trace, id)) return {};
  return formulaOf(tracedExpression(id, t), id, t);
}

/// Where the printed way back from box space cuts channels off (manual §26, D7), how it does; else nothing.
std::optional<RowFormula> cutOffFormula(const RowFormatter& t, const glm::vec3& moved) {
  const SpaceSettings& space = t.settings().space;
  const SpaceSettings axes{twin::withoutClamp(space).color, ToneSpace::Linear};
  const glm::vec3 before = twin::fromBox(moved, axes);
  if (space.color != ColorSpace::YCoCgAsPrinted || before == glm::clamp(before, 0.0f, 1.0f)) return {};
  return RowFormula{"clamp(" + t.tuple(before) +
                        ", 0, 1) = " + t.tuple(twin::compress(t.color(Id::historyRectified), space.tone)),
                    say<"compressed as in the box">()};
}

/// Where all of the correction leads, in box space.
RowFormula boxedFormula(const RowFormatter& t) {
  const auto& to = t.details().trace->rectifiedBox;
  const glm::dvec3 moved(to[0].value, to[1].value, to[2].value);
  if (auto cutOff = cutOffFormula(t, glm::vec3(moved))) return *cutOff;
  const auto text = formulaText(*t.details().trace, to, {t.digits});
  if (!text) return {};
  return {*text + " = " + t.tuple(glm::vec3(moved)), say<"in box space">()};
}

RowFormula rectifiedFormula(const RowFormatter& t) {
  const RectifySettings& rectify = t.settings().rectify;
  if (!isMoved(t)) return {};
  const bool isPartial = isOn(rectify.relaxAtRest) || t.value(Id::rectifyStrength) < 1.0f ||
                         t.details().lockState.protection > 0.0f;
  if (rectify.method == RectifyMethod::Select || isPartial) return tracedFormula(Id::historyRectified, t);
  return boxedFormula(t);
}

/// Mixed as a curve has the colors whose way back is told in words.
RowFormula curveFormula(const RowFormatter& t) {
  const auto red = [&](Id id) { return t.number(twin::compress(t.color(id), t.settings().blend).x); };
  const std::string past = red(Id::historyRectified);
  const std::string share =
      isMixedPerChannel(t) ? t.number(t.color(Id::alphaChannels).x) : t.number(Id::blendFactor);
  const glm::vec3 mixed = twin::compress(mixedColor(t), t.settings().blend);
  return {past + " + " + share + " × (" + red(Id::currentFiltered) + " − " + past +
              ") = " + t.number(mixed.x),
          say<"R, as the curve has it">()};
}

RowFormula resolvedFormula(const RowFormatter& t) {
  const ToneWeight tone = t.settings().blend.tone;
  const bool isBounded = tone == ToneWeight::ReinhardChannel || tone == ToneWeight::MaxChannel;
  if (twin::mixesCompressed(tone) && !isBounded && !isCurrentAlone(t)) return curveFormula(t);
  if (!isComputed(*t.details().trace, Id::resolved)) return {};
  Expression made = tracedExpression(Id::resolved, t);
  made.text = storedText(t, made.text, made.channel);
  return formulaOf(made, Id::resolved, t);
}

/// Of luma, or of the channel that differs most.
RowFormula differenceFormula(Id id, Id is, Id should, const RowFormatter& t) {
  const glm::vec3 a = t.color(is), b = t.color(should);
  if (id == Id::referenceError || id == Id::engineDifference)
    return {t.equals(t.number(twin::luma(a)) + " − " + t.number(twin::luma(b)), id), ""};
  std::string text;
  for (int i = 0; i < 3; ++i)
    text += (i == 0 ? "max(|" : ", |") + t.number(a[i]) + " − " + t.number(b[i]) + "|";
  return {t.equals(text + ")", id), ""};
}

RowFormula relativeFormula(const RowFormatter& t) {
  const glm::vec3 is = t.color(Id::output), should = t.color(Id::reference);
  std::string sum;
  for (int i = 0; i < 3; ++i) {
    const std::string reference = t.number(should[i]);
    sum += sum.empty() ? "(" : " + ";
    sum += "(" + t.number(is[i]) + " − " + reference + ")^2 / (" + reference + "^2 + 0.01)";
  }
  return {t.equals(sum + ") / 3", Id::relativeError), ""};
}

/// What is left of the error is known where the reference is.
RowFormula remainderFormula(const RowFormatter& t) {
  if (std::isnan(t.value(Id::reference))) return {};
  std::string text =
      t.number(twin::luma(t.color(Id::resolved))) + " − " + t.number(twin::luma(t.color(Id::reference)));
  for (const Id part : {Id::errorGhost, Id::errorLag, Id::errorBlur, Id::errorAliasing, Id::errorOlder}) {
    const float value = t.value(part);
    if (value != 0.0f) text += (value > 0.0f ? " − " : " + ") + t.number(std::fabs(value));
  }
  return {t.equals(text, Id::errorRectification), ""};
}

} // namespace

RowFormula rowFormula(Id id, const RowFormatter& t) {
  switch (id) {
  case Id::referenceError:
  case Id::referenceErrorAbs:
    return differenceFormula(id, Id::output, Id::reference, t);
  case Id::engineDifference:
  case Id::engineDifferenceAbs:
    return differenceFormula(id, Id::resolved, Id::engineOutput, t);
  case Id::relativeError:
    return relativeFormula(t);
  case Id::errorRectification:
    return remainderFormula(t);
  default:
    break;
  }
  if (!t.details().trace) return {};
  if (id == Id::historyRectified) return rectifiedFormula(t);
  return id == Id::resolved ? resolvedFormula(t) : tracedFormula(id, t);
}

} // namespace taa::explanation
