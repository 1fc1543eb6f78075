#include "core/cli/Options.h"

#include "core/base/NumberText.h"
#include "core/capture/format/Conventions.h"
#include "core/measure/Metrics.h"
#include "core/scene/ShotChoice.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <ostream>
#include <system_error>

namespace taa::cli {

namespace {

constexpr int kMinAskedSide = 4, kMaxAskedSide = 32768; // of every picture; the driver may draw none so large

std::optional<int> parseCount(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < 0) return std::nullopt;
  return value;
}

} // namespace

std::optional<glm::ivec2> parsePair(const std::string& text, std::string_view separator) {
  const std::size_t at = text.find(separator);
  if (at == std::string::npos) return std::nullopt;
  const std::optional<int> first = parseCount(std::string_view(text).substr(0, at));
  const std::optional<int> second = parseCount(std::string_view(text).substr(at + separator.size()));
  if (!first || !second) return std::nullopt;
  return glm::ivec2(*first, *second);
}

FrameRange parseFrames(const std::string& text) {
  const std::optional<int> one = parseCount(text);
  const std::optional<glm::ivec2> pair = one ? glm::ivec2(*one) : parsePair(text, "..");
  if (!pair) throw UsageError("--frames " + text + ": expected A..B, for example 0..31, or one frame");
  if (pair->y < pair->x) throw UsageError("--frames " + text + ": the last frame is before the first");
  return {pair->x, pair->y};
}

glm::ivec2 parseSize(const std::string& text) {
  const std::optional<glm::ivec2> size = parsePair(text, "x");
  if (!size || size->x < kMinAskedSide || size->y < kMinAskedSide || size->x > kMaxAskedSide ||
      size->y > kMaxAskedSide)
    throw UsageError("--size " + text + ": expected WIDTHxHEIGHT in pixels, each from " +
                     std::to_string(kMinAskedSide) + " to " + std::to_string(kMaxAskedSide) +
                     ", for example 1280x720");
  return *size;
}

glm::ivec2 parsePixel(const std::string& text) {
  const std::optional<glm::ivec2> pixel = parsePair(text, ",");
  if (!pixel)
    throw UsageError("--pixel " + text + ": expected X,Y, for example 412,207; 0,0 is the top left");
  return *pixel;
}

std::vector<IntermediateId> parseEmit(const std::vector<std::string>& names) {
  std::vector<IntermediateId> ids;
  const auto add = [&](IntermediateId id) {
    if (std::ranges::find(ids, id) == ids.end()) ids.push_back(id);
  };
  for (const std::string& name : names)
    if (name == "all")
      std::ranges::for_each(allRows(), add);
    else
      add(readOption("--emit", [&] { return intermediateNamed(name); }));
  return ids;
}

void checkReferenceSamples(int samples) {
  if (samples < kMinReferenceSamples || samples > kMaxReferenceSamples)
    throw UsageError("--reference-samples " + std::to_string(samples) + ": expected " +
                     std::to_string(kMinReferenceSamples) + " to " + std::to_string(kMaxReferenceSamples));
}

CLI::Option* addJson(CLI::App& command, bool& json) {
  return command.add_flag("--json", json, "Print JSON");
}

void addForce(CLI::App& command, bool& force) {
  command.add_flag("--force", force,
                   "Replace files that are there; without it they are left and nothing is done");
}

void addFrame(CLI::App& command, int& frame) {
  command.add_option("--frame", frame, "Number of the frame, from 0; else the session's")
      ->check(CLI::Range(0, kMaxShotFrames - 1));
}

CLI::Option* addPixel(CLI::App& command, std::string& pixel) {
  return command.add_option("--pixel", pixel, "X,Y; 0,0 is the top left");
}

void addReferenceSamples(CLI::App& command, int& samples, const std::string& what) {
  command.add_option("--reference-samples", samples, "Samples in a pixel " + what)->capture_default_str();
}

CLI::Validator numberFrom(double min, double max) {
  return {[min, max](std::string& text) -> std::string {
            double value = 0.0;
            const char* const end = text.data() + text.size();
            const auto [rest, error] = std::from_chars(text.data(), end, value);
            if (error == std::errc() && rest == end && value >= min && value <= max) return {};
            return "\"" + text + "\" is not a number from " + shortestText(min) + " to " + shortestText(max);
          },
          "FLOAT"};
}

void refuseEmptyValues(CLI::App& app) {
  const auto emptiness = [](const std::string& text) {
    return text.empty() ? std::string("its value is empty") : std::string();
  };
  for (CLI::Option* option : app.get_options())
    if (option->get_items_expected_max() > 0) option->check(emptiness);
  for (CLI::App* command : app.get_subcommands({})) refuseEmptyValues(*command);
}

void print(std::ostream& out, const nlohmann::ordered_json& json) {
  out << json.dump(2) << '\n';
}

std::string enumeration(const std::vector<std::string>& names, std::string_view last) {
  std::string text;
  for (const std::string& name : names) {
    if (!text.empty()) text += &name == &names.back() ? last : ", ";
    text += name;
  }
  return text;
}

std::string startingPointIds() {
  std::vector<std::string> ids;
  for (const capture::StartingPoint& point : capture::startingPoints()) ids.emplace_back(point.id);
  return enumeration(ids, " or ");
}

} // namespace taa::cli
