// Where a number of the settings matters: how much each pixel of the frame on show moves with it.
#pragma once

#include "app/background/MapWork.h"

#include <QDialog>
#include <QString>

#include <optional>

class QComboBox;

namespace taa::app {

class BackgroundBar;
class PictureBox;
class Session;

/// There is one of a window.
class MapDialog : public QDialog {
  Q_OBJECT
 public:
  /// Expects that something is open.
  MapDialog(Session& session, QWidget* parent, MapWork::Map map = mapShot);

  /// Opens that of `window`, or brings it to the front; draws the number of `path` unless that is empty.
  static void openAt(Session& session, const QString& path, QWidget* window);

  QComboBox* numbers() const { return numbers_; }
  PictureBox* picture() const { return picture_; }
  BackgroundBar* bar() const { return bar_; }
  void begin();
  /// Esc: ends what is under way, else closes.
  void reject() override;

 protected:
  void closeEvent(QCloseEvent*) override;

 private:
  void listNumbers();
  void choose(const QString& path);
  void showMap(const SensitivityMap& map);
  void finish(const QString& error);

  Session& session_;
  MapWork work_;
  std::optional<SensitivityMap> map_;
  int frame_ = 0; ///< that is drawn
  QComboBox* numbers_;
  PictureBox* picture_;
  BackgroundBar* bar_;
};

} // namespace taa::app
