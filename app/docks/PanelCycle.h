// From panel to panel by a key, as the Tab key goes from control to control.
#pragma once

#include <QObject>
#include <QPointer>

#include <functional>
#include <map>
#include <vector>

class QWidget;

namespace taa::app {

/// In each panel the focus comes back to where it was last.
class PanelCycle : public QObject {
  Q_OBJECT
 public:
  /// The panels in their order; those that are hidden, or hold nothing that takes the focus, are passed over.
  PanelCycle(const std::vector<QWidget*>& panels, QObject* parent);

  /// 1: to the next one, −1: to the one before; from elsewhere to the first, or the last.
  void go(int direction);

 private:
  /// What gets the focus in a panel; null: nothing does.
  QWidget* entryOf(QWidget* panel) const;

  std::vector<QPointer<QWidget>> panels_; ///< they may go before it, in which the focus moves on
  std::map<const QWidget*, QPointer<QWidget>> last_;
};

} // namespace taa::app
