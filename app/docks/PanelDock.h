// A part of the window that can be torn off, moved to another side and put on another screen.
#pragma once

#include <QDockWidget>
#include <QPointer>

class QHBoxLayout;

namespace taa::app {

class IconButton;

/// Is shown while its panel is, which whoever has the panel shows and hides. It is dragged by its head.
class PanelDock : public QDockWidget {
  Q_OBJECT
 public:
  /// `id` names it in files, `title` for people.
  PanelDock(const QString& id, const QString& title, QWidget* parent);

  /// `head` becomes its head, with a button behind it; null: the title does.
  void setHead(QWidget* head);
  /// As setHead(), of a head that has the buttons it needs.
  void setWholeHead(QWidget* head);
  /// Null: it has none at the moment, and is hidden.
  void setPanel(QWidget* panel);
  /// As setPanel(), of a panel that scrolls where there is less room than it needs, down to `leastPx` of
  /// texts of 100 %.
  void setScrolledPanel(QWidget* panel, int leastPx);
  /// Also hides its panel, as a close button does.
  void addCloseButton();
  /// Shows or hides it as its panel is.
  void follow();
  /// Where it has the focus in a window of its own, the window that it belongs to gets it.
  void giveFocusBack();
  /// Where the mouse drags it, it goes back to where it was.
  void endDrag();

 Q_SIGNALS:
  /// The button of its head was pressed.
  void headPressed();
  /// It is shown after it was hidden.
  void opened();
  /// Its window was closed.
  void closed();

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

 private:
  void showButton();
  /// `shown` is the panel, or has it.
  void takePanel(QWidget* panel, QWidget* shown);

  QPointer<QWidget> panel_;
  IconButton* button_ = nullptr;
  QHBoxLayout* row_ = nullptr; ///< of its head, where it is its own
};

} // namespace taa::app
