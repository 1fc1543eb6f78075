// A line across the window that says something without getting in the way: a shape, a sentence, a close
// button.
#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace taa::app {

enum class StripKind { Hint, Caution, Wrong };

class Strip : public QWidget {
  Q_OBJECT
 public:
  explicit Strip(StripKind kind, QWidget* parent = nullptr);

  void setText(const QString& text);
  QString text() const;
  /// What can be done about it, as a button before the close button; empty: nothing.
  void setAction(const QString& text);

 Q_SIGNALS:
  void closed();
  void acted(); ///< the action's button was pressed

 protected:
  void paintEvent(QPaintEvent*) override;

 private:
  StripKind kind_;
  QLabel* label_;
  QPushButton* action_;
};

} // namespace taa::app
