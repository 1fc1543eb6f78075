// A list that is searched by typing: commands, or the intermediates of a view.
#pragma once

#include "core/taa/SearchedRows.h"

#include <QFrame>
#include <QString>

#include <cstddef>
#include <functional>
#include <vector>

class QLineEdit;
class QListWidget;

namespace taa::app {

struct ChooserEntry {
  QString text;
  QString detail;         ///< at the right, in secondary text
  QString group;          ///< a heading before those of a group, which need not follow each other
  SearchedRow searched{}; ///< what else it is found by; text and group are known from above
  bool enabled = true;
};

/// Of a list of intermediates, under their stages.
ChooserEntry intermediateEntry(const Intermediate& row);

/// A popup that deletes itself when it closes.
class Chooser : public QFrame {
  Q_OBJECT
 public:
  Chooser(const QString& placeholder, std::vector<ChooserEntry> entries, std::function<void(int)> choose,
          QWidget* parent);

  /// Below `anchor` (its parent's coordinates), as large as the window allows.
  void open(const QRect& anchor, int current = -1);
  /// Shows what is found, the groups with the strongest hits first; the first one becomes current.
  void search(const QString& text);

 protected:
  bool eventFilter(QObject*, QEvent*) override;

 private:
  void fill(const QString& wanted, int current);
  void accept();
  void moveCurrent(int rows);

  std::vector<ChooserEntry> entries_;
  std::vector<std::size_t> order_; ///< of entries as all are listed: those of a group together
  std::function<void(int)> choose_;
  QLineEdit* field_;
  QListWidget* list_;
};

} // namespace taa::app
