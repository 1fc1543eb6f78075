// Where the watched rows go.
#include "core/taa/ExposureLayout.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace taa {

namespace {

// So many rows of the resolve are not packed: beside the targets of the history they take one run.
constexpr std::size_t kMostAlone = kMostTargets - kHistoryTargets;

// Stages whose rows are packed together: one run or little more for each group. The last group is that which
// takes the least to compute.
constexpr int groupOf(Stage stage) {
  switch (stage) {
  case Stage::Blend:
  case Stage::BlendWeight:
    return 0;
  case Stage::RectifyHistory:
  case Stage::ValidateHistory:
  case Stage::SampleHistory:
  case Stage::Reproject:
  case Stage::DilateMotion:
    return 1;
  default:
    return 2;
  }
}

int usedChannels(const ExposedSlot& slot) {
  int used = 0;
  for (const ExposedSlot::Part& part : slot.parts) used += intermediate(part.id).channels;
  return used;
}

std::string macro(IntermediateId id, const std::string& body) {
  return "#define expose_" + std::string(intermediate(id).name) + "(value)" +
         (body.empty() ? "" : " " + body) + "\n";
}

std::string nameOf(std::size_t slot) {
  return "o_exposed" + std::to_string(slot);
}

// Macros of all rows: assignments to the slots' variables, or nothing.
std::string macros(std::span<const ExposedSlot> slots) {
  std::array<std::string, kResolveRowCount> bodies;
  for (std::size_t index = 0; index < slots.size(); ++index)
    for (const ExposedSlot::Part& part : slots[index].parts) {
      const auto channels = static_cast<std::size_t>(intermediate(part.id).channels);
      const std::string swizzle = std::string("xyzw").substr(static_cast<std::size_t>(part.first), channels);
      const std::string target = nameOf(index) + (slots[index].channels == 1 ? "" : "." + swizzle);
      bodies[static_cast<std::size_t>(part.id)] = target + " = (value)";
    }
  std::string text;
  for (const Intermediate& row : kResolveRows)
    text += macro(row.id, bodies[static_cast<std::size_t>(row.id)]);
  return text;
}

} // namespace

ExposureLayout::ExposureLayout(std::vector<IntermediateId> watched)
    : watched_(inTableOrder(std::move(watched))) {
  const std::vector<IntermediateId> resolve = rowsOfResolve(watched_);
  if (resolve.size() <= kMostAlone)
    giveLayers(resolve);
  else
    pack(resolve);
  resolveSlots_ = slots_.size();
  giveLayers(rowsOfOutput(watched_));
}

void ExposureLayout::giveLayers(const std::vector<IntermediateId>& rows) {
  for (const IntermediateId id : rows) {
    const int channels =
        intermediate(id).channels == 3 ? 4 : intermediate(id).channels; // GL draws into no three
    slots_.push_back({channels, layers(channels), {{id, 0}}});
  }
}

// Within a group wide rows first, each into the first slot with room.
void ExposureLayout::pack(const std::vector<IntermediateId>& rows) {
  std::vector<IntermediateId> ordered = rows;
  std::ranges::stable_sort(ordered, [](IntermediateId a, IntermediateId b) {
    const Intermediate &left = intermediate(a), &right = intermediate(b);
    const int leftGroup = groupOf(left.stage), rightGroup = groupOf(right.stage);
    return leftGroup != rightGroup ? leftGroup < rightGroup : left.channels > right.channels;
  });
  std::size_t groupBegin = 0;
  int group = 0;
  for (const IntermediateId id : ordered) {
    const Intermediate& row = intermediate(id);
    if (groupOf(row.stage) != group) groupBegin = slots_.size();
    group = groupOf(row.stage);
    auto slot = std::find_if(slots_.begin() + static_cast<std::ptrdiff_t>(groupBegin), slots_.end(),
                             [&](const ExposedSlot& held) { return usedChannels(held) + row.channels <= 4; });
    if (slot == slots_.end()) slot = slots_.insert(slots_.end(), ExposedSlot{4, layers(4), {}});
    slot->parts.push_back({id, usedChannels(*slot)});
  }
}

bool ExposureLayout::holds(IntermediateId id) const {
  return std::ranges::binary_search(watched_, id);
}

int ExposureLayout::layers(int channels) const {
  return static_cast<int>(std::ranges::count(slots_, channels, &ExposedSlot::channels));
}

const ExposedSlot& ExposureLayout::slot(IntermediateId id) const {
  assert(holds(id));
  return *std::ranges::find_if(slots_, [id](const ExposedSlot& slot) {
    return std::ranges::find(slot.parts, id, &ExposedSlot::Part::id) != slot.parts.end();
  });
}

int ExposureLayout::firstChannel(IntermediateId id) const {
  return std::ranges::find(slot(id).parts, id, &ExposedSlot::Part::id)->first;
}

std::string exposeAsTargets(std::span<const ExposedSlot> slots, std::size_t taken) {
  assert(taken + slots.size() <= kMostTargets);
  std::string text;
  for (std::size_t index = 0; index < slots.size(); ++index) {
    const int channels = slots[index].channels;
    text += "layout(location = " + std::to_string(taken + index) + ") out " +
            (channels == 1 ? "float" : "vec" + std::to_string(channels)) + " " + nameOf(index) + ";\n";
  }
  return text + macros(slots) + "#define store_exposed()\n";
}

std::string exposeAsStores(std::span<const ExposedSlot> slots) {
  std::string text = "layout(rgba32f, binding = 0) uniform writeonly image2DArray u_exposed;\n", stores;
  for (std::size_t index = 0; index < slots.size(); ++index) {
    assert(slots[index].channels == 4);
    text += "vec4 " + nameOf(index) + " = vec4(0.0);\n";
    stores += "imageStore(u_exposed, ivec3(ivec2(gl_FragCoord.xy), " + std::to_string(slots[index].layer) +
              "), " + nameOf(index) + "); ";
  }
  return text + macros(slots) + "#define store_exposed() " + stores + "\n";
}

} // namespace taa
