#include "core/taa/Intermediates.h"

#include "core/base/Error.h"
#include "core/base/Say.h"

#include <algorithm>
#include <iterator>

namespace taa {

std::optional<IntermediateId> findIntermediate(std::string_view name) {
  const auto found = std::ranges::find(kIntermediates, name, &Intermediate::name);
  if (found == kIntermediates.end()) return std::nullopt;
  return found->id;
}

IntermediateId intermediateNamed(std::string_view name) {
  if (const auto id = findIntermediate(name)) return *id;
  std::string all;
  for (const Intermediate& row : kIntermediates) all += (all.empty() ? "" : ", ") + std::string(row.name);
  throw Error(say<"no intermediate is called \"%1\"; there are %2">(name, all));
}

std::vector<IntermediateId> allRows() {
  std::vector<IntermediateId> ids;
  for (const Intermediate& row : kResolveRows) ids.push_back(row.id);
  return ids;
}

std::optional<IntermediateId> mainRow(Stage stage) {
  return findIntermediate(stageInfo(stage).main);
}

std::vector<IntermediateId> mainRows() {
  std::vector<IntermediateId> rows;
  for (const StageInfo& stage : kStages)
    if (const auto row = mainRow(stage.stage)) rows.push_back(*row);
  return rows;
}

std::vector<IntermediateId> inTableOrder(std::vector<IntermediateId> ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

std::vector<OverTime> kindsOverTime(std::span<const IntermediateId> ids) {
  std::vector<OverTime> kinds;
  for (const OverTime kind : {OverTime::Flicker, OverTime::Parts})
    if (std::ranges::any_of(ids, [kind](IntermediateId id) { return overTime(id) == kind; }))
      kinds.push_back(kind);
  return kinds;
}

std::vector<IntermediateId> rowsOfOutput(const std::vector<IntermediateId>& watched) {
  std::vector<IntermediateId> rows;
  std::ranges::copy_if(watched, std::back_inserter(rows), isOfOutput);
  return rows;
}

std::vector<IntermediateId> rowsOfResolve(const std::vector<IntermediateId>& watched) {
  std::vector<IntermediateId> rows;
  std::ranges::remove_copy_if(watched, std::back_inserter(rows),
                              [](IntermediateId id) { return isOfOutput(id) || isOfReference(id); });
  return rows;
}

std::string_view rejectReasonText(int reason) {
  static constexpr std::string_view kTexts[] = {
      "kept",     "no history",     "no previous position", "off screen",     "depth",
      "too fast", "another object", "another class",        "another normal", "another velocity"};
  if (reason < 0 || reason >= static_cast<int>(std::size(kTexts))) return "unknown";
  return kTexts[reason];
}

std::string_view categoryText(IntermediateId id, int number) {
  if (id == IntermediateId::rejectReason) return rejectReasonText(number);
  if (id != IntermediateId::verdictMap && id != IntermediateId::geometryVerdict) return {};
  static constexpr std::string_view kVerdicts[] = {"rightly kept", "wrong history removed",
                                                   "wrong history let through", "good history thrown away"};
  return number >= 0 && number < static_cast<int>(std::size(kVerdicts)) ? kVerdicts[number] : "unknown";
}

} // namespace taa
