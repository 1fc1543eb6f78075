#include "core/picture/RegionSpreadText.h"

#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/io/FrameJson.h"
#include "core/taa/ChannelNames.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

namespace taa {

namespace {

std::string spreadShareText(int count, int total) {
  return significantText(100.0 * count / std::max(1, total), 3) + " %";
}

std::string spreadNumber(double value) {
  return significantText(value, 6);
}

int pixelsOf(const std::vector<std::pair<int, int>>& categories) {
  int total = 0;
  for (const auto& [category, count] : categories) total += count;
  return total;
}

/// Characters of a line as a reader counts them, not bytes.
std::size_t printedWidth(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0) != 0x80; }));
}

std::string inAlignedColumns(const std::vector<std::vector<std::string>>& lines) {
  std::vector<std::size_t> widths(lines.front().size(), 0);
  for (const auto& line : lines)
    for (std::size_t column = 0; column < line.size(); ++column)
      widths[column] = std::max(widths[column], printedWidth(line[column]));
  std::string text;
  for (const auto& line : lines) {
    for (std::size_t column = 0; column < line.size(); ++column)
      text += (column == 0 ? "" : "  ") + std::string(widths[column] - printedWidth(line[column]), ' ') +
              line[column];
    text += '\n';
  }
  return text;
}

} // namespace

std::string regionPlaceText(const gl::Rect& region) {
  return std::to_string(region.x) + "," + std::to_string(region.y) + " " + std::to_string(region.width) +
         "x" + std::to_string(region.height);
}

std::optional<gl::Rect> parseRegion(const std::string& text) {
  constexpr long kMaxEdge = 65536;
  std::array<long, 4> numbers{};
  std::size_t count = 0;
  const auto isDigit = [](char letter) { return letter >= '0' && letter <= '9'; };
  for (std::size_t at = 0; at < text.size();) {
    if (!isDigit(text[at])) {
      if (std::string_view(" ,;xX\xC3\x97").find(text[at]) == std::string_view::npos) return {};
      ++at;
      continue;
    }
    if (count == numbers.size()) return {};
    for (; at < text.size() && isDigit(text[at]); ++at)
      numbers[count] = std::min(kMaxEdge, 10 * numbers[count] + (text[at] - '0'));
    ++count;
  }
  if (count != numbers.size() || numbers[2] < 1 || numbers[3] < 1) return {};
  return gl::Rect{static_cast<int>(numbers[0]), static_cast<int>(numbers[1]), static_cast<int>(numbers[2]),
                  static_cast<int>(numbers[3])};
}

std::vector<std::string> spreadHeader() {
  std::vector<std::string> header{"", "min"};
  for (const int percent : kPercentiles) header.push_back(std::to_string(percent) + " %");
  for (const std::string& name : {say<"max">(), say<"mean">(), say<"deviation">(), std::string("NaN"),
                                  std::string("inf"), say<"none">()})
    header.push_back(name);
  return header;
}

std::vector<std::vector<std::string>> spreadLines(const RegionSpread& spread, const Intermediate& row,
                                                  const SpaceSettings& space) {
  const std::vector<std::string> names = channelNames(row, space);
  std::vector<std::vector<std::string>> lines;
  for (std::size_t channel = 0; channel < spread.channels.size(); ++channel) {
    const ChannelSpread& of = spread.channels[channel];
    const auto exact = [&](float value) { return of.count > 0 ? shortestText(value) : std::string("—"); };
    const auto rounded = [&](double value) { return of.count > 0 ? spreadNumber(value) : std::string("—"); };
    std::vector<std::string> line{row.channels > 1 ? names[channel] : "", exact(of.min)};
    for (const float value : of.percentiles) line.push_back(exact(value));
    line.push_back(exact(of.max));
    line.push_back(rounded(of.mean));
    line.push_back(rounded(of.deviation));
    for (const int count : {of.nan, of.infinite, of.absent}) line.push_back(std::to_string(count));
    lines.push_back(std::move(line));
  }
  return lines;
}

