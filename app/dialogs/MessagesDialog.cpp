#include "app/dialogs/MessagesDialog.h"

#include <QDialogButtonBox>
#include <QPlainTextEdit>
#include <QVBoxLayout>

namespace taa::app {

MessagesDialog::MessagesDialog(const QStringList& messages, QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Messages"));
  setAttribute(Qt::WA_DeleteOnClose);
  auto* text = new QPlainTextEdit;
  text->setReadOnly(true);
  text->setAccessibleName(tr("Messages, the latest first"));
  text->setPlainText(messages.isEmpty() ? tr("Nothing has been said yet.")
                                        : messages.join(QLatin1Char('\n')));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* rows = new QVBoxLayout(this);
  rows->addWidget(text);
  rows->addWidget(buttons);
  resize(720, 360);
}

} // namespace taa::app
