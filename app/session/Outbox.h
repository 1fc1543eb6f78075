// Requests of the session and its parts on their way to the render thread; errors are told and never thrown.
#pragma once

#include "app/session/Renderer.h"

#include <QString>

#include <functional>
#include <memory>
#include <utility>

namespace taa::app {

class Outbox {
 public:
  /// `tell` shows a sentence about what went wrong.
  explicit Outbox(std::function<void(const QString&)> tell) : tell_(std::move(tell)) {}

  /// Until then, and where there is no renderer, requests go nowhere.
  void setRenderer(std::unique_ptr<Renderer> renderer) { renderer_ = std::move(renderer); }
  /// 0: the request was not posted.
  RequestId post(Request request);
  /// What `act` throws is told.
  void guarded(const std::function<void()>& act);

 private:
  std::function<void(const QString&)> tell_;
  std::unique_ptr<Renderer> renderer_;
};

} // namespace taa::app
