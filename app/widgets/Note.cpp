#include "app/widgets/Note.h"

#include "app/style/Theme.h"

namespace taa::app {

void setSecondary(QWidget& widget) {
  widget.setFont(secondaryFont());
  widget.setForegroundRole(QPalette::PlaceholderText);
}

QLabel* newNote() {
  auto* note = new QLabel;
  setSecondary(*note);
  note->setWordWrap(true);
  return note;
}

} // namespace taa::app
