#include "core/lessons/Condition.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/lessons/LessonText.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace taa {

namespace {

constexpr int kMaxConditionFrame = 100'000;
constexpr std::string_view kPicked = "picked";
constexpr std::array<std::pair<std::string_view, Relation>, 5> kRelations{{{"<", Relation::Less},
                                                                           {"<=", Relation::LessOrEqual},
                                                                           {">", Relation::Greater},
                                                                           {">=", Relation::GreaterOrEqual},
                                                                           {"=", Relation::Equal}}};

/// The words of a condition, one after the other.
class WordReader {
 public:
  explicit WordReader(std::string_view text) : words_(wordsOf(text)) {}

  bool isAtEnd() const { return next_ == words_.size(); }
  std::string_view peek() const { return isAtEnd() ? std::string_view() : words_[next_]; }
  /// `what`: what should come.
  std::string_view take(const std::string& what) {
    if (isAtEnd()) throw Error(say<"the condition ends where %1 should come">(what));
    return words_[next_++];
  }
  bool takes(std::string_view word) {
    if (isAtEnd() || words_[next_] != word) return false;
    ++next_;
    return true;
  }

 private:
  std::vector<std::string_view> words_;
  std::size_t next_ = 0;
};

/// "resolved", "boxMin.y"
void readRow(Quantity& quantity, std::string_view word) {
  const std::size_t dot = std::min(word.find('.'), word.size());
  quantity.row = intermediateNamed(word.substr(0, dot));
  if (dot == word.size()) return;
  constexpr std::string_view kAxes = "xyz", kColors = "rgb";
  const std::string_view name = word.substr(dot + 1);
  const std::size_t axis = name.size() == 1 ? std::min(kAxes.find(name), kColors.find(name)) : kAxes.npos;
  if (axis == kAxes.npos || static_cast<int>(axis) >= intermediate(quantity.row).channels)
    throw Error(say<"%1 has no channel \"%2\"">(intermediate(quantity.row).name, shownText(name)));
  quantity.channel = static_cast<int>(axis);
}

void readPixel(Quantity& quantity, std::string_view word) {
  if (word != kPicked) quantity.pixel = pixelFrom(word);
}

VerdictKind verdictNamed(std::string_view id) {
  const auto found = std::ranges::find(kVerdictKinds, id, &VerdictKindInfo::id);
  if (found != kVerdictKinds.end()) return found->kind;
  std::vector<std::string_view> known;
  for (const VerdictKindInfo& info : kVerdictKinds) known.push_back(info.id);
  requireName(id, known, say<"verdict">());
  return VerdictKind::None; // never: the name was not known
}

void readShare(Quantity& quantity, WordReader& words) {
  readRow(quantity, words.take(say<"an intermediate">()));
  quantity.isBelow = words.takes("below");
  if (!quantity.isBelow && !words.takes("above"))
    throw Error(say<"a share is: share ROW above NUMBER, or below">());
  quantity.number = numberFrom(words.take(say<"a number">()));
}

constexpr std::array<std::pair<std::string_view, LineageFigure>, 5> kFigures{
    {{"samples", LineageFigure::Samples},
     {"frames", LineageFigure::Frames},
     {"radius", LineageFigure::Radius},
     {"spread", LineageFigure::Spread},
     {"older", LineageFigure::Older}}};

void readLineage(Quantity& quantity, WordReader& words) {
  readPixel(quantity, words.take(say<"a pixel">()));
  const std::string_view word = words.take(say<"samples, frames, radius, spread or older">());
  const auto named = std::ranges::find(kFigures, word, &std::pair<std::string_view, LineageFigure>::first);
  if (named == kFigures.end())
    throw Error(say<"\"%1\" is none of samples, frames, radius, spread and older">(shownText(word)));
  quantity.figure = named->second;
}

void readPushed(Quantity& quantity, WordReader& words) {
  quantity.isSeveral = words.takes("several");
  if (!quantity.isSeveral && !words.takes("none"))
    throw Error(say<"what is pushed is: pushed none, or pushed several">());
}

/// What follows the word that says what it is.
void readKind(Quantity& quantity, WordReader& words) {
  switch (quantity.kind) {
  case QuantityKind::Number:
  case QuantityKind::Fetches:
  case QuantityKind::Changed:
  case QuantityKind::Time:
    break;
  case QuantityKind::Metric:
    quantity.metric = metricNamed(words.take(say<"a metric">()));
    break;
  case QuantityKind::Share:
    readShare(quantity, words);
    break;
  case QuantityKind::Verdict:
    readPixel(quantity, words.take(say<"a pixel">()));
    quantity.verdict = verdictNamed(words.take(say<"a verdict">()));
    break;
  case QuantityKind::Doctor:
    quantity.fault = faultInfo(words.take(say<"a fault">())).fault;
    break;
  case QuantityKind::Lineage:
    readLineage(quantity, words);
    break;
  case QuantityKind::Volume:
    readPixel(quantity, words.take(say<"a pixel">()));
    break;
  case QuantityKind::Levels:
    readRow(quantity, words.take(say<"an intermediate">()));
    break;
  case QuantityKind::Pushed:
    readPushed(quantity, words);
    break;
  case QuantityKind::Value:
  case QuantityKind::Difference:
    readPixel(quantity, words.take(say<"a pixel">()));
    readRow(quantity, words.take(say<"an intermediate">()));
    break;
  }
}

constexpr std::array<std::pair<std::string_view, QuantityKind>, 13> kQuantities{
    {{"metric", QuantityKind::Metric},
     {"probe", QuantityKind::Value},
     {"difference", QuantityKind::Difference},
     {"share", QuantityKind::Share},
     {"verdict", QuantityKind::Verdict},
     {"doctor", QuantityKind::Doctor},
     {"lineage", QuantityKind::Lineage},
     {"volume", QuantityKind::Volume},
     {"levels", QuantityKind::Levels},
     {"pushed", QuantityKind::Pushed},
     {"fetches", QuantityKind::Fetches},
     {"changed", QuantityKind::Changed},
     {"time", QuantityKind::Time}}};

/// "+ 2", "* 0.5": at most one of each.
void readArithmetic(Quantity& quantity, WordReader& words) {
  if (words.takes("*")) quantity.factor = numberFrom(words.take(say<"a number">()));
  if (words.takes("+")) quantity.offset = numberFrom(words.take(say<"a number">()));
  if (words.takes("-")) quantity.offset = -numberFrom(words.take(say<"a number">()));
}

Quantity readQuantity(WordReader& words) {
  Quantity quantity;
  const std::string_view first = words.take(say<"a number">());
  const auto named = std::ranges::find(kQuantities, first, &std::pair<std::string_view, QuantityKind>::first);
  if (named == kQuantities.end()) {
    const bool isName = !first.empty() && first.front() >= 'a' && first.front() <= 'z';
    if (isName)
      throw Error(
          say<"\"%1\" is none of metric, probe, difference, share, verdict, doctor, lineage, volume, levels, "
              "pushed, fetches, changed and time">(shownText(first)));
    quantity.number = numberFrom(first);
    return quantity;
  }
  quantity.kind = named->second;
  readKind(quantity, words);
  if (words.takes("of")) quantity.lane = std::string(words.take(say<"the name of a lane">()));
  if (words.takes("at"))
    quantity.frame = wholeNumberFrom(words.take(say<"a frame">()), 0, kMaxConditionFrame);
  if (quantity.kind == QuantityKind::Difference && quantity.lane.empty())
    throw Error(say<"a difference is of a lane: difference PIXEL ROW of LANE">());
  readArithmetic(quantity, words);
  return quantity;
}

bool isYesOrNo(const Quantity& quantity) {
  return quantity.kind == QuantityKind::Verdict || quantity.kind == QuantityKind::Doctor;
}

} // namespace

