// A frame in the accent color around a part of the window that a lesson speaks of.
#pragma once

#include <QPointer>
#include <QWidget>

#include <vector>

namespace taa::app {

/// Lies over the window and lets the mouse through.
class PartFrame : public QWidget {
  Q_OBJECT
 public:
  explicit PartFrame(QWidget* window);
  /// Null: around nothing.
  void surround(QWidget* part);
  QWidget* part() const { return part_; }

 protected:
  void paintEvent(QPaintEvent*) override;
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  void watch();
  void follow();

  QPointer<QWidget> part_;
  std::vector<QPointer<QWidget>> watched_; ///< the part, and what it lies in
};

} // namespace taa::app
