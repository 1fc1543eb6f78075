#include "app/session/Outbox.h"

#include "core/base/ShownText.h"

#include <exception>

namespace taa::app {

RequestId Outbox::post(Request request) {
  RequestId id = 0;
  if (renderer_) guarded([&] { id = renderer_->post(std::move(request)); });
  return id;
}

void Outbox::guarded(const std::function<void()>& act) {
  try {
    act();
  } catch (const std::exception& error) {
    tell_(QString::fromStdString(shownReason(error)));
  }
}

} // namespace taa::app
