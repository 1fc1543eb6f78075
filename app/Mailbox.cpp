#include "app/Mailbox.h"

namespace taa::app {

RenderListener listenerOf(Mailbox& mailbox) {
  RenderListener listener;
  listener.onPicture = [&mailbox](ViewResult result) {
    if (result.view < 0 || result.view >= kViewCount) return;
    mailbox.put([&](Delivery& delivery) {
      delivery.pictures[static_cast<std::size_t>(result.view)] = std::move(result);
    });
  };
  listener.onProbe = [&mailbox](ProbeResult result) {
    mailbox.put([&](Delivery& delivery) { delivery.probe = std::move(result); });
  };
  listener.onStatus = [&mailbox](Status status) {
    mailbox.put([&](Delivery& delivery) { delivery.status = std::move(status); });
  };
  listener.onWork = [&mailbox](Work work) {
    mailbox.put([&](Delivery& delivery) { delivery.work = std::move(work); });
  };
  listener.onError = [&mailbox](std::string sentence) {
    mailbox.put([&](Delivery& delivery) { delivery.errors.push_back(std::move(sentence)); });
  };
  return listener;
}

} // namespace taa::app
