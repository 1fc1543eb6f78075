// Where the watched rows go: which texture holds which, what one run of a shader writes, and its GLSL.
#pragma once

#include "core/taa/Intermediates.h"
#include "core/taa/RowSources.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace taa {

/// One layer of a texture array of exposed rows, of `channels` (1, 2 or 4): rows side by side, each from a
/// channel on.
struct ExposedSlot {
  int channels = 4, layer = 0;
  struct Part {
    IntermediateId id;
    int first; ///< channel
    bool operator==(const Part&) const = default;
  };
  std::vector<Part> parts;
  std::optional<float> constant{}; ///< of all channels: no run writes it
};

/// A few rows have a layer each. Many of the resolve are packed into layers of four channels, because what
/// looking costs is the bytes written and the number of runs, and a run writes eight layers at most. The
/// first run computes everything, for the history; so the rows of the latest stages go there, and runs after
/// it are spared those stages. What need not be written has no layer at all or is constant.
class ExposedLayout {
 public:
  ExposedLayout() = default;
  /// `watched` in any order; the layout is that of the set.
  explicit ExposedLayout(std::vector<IntermediateId> watched, const RowSources& sources = {});

  const std::vector<IntermediateId>& watched() const { return watched_; } ///< in the order of the table
  bool holds(IntermediateId id) const;
  /// Of the rows the resolve gives, in the order of its runs.
  std::span<const ExposedSlot> ofResolve() const { return std::span(slots_).first(resolveSlots_); }
  /// Of the rows that the pass after the resolve gives.
  std::span<const ExposedSlot> ofOutput() const {
    return std::span(slots_).subspan(resolveSlots_, writtenSlots_ - resolveSlots_);
  }
  /// That no run writes.
  std::span<const ExposedSlot> constants() const { return std::span(slots_).subspan(writtenSlots_); }
  int layers(int channels) const;
  /// Whether any row has to be written.
  bool isWritten() const { return writtenSlots_ > 0; }
  /// Whether any comes from the frame's inputs, written or not.
  bool needsInputs() const;
  /// Whether rows lie at the same places; the values of constants may differ.
  bool hasSamePlaces(const ExposedLayout& other) const;

  /// Where another texture holds `id`; null: a slot does.
  const HeldRow* held(IntermediateId id) const;
  /// Expects holds(id), and not held(id).
  const ExposedSlot& slot(IntermediateId id) const;
  /// Expects holds(id).
  int firstChannel(IntermediateId id) const;

 private:
  IntermediateId writtenAs(IntermediateId id) const;
  std::vector<IntermediateId> rowsToWrite() const;
  void giveLayers(const std::vector<IntermediateId>& rows);
  void pack(std::vector<IntermediateId> rows);
  std::vector<IntermediateId> packRun(const std::vector<IntermediateId>& rows, std::size_t room);
  void giveConstants();
  std::vector<IntermediateId> watched_;
  RowSources sources_;
  std::vector<ExposedSlot> slots_;
  std::size_t resolveSlots_ = 0, writtenSlots_ = 0;
};

/// Color targets of a run at most: GL promises so many.
inline constexpr std::size_t kMaxTargets = 8;

/// GLSL text that defines `expose_<id>(value)` for every row, nothing for those that are not in `slots`, and
/// store_exposed(), called last. Each slot is a color target behind the `taken` first ones.
std::string exposeAsTargets(std::span<const ExposedSlot> slots, std::size_t taken);
/// The same, but store_exposed() writes each slot into its layer of image 0, which has four channels. For
/// small regions: dear for each pixel, but one run.
std::string exposeAsStores(std::span<const ExposedSlot> slots);

} // namespace taa
