#include "core/measure/compare/FrameBefore.h"

#include "core/base/Say.h"
#include "core/render/FrameInputs.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>

namespace taa {

namespace {

constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();

/// Whether the value is a mark, not a number to reckon with.
bool hasNoPrevious(const Intermediate& row, const glm::vec4& value) {
  return row.visual == Visual::Vector && (value.x == kNoPreviousPosition || value.y == kNoPreviousPosition);
}
bool standsForNothing(const Intermediate& row, const glm::vec4& value) {
  return hasNoPrevious(row, value) || (row.visual == Visual::Depth && value.x == 0.0f);
}

bool isReadNearest(const Intermediate& row) {
  return row.visual == Visual::Index || row.visual == Visual::Mask;
}

// A texel that counts nothing may be NaN.
glm::vec4 mixedTexels(const glm::vec4& a, const glm::vec4& b, float share) {
  return share == 0.0f ? a : a + share * (b - a);
}

PartialValue partialTexelOf(const PartialImage& image, int x, int y) {
  const float absence = image.absence.empty() ? 0.0f : *image.absence.at(x, y);
  return {image.values.texel(x, y), static_cast<Absence>(static_cast<int>(absence))};
}

void setTexelOf(PartialImage& image, int x, int y, const PartialValue& value) {
  for (int channel = 0; channel < image.values.channels; ++channel)
    image.values.at(x, y)[channel] = value.value[channel];
  if (value.absence == Absence::None) return;
  if (image.absence.empty()) image.absence = Image(image.values.width, image.values.height, 1);
  *image.absence.at(x, y) = static_cast<float>(value.absence);
}

Image cropped(const Image& image, const glm::ivec2& firstPx, const glm::ivec2& sizePx) {
  if (image.empty()) return {};
  Image part(sizePx.x, sizePx.y, image.channels);
  for (int y = 0; y < sizePx.y; ++y)
    std::copy_n(image.at(firstPx.x, firstPx.y + y), static_cast<std::size_t>(sizePx.x) * image.channels,
                part.at(0, y));
  return part;
}

Taps tapsAt(const Image& image, const glm::vec2& position) {
  const glm::ivec2 first = firstTap(position), last{image.width - 1, image.height - 1};
  Taps taps;
  for (int tap = 0; tap < 4; ++tap) {
    const glm::ivec2 texel = glm::clamp(first + glm::ivec2(tap % 2, tap / 2), glm::ivec2(0), last);
    taps[static_cast<std::size_t>(tap)] = image.texel(texel.x, texel.y);
  }
  return taps;
}

} // namespace

std::string absenceText(Absence absence) {
  switch (absence) {
  case Absence::None:
    break;
  case Absence::FirstFrame:
    return say<"no frame before">();
  case Absence::Cut:
    return say<"the shot is cut here">();
  case Absence::NoHistory:
    return say<"no history">();
  case Absence::NoReference:
    return say<"no reference">();
  case Absence::NoPreviousPosition:
    return say<"no previous position">();
  case Absence::OffScreen:
    return say<"off screen">();
  }
  return {};
}

PartialValue absentValue(Absence absence) {
  return {glm::vec4(kNoNumber), absence};
}

PartialImage absentImage(const Intermediate& row, const glm::ivec2& sizePx, Absence absence) {
  PartialImage image{Image(sizePx.x, sizePx.y, row.channels), Image(sizePx.x, sizePx.y, 1)};
  std::ranges::fill(image.values.pixels, kNoNumber);
  std::ranges::fill(image.absence.pixels, static_cast<float>(absence));
  return image;
}

PartialImage partOf(const PartialImage& image, const glm::ivec2& firstPx, const glm::ivec2& sizePx) {
  return {cropped(image.values, firstPx, sizePx), cropped(image.absence, firstPx, sizePx)};
}

Absence absenceAt(const glm::vec2& historyPosition, const glm::vec2& dilatedMotion,
                  const glm::ivec2& picturePx) {
  const glm::vec2 size(picturePx);
  // Written so that NaN is off screen. History that is read in place is always inside.
  const bool isInside = historyPosition.x >= 0.0f && historyPosition.x <= size.x &&
                        historyPosition.y >= 0.0f && historyPosition.y <= size.y;
  if (isInside) return Absence::None;
  return dilatedMotion.x == kNoPreviousPosition ? Absence::NoPreviousPosition : Absence::OffScreen;
}

glm::ivec2 firstTap(const glm::vec2& position) {
  return glm::ivec2(glm::floor(position - 0.5f));
}

glm::vec4 valueBetween(const Intermediate& row, const Taps& taps, const glm::vec2& position) {
  const glm::vec2 share = (position - 0.5f) - glm::floor(position - 0.5f);
  const glm::bvec2 isSplit(share.x != 0.0f, share.y != 0.0f);
  const std::size_t nearest = (share.x >= 0.5f ? 1u : 0u) + (share.y >= 0.5f ? 2u : 0u);
  bool readsNearest = isReadNearest(row);
  for (std::size_t tap = 0; tap < taps.size(); ++tap) {
    const bool counts = (tap % 2 == 0 || isSplit.x) && (tap < 2 || isSplit.y);
    readsNearest = readsNearest || (counts && standsForNothing(row, taps[tap]));
  }
  if (readsNearest) return taps[nearest];
  return mixedTexels(mixedTexels(taps[0], taps[1], share.x), mixedTexels(taps[2], taps[3], share.x), share.y);
}

PartialImage rowBefore(const Intermediate& row, const Image& before, const Image& historyPosition,
                       const Image& dilatedMotion) {
  assert(before.channels == row.channels && before.width == historyPosition.width &&
         before.height == historyPosition.height && before.width == dilatedMotion.width);
  PartialImage image{Image(before.width, before.height, row.channels), {}};
  for (int y = 0; y < before.height; ++y)
    for (int x = 0; x < before.width; ++x) {
      const glm::vec2 position(historyPosition.texel(x, y));
      const Absence absence =
          absenceAt(position, glm::vec2(dilatedMotion.texel(x, y)), {before.width, before.height});
      setTexelOf(image, x, y,
                 absence == Absence::None
                     ? PartialValue{valueBetween(row, tapsAt(before, position), position)}
                     : absentValue(absence));
    }
  return image;
}

PartialValue differenceOf(const Intermediate& row, const PartialValue& now, const PartialValue& other) {
  for (const PartialValue& each : {now, other})
    if (each.absence != Absence::None) return absentValue(each.absence);
  if (hasNoPrevious(row, now.value) || hasNoPrevious(row, other.value))
    return absentValue(Absence::NoPreviousPosition);
  return {now.value - other.value};
}

PartialImage differenceOf(const Intermediate& row, const PartialImage& now, const PartialImage& other) {
  assert(now.values.channels == other.values.channels && now.values.width == other.values.width &&
         now.values.height == other.values.height);
  PartialImage image{Image(now.values.width, now.values.height, now.values.channels), {}};
  for (int y = 0; y < now.values.height; ++y)
    for (int x = 0; x < now.values.width; ++x)
      setTexelOf(image, x, y, differenceOf(row, partialTexelOf(now, x, y), partialTexelOf(other, x, y)));
  return image;
}

} // namespace taa
