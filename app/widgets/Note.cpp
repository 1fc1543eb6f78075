#include "app/widgets/Note.h"

#include "app/style/Theme.h"

namespace taa::app {

QLabel* newNote() {
  auto* note = new QLabel;
  note->setFont(secondaryFont());
  note->setForegroundRole(QPalette::PlaceholderText);
  note->setWordWrap(true);
  return note;
}

} // namespace taa::app
