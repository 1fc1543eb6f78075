#include "core/sweep/tune/TuneSearch.h"

#include "core/base/Error.h"
#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/base/Text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <utility>

namespace taa {

namespace {

constexpr double kFirstStep = 1.0 / 8.0, kLastStep = 1.0 / 64.0; // shares of a number's range
constexpr double kMinGain = 1e-4;                                // of the start's goal

bool isOfResolve(const Parameter& row) {
  return row.stage >= Stage::DilateMotion && row.stage <= Stage::Blend && row.effect != Effect::Storage;
}

bool isNumeric(const Parameter& row) {
  return row.kind == ParameterKind::Number || row.kind == ParameterKind::Integer;
}

/// Where in 0…1 a value lies, and back.
double placeOf(const Parameter& row, double value) {
  const double share = (value - row.minimum) / (row.maximum - row.minimum);
  return row.minimum >= 0.0 ? std::cbrt(share) : share;
}
double valueAt(const Parameter& row, double place) {
  const double share = row.minimum >= 0.0 ? place * place * place : place;
  const double value = row.minimum + share * (row.maximum - row.minimum);
  if (row.kind == ParameterKind::Integer) return std::round(value);
  const std::string text = significantText(value, 3);
  double rounded = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), rounded);
  // What the row holds of it.
  return parseValue(row, shortestText(std::clamp(rounded, row.minimum, row.maximum)));
}

} // namespace

std::vector<const Parameter*> tunableRows() {
  std::vector<const Parameter*> rows;
  for (const Parameter& row : parameters())
    if (isOfResolve(row)) rows.push_back(&row);
  return rows;
}

std::vector<const Parameter*> tunableRows(const std::vector<std::string>& names) {
  const std::vector<const Parameter*> all = tunableRows();
  if (names.empty()) return all;
  std::vector<const Parameter*> rows;
  for (const Parameter* row : all)
    if (std::ranges::any_of(names, [&](const std::string& name) {
          return row->path == name || row->path.starts_with(name + ".");
        }))
      rows.push_back(row);
  for (const std::string& name : names)
    if (std::ranges::none_of(rows, [&](const Parameter* row) {
          return row->path == name || row->path.starts_with(name + ".");
        }))
      throw Error(say<"there is no parameter or group \"%1\" of the resolve that may be tuned">(name));
  return rows;
}

std::vector<double> tunedValues(const Parameter& row, double value, double step) {
  std::vector<double> values;
  if (!isNumeric(row)) {
    for (double other = row.minimum; other <= row.maximum; ++other)
      if (other != value) values.push_back(other);
    return values;
  }
  for (const double direction : {-1.0, 1.0}) {
    double other = valueAt(row, std::clamp(placeOf(row, value) + direction * step, 0.0, 1.0));
    if (row.kind == ParameterKind::Integer && other == value)
      other = std::clamp(value + direction, row.minimum, row.maximum);
    if (other != value) values.push_back(other);
  }
  return values;
}

TuneSearch::TuneSearch(const Settings& start, std::vector<const Parameter*> rows, unsigned seed,
                       Evaluate evaluate)
    : start_(start), rows_(std::move(rows)), random_(seed), evaluate_(std::move(evaluate)) {
  result_.settings = start;
}

void TuneSearch::run(const TuneLimits& limits) {
  limits_ = limits;
  result_.startGoal = result_.goal = goalOf(start_);
  double step = kFirstStep;
  while (step >= kLastStep && !isOver()) {
    const bool isBetter = goRound(step, step == kFirstStep);
    if (!isBetter) step /= 2.0;
  }
  result_.isComplete = step < kLastStep;
}

/// Whether anything was better. The order is another one in each round: no row is always the first.
bool TuneSearch::goRound(double step, bool withChoices) {
  // By hand: std::shuffle is another one in each standard library.
  for (std::size_t left = rows_.size(); left > 1; --left) std::swap(rows_[left - 1], rows_[random_() % left]);
  bool isBetter = false;
  for (const Parameter* row : rows_) {
    if (isOver()) break;
    if ((withChoices || isNumeric(*row)) && isRelevant(*row, result_.settings))
      isBetter = improve(*row, step) || isBetter;
  }
  return isBetter;
}

/// Of a choice the best of all; a number goes on where it has become better.
bool TuneSearch::improve(const Parameter& row, double step) {
  bool isBetter = false;
  const double before = row.get(result_.settings);
  for (const double value : tunedValues(row, before, step)) {
    if (isOver()) return isBetter;
    if (!tryValue(row, value)) continue;
    isBetter = true;
    if (!isNumeric(row)) continue;
    for (bool goesOn = true; goesOn && !isOver();) {
      const double now = row.get(result_.settings);
      goesOn = false;
      for (const double next : tunedValues(row, now, step))
        if ((next > now) == (value > before)) goesOn = tryValue(row, next);
    }
    break; // the other direction is where it came from
  }
  return isBetter;
}

bool TuneSearch::tryValue(const Parameter& row, double value) {
  Settings candidate = result_.settings;
  row.set(candidate, value);
  const double goal = goalOf(candidate);
  if (!(goal < result_.goal - kMinGain * std::abs(result_.startGoal))) return false;
  result_.settings = candidate;
  result_.goal = goal;
  result_.steps.push_back({result_.evaluations, goal, std::string(row.path) + "=" + valueText(row, value)});
  return true;
}

double TuneSearch::goalOf(const Settings& settings) {
  const std::string key = joined(differences(settings, start_));
  if (const auto found = known_.find(key); found != known_.end()) return found->second;
  const double goal = evaluate_(settings);
  ++result_.evaluations;
  known_.emplace(key, goal);
  return goal;
}

bool TuneSearch::isOver() const {
  return result_.evaluations >= limits_.evaluations || (limits_.isTimeOver && limits_.isTimeOver());
}

} // namespace taa
