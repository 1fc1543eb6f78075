#include "core/cli/Pictures.h"

#include "core/base/Error.h"
#include "core/picture/StyleText.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace taa::cli {

namespace {

// What is wrong with it is the caller's mistake.
void checkStyle(const std::vector<std::string>& assignments, const char* flag) {
  ViewStyle style;
  for (const std::string& assignment : assignments) try {
      applyStyle(style, assignment);
    } catch (const Error& error) {
      throw UsageError(std::string(flag) + ": " + error.what());
    }
}

template <typename Read>
auto understood(const char* flag, const std::string& text, Read read) {
  try {
    return read(text);
  } catch (const Error& error) {
    throw UsageError(std::string(flag) + ": " + error.what());
  }
}

} // namespace

Pictures::Pictures(const RenderArguments& arguments, const std::vector<IntermediateId>& ids)
    : arguments_(arguments) {
  checkStyle(arguments.style, "--style");
  checkStyle(arguments.otherStyle, "--other-style");
  if (!arguments.compare.empty()) comparison_ = understood("--compare", arguments.compare, parseComparison);
  if (!comparison_ && !(arguments.compareAs.empty() && arguments.otherStyle.empty()))
    throw UsageError("--compare-as and --other-style need --compare: " + std::string(kComparisonHelp));
  if (comparison_)
    showing_ = !arguments.compareAs.empty() ? understood("--compare-as", arguments.compareAs, showingNamed)
               : arguments.format == "exr"  ? Showing::Difference
                                            : Showing::Wipe;
  check(ids);
  showsReference_ = std::ranges::any_of(
      ids, [this](IntermediateId id) { return isOfReference(id) || isOfReference(otherId(id)); });
}

void Pictures::check(const std::vector<IntermediateId>& ids) const {
  if (!compares()) return;
  if (arguments_.format == "exr" && showing_ != Showing::Difference)
    throw UsageError("--compare-as " + arguments_.compareAs +
                     " is of pictures: it needs --format png or gif; of values there is the difference");
  for (const IntermediateId id : ids) {
    const Intermediate &row = intermediate(id), &other = intermediate(otherId(id));
    if (showing_ == Showing::Difference && row.channels != other.channels)
      throw UsageError("--compare-as difference: " + std::string(row.name) + " has " +
                       std::to_string(row.channels) + " channels and " + std::string(other.name) + " " +
                       std::to_string(other.channels));
  }
}

void Pictures::addLane(ShotPlan& plan) const {
  if (!compares()) return;
  if (plan.lanes.size() > 1) throw UsageError("--compare is of one lane: leave --lane out");
  if (comparison_.kind == OtherKind::Preset) plan.lanes.push_back(laneOfPreset("other", comparison_.preset));
}

ViewStyle Pictures::styled(ViewStyle style, const std::vector<std::string>& assignments) const {
  for (const std::string& assignment : assignments) applyStyle(style, assignment);
  return style;
}

IntermediateId Pictures::otherId(IntermediateId id) const {
  return comparison_.kind == OtherKind::Row ? comparison_.id : id;
}

PictureRequest Pictures::request(const Inspector& inspector, IntermediateId id, int lane) const {
  const Intermediate& row = intermediate(id);
  const ViewStyle first = styled(defaultStyle(row), arguments_.style);
  PictureRequest request{.id = id,
                         .style = first,
                         .transform = {},
                         .width = inspector.shot().width(),
                         .height = inspector.shot().height(),
                         .lane = lane,
                         .showing = showing_,
                         .divider =
                             static_cast<int>(std::lround(arguments_.divider * inspector.shot().width())),
                         .referenceSamples = arguments_.referenceSamples};
  if (!compares()) return request;
  if (showing_ == Showing::Difference) request.style = styled(differenceStyle(row), arguments_.style);
  OtherSide& other = request.other.emplace(otherSideOf(comparison_, id, 1));
  // The same row looks the same on both sides, as in a view.
  other.style = styled(other.id == id ? first : defaultStyle(intermediate(other.id)), arguments_.otherStyle);
  return request;
}

Picture Pictures::draw(Inspector& inspector, IntermediateId id, int lane, const Progress& progress) const {
  return shownPicture(inspector, request(inspector, id, lane), progress);
}

} // namespace taa::cli
