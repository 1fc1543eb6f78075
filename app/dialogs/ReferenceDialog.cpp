#include "app/dialogs/ReferenceDialog.h"

#include "app/style/Icons.h"
#include "app/style/Theme.h"
#include "core/report/ReferencePage.h"

#include <QLineEdit>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace taa::app {

ReferenceDialog::ReferenceDialog(QWidget* parent) : QDialog(parent) {
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Reference"));
  resize(210 * kUnit, 170 * kUnit);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(2 * kUnit, 2 * kUnit, 2 * kUnit, 2 * kUnit);
  layout->setSpacing(2 * kUnit);
  auto* search = new QLineEdit;
  search->setPlaceholderText(tr("Find in this page; Enter goes on"));
  search->setAccessibleName(tr("Find in this page"));
  search->setClearButtonEnabled(true);
  search->addAction(themedIcon(QStringLiteral("search")), QLineEdit::LeadingPosition);
  auto* page = new QTextBrowser;
  page->setAccessibleName(tr("Parameters and intermediates"));
  page->setHtml(QString::fromStdString(referencePageHtml()));
  // From the start when there is no further one below.
  const auto find = [search, page](bool fromHere) {
    if (!fromHere) page->moveCursor(QTextCursor::Start);
    if (page->find(search->text())) return;
    page->moveCursor(QTextCursor::Start);
    page->find(search->text());
  };
  connect(search, &QLineEdit::textChanged, this, [find] { find(false); });
  connect(search, &QLineEdit::returnPressed, this, [find] { find(true); });
  layout->addWidget(search);
  layout->addWidget(page, 1);
  search->setFocus();
}

} // namespace taa::app
