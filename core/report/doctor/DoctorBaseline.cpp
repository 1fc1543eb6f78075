#include "core/report/doctor/DoctorBaseline.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/base/json/JsonFields.h"
#include "core/base/json/LimitedJson.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <string_view>
#include <tuple>

namespace taa {

namespace {

constexpr std::size_t kMaxKnownFindings = 100'000;

KnownFinding knownFrom(const nlohmann::json& entry, const std::string& place) {
  static constexpr std::string_view kKeys[] = {"id", "region"};
  requireKeys(entry, place, kKeys);
  return {textOf(requireField(entry, place, "id"), pathOf(place, "id")),
          textOf(requireField(entry, place, "region"), pathOf(place, "region"))};
}

DoctorBaseline baselineFrom(const nlohmann::json& file) {
  static constexpr std::string_view kKeys[] = {"known"};
  requireKeys(file, "", kKeys);
  const nlohmann::json& list = requireField(file, "", "known");
  requireList(list, "known", kMaxKnownFindings);
  DoctorBaseline baseline;
  for (const nlohmann::json& entry : list)
    baseline.push_back(knownFrom(entry, elementOf("known", baseline.size())));
  return baseline;
}

} // namespace

DoctorBaseline baselineOf(const doctor::Diagnosis& diagnosis) {
  DoctorBaseline baseline;
  for (const doctor::Finding& finding : diagnosis.findings) {
    if (finding.isWholePicture || finding.regions.empty()) baseline.push_back({finding.id, {}});
    if (finding.isWholePicture) continue;
    for (const doctor::RegionPlace& region : finding.regions) baseline.push_back({finding.id, region.name});
  }
  std::ranges::sort(baseline, {}, [](const KnownFinding& known) { return std::tie(known.id, known.region); });
  const auto repeated = std::ranges::unique(baseline);
  baseline.erase(repeated.begin(), repeated.end());
  return baseline;
}

bool isKnown(const doctor::Finding& finding, const DoctorBaseline& baseline) {
  const auto lists = [&](const std::string& region) {
    return std::ranges::find(baseline, KnownFinding{finding.id, region}) != baseline.end();
  };
  if (lists({})) return true;
  if (finding.isWholePicture || finding.regions.empty()) return false;
  return std::ranges::all_of(finding.regions, lists, &doctor::RegionPlace::name);
}

void markKnown(doctor::Diagnosis& diagnosis, const DoctorBaseline& baseline) {
  for (doctor::Finding& finding : diagnosis.findings) finding.isKnown = isKnown(finding, baseline);
}

std::string baselineToText(const DoctorBaseline& baseline) {
  nlohmann::ordered_json known = nlohmann::ordered_json::array();
  for (const KnownFinding& finding : baseline)
    known.push_back({{"id", finding.id}, {"region", finding.region}});
  return nlohmann::ordered_json{{"known", known}}.dump(2) + "\n";
}

DoctorBaseline baselineFromText(const std::string& text, const std::string& place) {
  try {
    return baselineFrom(parseLimited(text));
  } catch (const Error& error) {
    throw Error(say<"%1 is no baseline of the doctor: %2">(place, error.what()));
  }
}

} // namespace taa
