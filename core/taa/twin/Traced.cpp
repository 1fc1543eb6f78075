#include "core/taa/twin/Traced.h"

#include "core/settings/NumberFields.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace taa::twin {

namespace {

thread_local Tracing* presentTracing = nullptr;

} // namespace

Tracing::Tracing() : before_(std::exchange(presentTracing, this)) {}

Tracing::~Tracing() {
  presentTracing = before_;
}

std::uint32_t Tracing::add(Operation operation, const std::array<Operand, 3>& from, double value) {
  if (!presentTracing) return 0;
  std::vector<TraceNode>& nodes = presentTracing->nodes_;
  nodes.push_back({operation, from, value});
  return static_cast<std::uint32_t>(nodes.size());
}

void Tracing::compare(const Operand& a, const Operand& b) {
  if (!presentTracing || (a.node == 0 && b.node == 0)) return;
  std::vector<Compared>& all = presentTracing->compared_;
  const Compared compared{a, b};
  if (std::ranges::find(all, compared) == all.end()) all.push_back(compared);
}

void Tracing::decide(IntermediateId id, bool isAll) {
  if (!presentTracing) return;
  std::vector<Compared>& all = presentTracing->compared_;
  presentTracing->decisions_[static_cast<std::size_t>(id)] = all;
  if (isAll) all.clear();
}

void Tracing::forget() {
  if (presentTracing) presentTracing->compared_.clear();
}

void Tracing::read(std::uint32_t node, const float* field) {
  if (presentTracing) presentTracing->settings_.push_back({node, field});
}

Traced minimum(Traced a, Traced b) {
  return Traced::made(Operation::Min, minimum(a.value, b.value), a, b);
}

Traced maximum(Traced a, Traced b) {
  return Traced::made(Operation::Max, maximum(a.value, b.value), a, b);
}

Traced bounded(Traced value, Traced low, Traced high) {
  return Traced::made(Operation::Clamp, bounded(value.value, low.value, high.value), value, low, high);
}

Traced saturated(Traced x) {
  return Traced::made(Operation::Clamp, saturated(x.value), x, 0.0f, 1.0f);
}

Traced smooth(Traced x) {
  return Traced::made(Operation::Smooth, smooth(x.value), x);
}

Traced named(Traced x) {
  return Traced::made(Operation::Named, x.value, x);
}

Traced powerOf256ths(Traced x, int steps) {
  return Traced::made(Operation::Power, powerOf256ths(x.value, steps), x, static_cast<float>(steps) / 256.0f);
}

Traced log2Of(Traced x) {
  return Traced::made(Operation::Log2, log2Of(x.value), x);
}

Traced log2OfRatio(Traced t) {
  return Traced::made(Operation::Log2OfRatio, log2OfRatio(t.value), t);
}

Traced log2OfOnePlus(Traced x) {
  return Traced::made(Operation::Log2OfOnePlus, log2OfOnePlus(x.value), x);
}

Traced exp2Of(Traced x) {
  return Traced::made(Operation::Exp2, exp2Of(x.value), x);
}

Traced exp2LessOne(Traced x) {
  return Traced::made(Operation::Exp2LessOne, exp2LessOne(x.value), x);
}

Traced power(Traced x, Traced e) {
  return Traced::made(Operation::Power, power(x.value, e.value), x, e);
}

Trace traceOf(const Inputs& inputs, const Settings& settings, const glm::ivec2& pixel) {
  Tracing tracing;
  const auto [record, rectifiedBox] = resolvePixelIn<Traced>(inputs, settings, pixel);
  Trace out;
  out.nodes = tracing.take();
  out.decisions = tracing.decisions();
  for (const auto& [node, field] : tracing.settings())
    if (const Parameter* number = numberAt(field, settings)) out.settings.emplace_back(node, number);
  for (std::size_t row = 0; row < record.size(); ++row)
    for (int channel = 0; channel < 4; ++channel)
      out.rows[row][static_cast<std::size_t>(channel)] = record[row][channel].operand();
  for (int i = 0; i < 3; ++i) out.rectifiedBox[static_cast<std::size_t>(i)] = rectifiedBox[i].operand();
  return out;
}

} // namespace taa::twin
