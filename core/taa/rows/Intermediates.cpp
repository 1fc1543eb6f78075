#include "core/taa/rows/Intermediates.h"

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

} // namespace taa
