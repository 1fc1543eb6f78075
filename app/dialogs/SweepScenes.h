// The scenes that a sweep measures: what is open, and built-in ones that are ticked.
#pragma once

#include "core/io/SessionFile.h"

#include <QListWidget>
#include <QString>

#include <string>
#include <vector>

namespace taa::app {

class Session;

/// A shot that settings are measured on.
struct SweptScene {
  QString name;
  SessionFile shot;
  bool isOpen = false; ///< what is on show, as it is
};

class SweepScenes : public QListWidget {
  Q_OBJECT
 public:
  explicit SweepScenes(Session& session, QWidget* parent = nullptr);

  /// Those that are ticked: built-in ones by their own cameras, in the size of the picture on show.
  std::vector<SweptScene> chosen() const;
  QSize sizeHint() const override;

 Q_SIGNALS:
  void changed();

 private:
  /// Lists them for what is open now; what is ticked stays.
  void list();

  Session& session_;
  std::string open_; ///< source that they are listed for
};

} // namespace taa::app
