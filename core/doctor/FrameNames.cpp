#include "core/doctor/FrameNames.h"

#include "core/base/Say.h"

#include <algorithm>
#include <cstddef>
#include <ranges>
#include <utility>

namespace taa::doctor {

namespace {

/// Whether none that was asked is left out between the first and the last.
bool areRun(const std::vector<int>& frames, const std::vector<int>& asked) {
  const auto first = std::ranges::find(asked, frames.front());
  return std::ranges::mismatch(frames, std::ranges::subrange(first, asked.end())).in1 == frames.end();
}

/// "3, 5, 8": as many as are said.
std::string listText(const std::vector<int>& numbers) {
  constexpr std::size_t kShown = 6;
  std::string text;
  for (std::size_t i = 0; i < std::min(kShown, numbers.size()); ++i)
    text += (i == 0 ? "" : ", ") + std::to_string(numbers[i]);
  return numbers.size() > kShown ? say<"%1 and %2 more">(text, numbers.size() - kShown) : text;
}

} // namespace

FrameNames::FrameNames(std::vector<int> numbers) {
  for (std::size_t place = 0; place < numbers.size(); ++place)
    if (numbers[place] != static_cast<int>(place)) {
      numbers_ = std::move(numbers);
      return;
    }
}

std::optional<int> FrameNames::number(int frame) const {
  const auto place = static_cast<std::size_t>(frame);
  return place < numbers_.size() ? std::optional(numbers_[place]) : std::nullopt;
}

std::string FrameNames::of(int frame) const {
  const auto named = number(frame);
  return named ? say<"%1 (number %2)">(frame, *named) : std::to_string(frame);
}

std::string FrameNames::of(const std::vector<int>& frames, const std::vector<int>& asked) const {
  if (frames.size() == asked.size()) return say<"all frames">();
  if (frames.size() == 1) return say<"frame %1">(of(frames.front()));
  std::vector<int> named;
  for (const int frame : frames) named.push_back(number(frame).value_or(frame));
  if (areRun(frames, asked)) {
    const std::string text = say<"frames %1 to %2">(frames.front(), frames.back());
    return numbers_.empty() ? text : say<"%1 (numbers %2 to %3)">(text, named.front(), named.back());
  }
  if (numbers_.empty()) return say<"frames %1 (%2 of %3)">(listText(frames), frames.size(), asked.size());
  return say<"frames %1 (%2 of %3; numbers %4)">(listText(frames), frames.size(), asked.size(),
                                                 listText(named));
}

} // namespace taa::doctor
