// The name of a parameter: a dot before it when changed, dimmed when without effect, reset by a double click.
#pragma once

#include <QWidget>

namespace taa::app {

class ParameterLabel : public QWidget {
  Q_OBJECT
 public:
  explicit ParameterLabel(const QString& text, QWidget* parent = nullptr);

  void setState(bool changed, bool dimmed);
  bool isChanged() const { return changed_; }
  bool isDimmed() const { return dimmed_; }
  QSize sizeHint() const override;

 Q_SIGNALS:
  void resetRequested();

 protected:
  void paintEvent(QPaintEvent*) override;
  void mouseDoubleClickEvent(QMouseEvent*) override;

 private:
  QString text_;
  bool changed_ = false, dimmed_ = false;
};

} // namespace taa::app
