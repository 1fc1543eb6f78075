#include "core/cli/Pictures.h"

#include "core/picture/StyleText.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace taa::cli {

namespace {

void checkStyle(const std::vector<std::string>& assignments, const char* flag) {
  ViewStyle style;
  for (const std::string& assignment : assignments) readOption(flag, [&] { applyStyle(style, assignment); });
}

} // namespace

void addPictureOptions(CLI::App& command, PictureOptions& options) {
  command
      .add_option("--style", options.style,
                  "How png and gif show values: low=, high=, exposure=, channels=, map=, marks=, clipped=, "
                  "rejected=, outlines= or arrows=; repeat it for more")
      ->allow_extra_args(false);
  command.add_option("--compare", options.compare,
                     "What each is compared with, " + std::string(kComparisonHelp) +
                         "; an exr has the values of the differences then");
  command.add_option("--compare-as", options.compareAs,
                     "Of png and gif: how both are shown: wipe, which it is without this, first, other or "
                     "difference");
  command
      .add_option("--divider", options.divider,
                  "Where a wipe goes over to the other side, share of the width")
      ->check(numberFrom(0.0, 1.0))
      ->capture_default_str();
  command
      .add_option("--other-style", options.otherStyle, "As --style, of the other side; repeat it for more")
      ->allow_extra_args(false);
}

Pictures::Pictures(PictureOptions options, const std::vector<IntermediateId>& ids, bool areValues,
                   int referenceSamples)
    : options_(std::move(options)), referenceSamples_(referenceSamples) {
  checkStyle(options_.style, "--style");
  checkStyle(options_.otherStyle, "--other-style");
  if (!options_.compare.empty())
    comparison_ = readOption("--compare", [&] { return parseComparison(options_.compare); });
  if (!comparison_ && !(options_.compareAs.empty() && options_.otherStyle.empty()))
    throw UsageError("--compare-as and --other-style need --compare: " + std::string(kComparisonHelp));
  showsReference_ = std::ranges::any_of(
      ids, [this](IntermediateId id) { return isOfReference(id) || isOfReference(otherId(id)); });
  if (!compares()) return;
  showing_ = !options_.compareAs.empty()
                 ? readOption("--compare-as", [&] { return showingNamed(options_.compareAs); })
             : areValues ? Showing::Difference
                         : Showing::Wipe;
  if (areValues && showing_ != Showing::Difference)
    throw UsageError("--compare-as " + options_.compareAs +
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
  const ViewStyle first = styled(defaultStyle(row), options_.style);
  PictureRequest request{.id = id,
                         .style = first,
                         .transform = {},
                         .width = inspector.shot().width(),
                         .height = inspector.shot().height(),
                         .lane = lane,
                         .showing = showing_,
                         .divider =
                             static_cast<int>(std::lround(options_.divider * inspector.shot().width())),
                         .referenceSamples = referenceSamples_};
  if (!compares()) return request;
  if (showing_ == Showing::Difference) request.style = styled(differenceStyle(row), options_.style);
  OtherSide& other = request.other.emplace(otherSideOf(comparison_, id, 1));
  // The same row looks the same on both sides, as in a view.
  other.style = styled(other.id == id ? first : defaultStyle(intermediate(other.id)), options_.otherStyle);
  return request;
}

Picture Pictures::draw(Inspector& inspector, IntermediateId id, int lane, const Progress& progress) const {
  return shownPicture(inspector, request(inspector, id, lane), progress);
}

} // namespace taa::cli
