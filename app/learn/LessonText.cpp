#include "app/learn/LessonText.h"

#include "app/style/Theme.h"
#include "core/lessons/Ladder.h"

#include <QDesktopServices>
#include <QEvent>
#include <QFontMetrics>
#include <QMouseEvent>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextFragment>
#include <QTextFrame>
#include <QTextList>
#include <QTextTable>
#include <QUrl>

#include <algorithm>
#include <cmath>
#include <utility>

namespace taa::app {

namespace {

constexpr double kLineSpacing = 135.0;  ///< percent of the font's own
constexpr int kLongestLine = 72;        ///< letters
constexpr double kParagraphSpace = 8.0; ///< px where text has its own size
constexpr double kItemSpace = 4.0;

void setSpacing(const QTextBlock& block) {
  const bool isCode = block.blockFormat().hasProperty(QTextFormat::BlockCodeFence);
  const bool isInside = block.textList() != nullptr || isCode;
  QTextBlockFormat format;
  format.setLineHeight(isCode ? 100.0 : kLineSpacing, QTextBlockFormat::ProportionalHeight);
  format.setTopMargin(0.0);
  format.setBottomMargin(scaled(isInside && block.next().textList() == block.textList()
                                    ? (isCode ? 0.0 : kItemSpace)
                                    : kParagraphSpace));
  QTextCursor(block).mergeBlockFormat(format);
}

/// What stands in code is in the font of numbers, on the ground of fields.
void setCode(const QTextBlock& block, const ThemeColors& colors) {
  QTextCharFormat code;
  code.setFontFamilies(numberFont().families());
  code.setFontPointSize(numberFont(10).pointSizeF());
  code.setBackground(colors.field);
  for (auto at = block.begin(); !at.atEnd(); ++at) {
    const QTextFragment fragment = at.fragment();
    if (!fragment.charFormat().fontFixedPitch()) continue;
    QTextCursor cursor(block);
    cursor.setPosition(fragment.position());
    cursor.setPosition(fragment.position() + fragment.length(), QTextCursor::KeepAnchor);
    cursor.mergeCharFormat(code);
  }
}

/// A title is as large as those of panels.
void setTitle(const QTextBlock& block) {
  if (block.blockFormat().headingLevel() == 0) return;
  QTextCursor cursor(block);
  cursor.movePosition(QTextCursor::EndOfBlock, QTextCursor::KeepAnchor);
  QTextCharFormat title = cursor.charFormat();
  title.clearProperty(QTextFormat::FontSizeAdjustment); // which would count for more than a size
  title.setFontPointSize(titleFont().pointSizeF());
  title.setFontWeight(titleFont().weight());
  cursor.setCharFormat(title);
  QTextBlockFormat format;
  format.setLineHeight(100.0, QTextBlockFormat::ProportionalHeight);
  format.setBottomMargin(scaled(kItemSpace));
  cursor.mergeBlockFormat(format);
}

/// Lines as quiet as those of the window; numbers stand under each other.
void setTable(QTextTable& table, const ThemeColors& colors) {
  QTextTableFormat format = table.format();
  format.setBorderCollapse(true);
  format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
  format.setBorder(1.0);
  format.setBorderBrush(colors.line);
  format.setCellPadding(scaled(kUnit));
  format.setBottomMargin(scaled(kParagraphSpace));
  table.setFormat(format);
  for (int row = 0; row < table.rows(); ++row)
    for (int column = 0; column < table.columns(); ++column) {
      QTextBlockFormat cell;
      cell.setLineHeight(100.0, QTextBlockFormat::ProportionalHeight);
      cell.setBottomMargin(0.0);
      if (column > 0) cell.setAlignment(Qt::AlignRight);
      table.cellAt(row, column).firstCursorPosition().mergeBlockFormat(cell);
    }
}

bool isRung(const QUrl& link) {
  return link.scheme() == QLatin1String(kRungScheme.data(), static_cast<qsizetype>(kRungScheme.size()));
}

} // namespace

LessonText::LessonText(QWidget* parent) : QTextBrowser(parent) {
  setObjectName(QStringLiteral("lessonText"));
  setOpenLinks(false);
  setFrameShape(QFrame::NoFrame);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Maximum); // no higher than it is
  setLineWrapMode(QTextEdit::FixedPixelWidth);
  document()->setDocumentMargin(0.0);
  connect(this, &QTextBrowser::anchorClicked, this, [this](const QUrl& link) {
    if (link.scheme() == QLatin1String("https")) QDesktopServices::openUrl(link);
    if (isRung(link)) Q_EMIT rungChosen(link.path());
  });
}

