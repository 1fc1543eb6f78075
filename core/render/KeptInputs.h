// A source of frames that keeps what it has drawn: who looks at one shot under many settings of the resolve
// asks for the same inputs again and again.
#pragma once

#include "core/render/FrameRequest.h"
#include "core/render/FrameSource.h"

#include <cstddef>
#include <list>
#include <memory>
#include <string>

namespace taa {

/// Drawn frames of any sources, those that were used last, up to a number of bytes. Its textures are those of
/// the current context, which outlives it.
class InputsStore {
 public:
  explicit InputsStore(std::size_t budgetBytes) : budgetBytes_(budgetBytes) {}

  struct Frame {
    std::string source; ///< what is open, as the text that names it
    int number = 0;
    FrameRequest request;
    FrameInputs inputs;
    DrawCounts counts;
  };

  /// Null: it is not kept. Valid until the next call.
  const Frame* find(const std::string& source, const FrameRequest& request, int frame);
  void keep(Frame&& frame);
  std::size_t bytes() const { return bytes_; }

 private:
  std::size_t budgetBytes_, bytes_ = 0;
  std::list<Frame> frames_; ///< those used last first
};

/// `source`, and what `store` keeps of it under its name. The same bits either way.
class KeptInputs final : public FrameSource {
 public:
  KeptInputs(std::shared_ptr<FrameSource> source, std::string name, std::shared_ptr<InputsStore> store);

  void draw(const FrameRequest& request, int frame, FrameInputs& out) override;
  FrameInfo info(const FrameRequest& request, int frame) const override;
  CameraState camera(const FrameRequest& request, int frame) const override;
  void warmUp(const FrameRequest& request, const Progress& progress) override;
  const DrawCounts& counts() const override { return counts_; }
  void reloadShaders() override;
  std::shared_ptr<const CaptureFacts> capture() const override;
  std::shared_ptr<const Image> reference(int frame) override;
  std::shared_ptr<const Image> engineOutput(int frame) override;

 private:
  std::shared_ptr<FrameSource> source_;
  std::string name_;
  std::shared_ptr<InputsStore> store_;
  DrawCounts counts_;
  int reloads_ = 0; ///< what other shaders drew is another source's
};

} // namespace taa
