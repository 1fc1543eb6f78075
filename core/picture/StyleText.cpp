// Styles of views as text and back.
#include "core/picture/StyleText.h"

#include "core/base/Error.h"
#include "core/base/NumberText.h"
#include "core/base/Say.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

namespace taa {

namespace {

struct NumberKey {
  std::string_view key;
  float ViewStyle::*field;
};
constexpr NumberKey kNumberKeys[] = {
    {"low", &ViewStyle::low}, {"high", &ViewStyle::high}, {"exposure", &ViewStyle::exposure}};

struct ChannelKey {
  char letter;
  bool ViewStyle::*field;
};
constexpr ChannelKey kChannels[] = {
    {'r', &ViewStyle::red}, {'g', &ViewStyle::green}, {'b', &ViewStyle::blue}};

struct SwitchKey {
  std::string_view key;
  bool ViewStyle::*field;
};
constexpr SwitchKey kSwitches[] = {{"marks", &ViewStyle::markInvalid},
                                   {"clipped", &ViewStyle::markClipped},
                                   {"rejected", &ViewStyle::markRejected},
                                   {"outlines", &ViewStyle::outlineObjects},
                                   {"arrows", &ViewStyle::arrows}};

constexpr std::array<std::string_view, 6> kMaps{"gray",      "viridis", "inferno",
                                                "diverging", "cyclic",  "categorical"};

std::string channelsText(const ViewStyle& style) {
  std::string text;
  for (const ChannelKey& channel : kChannels)
    if (style.*channel.field) text += channel.letter;
  return text.empty() ? "none" : text;
}

[[noreturn]] void refuseStyle(std::string_view assignment, const std::string& expected) {
  throw Error(say<"cannot read the style \"%1\": %2">(assignment, expected));
}

float readNumber(std::string_view value, std::string_view assignment) {
  float read = 0.0f;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), read);
  if (error != std::errc() || end != value.data() + value.size() || !std::isfinite(read))
    refuseStyle(assignment, say<"expected a number">());
  return read;
}

void applyChannels(ViewStyle& style, std::string_view value, std::string_view assignment) {
  if (value != "none" && (value.empty() || value.find_first_not_of("rgb") != value.npos))
    refuseStyle(assignment, say<"channels are letters of rgb, or none">());
  for (const ChannelKey& channel : kChannels)
    style.*channel.field = value != "none" && value.find(channel.letter) != value.npos;
}

} // namespace

std::vector<std::string> styleDifferences(const ViewStyle& style, const ViewStyle& base) {
  std::vector<std::string> texts;
  for (const NumberKey& number : kNumberKeys)
    if (style.*number.field != base.*number.field)
      texts.push_back(std::string(number.key) + "=" + shortestText(style.*number.field));
  if (channelsText(style) != channelsText(base)) texts.push_back("channels=" + channelsText(style));
  if (style.map != base.map)
    texts.push_back("map=" + std::string(kMaps.at(static_cast<std::size_t>(style.map))));
  for (const SwitchKey& choice : kSwitches)
    if (style.*choice.field != base.*choice.field)
      texts.push_back(std::string(choice.key) + (style.*choice.field ? "=on" : "=off"));
  return texts;
}

void applyStyle(ViewStyle& style, std::string_view assignment) {
  const std::size_t equals = assignment.find('=');
  const std::string_view key = assignment.substr(0, equals);
  const std::string_view value = equals == assignment.npos ? "" : assignment.substr(equals + 1);
  for (const NumberKey& number : kNumberKeys)
    if (key == number.key) {
      style.*number.field = readNumber(value, assignment);
      return;
    }
  for (const SwitchKey& choice : kSwitches)
    if (key == choice.key) {
      if (value != "on" && value != "off") refuseStyle(assignment, say<"expected on or off">());
      style.*choice.field = value == "on";
      return;
    }
  if (key == "channels") {
    applyChannels(style, value, assignment);
    return;
  }
  if (key != "map")
    refuseStyle(assignment,
                say<"write low, high, exposure, channels, map, or marks, clipped, rejected, outlines, "
                    "arrows (on or off), = and a value">());
  const auto found = std::ranges::find(kMaps, value);
  if (found == kMaps.end())
    refuseStyle(assignment, say<"there are gray, viridis, inferno, diverging, cyclic and categorical">());
  style.map = static_cast<ColorMap>(found - kMaps.begin());
}

} // namespace taa
