// In the place of the first picture, until it is there: what is opened, what is being done, and for how long.
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

class QLabel;

namespace taa::app {

class Session;

class LoadingNote : public QWidget {
  Q_OBJECT
 public:
  /// Lies in the middle of `over`; gone for good once a picture has arrived.
  LoadingNote(const Session& session, QWidget* over);

  QString text() const;

 protected:
  void paintEvent(QPaintEvent*) override;
  bool eventFilter(QObject*, QEvent*) override;

 private:
  void tell();
  void fail();
  void place();

  const Session& session_;
  QLabel *title_, *step_;
  QElapsedTimer since_;
  QTimer clock_;
  bool failed_ = false;
};

} // namespace taa::app
