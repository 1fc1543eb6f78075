// Where the watched rows go: which texture holds which, what one run of a shader writes, and its GLSL.
#pragma once

#include "core/taa/Intermediates.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace taa {

/// One layer of an exposure's texture array of `channels` (1, 2 or 4): rows side by side, each from a channel
/// on.
struct ExposedSlot {
  int channels = 4, layer = 0;
  struct Part {
    IntermediateId id;
    int first; ///< channel
  };
  std::vector<Part> parts;
};

/// A few rows have a layer each. Many of the resolve are packed into layers of four channels, because what
/// looking costs is the bytes written and the number of runs, and a run writes eight layers at most. Rows
/// that are packed together are of neighboring stages: a run that writes those of early stages is spared the
/// later ones.
class ExposureLayout {
 public:
  ExposureLayout() = default;
  /// In any order; the layout is that of the set.
  explicit ExposureLayout(std::vector<IntermediateId> watched);

  const std::vector<IntermediateId>& watched() const { return watched_; } ///< in the order of the table
  bool holds(IntermediateId id) const;
  /// Of the rows the resolve gives; packed ones of the latest stages first.
  std::span<const ExposedSlot> ofResolve() const { return std::span(slots_).first(resolveSlots_); }
  /// Of the rows that the pass after the resolve gives.
  std::span<const ExposedSlot> ofOutput() const { return std::span(slots_).subspan(resolveSlots_); }
  int layers(int channels) const;

  /// Expects holds(id).
  const ExposedSlot& slot(IntermediateId id) const;
  int firstChannel(IntermediateId id) const;

 private:
  void giveLayers(const std::vector<IntermediateId>& rows);
  void pack(const std::vector<IntermediateId>& rows);
  std::vector<IntermediateId> watched_;
  std::vector<ExposedSlot> slots_;
  std::size_t resolveSlots_ = 0;
};

/// Color targets of a run at most: GL promises so many.
inline constexpr std::size_t kMostTargets = 8;

/// GLSL text that defines `expose_<id>(value)` for every row, nothing for those that are not in `slots`, and
/// store_exposed(), called last. Each slot is a color target behind the `taken` first ones.
std::string exposeAsTargets(std::span<const ExposedSlot> slots, std::size_t taken);
/// The same, but store_exposed() writes each slot into its layer of image 0, which has four channels. For
/// small regions: dear for each pixel, but one run.
std::string exposeAsStores(std::span<const ExposedSlot> slots);

} // namespace taa
