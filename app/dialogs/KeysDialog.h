// The list of keys and gestures.
#pragma once

#include <QDialog>
#include <QString>

#include <vector>

class QScrollArea;

namespace taa::app {

class NoHits;

struct KeyLine {
  QString group, keys, text;
};

/// Deletes itself when closed. A field above the list finds keys by what they do, or by their names.
class KeysDialog : public QDialog {
  Q_OBJECT
 public:
  KeysDialog(const std::vector<KeyLine>& lines, QWidget* parent);

 private:
  void find(const QString& text);

  std::vector<KeyLine> lines_;
  int room_ = 0; ///< px, what the columns may take
  NoHits* noHits_;
  QScrollArea* scroll_;
};

} // namespace taa::app
