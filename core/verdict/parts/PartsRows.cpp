#include "core/verdict/parts/PartsRows.h"

#include "core/taa/twin/Color.h"
#include "core/verdict/parts/VerdictMaps.h"

#include <array>
#include <cstddef>
#include <utility>

namespace taa {

namespace {

using Id = IntermediateId;

/// In the order of ErrorPart.
constexpr std::array<Id, kErrorParts> kPartIds = {Id::errorGhost,    Id::errorLag,   Id::errorBlur,
                                                  Id::errorAliasing, Id::errorOlder, Id::errorRectification};

bool hasOwnAlphas(const Settings& settings) {
  return settings.weight.source == AlphaSource::ContrastPerChannel;
}

bool mixesByLuma(const Settings& settings) {
  return settings.blend.tone == ToneWeight::Luma || settings.blend.tone == ToneWeight::LumaAsPrinted;
}

// The share of the current color in each channel, as the blend makes it of its α (manual 15.1).
Image sharesOfChannels(const RowImages& resolve, const Settings& settings) {
  Image shares = resolve.at(Id::alphaChannels);
  if (!mixesByLuma(settings)) return shares;
  for (std::size_t at = 0; at < shares.pixels.size(); ++at) {
    float& alpha = shares.pixels[at];
    const float current = alpha * resolve.at(Id::toneWeightCurrent).pixels[at / 3];
    const float history = (1.0f - alpha) * resolve.at(Id::toneWeightHistory).pixels[at / 3];
    if (alpha < 1.0f) alpha = current / (current + history);
  }
  return shares;
}

Image lumaRow(const Image& color) {
  Image luma(color.width, color.height, 1);
  for (std::size_t pixel = 0; pixel < luma.pixels.size(); ++pixel) {
    const float* value = color.pixels.data() + 3 * pixel;
    luma.pixels[pixel] = twin::luma({value[0], value[1], value[2]});
  }
  return luma;
}

} // namespace

IntermediateId rowOfPart(ErrorPart part) {
  return kPartIds[static_cast<std::size_t>(part)];
}

std::vector<IntermediateId> rowsOfErrors(const Settings& settings) {
  std::vector<Id> ids{Id::historyPosition, Id::depthEdge, Id::currentFiltered, Id::resolved};
  if (!hasOwnAlphas(settings))
    ids.push_back(Id::blendFactor);
  else
    ids.insert(ids.end(), {Id::alphaChannels, Id::toneWeightCurrent, Id::toneWeightHistory});
  return ids;
}

std::vector<IntermediateId> rowsOfVerdicts() {
  return {Id::historyPosition, Id::historyRaw, Id::historyRectified, Id::rejectReason};
}

PartsInputs partsInputs(const RowImages& resolve, const Settings& settings) {
  return {.resolved = resolve.at(Id::resolved),
          .reference = {},
          .current = resolve.at(Id::currentFiltered),
          .alpha = hasOwnAlphas(settings) ? sharesOfChannels(resolve, settings) : resolve.at(Id::blendFactor),
          .historyPosition = resolve.at(Id::historyPosition),
          .depthEdge = resolve.at(Id::depthEdge),
          .steps = {}};
}

RowImages partsRows(const ErrorParts& parts, const RowImages& resolve, const Image& reference,
                    const Image& steps) {
  RowImages rows;
  for (std::size_t part = 0; part < kErrorParts; ++part)
    rows.emplace(kPartIds[part], lumaRow(parts.images[part]));
  const Image& reasons = resolve.at(Id::rejectReason);
  rows.emplace(Id::verdictMap, verdictMap({resolve.at(Id::historyRaw), resolve.at(Id::historyRectified),
                                           reference, reasons}));
  rows.emplace(Id::geometryVerdict, geometryVerdict(reasons, resolve.at(Id::historyPosition), steps));
  return rows;
}

} // namespace taa
