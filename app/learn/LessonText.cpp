#include "app/learn/LessonText.h"

#include <QDesktopServices>
#include <QTextDocument>
#include <QUrl>

namespace taa::app {

LessonText::LessonText(QWidget* parent) : QTextBrowser(parent) {
  setOpenLinks(false);
  setFrameShape(QFrame::NoFrame);
  connect(this, &QTextBrowser::anchorClicked, this, [](const QUrl& link) {
    if (link.scheme() == QLatin1String("https")) QDesktopServices::openUrl(link);
  });
}

void LessonText::setText(const QString& markdown) {
  document()->setMarkdown(markdown, QTextDocument::MarkdownFeatures(QTextDocument::MarkdownDialectGitHub) |
                                        QTextDocument::MarkdownNoHTML);
  moveCursor(QTextCursor::Start);
}

} // namespace taa::app
