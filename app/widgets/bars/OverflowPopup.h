// The controls that a line has no room for, one below the other, for as long as it is open.
#pragma once

#include <QFrame>
#include <QPointer>

#include <utility>
#include <vector>

namespace taa::app {

class OverflowPopup : public QFrame {
  Q_OBJECT
 public:
  using Controls = std::vector<std::pair<QWidget*, QString>>; ///< each with what it is called

  /// They go back to `owner` when it closes.
  explicit OverflowPopup(QWidget* owner);
  /// `corner`: its upper right one, in the owner's coordinates; it stays on the screen.
  void open(const Controls& controls, QPoint corner);
  bool holds(const QWidget* control) const;

 Q_SIGNALS:
  void closed();

 protected:
  void hideEvent(QHideEvent*) override;

 private:
  QWidget* owner_;
  std::vector<QPointer<QWidget>> controls_;
};

} // namespace taa::app
