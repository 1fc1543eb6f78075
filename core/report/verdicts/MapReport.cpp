#include "core/report/verdicts/MapReport.h"

#include "core/base/NumberText.h"
#include "core/inspect/Inspector.h"
#include "core/inspect/WorstOfShot.h"
#include "core/io/FrameJson.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace taa {

using nlohmann::ordered_json;

namespace {

constexpr IntermediateId kRowsOfCategories[] = {IntermediateId::verdictMap, IntermediateId::geometryVerdict,
                                                IntermediateId::rejectReason};

/// All that pixels can be worst by: amounts against the reference, the signed error by its amount.
std::vector<IntermediateId> rowsOfErrorsHere() {
  std::vector<IntermediateId> ids;
  for (const Intermediate& row : kIntermediates) {
    const bool isAmount = WorstOfShot::rowOf(row.id) == row.id && categoryText(row.id, 0).empty();
    if (isAmount && needsReference(row.id) && row.id != IntermediateId::referenceError) ids.push_back(row.id);
  }
  return ids;
}

std::vector<CategoryOfMap> categoriesOf(Inspector& inspector, IntermediateId row, WorstQuestion question) {
  const Image image = inspector.views().image(row, question.lane);
  std::vector<CategoryOfMap> categories;
  question.row = row;
  for (int number = 0; number <= static_cast<int>(intermediate(row).high); ++number) {
    const auto pixels = std::ranges::count(image.pixels, static_cast<float>(number));
    if (pixels == 0 && row == IntermediateId::rejectReason) continue;
    question.category = number;
    categories.push_back({row, number, static_cast<std::size_t>(pixels),
                          number == 0 ? std::vector<WorstPixel>() : inspector.worst().of(question)});
  }
  return categories;
}

ErrorOfMap errorOf(Inspector& inspector, IntermediateId row, WorstQuestion question) {
  const Image image = inspector.views().image(row, question.lane);
  question.row = row;
  double sum = 0.0;
  for (const float value : image.pixels) sum += std::fabs(static_cast<double>(value));
  return {row, sum / static_cast<double>(image.pixels.size()), inspector.worst().of(question)};
}

ordered_json worstJson(const std::vector<WorstPixel>& worst) {
  ordered_json json = ordered_json::array();
  for (const WorstPixel& found : worst)
    json.push_back({{"pixel", {found.pixel.x, found.pixel.y}}, {"error", floatJson(found.badness)}});
  return json;
}

double percentOf(std::size_t pixels, std::size_t all) {
  return 100.0 * static_cast<double>(pixels) / static_cast<double>(all);
}

ordered_json laneOfMapJson(const MapOfLane& lane) {
  ordered_json json = laneJson(lane.lane);
  for (const CategoryOfMap& found : lane.categories) {
    ordered_json category{{"number", found.category},
                          {"category", categoryText(found.row, found.category)},
                          {"pixels", found.pixels},
                          {"percent", percentOf(found.pixels, lane.pixels)}};
    if (found.category != 0) category["worst"] = worstJson(found.worst);
    json[std::string(intermediate(found.row).name)].push_back(std::move(category));
  }
  for (const ErrorOfMap& error : lane.errors)
    json["errors"][std::string(intermediate(error.row).name)] = {{"mean", error.mean},
                                                                 {"worst", worstJson(error.worst)}};
  return json;
}

std::string worstText(const std::vector<WorstPixel>& worst) {
  std::string text;
  for (const WorstPixel& found : worst)
    text += (text.empty() ? "; worst " : ", ") + std::to_string(found.pixel.x) + " " +
            std::to_string(found.pixel.y) + " (" + shortestText(found.badness) + ")";
  return text;
}

} // namespace

MapOfLane mapOfLane(Inspector& inspector, const LaneFacts& lane, int index, int samples, int worst,
                    const Progress& progress) {
  std::vector<IntermediateId> made = rowsOfErrorsHere();
  made.push_back(IntermediateId::verdictMap);
  inspector.reference().makeRows(made, samples, progress, index);
  const WorstQuestion question{.count = worst, .lane = index};
  MapOfLane map{lane, {}, {}, {}};
  map.pixels = static_cast<std::size_t>(inspector.shot().width()) *
               static_cast<std::size_t>(inspector.shot().height());
  for (const IntermediateId row : kRowsOfCategories)
    for (CategoryOfMap& found : categoriesOf(inspector, row, question))
      map.categories.push_back(std::move(found));
  for (const IntermediateId row : rowsOfErrorsHere()) map.errors.push_back(errorOf(inspector, row, question));
  return map;
}

ordered_json mapJson(const MapReport& report) {
  ordered_json json = shotJson(report.shot);
  json["frame"] = report.frame;
  json["referenceSamples"] = report.samples;
  for (const MapOfLane& lane : report.lanes) json["lanes"].push_back(laneOfMapJson(lane));
  return json;
}

std::string mapText(const MapOfLane& lane) {
  std::string text;
  const Intermediate* row = nullptr;
  for (const CategoryOfMap& found : lane.categories) {
    if (row != &intermediate(found.row)) {
      row = &intermediate(found.row);
      text += std::string(row->label) + "\n";
    }
    text += "  " + std::string(categoryText(found.row, found.category)) + ": " +
            std::to_string(found.pixels) + " pixels, " +
            shortestText(static_cast<float>(percentOf(found.pixels, lane.pixels))) + " %" +
            worstText(found.worst) + "\n";
  }
  text += "Error\n";
  for (const ErrorOfMap& error : lane.errors)
    text += "  " + std::string(intermediate(error.row).label) + ": mean " +
            shortestText(static_cast<float>(error.mean)) + worstText(error.worst) + "\n";
  return text;
}

} // namespace taa
