// One intermediate in a list: its name, and the letters of the views that show it.
#pragma once

#include "core/taa/SearchedRows.h"

#include <QAbstractButton>

class QPainter;

namespace taa::app {

struct ThemeColors;

class IntermediateRow : public QAbstractButton {
  Q_OBJECT
 public:
  explicit IntermediateRow(const Intermediate& row, QWidget* parent = nullptr);

  IntermediateId id() const { return row_.id; }
  /// Letters of the views that show it: "", "A", "AB"; `active` is the letter that keys act on.
  void setShownIn(const QString& letters, QChar active);
  QString shownIn() const { return letters_; }
  const SearchedRow& searched() const { return searched_; }
  /// Why a search found it, at the right in secondary text; empty: nothing to say.
  void setFound(const QString& why);
  const QString& found() const { return found_; }
  QSize sizeHint() const override;

 Q_SIGNALS:
  /// In the active view, or in the other one.
  void chosen(IntermediateId id, bool inOtherView);

 protected:
  void paintEvent(QPaintEvent*) override;
  void mouseReleaseEvent(QMouseEvent*) override;
  void keyPressEvent(QKeyEvent*) override;

 private:
  const Intermediate& row_;
  SearchedRow searched_;
  QString letters_, found_;
  QChar active_;
};

/// Name, unit and description, rich text.
QString intermediateToolTip(const Intermediate& row);

/// A view's letter in a small box, filled for the active one.
void paintViewLetter(QPainter& painter, const QRect& box, QChar letter, bool active,
                     const ThemeColors& colors);

} // namespace taa::app
