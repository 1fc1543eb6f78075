// What is sure of a guess, what is not, and what is missing: a sentence a line.
#pragma once

#include "core/capture/import/Guess.h"

#include <QListWidget>
#include <QString>

namespace taa::app {

class GuessSentences : public QListWidget {
  Q_OBJECT
 public:
  explicit GuessSentences(QWidget* parent = nullptr);

  /// What is not sure comes first: it is what somebody has to look at.
  void setGuess(const capture::Guess& guess);
  QSize sizeHint() const override { return {400, 84}; }

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void fitHeight(); ///< as many whole sentences as have room
  void add(const QString& icon, const QString& text, const QString& sentence);
};

} // namespace taa::app
