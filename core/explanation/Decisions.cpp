#include "core/explanation/Decisions.h"

#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/taa/ChannelNames.h"
#include "core/taa/twin/Stages.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

namespace taa::explanation {

namespace {

using twin::Operand;

/// As within a sentence: "depth mismatch", "FLIP".
std::string withinSentence(std::string_view label) {
  std::string text(label);
  const auto isLower = [](char letter) { return std::islower(static_cast<unsigned char>(letter)) != 0; };
  if (text.size() > 1 && isLower(text[1]))
    text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  return text;
}

/// Of a row's channel or a number of the settings; empty: it has no name.
std::string nameOf(const twin::Trace& trace, const Operand& of, const Settings& settings) {
  if (of.node == 0) return {};
  for (const Intermediate& row : kResolveRows)
    for (int channel = 0; channel < row.channels; ++channel) {
      if (trace.of(row.id)[static_cast<std::size_t>(channel)].node != of.node) continue;
      const std::string name = withinSentence(row.label);
      if (row.channels == 1) return name;
      return name + " " + channelNames(row, settings.space)[static_cast<std::size_t>(channel)];
    }
  const auto read =
      std::ranges::find(trace.settings, of.node, &std::pair<std::uint32_t, const Parameter*>::first);
  return read == trace.settings.end() ? std::string() : withinSentence(read->second->label);
}

/// Nothing is that large: what is compared with it is looked at for being a number at all.
bool isBeyond(const Operand& x) {
  return x.node == 0 && !(std::fabs(x.value) < static_cast<double>(twin::kNoPreviousPosition));
}

std::string decisionText(const twin::Trace& trace, const twin::Compared& compared, const Settings& settings,
                         int digits) {
  const auto [a, b] = compared;
  const std::string nameA = nameOf(trace, a, settings), nameB = nameOf(trace, b, settings);
  if (nameA.empty() && nameB.empty()) return {};
  if (isBeyond(a) || isBeyond(b)) return {};
  const auto side = [&](const std::string& name, const Operand& x) {
    return (name.empty() ? "" : name + " ") + numberText(x.value, digits);
  };
  const std::string relation = a.value < b.value    ? " < "
                               : a.value > b.value  ? " > "
                               : a.value == b.value ? " = "
                                                    : "";
  if (relation.empty()) return say<"%1 is no number">(std::isnan(a.value) ? nameA : nameB);
  return side(nameA, a) + relation + side(nameB, b);
}

} // namespace

std::vector<std::string> decisionTexts(const twin::Trace& trace, IntermediateId id, const Settings& settings,
                                       int digits) {
  std::vector<std::string> out;
  for (const twin::Compared& compared : trace.decisions[static_cast<std::size_t>(id)]) {
    std::string text = decisionText(trace, compared, settings, digits);
    if (!text.empty() && std::ranges::find(out, text) == out.end()) out.push_back(std::move(text));
  }
  return out;
}

} // namespace taa::explanation
