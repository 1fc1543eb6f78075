#include "app/learn/LessonText.h"

#include "app/style/Theme.h"

#include <QDesktopServices>
#include <QEvent>
#include <QFontMetrics>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextFragment>
#include <QTextList>
#include <QUrl>

#include <algorithm>

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

} // namespace

LessonText::LessonText(QWidget* parent) : QTextBrowser(parent) {
  setObjectName(QStringLiteral("lessonText"));
  setOpenLinks(false);
  setFrameShape(QFrame::NoFrame);
  setLineWrapMode(QTextEdit::FixedPixelWidth);
  document()->setDocumentMargin(0.0);
  connect(this, &QTextBrowser::anchorClicked, this, [](const QUrl& link) {
    if (link.scheme() == QLatin1String("https")) QDesktopServices::openUrl(link);
  });
}

void LessonText::setText(const QString& markdown) {
  document()->setMarkdown(markdown, QTextDocument::MarkdownFeatures(QTextDocument::MarkdownDialectGitHub) |
                                        QTextDocument::MarkdownNoHTML);
  setType();
  moveCursor(QTextCursor::Start);
}

void LessonText::setType() {
  for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
    setSpacing(block);
    setCode(block, themeColors(this));
  }
  document()->setIndentWidth(scaled(7.0 * kUnit));
  fitLines();
}

void LessonText::fitLines() {
  const int longest = kLongestLine * QFontMetrics(font()).averageCharWidth();
  setLineWrapColumnOrWidth(std::max(1, std::min(longest, viewport()->width())));
}

void LessonText::changeEvent(QEvent* event) {
  QTextBrowser::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::PaletteChange) setType();
}

void LessonText::resizeEvent(QResizeEvent* event) {
  QTextBrowser::resizeEvent(event);
  fitLines();
}

} // namespace taa::app
