// The calls that draw a list of objects in its order, neighbors that differ in nothing but their blocks by
// one call.
#pragma once

#include "core/gl/RenderPass.h"
#include "shaders/shared/DrawBlock.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace taa {

class DrawCalls {
 public:
  /// Objects that one call draws, one after another in the list.
  struct Call {
    std::size_t first = 0, count = 1;
    std::size_t offset = 0; ///< of the first one's block in the buffer, bytes
  };

  /// Starts an empty list.
  void clear();
  /// Adds the next object of the list. `joins`: by the call of the one before, whose program is instanced.
  void add(bool joins);
  /// Uploads the blocks of all objects; `blockOf`: of a place in the list.
  void fill(const std::function<shared::DrawBlock(std::size_t)>& blockOf);

  const std::vector<Call>& calls() const { return calls_; }
  /// Binds the blocks of a call as the program takes them: as instances, or as a uniform block of one.
  void bind(gl::RenderPass& pass, const Call& call, bool isInstanced) const;

 private:
  std::vector<Call> calls_;
  std::size_t bytes_ = 0;     ///< of all blocks and what lies between them
  std::size_t alignment_ = 0; ///< of offsets, bytes; 0: not asked for yet
  gl::Buffer buffer_;         ///< starts with them
};

} // namespace taa
