// Where a number of the settings matters: how much each pixel of the frame on show moves with it.
#pragma once

#include "app/background/BackgroundWork.h"
#include "app/background/WorkDialog.h"
#include "core/inspect/MappedShot.h"

#include <QString>

#include <functional>
#include <optional>

class QComboBox;
class QPushButton;

namespace taa::app {

class BackgroundBar;
class PictureBox;
class Session;

/// There is one of a window.
class MapDialog : public WorkDialog {
  Q_OBJECT
 public:
  /// As mapShot(); tests put another one in its place.
  using Map = std::function<SensitivityMap(const MapRequest&, const Progress&)>;
  /// Expects that something is open.
  MapDialog(Session& session, QWidget* parent, Map map = mapShot);

  /// Opens that of `window`, or brings it to the front; draws the number of `path` unless that is empty.
  static void openAt(Session& session, const QString& path, QWidget* window);

  QComboBox* numbers() const { return numbers_; }
  PictureBox* picture() const { return picture_; }
  BackgroundBar* bar() const { return bar_; }
  void begin();

 private:
  void listNumbers();
  void choose(const QString& path);
  void showMap(const SensitivityMap& map);
  void finish(const QString& error);

  Session& session_;
  Map make_;
  BackgroundWork work_;
  std::optional<SensitivityMap> map_;
  int frame_ = 0; ///< that is drawn
  QComboBox* numbers_;
  PictureBox* picture_;
  BackgroundBar* bar_;
  QPushButton* probe_;
};

} // namespace taa::app
