// A number that can be typed, dragged, scrolled and stepped; its place in the range is a thin bar under it.
#pragma once

#include "app/widgets/Drags.h"
#include "app/widgets/parameters/NumberScale.h"

#include <QString>
#include <QWidget>

class QLineEdit;

namespace taa::app {

class NumberField : public QWidget, public Draggable {
  Q_OBJECT
 public:
  explicit NumberField(const NumberScale& scale, QWidget* parent = nullptr);

  double value() const { return value_; }
  /// Shows a value; emits nothing.
  void setValue(double value);
  void setScale(const NumberScale& scale);
  /// Unit, after a thin space in secondary text.
  void setUnit(const QString& unit);
  /// A name before the number, in secondary text: "EV".
  void setPrefix(const QString& prefix);
  void setDimmed(bool dimmed);

  void cancelDrag() override;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 Q_SIGNALS:
  /// The user changed it.
  void valueEdited(double value);

 protected:
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void mouseReleaseEvent(QMouseEvent*) override;
  void wheelEvent(QWheelEvent*) override;
  void keyPressEvent(QKeyEvent*) override;
  bool event(QEvent*) override;
  bool eventFilter(QObject*, QEvent*) override;

 private:
  void edit(double value);
  void beginTyping(const QString& text);
  void endTyping(bool commit);
  bool takesEditorKey(QKeyEvent& event);
  QString text() const;

  NumberScale scale_;
  double value_ = 0.0;
  QString unit_, prefix_;
  QLineEdit* editor_ = nullptr;
  QString typedFrom_;      ///< what the editor began with
  double dragStart_ = 0.0; ///< unrounded, so that slow drags add up
  double dragX_ = 0.0;
  bool pressed_ = false, dragged_ = false, dimmed_ = false;
};

} // namespace taa::app
