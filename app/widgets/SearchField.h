// A field whose text is searched for as it is typed. Nothing in it waits to be taken: undo is the window's,
// and so is Esc (EscapeKey.h).
#pragma once

#include "core/base/Search.h"

#include <QLabel>
#include <QLineEdit>

class QKeyEvent;

namespace taa::app {

class SearchField : public QLineEdit {
  Q_OBJECT
 public:
  /// `asks` stands in it while it is empty, or one word of it where there is no room, and is its name.
  explicit SearchField(const QString& asks, QWidget* parent = nullptr);

 protected:
  bool event(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
};

/// In the place of what is searched: that nothing was found, and what to do then. Hidden otherwise.
class NoHits : public QLabel {
  Q_OBJECT
 public:
  explicit NoHits(QWidget* parent = nullptr);

  /// What was searched for, and whether something was found.
  void tell(const QString& wanted, bool found);
};

/// Why a row is among those that were found, where its label does not show it; else empty.
QString foundText(const SearchHit& hit);

/// Whether a key is for undo or redo of the window.
bool isUndoKey(const QKeyEvent& event);

} // namespace taa::app
