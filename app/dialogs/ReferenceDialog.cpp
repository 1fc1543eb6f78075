#include "app/dialogs/ReferenceDialog.h"

#include "app/style/DialogSize.h"
#include "app/style/Icons.h"
#include "app/style/Theme.h"

#include <QDesktopServices>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QStringList>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextDocument>
#include <QTextFrame>
#include <QTextOption>
#include <QTextTable>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace taa::app {

namespace {

constexpr double kTitlesShare = 0.3; ///< of the width, that titles of pages take at most: long ones wrap

/// Tables as wide as the page, their cells apart by thin lines.
void styleTables(QTextDocument* document, const QColor& line) {
  for (QTextFrame* frame : document->rootFrame()->childFrames()) {
    auto* table = qobject_cast<QTextTable*>(frame);
    if (!table) continue;
    QTextTableFormat format = table->format();
    format.setBorder(1);
    format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
    format.setBorderBrush(line);
    format.setBorderCollapse(true);
    format.setCellPadding(kUnit);
    format.setCellSpacing(0);
    format.setWidth(QTextLength(QTextLength::PercentageLength, 100));
    table->setFormat(format);
  }
}

} // namespace

ReferenceDialog::ReferenceDialog(QWidget* parent) : QDialog(parent), pages_(manualPages()) {
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Manual"));
  resize(largeOver(parent, {scaled(250 * kUnit), scaled(170 * kUnit)}));
  list_ = new QListWidget;
  list_->setAccessibleName(tr("Pages of the manual"));
  for (const ManualPage& page : pages_) list_->addItem(QString::fromStdString(page.title));
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setWordWrap(true);
  list_->setFixedWidth(
      std::min(list_->sizeHintForColumn(0) + 4 * kUnit, static_cast<int>(kTitlesShare * width())));
  search_ = new QLineEdit;
  search_->setPlaceholderText(tr("Find in the manual; Enter goes on"));
  search_->setAccessibleName(tr("Find in the manual"));
  search_->setClearButtonEnabled(true);
  search_->addAction(themedIcon(QStringLiteral("search")), QLineEdit::LeadingPosition);
  browser_ = new QTextBrowser;
  browser_->setAccessibleName(tr("Page of the manual"));
  browser_->setOpenLinks(false);
  browser_->setWordWrapMode(QTextOption::WordWrap); // a column is as wide as its longest word
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(2 * kUnit, 2 * kUnit, 2 * kUnit, 2 * kUnit);
  layout->setSpacing(2 * kUnit);
  auto* below = new QHBoxLayout;
  below->setSpacing(2 * kUnit);
  below->addWidget(list_);
  below->addWidget(browser_, 1);
  missed_ = new QLabel;
  missed_->setObjectName(QStringLiteral("noHits"));
  missed_->setTextFormat(Qt::PlainText);
  missed_->setWordWrap(true);
  missed_->setForegroundRole(QPalette::PlaceholderText);
  missed_->hide();
  layout->addWidget(search_);
  layout->addWidget(missed_);
  layout->addLayout(below, 1);
  connect(list_, &QListWidget::currentRowChanged, this, &ReferenceDialog::showPage);
  connect(browser_, &QTextBrowser::anchorClicked, this, &ReferenceDialog::follow);
  connect(search_, &QLineEdit::textChanged, this, [this] { find(false); });
  connect(search_, &QLineEdit::returnPressed, this, [this] { find(true); });
  list_->setCurrentRow(0);
  search_->setFocus();
}

// Made before it is shown: a document on show is laid out anew for each cell of a table, and pages have
// thousands.
void ReferenceDialog::showPage(int row) {
  auto* document = new QTextDocument(browser_);
  document->setDefaultFont(browser_->font());
  document->setMarkdown(QString::fromStdString(pages_.at(static_cast<std::size_t>(row)).text));
  styleTables(document, themeColors(this).line);
  browser_->setDocument(document); // which deletes the one before
  find(false);
}

// Other pages open here; the web does in the desktop's browser.
void ReferenceDialog::follow(const QUrl& link) {
  if (!link.scheme().isEmpty()) {
    QDesktopServices::openUrl(link);
    return;
  }
  const std::string file = link.path().toStdString();
  const auto page = std::ranges::find(pages_, file, &ManualPage::file);
  if (page != pages_.end()) list_->setCurrentRow(static_cast<int>(page - pages_.begin()));
  if (link.hasFragment()) scrollTo(link.fragment().toStdString());
}

void ReferenceDialog::scrollTo(const std::string& anchor) {
  for (QTextBlock block = browser_->document()->begin(); block.isValid(); block = block.next()) {
    if (block.blockFormat().headingLevel() == 0 || headingAnchor(block.text().toStdString()) != anchor)
      continue;
    browser_->moveCursor(QTextCursor::End); // so that the heading comes to the top
    browser_->setTextCursor(QTextCursor(block));
    return;
  }
}

// Found where it is read: in Markdown a page's links and marks would be found, too.
std::vector<int> ReferenceDialog::pagesWith(const QString& text) {
  if (texts_.empty())
    for (const ManualPage& page : pages_) {
      QTextDocument document;
      document.setMarkdown(QString::fromStdString(page.text));
      texts_.push_back(document.toPlainText());
    }
  std::vector<int> rows;
  const auto count = static_cast<int>(pages_.size());
  for (int step = 1; step < count; ++step) {
    const int row = (list_->currentRow() + step) % count;
    if (texts_[static_cast<std::size_t>(row)].contains(text, Qt::CaseInsensitive)) rows.push_back(row);
  }
  return rows;
}

// Enter goes on to the next place, on the next page that has it where this one has no further one.
void ReferenceDialog::find(bool fromHere) {
  const QString text = search_->text();
  missed_->hide();
  if (text.isEmpty()) return;
  if (!fromHere) browser_->moveCursor(QTextCursor::Start);
  if (browser_->find(text)) return;
  const std::vector<int> rows = pagesWith(text);
  if (fromHere && !rows.empty()) {
    list_->setCurrentRow(rows.front());
    return;
  }
  browser_->moveCursor(QTextCursor::Start);
  if (browser_->find(text)) return;
  missed_->show();
  QStringList titles;
  for (const int row : rows) titles << list_->item(row)->text();
  missed_->setText(
      titles.isEmpty()
          ? tr("No page of the manual has “%1”. Fewer letters or another word may find it.").arg(text)
          : tr("“%1” is not on this page, but on: %2. Enter goes there.")
                .arg(text, titles.join(QStringLiteral(", "))));
}

} // namespace taa::app
