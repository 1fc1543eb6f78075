// Inputs of frames that were drawn lately, for those who come back to them: other lanes, frames before that
// are looked at again.
#pragma once

#include "core/render/FrameInputs.h"
#include "core/render/FrameRequest.h"

#include <cstddef>
#include <list>
#include <memory>

namespace taa {

class FrameSource;

/// Inputs that are drawn when somebody first wants them. Shared by frames on show that want the same.
struct LazyInputs {
  FrameInputs textures; ///< nothing of use before they are drawn
  bool areDrawn = false;
};
using InputsHandle = std::shared_ptr<LazyInputs>;

/// Drawn inputs are what source, request and frame say, and are not drawn over while they are kept.
class KeptInputs {
 public:
  /// Bytes of textures that may be kept, 0 unless told otherwise: none are.
  void setBudget(std::size_t bytes);
  /// Null: they are not kept.
  InputsHandle find(const std::shared_ptr<FrameSource>& source, const FrameRequest& request, int frame);
  /// Keeps what was drawn, which takes so many bytes; what was wanted least lately goes.
  void keep(const std::shared_ptr<FrameSource>& source, FrameRequest request, int frame,
            const InputsHandle& drawn, std::size_t bytes);
  /// Inputs to draw into: those that went last, unless somebody has them still.
  InputsHandle takeFree();
  void clear();

 private:
  struct Frame {
    std::weak_ptr<FrameSource> source;
    FrameRequest request;
    int number = 0;
    InputsHandle inputs;
    std::size_t bytes = 0;
  };
  void trim();

  std::list<Frame> frames_; // latest first
  InputsHandle free_;
  std::size_t budget_ = 0;
};

} // namespace taa
