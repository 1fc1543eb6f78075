// A line across the window that says something without getting in the way: a shape, a sentence, a close
// button.
#pragma once

#include <QWidget>

class QLabel;

namespace taa::app {

enum class StripKind { Hint, Caution, Wrong };

class Strip : public QWidget {
  Q_OBJECT
 public:
  explicit Strip(StripKind kind, QWidget* parent = nullptr);

  void setText(const QString& text);
  QString text() const;

 Q_SIGNALS:
  void closed();

 protected:
  void paintEvent(QPaintEvent*) override;

 private:
  StripKind kind_;
  QLabel* label_;
};

} // namespace taa::app
