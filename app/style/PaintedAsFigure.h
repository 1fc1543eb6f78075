// How widgets know that they are painted for a file: without what only says where the keys are.
#pragma once

#include <QVariant>
#include <QWidget>

namespace taa::app {

inline constexpr const char* kPaintedAsFigure = "paintedAsFigure"; ///< a property, true meanwhile

inline bool isPaintedAsFigure(const QWidget& widget) {
  return widget.property(kPaintedAsFigure).toBool();
}

/// For as long as it lasts.
class PaintedAsFigure {
 public:
  explicit PaintedAsFigure(QWidget& widget) : widget_(widget) { widget_.setProperty(kPaintedAsFigure, true); }
  ~PaintedAsFigure() { widget_.setProperty(kPaintedAsFigure, {}); }
  PaintedAsFigure(const PaintedAsFigure&) = delete;
  PaintedAsFigure& operator=(const PaintedAsFigure&) = delete;

 private:
  QWidget& widget_;
};

} // namespace taa::app
