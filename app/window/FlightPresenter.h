// Shows a flight in its bar, does what the bar asks for, and says what was recorded.
#pragma once

#include <QObject>

namespace taa::app {

class Flight;
class FlightBar;
class MessagesBar;
class Session;

class FlightPresenter : public QObject {
  Q_OBJECT
 public:
  FlightPresenter(const Session& session, Flight& flight, FlightBar& bar, MessagesBar& messages);

 private:
  void showFlight();

  const Session& session_;
  Flight& flight_;
  FlightBar& bar_;
};

} // namespace taa::app