void LessonText::setText(const QString& markdown) {
  if (markdown == markdown_) return;
  markdown_ = markdown;
  keepsEnd_ = false; // the new text may be laid out before setKeepsEnd() is called for it
  document()->setMarkdown(markdown, QTextDocument::MarkdownFeatures(QTextDocument::MarkdownDialectGitHub) |
                                        QTextDocument::MarkdownNoHTML);
  setType();
  moveCursor(QTextCursor::Start);
}

void LessonText::setKeepsEnd(bool keepsEnd) {
  keepsEnd_ = keepsEnd;
  showEnd();
}

void LessonText::showEnd() {
  if (keepsEnd_) verticalScrollBar()->setValue(verticalScrollBar()->maximum());
}

QSize LessonText::sizeHint() const {
  return {QTextBrowser::sizeHint().width(), static_cast<int>(std::ceil(document()->size().height()))};
}

QSize LessonText::minimumSizeHint() const {
  const double line = kLineSpacing / 100.0 * QFontMetrics(font()).lineSpacing();
  return {QTextBrowser::minimumSizeHint().width(), static_cast<int>(std::ceil(line))};
}

void LessonText::setType() {
  for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
    setSpacing(block);
    setTitle(block);
    setCode(block, themeColors(this));
  }
  for (QTextFrame* frame : document()->rootFrame()->childFrames())
    if (auto* table = qobject_cast<QTextTable*>(frame)) setTable(*table, themeColors(this));
  document()->setIndentWidth(scaled(7.0 * kUnit));
  fitLines();
}

void LessonText::fitLines() {
  const int longest = kLongestLine * QFontMetrics(font()).averageCharWidth();
  // Lines leave the place of the scroll bar free, so that they break alike with it and without.
  const int room = contentsRect().width() - verticalScrollBar()->sizeHint().width();
  setLineWrapColumnOrWidth(std::max(1, std::min(longest, room)));
  if (std::exchange(heightPx_, sizeHint().height()) != heightPx_) updateGeometry();
}

QUrl LessonText::linkOfRow(const QPoint& position) const {
  const QTextCursor at = cursorForPosition(position);
  QTextTable* table = at.currentTable();
  if (!table) return {};
  const int row = table->cellAt(at).row();
  for (int column = 0; column < table->columns(); ++column)
    for (auto part = table->cellAt(row, column).firstCursorPosition().block().begin(); !part.atEnd(); ++part)
      if (part.fragment().charFormat().isAnchor()) return QUrl(part.fragment().charFormat().anchorHref());
  return {};
}

void LessonText::mouseMoveEvent(QMouseEvent* event) {
  QTextBrowser::mouseMoveEvent(event);
  if (isRung(linkOfRow(event->position().toPoint()))) viewport()->setCursor(Qt::PointingHandCursor);
}

// The whole row leads where its link does; text that was marked in it is left alone.
void LessonText::mouseReleaseEvent(QMouseEvent* event) {
  const QPoint position = event->position().toPoint();
  const bool isElsewhere = event->button() == Qt::LeftButton && anchorAt(position).isEmpty();
  QTextBrowser::mouseReleaseEvent(event);
  if (!isElsewhere || textCursor().hasSelection() || !viewport()->rect().contains(position)) return;
  if (const QUrl link = linkOfRow(position); isRung(link)) Q_EMIT rungChosen(link.path());
}

void LessonText::changeEvent(QEvent* event) {
  QTextBrowser::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::PaletteChange) setType();
}

void LessonText::resizeEvent(QResizeEvent* event) {
  QTextBrowser::resizeEvent(event);
  fitLines();
  showEnd();
}

} // namespace taa::app
