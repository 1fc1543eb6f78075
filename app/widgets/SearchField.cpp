#include "app/widgets/SearchField.h"

#include "app/style/Icons.h"
#include "app/style/Theme.h"

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

void SearchField::resizeEvent(QResizeEvent* event) {
  QLineEdit::resizeEvent(event);
  const int sign = 2 * fontMetrics().height(); // and what is around the words
  const bool fits = fontMetrics().horizontalAdvance(accessibleName()) + sign <= width();
  setPlaceholderText(fits ? accessibleName() : tr("Search"));
}

NoHits::NoHits(QWidget* parent) : QLabel(parent) {
  setObjectName(QStringLiteral("noHits"));
  setTextFormat(Qt::PlainText);
  setWordWrap(true);
  setForegroundRole(QPalette::PlaceholderText);
  setContentsMargins(2 * kUnit, 2 * kUnit, 2 * kUnit, 2 * kUnit);
  hide();
}

void NoHits::tell(const QString& wanted, bool found) {
  setText(tr("Nothing here has “%1”. Fewer letters or another word may find it; Esc shows all again.")
              .arg(wanted));
  setVisible(!found);
}

QString foundText(const SearchHit& hit) {
  const QString why = QString::fromStdString(hit.why);
  switch (hit.by) {
  case FoundBy::Label:
  case FoundBy::Id:
    return {};
  case FoundBy::Choice:
    return NoHits::tr("choice: %1").arg(why);
  case FoundBy::Text:
    return NoHits::tr("in its description");
  case FoundBy::Synonym:
    return NoHits::tr("here: %1").arg(why);
  }
  return {};
}

bool isUndoKey(const QKeyEvent& event) {
  return event.key() == Qt::Key_Z &&
         (event.modifiers() | Qt::ShiftModifier) == (Qt::ControlModifier | Qt::ShiftModifier);
}

} // namespace taa::app
