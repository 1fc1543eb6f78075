// Specialised programs of one fragment shader.
#include "core/taa/ProgramCache.h"

#include "core/settings/Parameters.h"

#include <algorithm>
#include <utility>

namespace taa {

namespace {

constexpr std::size_t kMaxPrograms = 32;
// A program that was not used in this many runs is compiled again only when it is needed again.
constexpr std::uint64_t kRunsInUse = 16;

} // namespace

std::string slotsKey(std::span<const ExposedSlot> slots) {
  std::string key;
  for (const ExposedSlot& slot : slots) {
    key += std::to_string(slot.channels) + "@" + std::to_string(slot.layer);
    for (const ExposedSlot::Part& part : slot.parts)
      key += " " + std::to_string(static_cast<int>(part.id)) + "." + std::to_string(part.first);
    key += ";";
  }
  return key;
}

ProgramCache::ProgramCache(std::string fragment, std::string label)
    : fragment_(std::move(fragment)), label_(std::move(label)) {}

gl::Program ProgramCache::compile(const std::string& prelude) const {
  return gl::Program(gl::ShaderSource("include/fullscreen.vert"), gl::ShaderSource(fragment_, prelude),
                     label_);
}

bool ProgramCache::holds(const Settings& settings, const std::string& more) const {
  return variants_.contains(programKey(settings) + more);
}

const gl::Program& ProgramCache::program(const Settings& settings, const std::string& more,
                                         const std::function<std::string()>& prelude) {
  const std::string key = programKey(settings) + more;
  const auto found = variants_.find(key);
  Variant& variant = found != variants_.end() ? found->second : [&]() -> Variant& {
    Variant made;
    made.prelude = glslPrelude(settings) + prelude();
    made.program = compile(made.prelude);
    dropOldest();
    return variants_[key] = std::move(made);
  }();
  variant.lastUse = ++runs_;
  return variant.program;
}

void ProgramCache::dropOldest() {
  if (variants_.size() < kMaxPrograms) return;
  variants_.erase(
      std::ranges::min_element(variants_, {}, [](const auto& entry) { return entry.second.lastUse; }));
}

ProgramCache ProgramCache::compiledAnew() const {
  ProgramCache fresh(fragment_, label_);
  fresh.runs_ = runs_;
  for (const auto& [key, variant] : variants_) {
    if (variant.lastUse + kRunsInUse < runs_) continue;
    fresh.variants_[key] = {variant.prelude, compile(variant.prelude), variant.lastUse};
  }
  return fresh;
}

} // namespace taa
