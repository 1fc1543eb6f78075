#include "core/report/VerificationReport.h"

#include "core/base/NumberText.h"
#include "core/base/Say.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace taa {

namespace {

using nlohmann::ordered_json;

/// "99.98": never 100 of what is not all.
std::string percentText(std::size_t part, std::size_t whole) {
  if (whole == 0 || part == whole) return "100";
  const double percent = 100.0 * static_cast<double>(part) / static_cast<double>(whole);
  return fixedText(std::min(percent, 99.99), 2);
}

std::vector<RowVerification> sorted(const Verification& verification) {
  std::vector<RowVerification> rows = verification.rows;
  const auto rank = [](const RowVerification& row) { return std::tuple(row.outside == 0, -row.widestUlp); };
  std::ranges::stable_sort(rows, [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  return rows;
}

std::string rangeText(const twin::Interval& range) {
  return say<"%1 … %2">(shortestText(range.low), shortestText(range.high));
}

/// Expects an example.
std::string outsideSentence(const RowVerification& row) {
  const OutsideValue& value = row.example.value();
  return say<"%1, channel %2, pixel %3, %4: %5, allowed %6">(
      intermediate(row.id).name, value.channel, value.pixel.x, value.pixel.y, shortestText(value.found),
      rangeText(value.allowed));
}

/// Infinite numbers have no JSON.
ordered_json finite(float x) {
  return std::isfinite(x) ? ordered_json(x) : ordered_json();
}

} // namespace

std::string verificationSentence(const Verification& verification, const std::string& driver) {
  const RowVerification all = verification.all();
  std::string equal = say<"%1 % have the bits of the CPU twin">(percentText(all.equal, all.values));
  if (all.open > 0) equal += say<"; %1 are open">(all.open);
  if (all.outside + all.open == 0)
    return say<"All %1 values of %2 rows lie within what GLSL allows on %3; %4">(
        all.values, verification.rows.size(), driver, equal);
  const auto rows = std::ranges::count_if(verification.rows, [](const auto& row) { return row.outside > 0; });
  return say<"%1 of %2 values lie outside of what GLSL allows, in %3 of %4 rows, on %5; %6">(
      all.outside, all.values, rows, verification.rows.size(), driver, equal);
}

std::vector<std::vector<std::string>> verificationTable(const Verification& verification) {
  std::vector<std::vector<std::string>> table{{"ROW", "STAGE", "VALUES", "OUTSIDE", "OPEN", "UNBOUNDED",
                                               "BIT-EQUAL %", "WIDTH ULP, MEDIAN", "WIDEST"}};
  for (const RowVerification& row : sorted(verification)) {
    const Intermediate& of = intermediate(row.id);
    table.push_back({std::string(of.name), std::string(stageInfo(of.stage).id), std::to_string(row.values),
                     std::to_string(row.outside), std::to_string(row.open), std::to_string(row.anything),
                     percentText(row.equal, row.values), numberText(row.medianUlp),
                     numberText(row.widestUlp)});
  }
  return table;
}

std::vector<std::string> outsideSentences(const Verification& verification) {
  std::vector<std::string> lines;
  for (const RowVerification& row : sorted(verification))
    if (row.example) lines.push_back(outsideSentence(row));
  return lines;
}

ordered_json verificationJson(const Verification& verification) {
  ordered_json json;
  const RowVerification all = verification.all();
  json["values"] = all.values;
  json["outside"] = all.outside;
  json["open"] = all.open;
  json["unbounded"] = all.anything;
  json["bitEqual"] = all.equal;
  json["rows"] = ordered_json::array();
  for (const RowVerification& row : verification.rows) {
    ordered_json& each = json["rows"].emplace_back();
    each = {{"row", intermediate(row.id).name},
            {"values", row.values},
            {"outside", row.outside},
            {"open", row.open},
            {"unbounded", row.anything},
            {"bitEqual", row.equal},
            {"medianUlp", row.medianUlp},
            {"widestUlp", row.widestUlp},
            {"widestAt", {row.widestAt.x, row.widestAt.y}}};
    if (!row.example) continue;
    const OutsideValue& value = *row.example;
    each["example"] = {{"pixel", {value.pixel.x, value.pixel.y}},
                       {"channel", value.channel},
                       {"found", finite(value.found)},
                       {"allowed", {finite(value.allowed.low), finite(value.allowed.high)}}};
  }
  return json;
}

} // namespace taa
