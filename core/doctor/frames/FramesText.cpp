#include "core/doctor/frames/FramesText.h"

#include "core/base/Say.h"

#include <algorithm>
#include <cstddef>
#include <ranges>

namespace taa::doctor {

namespace {

/// Whether none that was asked is left out between the first and the last.
bool isRun(const std::vector<int>& frames, const std::vector<int>& asked) {
  const auto first = std::ranges::find(asked, frames.front());
  return std::ranges::mismatch(frames, std::ranges::subrange(first, asked.end())).in1 == frames.end();
}

} // namespace

std::string framesText(const std::vector<int>& frames, const std::vector<int>& asked) {
  constexpr std::size_t kShown = 6;
  if (frames.size() == asked.size()) return say<"all frames">();
  if (frames.size() == 1) return say<"frame %1">(frames.front());
  if (isRun(frames, asked)) return say<"frames %1 to %2">(frames.front(), frames.back());
  std::string text;
  for (std::size_t i = 0; i < std::min(kShown, frames.size()); ++i)
    text += (i == 0 ? "" : ", ") + std::to_string(frames[i]);
  if (frames.size() > kShown)
    return say<"frames %1 and %2 more (%3 of %4)">(text, frames.size() - kShown, frames.size(), asked.size());
  return say<"frames %1 (%2 of %3)">(text, frames.size(), asked.size());
}

} // namespace taa::doctor
