#include "core/taa/ChannelNames.h"

#include "core/base/Say.h"
#include "core/base/Text.h"
#include "core/settings/Parameters.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace taa {

namespace {

std::vector<std::string> boxNames(ColorSpace color) {
  switch (color) {
  case ColorSpace::Rgb:
    return {"R", "G", "B"};
  case ColorSpace::YCbCr:
    return {"Y", "Cb", "Cr"};
  case ColorSpace::YCoCg:
  case ColorSpace::YCoCgLifting:
  case ColorSpace::YCoCgAsPrinted:
    break;
  }
  return {"Y", "Co", "Cg"};
}

} // namespace

std::vector<std::string> channelNames(const Intermediate& row, const SpaceSettings& space) {
  switch (intermediate(row.id).visual) { // not its own: a difference of rows is shown signed
  case Visual::Color:
    return {"R", "G", "B"};
  case Visual::Box:
    return boxNames(space.color);
  case Visual::Normal:
    return {"X", "Y", "Z"};
  case Visual::Vector:
  case Visual::Position:
    return {"X", "Y"};
  case Visual::Depth:
    return {"Z"};
  case Visual::Scalar:
  case Visual::Signed:
  case Visual::Mask:
  case Visual::Index:
    break;
  }
  return {"V"};
}

std::string channelNamesText(const Intermediate& row) {
  std::vector<std::string> all;
  const std::size_t spaces = parameter("space.color").choices.size();
  for (std::size_t color = 0; color < spaces; ++color) {
    std::string names = joined(channelNames(row, {static_cast<ColorSpace>(color), ToneSpace::Linear}));
    if (std::ranges::find(all, names) == all.end()) all.push_back(std::move(names));
  }
  std::string text;
  for (const std::string& names : all) text = text.empty() ? names : say<"%1 or %2">(text, names);
  return text;
}

} // namespace taa
