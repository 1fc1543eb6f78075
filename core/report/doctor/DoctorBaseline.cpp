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
  requireObject(entry, place);
  requireKeys(entry, place, kKeys);
  return {textOf(requireField(entry, place, "id"), pathOf(place, "id")),
          textOf(requireField(entry, place, "region"), pathOf(place, "region"))};
}

nlohmann::json parsedBaseline(const std::string& text, const std::string& place) {
  try {
    return parseLimited(text);
  } catch (const Error& error) {
    throw Error(say<"%1 is no baseline of the doctor: %2">(place, error.what()));
  }
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
  static constexpr std::string_view kKeys[] = {"known"};
  const nlohmann::json file = parsedBaseline(text, place);
  requireObject(file, place);
  requireKeys(file, place, kKeys);
  const std::string listPlace = pathOf(place, "known");
  const nlohmann::json& list = requireField(file, place, "known");
  requireList(list, listPlace, kMaxKnownFindings);
  DoctorBaseline baseline;
  for (std::size_t i = 0; i < list.size(); ++i)
    baseline.push_back(knownFrom(list[i], listPlace + "[" + std::to_string(i) + "]"));
  return baseline;
}

} // namespace taa
