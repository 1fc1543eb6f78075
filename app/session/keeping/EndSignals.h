// Signals that ask the program to end, as events of the window's thread.
#pragma once

#include <QObject>

#include <array>

namespace taa::app {

/// While it is there, the first SIGINT, SIGTERM or SIGHUP is told; the same one again ends the program at
/// once, as without this. There is one of it at a time.
class EndSignals : public QObject {
  Q_OBJECT
 public:
  /// Throws Error when the system has no more descriptors.
  EndSignals();
  ~EndSignals() override;

 Q_SIGNALS:
  void asked(int signal);

 private:
  void take();

  std::array<int, 2> pipe_{-1, -1}; ///< the end to read, the end to write
};

} // namespace taa::app
