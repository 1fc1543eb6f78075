// Whether the window is dark or light and how large its text is, and where that is remembered.
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
  /// Of the size by design; kept within what resizeText() takes, and remembered.
  void setTextPercent(int percent);
  /// As it was remembered.
  void restoreTextSize();
  /// For a while: it is not remembered.
  void showTextPercent(int percent);

 Q_SIGNALS:
  void changed();

 private:
  QSettings* settings_;
  ThemeChoice choice_ = ThemeChoice::System;
};

} // namespace taa::app
