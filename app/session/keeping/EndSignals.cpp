#include "app/session/keeping/EndSignals.h"

#include "core/base/Error.h"
#include "core/base/Say.h"

#include <QSocketNotifier>

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <cassert>
#include <cerrno>
#include <csignal>
#include <cstring>

namespace taa::app {

namespace {

constexpr std::array kEndingSignals{SIGINT, SIGTERM, SIGHUP};

volatile std::sig_atomic_t endingPipe = -1; // a handler may do little more than write to it

void noteSignal(int signal) {
  const int before = errno;
  const auto number = static_cast<unsigned char>(signal);
  static_cast<void>(::write(endingPipe, &number, 1) == 1); // a full pipe has been told of one already
  errno = before;
}

void setHandler(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = static_cast<int>(SA_RESTART | SA_RESETHAND);
  for (const int signal : kEndingSignals) ::sigaction(signal, &action, nullptr);
}

} // namespace

EndSignals::EndSignals() {
  assert(endingPipe < 0);
  if (::pipe2(pipe_.data(), O_CLOEXEC | O_NONBLOCK) != 0)
    throw Error(say<"cannot open a pipe: %1">(std::strerror(errno)));
  auto* notifier = new QSocketNotifier(pipe_[0], QSocketNotifier::Read, this);
  connect(notifier, &QSocketNotifier::activated, this, &EndSignals::take);
  endingPipe = pipe_[1];
  setHandler(noteSignal);
}

EndSignals::~EndSignals() {
  setHandler(SIG_DFL);
  endingPipe = -1;
  for (const int end : pipe_) ::close(end);
}

void EndSignals::take() {
  unsigned char signal = 0;
  if (::read(pipe_[0], &signal, 1) == 1) Q_EMIT asked(signal);
}

} // namespace taa::app
