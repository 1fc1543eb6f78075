#include "core/capture/format/Conventions.h"

#include "core/base/Error.h"
#include "core/base/NearestNames.h"
#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/capture/format/ConventionText.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace taa::capture {

namespace {

std::string idsOf(const Convention& row) {
  std::string ids;
  for (const ConventionChoice& choice : row.choices)
    ids += (ids.empty() ? "" : ", ") + std::string(choice.id);
  return row.kind == ConventionKind::OptionalChoice ? ids + ", none" : ids;
}

[[noreturn]] void refuseNumber(const Convention& row, const std::string& shown) {
  const std::string least = decimalText(row.minimum), most = decimalText(row.maximum);
  if (row.kind == ConventionKind::Integer)
    throw Error(
        say<"cannot set %1 to \"%2\": give a whole number from %3 to %4">(row.path, shown, least, most));
  if (row.kind == ConventionKind::OptionalNumber)
    throw Error(
        say<"cannot set %1 to \"%2\": give a number from %3 to %4 or none">(row.path, shown, least, most));
  throw Error(say<"cannot set %1 to \"%2\": give a number from %3 to %4">(row.path, shown, least, most));
}

/// Whether the "path=choice|choice" or "path!=none" of a row holds.
bool holds(std::string_view when, const Conventions& conventions) {
  const std::size_t equals = when.find('=');
  const bool isDenied = when[equals - 1] == '!';
  const std::string value = convention(when.substr(0, equals - (isDenied ? 1 : 0))).text(conventions);
  if (isDenied) return value != when.substr(equals + 1);
  for (std::string_view rest = when.substr(equals + 1); !rest.empty();) {
    const std::size_t bar = std::min(rest.find('|'), rest.size());
    if (rest.substr(0, bar) == value) return true;
    rest.remove_prefix(std::min(bar + 1, rest.size()));
  }
  return false;
}

/// What a depth buffer stores at the near plane.
double windowNear(const DepthConventions& depth) {
  if (depth.reversed) return 1.0;
  return depth.range == ClipRange::ZeroToOne ? 0.0 : -1.0;
}

std::string depthContradiction(const DepthConventions& depth) {
  if (depth.kind != DepthKind::Window)
    return depth.scale == 0.0 ? say<"%1 is 0, which makes all depth 0">("depth.scale") : "";
  if (depth.farPlane > 0.0 && depth.nearPlane == 0.0)
    return say<"%1 is given without %2">("depth.farPlane", "depth.nearPlane");
  if (depth.farPlane > 0.0 && depth.farPlane <= depth.nearPlane)
    return say<"%1 is not farther than %2">("depth.farPlane", "depth.nearPlane");
  if (depth.nothing == windowNear(depth))
    return say<"%1 is %2, which with %3=%4 is the near plane">(
        "depth.nothing", decimalText(*depth.nothing), "depth.reversed", depth.reversed ? "on" : "off");
  return "";
}

} // namespace

void refuseValue(const Convention& row, std::string_view text) {
  const std::string shown = shownText(text);
  switch (row.kind) {
  case ConventionKind::Choice:
  case ConventionKind::OptionalChoice:
    throw Error(say<"cannot set %1 to \"%2\": give one of %3">(row.path, shown, idsOf(row)));
  case ConventionKind::Toggle:
    throw Error(say<"cannot set %1 to \"%2\": give on or off">(row.path, shown));
  case ConventionKind::Integer:
  case ConventionKind::Number:
  case ConventionKind::OptionalNumber:
    break;
  }
  refuseNumber(row, shown);
}

std::size_t choiceIndex(const Convention& row, std::string_view text) {
  const auto found = std::ranges::find(row.choices, text, &ConventionChoice::id);
  if (found == row.choices.end()) refuseValue(row, text);
  return static_cast<std::size_t>(found - row.choices.begin());
}

bool parseToggle(const Convention& row, std::string_view text) {
  if (text == "on" || text == "true" || text == "1") return true;
  if (text == "off" || text == "false" || text == "0") return false;
  refuseValue(row, text);
}

double parseNumber(const Convention& row, std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) refuseValue(row, text);
  // Written so that NaN is refused.
  if (!(value >= row.minimum && value <= row.maximum)) refuseValue(row, text);
  if (row.kind == ConventionKind::Integer && value != std::floor(value)) refuseValue(row, text);
  return value;
}

const Convention& convention(std::string_view path) {
  const std::span<const Convention> rows = conventions();
  const auto found = std::ranges::find(rows, path, &Convention::path);
  if (found != rows.end()) return *found;
  std::vector<std::string_view> paths;
  for (const Convention& row : rows) paths.push_back(row.path);
  const std::vector<std::string_view> near = nearestNames(path, paths, 3);
  throw Error(say<"there is no convention \"%1\"; near it are %2, %3 or %4">(shownText(path), near[0],
                                                                             near[1], near[2]));
}

void applyAssignment(Conventions& conventions, std::string_view assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string_view::npos)
    throw Error(
        say<"cannot read \"%1\": write path=value, for example motion.yAxis=up">(shownText(assignment)));
  convention(assignment.substr(0, equals)).assign(conventions, assignment.substr(equals + 1));
}

bool isRelevant(const Convention& row, const Conventions& conventions) {
  return row.when.empty() || holds(row.when, conventions);
}

Conventions normalized(const Conventions& conventions) {
  Conventions result = conventions;
  for (const Convention& row : capture::conventions())
    if (!isRelevant(row, conventions)) row.assign(result, row.text(Conventions{}));
  return result;
}

std::string contradiction(const Conventions& conventions) {
  const glm::dvec2 scale = conventions.motion.scale;
  if (scale.x == 0.0 || scale.y == 0.0)
    return say<"%1 is 0, which says that nothing ever moves">(scale.x == 0.0 ? "motion.scaleX"
                                                                             : "motion.scaleY");
  return depthContradiction(conventions.depth);
}

std::vector<std::string> differences(const Conventions& stated, const Conventions& base) {
  std::vector<std::string> assignments;
  for (const Convention& row : conventions())
    if (std::string text = row.text(stated); text != row.text(base))
      assignments.push_back(std::string(row.path) + "=" + text);
  return assignments;
}

} // namespace taa::capture
