// The calls that draw a list of objects in its order, neighbors that differ in nothing but their blocks by
// one call. Blocks are uploaded as they are drawn, so that a buffer of bounded size does for any number of
// them.
#pragma once

#include "core/gl/RenderPass.h"
#include "shaders/shared/DrawBlock.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace taa {

class DrawCalls {
 public:
  /// Objects that one call draws, one after another in the list.
  struct Call {
    std::size_t first = 0, count = 1;
    std::size_t batch = 0;  ///< of those that are uploaded together
    std::size_t offset = 0; ///< of the first one's block in the buffer, bytes
  };
  /// The block of a place in the list.
  using BlockOf = std::function<shared::DrawBlock(std::size_t)>;

  /// Starts an empty list.
  void clear();
  /// Adds the next object of the list. `joins`: by the call of the one before, whose program is instanced.
  void add(bool joins);

  const std::vector<Call>& calls() const { return calls_; }
  /// Binds the blocks of a call as the program takes them: as instances, or as a uniform block of one.
  /// Uploads those of its batch unless they are there already.
  void bind(gl::RenderPass& pass, const Call& call, bool isInstanced, const BlockOf& blockOf);

 private:
  void upload(std::size_t batch, const BlockOf& blockOf);

  std::vector<Call> calls_;
  std::size_t bytes_ = 0;               ///< of the blocks of the last batch and what lies between them
  std::size_t mostBytes_ = 0;           ///< of any batch
  std::size_t alignment_ = 0;           ///< of offsets, bytes; 0: not asked for yet
  std::vector<std::size_t> batches_;    ///< of each the first call
  std::optional<std::size_t> uploaded_; ///< the batch in the buffer
  gl::Buffer buffer_;                   ///< starts with its blocks
};

} // namespace taa
