#include "core/taa/twin/Dual.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace taa::twin {

namespace {

thread_local Seeding* presentSeeding = nullptr;

template <typename Item>
void addOnce(std::vector<Item>& items, const Item& item) {
  if (std::ranges::find(items, item) == items.end()) items.push_back(item);
}

/// d log₂ x / dx
double slopeOfLog2(double x) {
  return 1.0 / (x * std::numbers::ln2);
}

} // namespace

void noteTie(bool isOpen) {
  if (!presentSeeding) return;
  presentSeeding->hasTie_ = true;
  if (isOpen) presentSeeding->hasOpenTie_ = true;
}

Seeding::Seeding(const Seed& seed) : seed_(seed), before_(std::exchange(presentSeeding, this)) {}

Seeding::~Seeding() {
  presentSeeding = before_;
}

Vec4<Dual> Source<Dual>::read(const Texels& plane, int x, int y) {
  Vec4<Dual> out(plane.texel(x, y));
  Seeding* seeding = presentSeeding;
  if (!seeding) return out;
  if (seeding->collects()) addOnce(seeding->reads_.texels, Reads::Texel{&plane, {x, y}});
  if (seeding->seed_.plane == &plane && seeding->seed_.texel == glm::ivec2(x, y))
    for (int channel = 0; channel < 4; ++channel) out[channel].slope = seeding->seed_.direction;
  return out;
}

Dual Source<Dual>::number(const float& field) {
  Seeding* seeding = presentSeeding;
  if (!seeding) return field;
  if (seeding->collects()) addOnce<const float*>(seeding->reads_.numbers, &field);
  return {field, seeding->seed_.setting == &field ? seeding->seed_.direction : 0.0};
}

Dual minimum(Dual a, Dual b) {
  if (a.partsFrom(b)) noteTie(false);
  const float value = minimum(a.value, b.value);
  if (a.value == b.value) return {value, std::min(a.slope, b.slope)};
  return {value, a.value < b.value ? a.slope : b.slope};
}

Dual maximum(Dual a, Dual b) {
  if (a.partsFrom(b)) noteTie(false);
  const float value = maximum(a.value, b.value);
  if (a.value == b.value) return {value, std::max(a.slope, b.slope)};
  return {value, a.value > b.value ? a.slope : b.slope};
}

Dual bounded(Dual value, Dual low, Dual high) {
  return minimum(maximum(value, low), high);
}

Dual saturated(Dual x) {
  return bounded(x, 0.0f, 1.0f);
}

Dual log2Of(Dual x) {
  return {log2Of(x.value), x.slope * slopeOfLog2(x.wide())};
}

Dual log2OfRatio(Dual t) {
  // log₂((1 + t)/(1 − t)): 2/(1 − t²) in natural logarithms
  return {log2OfRatio(t.value), t.slope * 2.0 / ((1.0 - t.wide() * t.wide()) * std::numbers::ln2)};
}

Dual log2OfOnePlus(Dual x) {
  return {log2OfOnePlus(x.value), x.slope * slopeOfLog2(1.0 + x.wide())};
}

Dual exp2Of(Dual x) {
  const float power = exp2Of(x.value);
  return {power, x.slope * static_cast<double>(power) * std::numbers::ln2};
}

Dual exp2LessOne(Dual x) {
  const float less = exp2LessOne(x.value);
  return {less, x.slope * (static_cast<double>(less) + 1.0) * std::numbers::ln2};
}

Dual power(Dual x, Dual e) {
  const float result = power(x.value, e.value);
  if (result == 0.0f) return {result, 0.0}; // of what is too small for a logarithm
  const double byBase = e.wide() * static_cast<double>(result) / x.wide();
  const double byExponent = static_cast<double>(result) * std::log(x.wide());
  return {result, x.slope * byBase + e.slope * byExponent};
}

} // namespace taa::twin
