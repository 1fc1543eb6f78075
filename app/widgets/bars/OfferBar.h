// A line across the window that offers something, with two buttons; goes when either is pressed.
#pragma once

#include <QWidget>

namespace taa::app {

class OfferBar : public QWidget {
  Q_OBJECT
 public:
  OfferBar(const QString& sentence, const QString& accept, const QString& refuse, QWidget* parent = nullptr);

 Q_SIGNALS:
  void accepted();
  void refused();

 protected:
  void paintEvent(QPaintEvent*) override;
};

} // namespace taa::app
