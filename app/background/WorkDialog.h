// A dialog around something that is done in the background.
#pragma once

#include <QDialog>

namespace taa::app {

class BackgroundWork;

/// There is one of a kind in a window: what was found is there again when it is opened again.
class WorkDialog : public QDialog {
  Q_OBJECT
 public:
  /// Esc: ends what is under way, else closes.
  void reject() override;
  /// Opens it, or brings it to the front.
  void present();

 protected:
  /// `work` is a member of the subclass.
  WorkDialog(BackgroundWork& work, QWidget* parent);
  void closeEvent(QCloseEvent*) override;

 private:
  BackgroundWork& work_;
};

} // namespace taa::app
