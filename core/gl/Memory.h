// What GL storage the objects of this thread hold, by label: every gl::Texture and gl::Buffer is in it from
// its allocation to its end. All functions speak of the calling thread only, which is the thread of its
// context; nothing is locked, and asking costs no GL call.
//
// A label is what stands before the first ": " of the object's own: "texture: bark" and "texture: leaf" are
// both "texture".
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace taa::gl {

enum class StorageKind : std::uint8_t { Texture, Buffer };

struct MemoryUse {
  std::string label;
  StorageKind kind = StorageKind::Texture;
  int objects = 0;
  std::size_t bytes = 0; ///< of all levels and layers, without what the driver adds
};

/// One row a label and kind, the largest first; without those that have no object any more.
std::vector<MemoryUse> memoryUse();
/// The sum of all rows, bytes.
std::size_t memoryInUse();
/// The largest memoryInUse() since resetMemoryPeak(), bytes.
std::size_t memoryPeak();
void resetMemoryPeak();

/// For tests: the allocation after `count` more ones throws what it throws when the driver is out of memory,
/// and so do those after it until this is called again; negative: none does.
void failAllocationsAfter(int count);

/// The share of one object in the sums above, for as long as it lives. Move-only; empty when moved from.
class Allocation {
 public:
  Allocation() = default;
  /// Throws Error where failAllocationsAfter() says so, beginning with `what`.
  Allocation(StorageKind kind, const std::string& label, std::size_t bytes, const std::string& what);
  ~Allocation();
  Allocation(Allocation&& other) noexcept = default;
  /// Ends the share that it had, at once.
  Allocation& operator=(Allocation&& other) noexcept;

 private:
  struct Ledger;
  struct Row;
  friend std::vector<MemoryUse> memoryUse();
  friend std::size_t memoryInUse();
  friend std::size_t memoryPeak();
  friend void resetMemoryPeak();
  friend void failAllocationsAfter(int count);
  static const std::shared_ptr<Ledger>& ledger();
  void end();

  std::shared_ptr<Ledger> ledger_; // also owned by the thread, which may end before a static object
  Row* row_ = nullptr;             ///< of the ledger, stable
  std::size_t bytes_ = 0;
};

} // namespace taa::gl
