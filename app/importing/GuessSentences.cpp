#include "app/importing/GuessSentences.h"

#include "app/style/Icons.h"
#include "app/style/Theme.h"

#include <QEvent>
#include <QResizeEvent>

#include <algorithm>
#include <string>

namespace taa::app {

namespace {
constexpr int kSentenceIcon = 16;     ///< px
constexpr int kMaxSentencesHigh = 92; ///< px, both where text has its own size
} // namespace

GuessSentences::GuessSentences(QWidget* parent) : QListWidget(parent) {
  setObjectName(QStringLiteral("sentences"));
  setAccessibleName(tr("What is known of the frames"));
  setWordWrap(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setIconSize({scaled(kSentenceIcon), scaled(kSentenceIcon)});
}

void GuessSentences::add(const QString& icon, const QString& text, const QString& sentence) {
  auto* item = new QListWidgetItem(themedIcon(icon), text.arg(sentence), this);
  item->setToolTip(sentence);
}

void GuessSentences::setGuess(const capture::Guess& guess) {
  clear();
  for (const std::string& sentence : guess.unsure)
    add(QStringLiteral("caution"), tr("Not sure: %1"), QString::fromStdString(sentence));
  for (const std::string& sentence : guess.missing)
    add(QStringLiteral("wrong"), tr("Missing: %1"), QString::fromStdString(sentence));
  for (const std::string& sentence : guess.sure)
    add(QStringLiteral("right"), tr("Sure: %1"), QString::fromStdString(sentence));
  fitHeight();
}

void GuessSentences::fitHeight() {
  int high = 0;
  for (int row = 0; row < count(); ++row) {
    const int more = sizeHintForRow(row);
    if (row > 0 && high + more > scaled(kMaxSentencesHigh)) break;
    high += more;
  }
  setFixedHeight(std::max(high, rowHeight()) + 2 * frameWidth());
}

// Other lines are wrapped, or all are higher.
void GuessSentences::resizeEvent(QResizeEvent* event) {
  QListWidget::resizeEvent(event);
  if (event->oldSize().width() != event->size().width()) fitHeight();
}

void GuessSentences::changeEvent(QEvent* event) {
  QListWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) fitHeight();
}

} // namespace taa::app
