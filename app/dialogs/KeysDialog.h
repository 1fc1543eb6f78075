// The list of keys and gestures.
#pragma once

#include <QDialog>
#include <QString>

#include <vector>

namespace taa::app {

struct KeyLine {
  QString group, keys, text;
};

/// Deletes itself when closed.
class KeysDialog : public QDialog {
  Q_OBJECT
 public:
  KeysDialog(const std::vector<KeyLine>& lines, QWidget* parent);
};

} // namespace taa::app
