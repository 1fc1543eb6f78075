#include "core/sweep/SweepTable.h"

#include "core/base/Files.h"
#include "core/settings/Parameters.h"
#include "core/sweep/MetricsOfFrames.h"
#include "core/sweep/ParetoFront.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <string_view>
#include <utility>

namespace taa {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

namespace {

constexpr int kTableFormat = 1;

/// The opposite of metricJson().
std::optional<double> metricFromJson(const ordered_json& value) {
  if (value.is_number()) return value.get<double>();
  if (value == "inf") return std::numeric_limits<double>::infinity();
  if (value == "-inf") return -std::numeric_limits<double>::infinity();
  if (value == "nan") return std::numeric_limits<double>::quiet_NaN();
  return {};
}

std::string csvField(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  return quoted + "\"";
}

std::string valueOfRange(const SweepSpec& spec, const SweepPoint& point, std::size_t range) {
  const SweepRange& each = spec.ranges[range];
  return valueText(*each.row, each.values[point.values[range]]);
}

TradeOff tradeOffOf(const SweepSpec& spec, const SweepRow& row) {
  if (!row.isMeasured) return {};
  std::array<double, 2> both{};
  for (std::size_t side = 0; side < both.size(); ++side) {
    const auto column = std::ranges::find(spec.metrics, spec.tradeOff[side]) - spec.metrics.begin();
    const std::optional<double>& mean = row.means[static_cast<std::size_t>(column)];
    if (!mean) return {};
    both[side] = metricInfo(spec.tradeOff[side]).isHigherBetter ? -*mean : *mean;
  }
  return both;
}

ordered_json sweepRowJson(const SweepSpec& spec, const SweepRow& row) {
  ordered_json json;
  json["point"] = row.point.index;
  json["source"] = spec.sources[row.point.source].name;
  json["camera"] = spec.cameras[row.point.camera];
  json["settings"] = spec.settings[row.point.settings].name;
  json["parameters"] = ordered_json::object();
  for (std::size_t range = 0; range < spec.ranges.size(); ++range)
    json["parameters"][std::string(spec.ranges[range].row->path)] = valueOfRange(spec, row.point, range);
  json["file"] = row.file;
  json["mean"] = nullptr;
  if (!row.isMeasured) return json;
  json["mean"] = ordered_json::object();
  for (std::size_t column = 0; column < spec.metrics.size(); ++column)
    json["mean"][std::string(metricInfo(spec.metrics[column]).id)] = metricJson(row.means[column]);
  json["pareto"] = row.isOnFront;
  return json;
}

std::size_t measuredCount(const std::vector<SweepRow>& rows) {
  return static_cast<std::size_t>(std::ranges::count_if(rows, &SweepRow::isMeasured));
}

} // namespace

std::vector<SweepRow> sweepRows(const SweepSpec& spec, const SweepFolder& folder) {
  const SweepGround ground(spec);
  std::vector<SweepRow> rows;
  for (std::size_t index = 0; index < spec.pointCount(); ++index) {
    SweepRow row{sweepPoint(spec, index), {}, false, {}, false};
    const PointKey key(ground.inputs(spec, row.point));
    row.file = folder.pointFile(key).filename().string();
    if (const std::optional<ordered_json> kept = folder.result(key)) {
      row.isMeasured = true;
      const ordered_json mean = kept->value("mean", ordered_json::object());
      for (const Metric metric : spec.metrics)
        row.means.push_back(metricFromJson(mean.value(std::string(metricInfo(metric).id), ordered_json())));
    }
    rows.push_back(std::move(row));
  }
  markFronts(spec, rows);
  return rows;
}

void markFronts(const SweepSpec& spec, std::vector<SweepRow>& rows) {
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> shots;
  for (std::size_t index = 0; index < rows.size(); ++index)
    shots[{rows[index].point.source, rows[index].point.camera}].push_back(index);
  for (const auto& [shot, ofShot] : shots) {
    std::vector<TradeOff> tradeOffs;
    for (const std::size_t index : ofShot) tradeOffs.push_back(tradeOffOf(spec, rows[index]));
    const std::vector<bool> isOnFront = onParetoFront(tradeOffs);
    for (std::size_t place = 0; place < ofShot.size(); ++place)
      rows[ofShot[place]].isOnFront = isOnFront[place];
  }
}

std::string sweepCsv(const SweepSpec& spec, const std::vector<SweepRow>& rows) {
  std::string text = "point,source,camera,settings";
  for (const SweepRange& range : spec.ranges) text += "," + std::string(range.row->path);
  for (const Metric metric : spec.metrics) text += "," + std::string(metricInfo(metric).id);
  text += ",pareto\n";
  for (const SweepRow& row : rows) {
    text += std::to_string(row.point.index) + "," + csvField(spec.sources[row.point.source].name) + "," +
            csvField(spec.cameras[row.point.camera]) + "," + csvField(spec.settings[row.point.settings].name);
    for (std::size_t range = 0; range < spec.ranges.size(); ++range)
      text += "," + valueOfRange(spec, row.point, range);
    for (std::size_t column = 0; column < spec.metrics.size(); ++column)
      text += "," + (row.isMeasured ? exactMetricText(row.means[column]) : "");
    text += row.isMeasured ? (row.isOnFront ? ",1\n" : ",0\n") : ",\n";
  }
  return text;
}

ordered_json sweepJson(const SweepSpec& spec, const std::vector<SweepRow>& rows) {
  ordered_json json;
  json["format"] = kTableFormat;
  json["frames"] = {spec.first, spec.last};
  json["referenceSamples"] = spec.referenceSamples;
  json["flickerFrames"] = spec.flickerFrames;
  json["metrics"] = metricsJson(spec.metrics);
  json["pareto"] = {metricInfo(spec.tradeOff[0]).id, metricInfo(spec.tradeOff[1]).id};
  json["measured"] = measuredCount(rows);
  json["points"] = ordered_json::array();
  for (const SweepRow& row : rows) json["points"].push_back(sweepRowJson(spec, row));
  return json;
}

std::vector<fs::path> writeSweepTables(const SweepSpec& spec, const SweepFolder& folder) {
  const fs::path csv = folder.path() / "sweep.csv", json = folder.path() / "sweep.json";
  std::vector<SweepRow> rows = sweepRows(spec, folder);
  for (std::size_t written = rows.size() + 1; written != measuredCount(rows);) {
    written = measuredCount(rows);
    writeFile(csv, sweepCsv(spec, rows));
    writeFile(json, sweepJson(spec, rows).dump(1) + "\n");
    rows = sweepRows(spec, folder);
  }
  return {csv, json};
}

} // namespace taa