Condition conditionFrom(std::string_view text) {
  Condition condition;
  condition.text = std::string(withoutBlanks(text));
  WordReader words(text);
  const bool isDenied = words.takes("not");
  condition.left = readQuantity(words);
  if (isYesOrNo(condition.left)) {
    condition.relation = Relation::Equal;
    condition.right.number = isDenied ? 0.0 : 1.0;
  } else {
    if (isDenied) throw Error(say<"\"not\" is of verdict and doctor alone">());
    const std::string_view word = words.take(say<"a comparison">());
    const auto named = std::ranges::find(kRelations, word, &std::pair<std::string_view, Relation>::first);
    if (named == kRelations.end()) throw Error(say<"\"%1\" is none of <, <=, >, >= and =">(shownText(word)));
    condition.relation = named->second;
    condition.right = readQuantity(words);
    if (words.takes("within")) condition.tolerance = numberFrom(words.take(say<"a number">()));
  }
  if (!words.isAtEnd()) throw Error(say<"\"%1\" is more than the condition needs">(shownText(words.peek())));
  return condition;
}

// Written so that NaN, which is what is not known, holds nothing.
bool holds(const Condition& condition, double left, double right) {
  switch (condition.relation) {
  case Relation::Less:
    return left < right;
  case Relation::LessOrEqual:
    return left <= right;
  case Relation::Greater:
    return left > right;
  case Relation::GreaterOrEqual:
    return left >= right;
  case Relation::Equal:
    return left == right || std::abs(left - right) <= condition.tolerance;
  }
  return false;
}

std::vector<const Quantity*> quantitiesOf(const std::vector<Condition>& conditions) {
  std::vector<const Quantity*> all;
  for (const Condition& condition : conditions)
    for (const Quantity* side : {&condition.left, &condition.right})
      if (side->kind != QuantityKind::Number) all.push_back(side);
  return all;
}

} // namespace taa
