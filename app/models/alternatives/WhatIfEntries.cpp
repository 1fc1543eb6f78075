#include "app/models/alternatives/WhatIfEntries.h"

#include "core/base/Light.h"
#include "core/settings/Parameters.h"
#include "core/taa/twin/Known.h"

#include <algorithm>
#include <cmath>

namespace taa::app {

namespace {

/// As a screen is sent it, at exposure 0.
double shownChannel(float linear) {
  return static_cast<double>(srgbEncoded(linear > 0.0f ? std::min(linear, 1.0f) : 0.0f));
}

double shownDistance(const glm::vec3& color, const glm::vec3& reference) {
  double sum = 0.0;
  for (int channel = 0; channel < 3; ++channel) {
    const double difference = shownChannel(color[channel]) - shownChannel(reference[channel]);
    sum += difference * difference;
  }
  return std::sqrt(sum / 3.0);
}

} // namespace

std::vector<WhatIfEntry> whatIfEntries(const ProbeResult& result, bool sortsByChange) {
  std::vector<WhatIfEntry> entries;
  const PixelRecord* record = result.around.size() > kProbedMiddle ? &result.around[kProbedMiddle] : nullptr;
  const bool hasReference = record && twin::isKnown(*record, IntermediateId::reference);
  for (std::size_t row = 0; row < result.whatIf.size(); ++row) {
    const WhatIfRow& of = result.whatIf[row];
    WhatIfEntry& entry =
        entries.emplace_back(WhatIfEntry{row, {}, shownDistance(of.resolved, of.resolved - of.difference)});
    if (hasReference)
      entry.error = shownDistance(of.resolved, glm::vec3(twin::at(*record, IntermediateId::reference)));
  }
  if (!hasReference && !sortsByChange) return entries;
  std::ranges::stable_sort(entries, [hasReference](const WhatIfEntry& a, const WhatIfEntry& b) {
    return hasReference ? *a.error < *b.error : a.change > b.change;
  });
  return entries;
}

void PictureNumbers::add(const Settings& settings, const LaneMetrics& frames) {
  Means means;
  for (std::size_t place = 0; place < means.size(); ++place)
    means[place] = meanOfFrames(frames, kPictureMetrics[place]);
  known_.emplace_back(settings, means);
}

const PictureNumbers::Means* PictureNumbers::find(const Settings& settings) const {
  const auto found = std::ranges::find_if(known_, [&](const auto& each) { return each.first == settings; });
  return found == known_.end() ? nullptr : &found->second;
}

std::optional<Variant> variantOf(const Settings& settings, const WhatIfRow& row) {
  for (Variant& variant : variantsOf(settings))
    if (variant.group == row.group && variant.id == row.id) return std::move(variant);
  return {};
}

} // namespace taa::app
