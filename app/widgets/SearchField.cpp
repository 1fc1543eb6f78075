#include "app/widgets/SearchField.h"

#include "app/style/Icons.h"

#include <QKeyEvent>

namespace taa::app {

SearchField::SearchField(const QString& asks, QWidget* parent) : QLineEdit(parent) {
  setPlaceholderText(asks);
  setAccessibleName(asks);
  addAction(themedIcon(QStringLiteral("search")), QLineEdit::LeadingPosition);
}

bool SearchField::event(QEvent* event) {
  const bool isKey = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
  if (!isKey || !isUndoKey(*static_cast<QKeyEvent*>(event))) return QLineEdit::event(event);
  event->ignore(); // the shortcut of the menu gets it
  return true;
}

bool isUndoKey(const QKeyEvent& event) {
  return event.key() == Qt::Key_Z &&
         (event.modifiers() | Qt::ShiftModifier) == (Qt::ControlModifier | Qt::ShiftModifier);
}

} // namespace taa::app
