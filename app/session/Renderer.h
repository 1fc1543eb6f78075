// What the session asks of the thread that renders; tests put a synthetic one in its place.
#pragma once

#include "core/requests/Requests.h"
#include "core/requests/Results.h"

#include <memory>

namespace taa::app {

/// Pictures that it is asked for at a time, at most.
inline constexpr int kViewCount = 4;

/// As RenderThread: answers come through the listener on another thread.
class Renderer {
 public:
  Renderer() = default;
  virtual ~Renderer() = default;
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Returns at once.
  virtual RequestId post(Request request) = 0;
};

/// The real one.
std::unique_ptr<Renderer> makeRenderThread(Listener listener);

} // namespace taa::app
