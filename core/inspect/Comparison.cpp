#include "core/inspect/Comparison.h"

#include "core/base/Error.h"
#include "core/base/Say.h"

#include <array>
#include <charconv>
#include <system_error>

namespace taa {

namespace {

constexpr std::array<std::string_view, 4> kShowings = {"first", "other", "difference", "wipe"};
constexpr std::string_view kPreset = "preset:", kFrame = "frame:", kRow = "row:", kAlongMotion = "motion:-1";

} // namespace

std::string comparisonText(const Comparison& comparison) {
  switch (comparison.kind) {
  case OtherKind::Nothing:
    return "nothing";
  case OtherKind::Row:
    return std::string(intermediate(comparison.id).name);
  case OtherKind::Preset:
    return std::string(kPreset) + comparison.preset;
  case OtherKind::Frame:
    return std::string(kFrame) + std::to_string(comparison.frame);
  case OtherKind::FramesBefore:
    return std::string(kFrame) + std::to_string(-comparison.frame);
  case OtherKind::AlongMotion:
    return std::string(kAlongMotion);
  }
  return {};
}

Comparison parseComparison(const std::string& text) {
  if (text == "nothing") return {};
  if (text == kAlongMotion) return {.kind = OtherKind::AlongMotion};
  if (text.starts_with(kPreset) && text.size() > kPreset.size())
    return {.kind = OtherKind::Preset, .preset = text.substr(kPreset.size())};
  if (text.starts_with(kFrame)) {
    int number = 0;
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data() + kFrame.size(), end, number);
    constexpr int kMax = 1 << 30;
    if (error == std::errc() && rest == end && number > -kMax && number < kMax) {
      if (number < 0) return {.kind = OtherKind::FramesBefore, .frame = -number};
      return {.kind = OtherKind::Frame, .frame = number};
    }
  } else if (const auto id = findIntermediate(text.starts_with(kRow) ? text.substr(kRow.size()) : text)) {
    return {.kind = OtherKind::Row, .id = *id};
  }
  throw Error(say<"cannot compare with \"%1\": name %2">(text, say<kComparisonHelp>()));
}

std::string_view showingName(Showing showing) {
  return kShowings[static_cast<std::size_t>(showing)];
}

Showing showingNamed(std::string_view name) {
  for (std::size_t index = 0; index < kShowings.size(); ++index)
    if (kShowings[index] == name) return static_cast<Showing>(index);
  throw Error(say<"there is no way to compare \"%1\": it is wipe, first, other or difference">(name));
}

} // namespace taa
