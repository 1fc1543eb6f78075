// All that the program has said since it was started.
#pragma once

#include <QDialog>
#include <QStringList>

namespace taa::app {

/// Deletes itself when closed. `messages`: with their times, the latest first.
class MessagesDialog : public QDialog {
  Q_OBJECT
 public:
  MessagesDialog(const QStringList& messages, QWidget* parent);
};

} // namespace taa::app
