// The parts of a pixel's error as bars from a line in the middle: to the right where they make it too bright,
// to the left where too dark. They sum up to the last one.
#pragma once

#include "core/verdict/pixel/PixelError.h"

#include <QWidget>

#include <vector>

class QPainter;

namespace taa::app {

class ErrorBars : public QWidget {
  Q_OBJECT
 public:
  explicit ErrorBars(QWidget* parent = nullptr);

  void setError(const PixelError& error);

  struct Bar {
    QString label, text;
    double value = 0.0; ///< luma, scene-linear
  };
  /// Of each part, then of all.
  const std::vector<Bar>& bars() const { return bars_; }
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent*) override;

 private:
  void paintBar(QPainter& painter, const Bar& bar, const QRect& line, double largest) const;

  std::vector<Bar> bars_;
};

} // namespace taa::app
