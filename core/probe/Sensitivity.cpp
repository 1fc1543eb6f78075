#include "core/probe/Sensitivity.h"

#include "core/base/Light.h"
#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/settings/Parameters.h"
#include "core/taa/twin/Dual.h"
#include "core/taa/twin/Upsample.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <tuple>

namespace taa {

namespace {

/// What the resolve of a pixel is by one seed.
struct Derivative {
  glm::dvec3 slope{0.0};
  bool isOneSided = false;
};

Derivative derivativeBy(const twin::Seed& seed, const twin::Inputs& inputs, const Settings& settings,
                        const glm::ivec2& pixel) {
  const twin::Seeding seeding(seed);
  const auto record = twin::resolvePixelIn<twin::Dual>(inputs, settings, pixel).record;
  const auto& resolved = twin::at(record, IntermediateId::resolved);
  return {{resolved.x.slope, resolved.y.slope, resolved.z.slope}, seeding.isCorner()};
}

twin::Reads readsOf(const twin::Inputs& inputs, const Settings& settings, const glm::ivec2& pixel) {
  const twin::Seeding seeding({});
  twin::resolvePixelIn<twin::Dual>(inputs, settings, pixel);
  return seeding.reads();
}

const float* fieldOf(const Parameter& row, const Settings& settings) {
  assert(row.kind == ParameterKind::Number);
  const auto* bytes = reinterpret_cast<const std::byte*>(&settings); // NOLINT: Field says where a field lies
  return reinterpret_cast<const float*>(bytes + row.field.offset);   // NOLINT
}

const Parameter* rowOf(const float* field, const Settings& settings) {
  const auto row = std::ranges::find_if(parameters(), [&](const Parameter& each) {
    return each.kind == ParameterKind::Number && fieldOf(each, settings) == field;
  });
  return row == parameters().end() ? nullptr : &*row;
}

void add(Sensitivity sensitivity, const Derivative& by, std::vector<Sensitivity>& out) {
  if (by.slope == glm::dvec3(0.0)) return;
  sensitivity.slope = by.slope;
  sensitivity.isOneSided = by.isOneSided;
  out.push_back(sensitivity);
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
    if (const Parameter* row = rowOf(field, settings))
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
