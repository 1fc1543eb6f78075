#include "core/doctor/Correction.h"

#include "core/render/faults/FaultPass.h"
#include "core/settings/Faults.h"
#include "core/settings/Parameters.h"

#include <algorithm>
#include <map>
#include <utility>

namespace taa::doctor {

namespace {

/// Of all pixels: what is wrong with so many is taken to be wrong everywhere, where the rest says nothing.
constexpr double kMostOfPicture = 0.5;

/// Where and when planes are faulty.
void copyPlace(const FaultSettings& from, FaultSettings& to) {
  to.region = from.region;
  to.object = from.object;
  to.left = from.left;
  to.top = from.top;
  to.right = from.right;
  to.bottom = from.bottom;
  to.firstFrame = from.firstFrame;
  to.lastFrame = from.lastFrame;
}

bool isSamePlace(const FaultSettings& a, const FaultSettings& b) {
  FaultSettings moved = a;
  copyPlace(b, moved);
  return moved == a;
}

bool changesPlane(const FaultSettings& faults) {
  return changesMotion(faults) || changesDepth(faults) || changesColor(faults);
}

/// Takes back what is injected of a part. False: nothing was.
bool takeBack(FaultPart part, const Settings& healthy, Settings& settings) {
  const Settings before = settings;
  for (const FaultInfo& info : faultTable()) {
    if (info.part != part) continue;
    const bool isAdded = isInjected(info.fault, before) && !isInjected(info.fault, healthy);
    // Of the group any strength is one; a technique's choice may be meant.
    if (isAdded || isOfFaults(std::string(info.assignments))) withdraw(info.fault, healthy, settings);
  }
  if (isFaulty(settings))
    copyPlace(before.fault, settings.fault);
  else
    copyPlace(healthy.fault, settings.fault);
  return !differences(settings, before).empty();
}

/// Whether a row of `settings` only says where or when.
bool saysPlace(const Parameter& row, const Settings& settings) {
  Settings one;
  row.set(one, row.get(settings));
  copyPlace(FaultSettings{}, one.fault);
  return one == Settings{};
}

/// Adds what makes a finding right. False, and nothing is added: it says nothing, or excludes what is set.
bool addCorrection(const std::vector<std::string>& correction, Settings& settings) {
  if (correction.empty()) return false;
  Settings alone;
  for (const std::string& assignment : correction) applyAssignment(alone, assignment);
  Settings both = settings;
  for (const std::string& assignment : correction) {
    const Parameter& row = parameter(assignment.substr(0, assignment.find('=')));
    if (saysPlace(row, alone)) continue;
    if (row.get(settings) != row.defaultValue() && row.get(settings) != row.get(alone)) return false;
    row.set(both, row.get(alone));
  }
  const bool isOfPlanes = changesPlane(alone.fault);
  if (isOfPlanes && changesPlane(settings.fault) && !isSamePlace(settings.fault, alone.fault)) return false;
  if (isOfPlanes) copyPlace(alone.fault, both.fault);
  settings = both;
  return true;
}

} // namespace

std::optional<std::vector<std::string>> placeSettings(const Finding& finding) {
  double share = 0.0;
  for (const RegionPlace& region : finding.regions) share += region.share;
  if (finding.isWholePicture || finding.regions.empty() || share >= kMostOfPicture)
    return std::vector<std::string>();
  const RegionPlace& largest = finding.regions.front();
  if (largest.isSky) return std::vector<std::string>{"fault.region=sky"};
  if (largest.objectId == 0) return {};
  return std::vector<std::string>{"fault.region=object", "fault.object=" + std::to_string(largest.objectId)};
}

void correctBy(const std::vector<std::string>& assignments, Finding& finding) {
  const auto place = placeSettings(finding);
  if (assignments.empty() || !place) return;
  finding.correction = assignments;
  finding.correction.insert(finding.correction.end(), place->begin(), place->end());
}

void correctEverywhereBy(const std::vector<std::string>& assignments, Finding& finding) {
  finding.correction = assignments;
}

Corrected corrected(const std::vector<Finding>& findings, const Settings& settings, const Settings& healthy) {
  Corrected out{settings, {}};
  std::map<FaultPart, bool> takenBack; ///< of parts that were come to: whether something of them was injected
  for (std::size_t i = 0; i < findings.size(); ++i) {
    const auto part = partOf(findings[i]);
    if (!part) continue;
    if (!takenBack.contains(*part)) takenBack[*part] = takeBack(*part, healthy, out.settings);
    if (takenBack[*part] || addCorrection(findings[i].correction, out.settings)) out.findings.push_back(i);
  }
  return out;
}

} // namespace taa::doctor
