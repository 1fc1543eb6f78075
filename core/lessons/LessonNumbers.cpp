#include "core/lessons/LessonNumbers.h"

#include "core/base/Say.h"
#include "core/explanation/RowFormatter.h"
#include "core/inspect/Inspector.h"
#include "core/lessons/StateMeasurer.h"
#include "core/settings/AssignmentWords.h"
#include "core/settings/Parameters.h"
#include "core/taa/ChannelNames.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <tuple>
#include <utility>

namespace taa {

namespace {

bool isNumber(const Quantity& quantity) {
  return quantity.kind != QuantityKind::Number && quantity.kind != QuantityKind::Verdict &&
         quantity.kind != QuantityKind::Doctor;
}

bool isSameQuantity(const Quantity& a, const Quantity& b) {
  const auto parts = [](const Quantity& of) {
    return std::tuple(of.kind, of.number, of.metric, of.row, of.channel, of.pixel, of.isBelow, of.figure,
                      of.isSeveral, of.frame);
  };
  return parts(a) == parts(b);
}

/// "History position X", "Motion, its length": what of a row is one number.
std::string rowText(const Quantity& quantity, const SpaceSettings& space) {
  const Intermediate& row = intermediate(quantity.row);
  const std::string label(row.label);
  if (row.channels == 1) return label;
  if (quantity.channel >= 0)
    return label + " " + channelNames(row, space).at(static_cast<std::size_t>(quantity.channel));
  if (quantity.kind == QuantityKind::Difference) return label;
  return row.channels == 2 ? say<"%1, its length">(label) : say<"%1, its luma">(label);
}

std::string lineageText(LineageFigure figure) {
  switch (figure) {
  case LineageFigure::Samples:
    return say<"samples of equal weight">();
  case LineageFigure::Frames:
    return say<"frames of equal weight">();
  case LineageFigure::Radius:
    return say<"radius of its samples, px">();
  case LineageFigure::Spread:
    return say<"blur of the oldest frame, px">();
  case LineageFigure::Older:
    return say<"weight of older frames">();
  }
  return {};
}

std::string withUnit(const std::string& text, std::string_view unit) {
  return unit.empty() ? text : text + ", " + std::string(unit);
}

/// "100, 60", or that it is the one that is probed.
std::string probedText(const Quantity& quantity) {
  if (!quantity.pixel) return say<"the probe">();
  return std::to_string(quantity.pixel->x) + ", " + std::to_string(quantity.pixel->y);
}

std::string labelInFrame(const Quantity& quantity, const SpaceSettings& space) {
  const std::string_view unit = intermediate(quantity.row).unit;
  switch (quantity.kind) {
  case QuantityKind::Metric:
    return withUnit(std::string(metricInfo(quantity.metric).label), metricInfo(quantity.metric).unit);
  case QuantityKind::Value:
    return withUnit(say<"%1 at %2">(rowText(quantity, space), probedText(quantity)), unit);
  case QuantityKind::Difference:
    return withUnit(say<"%1 at %2, difference">(rowText(quantity, space), probedText(quantity)), unit);
  case QuantityKind::Share:
    return quantity.isBelow
               ? say<"%1 below %2, % of pixels">(rowText(quantity, space), numberText(quantity.number))
               : say<"%1 above %2, % of pixels">(rowText(quantity, space), numberText(quantity.number));
  case QuantityKind::Lineage:
    return say<"Lineage of %1, %2">(probedText(quantity), lineageText(quantity.figure));
  case QuantityKind::Volume:
    return say<"Volume of the box at %1">(probedText(quantity));
  case QuantityKind::Levels:
    return say<"%1, levels in the picture">(rowText(quantity, space));
  case QuantityKind::Pushed:
    return quantity.isSeveral ? say<"Where several pixels are pushed to, %">()
                              : say<"Where no pixel is pushed to, %">();
  case QuantityKind::Fetches:
    return say<"Texture fetches of a pixel">();
  case QuantityKind::Changed:
    return say<"Pixels of another color, %">();
  case QuantityKind::Time:
    return say<"Time of the resolve, times that of the first">();
  case QuantityKind::Verdict: {
    const auto kind = std::ranges::find(kVerdictKinds, quantity.verdict, &VerdictKindInfo::kind);
    return say<"Verdict \"%1\" at %2">(kind->label, probedText(quantity));
  }
  case QuantityKind::Doctor:
    return say<"Finding \"%1\"">(faultInfo(quantity.fault).label);
  case QuantityKind::Number:
    break;
  }
  return {};
}

std::string quantityLabel(const Quantity& quantity, const SpaceSettings& space) {
  const std::string label = labelInFrame(quantity, space);
  return quantity.frame ? say<"%1, in frame %2">(label, *quantity.frame) : label;
}

/// By what the settings of a lane differ from the step's own.
std::string laneText(const Settings& lane, const Settings& own) {
  constexpr std::size_t kMost = 3;
  const std::vector<std::string> changes = differences(lane, own);
  if (changes.empty()) return say<"as the step has it">();
  if (changes.size() > kMost) return say<"%1 settings differ">(changes.size());
  std::string text;
  for (const std::string& change : changes) text += (text.empty() ? "" : "; ") + assignmentWords(change);
  return text;
}

std::string tableRow(const std::vector<std::string>& cells) {
  std::string row = "|";
  for (std::string cell : cells) {
    for (std::size_t at = 0; (at = cell.find('|', at)) != cell.npos; at += 2) cell.insert(at, "\\");
    row += " " + cell + " |";
  }
  return row + "\n";
}

std::string askedText(Relation relation, const std::string& value) {
  switch (relation) {
  case Relation::Less:
    return say<"less than %1">(value);
  case Relation::LessOrEqual:
    return say<"at most %1">(value);
  case Relation::Greater:
    return say<"more than %1">(value);
  case Relation::GreaterOrEqual:
    return say<"at least %1">(value);
  case Relation::Equal:
    break;
  }
  return value;
}

std::string yesOrNo(double value) {
  return value != 0.0 ? say<"yes">() : say<"no">();
}

} // namespace

std::vector<Quantity> measuredQuantities(const std::vector<Condition>& conditions) {
  std::vector<Quantity> numbers;
  for (const Quantity* asked : quantitiesOf(conditions)) {
    Quantity number = *asked;
    number.lane.clear();
    number.factor = 1.0;
    number.offset = 0.0;
    if (isNumber(number) &&
        std::ranges::none_of(numbers, [&](const Quantity& known) { return isSameQuantity(known, number); }))
      numbers.push_back(number);
  }
  return numbers;
}

bool hasNumbers(const LessonStep& step) {
  return !step.task && !measuredQuantities(step.claims).empty();
}

std::vector<LessonNumber> measureNumbers(Inspector& inspector, const LessonState& state,
                                         const std::vector<Condition>& conditions, const Progress& progress) {
  const LessonState opened = openState(inspector, state, progress);
  const SpaceSettings space = opened.shot.settings.settings.space;
  StateMeasurer measurer(inspector, opened, progress);
  const std::vector<Quantity> asked = measuredQuantities(conditions);
  std::vector<const Quantity*> planned;
  for (const Quantity& quantity : asked) planned.push_back(&quantity);
  measurer.plan(planned);
  std::vector<LessonNumber> numbers;
  for (Quantity quantity : asked) {
    LessonNumber number{quantityLabel(quantity, space), {}};
    // From itself nothing differs.
    number.values.push_back(quantity.kind == QuantityKind::Difference ? 0.0 : measurer.measure(quantity));
    for (const LessonLane& lane : opened.lanes) {
      quantity.lane = lane.name;
      number.values.push_back(measurer.measure(quantity));
    }
    numbers.push_back(std::move(number));
  }
  return numbers;
}

std::string numbersMarkdown(const std::vector<LessonNumber>& numbers, const LessonState& step,
                            const std::string& first) {
  if (numbers.empty()) return {};
  std::vector<std::string> cells{say<"Measured">(), first};
  for (const LessonLane& lane : step.lanes) cells.push_back(lane.name);
  std::string text = tableRow(cells) + tableRow(std::vector<std::string>(cells.size(), "---"));
  for (const LessonNumber& number : numbers) {
    cells.assign(1, number.label);
    for (const double value : number.values) cells.push_back(std::isnan(value) ? "–" : numberText(value));
    text += tableRow(cells);
  }
  for (const LessonLane& lane : step.lanes)
    text += "\n*" + lane.name + "*: " + laneText(lane.settings, step.shot.settings.settings) + "\n";
  return text;
}

std::string lackText(const CheckedCondition& checked, const SpaceSettings& space) {
  const Condition& condition = checked.condition;
  const std::string label = quantityLabel(condition.left, space);
  if (!isNumber(condition.left))
    return say<"%1: %2, asked for: %3">(label, yesOrNo(checked.left), yesOrNo(checked.right));
  if (std::isnan(checked.left)) return say<"%1: not known in this frame">(label);
  return say<"%1: %2, asked for: %3">(label, numberText(checked.left),
                                      askedText(condition.relation, numberText(checked.right)));
}

} // namespace taa
