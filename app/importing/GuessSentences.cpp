#include "app/importing/GuessSentences.h"

#include "app/style/Icons.h"

#include <string>

namespace taa::app {

GuessSentences::GuessSentences(QWidget* parent) : QListWidget(parent) {
  setObjectName(QStringLiteral("sentences"));
  setAccessibleName(tr("What is known of the frames"));
  setWordWrap(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setSelectionMode(QAbstractItemView::SingleSelection);
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
}

} // namespace taa::app
