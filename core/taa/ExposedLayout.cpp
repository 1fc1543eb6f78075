// Where the watched rows go.
#include "core/taa/ExposedLayout.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <functional>
#include <iterator>
#include <utility>

namespace taa {

namespace {

// So many rows of the resolve are not packed: beside the targets of the history they take one run.
constexpr std::size_t kMaxAlone = kMaxTargets - kHistoryTargets;

// GL draws into no three.
int storedChannels(IntermediateId id) {
  const int channels = intermediate(id).channels;
  return channels == 3 ? 4 : channels;
}

int usedChannels(const ExposedSlot& slot) {
  int used = 0;
  for (const ExposedSlot::Part& part : slot.parts) used += intermediate(part.id).channels;
  return used;
}

// Slots of four channels that hold so many rows of 1, 2 and 3 channels, wide ones first.
std::size_t slotsFor(const std::array<std::size_t, 4>& counts) {
  const std::size_t holes = counts[3] + (counts[2] % 2) * 2;
  const std::size_t singles = counts[1] > holes ? counts[1] - holes : 0;
  return counts[3] + (counts[2] + 1) / 2 + (singles + 3) / 4;
}

std::string macro(IntermediateId id, const std::string& body) {
  return "#define expose_" + std::string(intermediate(id).name) + "(value)" +
         (body.empty() ? "" : " " + body) + "\n";
}

std::string targetName(std::size_t slot) {
  return "o_exposed" + std::to_string(slot);
}

// Macros of all rows: assignments to the slots' variables, or nothing.
std::string macros(std::span<const ExposedSlot> slots) {
  std::array<std::string, kResolveRowCount> bodies;
  for (std::size_t index = 0; index < slots.size(); ++index)
    for (const ExposedSlot::Part& part : slots[index].parts) {
      const auto channels = static_cast<std::size_t>(intermediate(part.id).channels);
      const std::string swizzle = std::string("xyzw").substr(static_cast<std::size_t>(part.first), channels);
      const std::string target = targetName(index) + (slots[index].channels == 1 ? "" : "." + swizzle);
      bodies[static_cast<std::size_t>(part.id)] = target + " = (value)";
    }
  std::string text;
  for (const Intermediate& row : kResolveRows)
    text += macro(row.id, bodies[static_cast<std::size_t>(row.id)]);
  return text;
}

} // namespace

ExposedLayout::ExposedLayout(std::vector<IntermediateId> watched, const RowSources& sources)
    : watched_(inTableOrder(std::move(watched))), sources_(sources) {
  std::erase_if(watched_, isOfReference);
  const std::vector<IntermediateId> written = rowsToWrite();
  const std::vector<IntermediateId> resolve = rowsOfResolve(written);
  if (resolve.size() <= kMaxAlone)
    giveLayers(resolve);
  else
    pack(resolve);
  resolveSlots_ = slots_.size();
  giveLayers(rowsOfOutput(written));
  writtenSlots_ = slots_.size();
  giveConstants();
}

std::vector<IntermediateId> ExposedLayout::rowsToWrite() const {
  std::vector<IntermediateId> rows;
  std::ranges::copy_if(watched_, std::back_inserter(rows), [this](IntermediateId id) {
    const RowSource& source = sources_.of(id);
    return !source.held && !source.constant && writtenAs(id) == id;
  });
  return rows;
}

// The row that is equal must be watched too.
IntermediateId ExposedLayout::writtenAs(IntermediateId id) const {
  const std::optional<IntermediateId>& same = sources_.of(id).same;
  return same && holds(*same) ? *same : id;
}

void ExposedLayout::giveLayers(const std::vector<IntermediateId>& rows) {
  for (const IntermediateId id : rows) {
    const int channels = storedChannels(id);
    slots_.push_back({channels, layers(channels), {{id, 0}}});
  }
}

void ExposedLayout::pack(std::vector<IntermediateId> rows) {
  std::ranges::stable_sort(rows, [](IntermediateId a, IntermediateId b) {
    const Intermediate &left = intermediate(a), &right = intermediate(b);
    return left.stage > right.stage; // the latest first
  });
  for (std::size_t taken = sources_.historyTargets; !rows.empty(); taken = 0)
    rows = packRun(rows, kMaxTargets - taken);
}

// As many of the rows as fit into so many slots, those that stand first before others; what is left over.
std::vector<IntermediateId> ExposedLayout::packRun(const std::vector<IntermediateId>& rows,
                                                   std::size_t room) {
  std::vector<IntermediateId> taken, left;
  std::array<std::size_t, 4> counts{}; // of rows, by their channels
  for (const IntermediateId id : rows) {
    std::array<std::size_t, 4> more = counts;
    ++more[static_cast<std::size_t>(intermediate(id).channels)];
    const bool fits = slotsFor(more) <= room;
    (fits ? taken : left).push_back(id);
    if (fits) counts = more;
  }
  std::ranges::stable_sort(taken, std::ranges::greater(),
                           [](IntermediateId id) { return intermediate(id).channels; });
  const auto begin = static_cast<std::ptrdiff_t>(slots_.size());
  for (const IntermediateId id : taken) {
    auto slot = std::find_if(slots_.begin() + begin, slots_.end(), [&](const ExposedSlot& candidate) {
      return usedChannels(candidate) + intermediate(id).channels <= 4;
    });
    if (slot == slots_.end()) slot = slots_.insert(slots_.end(), ExposedSlot{4, layers(4), {}});
    slot->parts.push_back({id, usedChannels(*slot)});
  }
  return left;
}

// Rows that choices make 0 or 1 share a layer each of those, where they have as many channels; a number of
// the settings has its own, so that places stay when it changes.
void ExposedLayout::giveConstants() {
  for (const IntermediateId id : watched_) {
    const std::optional<float>& value = sources_.of(id).constant;
    if (!value || held(id)) continue;
    const int channels = storedChannels(id);
    const auto shares = [&](const ExposedSlot& other) {
      return !sources_.of(id).isNumber && !sources_.of(other.parts.front().id).isNumber &&
             other.channels == channels && other.constant == value;
    };
    auto slot =
        std::find_if(slots_.begin() + static_cast<std::ptrdiff_t>(writtenSlots_), slots_.end(), shares);
    if (slot == slots_.end())
      slot = slots_.insert(slots_.end(), ExposedSlot{channels, layers(channels), {}, value});
    slot->parts.push_back({id, 0});
  }
}

bool ExposedLayout::needsInputs() const {
  return isWritten() || std::ranges::any_of(watched_, [this](IntermediateId id) {
           const HeldRow* row = held(id);
           return row && row->input;
         });
}

bool ExposedLayout::hasSamePlaces(const ExposedLayout& other) const {
  const auto isSameSlot = [](const ExposedSlot& a, const ExposedSlot& b) {
    return a.channels == b.channels && a.layer == b.layer && a.parts == b.parts &&
           a.constant.has_value() == b.constant.has_value();
  };
  return watched_ == other.watched_ && std::ranges::equal(slots_, other.slots_, isSameSlot);
}

bool ExposedLayout::holds(IntermediateId id) const {
  return std::ranges::binary_search(watched_, id);
}

int ExposedLayout::layers(int channels) const {
  return static_cast<int>(std::ranges::count(slots_, channels, &ExposedSlot::channels));
}

const HeldRow* ExposedLayout::held(IntermediateId id) const {
  const std::optional<HeldRow>& row = sources_.of(id).held;
  return row ? &*row : nullptr;
}

const ExposedSlot& ExposedLayout::slot(IntermediateId id) const {
  assert(holds(id) && !held(id));
  return *std::ranges::find_if(slots_, [id = writtenAs(id)](const ExposedSlot& slot) {
    return std::ranges::find(slot.parts, id, &ExposedSlot::Part::id) != slot.parts.end();
  });
}

int ExposedLayout::firstChannel(IntermediateId id) const {
  if (const HeldRow* row = held(id)) return row->firstChannel;
  return std::ranges::find(slot(id).parts, writtenAs(id), &ExposedSlot::Part::id)->first;
}

std::string exposeAsTargets(std::span<const ExposedSlot> slots, std::size_t taken) {
  assert(taken + slots.size() <= kMaxTargets);
  std::string text;
  for (std::size_t index = 0; index < slots.size(); ++index) {
    const int channels = slots[index].channels;
    text += "layout(location = " + std::to_string(taken + index) + ") out " +
            (channels == 1 ? "float" : "vec" + std::to_string(channels)) + " " + targetName(index) + ";\n";
  }
  return text + macros(slots) + "#define store_exposed()\n";
}

std::string exposeAsStores(std::span<const ExposedSlot> slots) {
  std::string text = "layout(rgba32f, binding = 0) uniform writeonly image2DArray u_exposed;\n", stores;
  for (std::size_t index = 0; index < slots.size(); ++index) {
    assert(slots[index].channels == 4);
    text += "vec4 " + targetName(index) + " = vec4(0.0);\n";
    stores += "imageStore(u_exposed, ivec3(ivec2(gl_FragCoord.xy), " + std::to_string(slots[index].layer) +
              "), " + targetName(index) + "); ";
  }
  return text + macros(slots) + "#define store_exposed() " + stores + "\n";
}

} // namespace taa
