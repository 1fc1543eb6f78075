// A value that decided a verdict: its name, the value with its limit, and the frame it is of.
#pragma once

#include "core/verdict/pixel/PixelVerdict.h"

#include <QAbstractButton>

namespace taa::app {

class EvidenceRow : public QAbstractButton {
  Q_OBJECT
 public:
  explicit EvidenceRow(QWidget* parent = nullptr);

  void setRow(const VerdictRow& row);
  const VerdictRow& row() const { return row_; }
  /// Value and limit.
  const QString& value() const { return value_; }
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent*) override;
  void keyPressEvent(QKeyEvent*) override;

 private:
  VerdictRow row_;
  QString value_, frame_;
};

} // namespace taa::app
