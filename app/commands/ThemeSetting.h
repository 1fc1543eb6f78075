// Whether the window is dark or light, and where that is remembered.
#pragma once

#include "app/style/Theme.h"

#include <QObject>

class QSettings;

namespace taa::app {

class ThemeSetting : public QObject {
  Q_OBJECT
 public:
  /// `settings` remembers it; null: nothing does.
  ThemeSetting(QSettings* settings, QObject* parent);

  ThemeChoice choice() const { return choice_; }
  /// Draws the whole program so.
  void choose(ThemeChoice choice);

 Q_SIGNALS:
  void changed();

 private:
  QSettings* settings_;
  ThemeChoice choice_ = ThemeChoice::System;
};

} // namespace taa::app
