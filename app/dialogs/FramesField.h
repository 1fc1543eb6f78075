// A range of frames of the shot that is open, as two numbers.
#pragma once

#include <QWidget>

class QSpinBox;

namespace taa::app {

class Session;

class FramesField : public QWidget {
  Q_OBJECT
 public:
  /// Begins with `count` frames up to the one on show, as far as there are as many.
  FramesField(Session& session, int count, QWidget* parent = nullptr);

  int first() const;
  int last() const;
  int count() const { return last() - first() + 1; }
  bool isOrdered() const { return first() <= last(); }

 Q_SIGNALS:
  void changed();

 private:
  void listFrames();

  Session& session_;
  QSpinBox *first_, *last_;
};

} // namespace taa::app
