// The shaders to read: the file of each stage, and the program that these settings make of them.
#pragma once

#include "app/session/Session.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QLineEdit;

namespace taa::app {

class SourceText;

class GlslWindow : public QDialog {
  Q_OBJECT
 public:
  GlslWindow(Session& session, QWidget* parent);

  /// Opens the one of `window`, or brings it to the front, at this stage.
  static void openAt(Session& session, Stage stage, QWidget* window);
  void showStage(Stage stage);
  QComboBox* files() const { return files_; }
  SourceText* text() const { return text_; }
  QLineEdit* search() const { return search_; }

 private:
  void refresh();
  void find(bool fromHere);

  Session& session_;
  QComboBox* files_;
  SourceText* text_;
  QLineEdit* search_;
  QLabel* note_;
  int asked_ = 0; ///< texts so far; only the last one is shown
};

} // namespace taa::app
