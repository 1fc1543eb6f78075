#include "app/session/Renderer.h"

#include "core/jobs/RenderThread.h"

#include <utility>

namespace taa::app {

namespace {

class ThreadRenderer final : public Renderer {
 public:
  explicit ThreadRenderer(Listener listener) : thread_(std::move(listener)) {
    constexpr double kFeltMs = 50.0; // so long a hand that drags does not notice
    thread_.post(request::SetPreviews{kFeltMs});
  }
  RequestId post(Request request) override { return thread_.post(std::move(request)); }

 private:
  RenderThread thread_;
};

} // namespace

std::unique_ptr<Renderer> makeRenderThread(Listener listener) {
  return std::make_unique<ThreadRenderer>(std::move(listener));
}

} // namespace taa::app