// Two bins a character, as high as the logarithm of their counts: what is rare is what one looks for.
std::string histogramText(const RegionSpread& spread) {
  constexpr std::array<std::string_view, 9> kBars{" ", "▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
  if (spread.counts.empty()) return {};
  std::vector<int> pairs;
  for (std::size_t bin = 0; bin + 1 < spread.counts.size(); bin += 2)
    pairs.push_back(spread.counts[bin] + spread.counts[bin + 1]);
  const double most = std::log1p(*std::ranges::max_element(pairs));
  std::string bars;
  for (const int count : pairs) {
    const double share = most > 0.0 ? std::log1p(count) / most : 0.0;
    bars +=
        kBars[count == 0 ? 0 : std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(share * 8)))];
  }
  const std::string low = spreadNumber(spread.axis.valueAt(0.0)),
                    high = spreadNumber(spread.axis.valueAt(1.0));
  return spread.axis.isLogarithmic ? say<"%1 |%2| %3, in logarithms from %4">(
                                         low, bars, high, spreadNumber(static_cast<double>(spread.axis.low)))
                                   : low + " |" + bars + "| " + high;
}

std::string categoriesText(const RegionSpread& spread, const Intermediate& row) {
  std::string text;
  const int total = pixelsOf(spread.categories);
  for (const auto& [category, count] : spread.categories) {
    const std::string_view name = categoryText(row.id, category);
    text += (text.empty() ? "" : ", ") + std::to_string(category) +
            (name.empty() ? "" : " " + std::string(name)) + " " + spreadShareText(count, total) + " (" +
            std::to_string(count) + ")";
  }
  return text;
}

std::string spreadText(const RegionSpread& spread, const Intermediate& row, const SpaceSettings& space) {
  std::string text = std::string(row.name) + " " + regionPlaceText(spread.region) + "\n";
  if (!spread.categories.empty()) return text + categoriesText(spread, row) + "\n";
  std::vector<std::vector<std::string>> lines = spreadLines(spread, row, space);
  lines.insert(lines.begin(), spreadHeader());
  text += inAlignedColumns(lines);
  const std::string histogram = histogramText(spread);
  return histogram.empty() ? text : text + histogram + "\n";
}

namespace {

nlohmann::ordered_json spreadChannelJson(const ChannelSpread& of, const std::string& name) {
  nlohmann::ordered_json json;
  json["name"] = name;
  json["count"] = of.count;
  json["nan"] = of.nan;
  json["infinite"] = of.infinite;
  json["absent"] = of.absent;
  if (of.count == 0) return json;
  json["min"] = floatJson(of.min);
  json["max"] = floatJson(of.max);
  json["mean"] = of.mean;
  json["deviation"] = of.deviation;
  for (std::size_t index = 0; index < kPercentiles.size(); ++index)
    json["percentiles"][std::to_string(kPercentiles[index])] = floatJson(of.percentiles[index]);
  return json;
}

} // namespace

nlohmann::ordered_json spreadJson(const RegionSpread& spread, const Intermediate& row,
                                  const SpaceSettings& space) {
  const std::vector<std::string> names = channelNames(row, space);
  nlohmann::ordered_json json;
  for (std::size_t channel = 0; channel < spread.channels.size(); ++channel)
    json["channels"].push_back(spreadChannelJson(spread.channels[channel], names[channel]));
  if (!spread.counts.empty())
    json["histogram"] = {{"low", floatJson(spread.axis.low)},
                         {"high", floatJson(spread.axis.high)},
                         {"logarithmic", spread.axis.isLogarithmic},
                         {"counts", spread.counts}};
  for (const auto& [category, count] : spread.categories)
    json["categories"][std::to_string(category)] = count;
  return json;
}

} // namespace taa
