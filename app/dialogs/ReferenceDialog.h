// The reference page: every stage, parameter and intermediate, with a field that finds a word in it.
#pragma once

#include <QDialog>

namespace taa::app {

/// Deletes itself when closed.
class ReferenceDialog : public QDialog {
  Q_OBJECT
 public:
  explicit ReferenceDialog(QWidget* parent);
};

} // namespace taa::app
