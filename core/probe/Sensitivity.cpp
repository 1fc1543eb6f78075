#include "core/probe/Sensitivity.h"

#include "core/base/Light.h"
#include "core/base/NumberText.h"
#include "core/base/Parallel.h"
#include "core/base/Say.h"
#include "core/settings/NumberFields.h"
#include "core/taa/twin/Dual.h"
#include "core/taa/twin/Upsample.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <tuple>

namespace taa {

namespace {

glm::dvec3 slopeOfResolved(const twin::Inputs& inputs, const Settings& settings, const glm::ivec2& pixel) {
  const auto record = twin::resolvePixelIn<twin::Dual>(inputs, settings, pixel).record;
  const auto& resolved = twin::at(record, IntermediateId::resolved);
  return {resolved.x.slope, resolved.y.slope, resolved.z.slope};
}

/// What the resolve of a pixel is by one seed, to the side where it grows.
struct Derivative {
  glm::dvec3 slope{0.0};
  bool isOneSided = false;
};

Derivative derivativeBy(twin::Seed seed, const twin::Inputs& inputs, const Settings& settings,
                        const glm::ivec2& pixel) {
  Derivative out;
  bool hasTie = false;
  {
    const twin::Seeding seeding(seed);
    out.slope = slopeOfResolved(inputs, settings, pixel);
    out.isOneSided = seeding.hasOpenTie();
    hasTie = seeding.hasTie();
  }
  if (!hasTie || out.isOneSided) return out;
  seed.direction = -1.0;
  const twin::Seeding seeding(seed);
  out.isOneSided = slopeOfResolved(inputs, settings, pixel) != -out.slope;
  return out;
}

twin::Reads readsOf(const twin::Inputs& inputs, const Settings& settings, const glm::ivec2& pixel) {
  const twin::Seeding seeding({});
  twin::resolvePixelIn<twin::Dual>(inputs, settings, pixel);
  return seeding.reads();
}

void add(Sensitivity sensitivity, const Derivative& by, std::vector<Sensitivity>& out) {
  if (by.slope == glm::dvec3(0.0)) return;
  sensitivity.slope = by.slope;
  sensitivity.isOneSided = by.isOneSided;
  out.push_back(sensitivity);
}

/// How much of the picture moves, and how far.
void measure(SensitivityMap& map) {
  std::size_t moved = 0;
  double sum = 0.0;
  for (int y = 0; y < map.change.height; ++y)
    for (int x = 0; x < map.change.width; ++x) {
      const double luma = std::fabs(luminance(glm::dvec3(glm::vec3(map.change.texel(x, y)))));
      if (!(luma > 0.0) || !std::isfinite(luma)) continue;
      ++moved;
      sum += luma;
      if (luma <= map.largest) continue;
      map.largest = luma;
      map.largestAt = {x, y};
    }
  const auto count = static_cast<double>(map.change.width) * static_cast<double>(map.change.height);
  map.share = static_cast<double>(moved) / count;
  map.mean = sum / count;
}

std::string stepText(const glm::ivec2& step) {
  return "(" + numberText(step.x) + ", " + numberText(step.y) + ")";
}

} // namespace

std::string_view sensitivityLabel(SensitivityTo to) {
  switch (to) {
  case SensitivityTo::Sample:
    return "Samples";
  case SensitivityTo::History:
    return "History";
  case SensitivityTo::Parameter:
    return "Parameters";
  }
  return {};
}

double Sensitivity::step() const {
  if (to != SensitivityTo::Parameter) return 1.0;
  const Parameter& row = parameter(path);
  return 0.1 * (value != 0.0 ? value : row.maximum - row.minimum);
}

double Sensitivity::lumaChange() const {
  return luminance(change());
}

std::vector<Sensitivity> sensitivitiesOf(const twin::Inputs& inputs, const Settings& settings,
                                         const glm::ivec2& pixel) {
  const twin::Reads reads = readsOf(inputs, settings, pixel);
  const glm::ivec2 sample = isUpsampled(settings) ? twin::placeOf(inputs, pixel).texel : pixel;
  std::vector<Sensitivity> out;
  for (const auto& [plane, texel] : reads.texels) {
    const bool isSample = plane == &inputs.color;
    if (!isSample && plane != &inputs.historyColor) continue;
    add({.to = isSample ? SensitivityTo::Sample : SensitivityTo::History,
         .texel = texel,
         .offset = texel - (isSample ? sample : pixel)},
        derivativeBy({.plane = plane, .texel = texel}, inputs, settings, pixel), out);
  }
  for (const float* field : reads.numbers)
    if (const Parameter* row = numberAt(field, settings))
      add({.to = SensitivityTo::Parameter, .path = row->path, .value = row->get(settings)},
          derivativeBy({.setting = field}, inputs, settings, pixel), out);
  std::ranges::stable_sort(out, [](const Sensitivity& a, const Sensitivity& b) {
    return std::tuple(a.to, -std::fabs(a.lumaChange())) < std::tuple(b.to, -std::fabs(b.lumaChange()));
  });
  return out;
}

glm::dvec3 sensitivityTo(std::string_view path, const twin::Inputs& inputs, const Settings& settings,
                         const glm::ivec2& pixel) {
  return derivativeBy({.setting = fieldOf(parameter(path), settings)}, inputs, settings, pixel).slope;
}

SensitivityMap sensitivityMap(std::string_view path, const twin::Inputs& inputs, const Settings& settings,
                              const Progress& progress) {
  const Parameter& row = parameter(path);
  SensitivityMap map{{.to = SensitivityTo::Parameter, .path = row.path, .value = row.get(settings)},
                     Image(inputs.outputWidth(), inputs.outputHeight(), 3)};
  const twin::Seed seed{.setting = fieldOf(row, settings)};
  const double step = map.number.step();
  const int lines = map.change.height;
  constexpr int kAtOnce = 32; // lines between two reports
  for (int first = 0; first < lines; first += kAtOnce) {
    report(progress, say<"Following the number">(), first, lines);
    parallelFor(std::min(kAtOnce, lines - first), [&](int line) {
      const twin::Seeding seeding(seed);
      for (int x = 0; x < map.change.width; ++x) {
        const glm::vec3 change(step * slopeOfResolved(inputs, settings, {x, first + line}));
        std::copy_n(&change.x, 3, map.change.at(x, first + line));
      }
    });
  }
  measure(map);
  report(progress, say<"Following the number">(), lines, lines);
  return map;
}

std::string sensitivityMapText(const SensitivityMap& map) {
  const std::string what = sensitivityText(map.number);
  if (map.share == 0.0) return say<"%1 moves no pixel">(what);
  return say<"%1 moves luma in %2 % of the pixels, by %3 on average and at most by %4 at %5, %6">(
      what, numberText(100.0 * map.share, 3), numberText(map.mean, 3), numberText(map.largest, 3),
      map.largestAt.x, map.largestAt.y);
}

std::string sensitivityText(const Sensitivity& sensitivity) {
  switch (sensitivity.to) {
  case SensitivityTo::Sample:
    return say<"sample %1 + 1">(stepText(sensitivity.offset));
  case SensitivityTo::History:
    return say<"history %1 + 1">(stepText(sensitivity.offset));
  case SensitivityTo::Parameter:
    break;
  }
  const Parameter& row = parameter(sensitivity.path);
  return say<"%1 %2 → %3">(row.label, numberText(sensitivity.value),
                           numberText(sensitivity.value + sensitivity.step()));
}

} // namespace taa
