#include "app/commands/ThemeSetting.h"

#include <QApplication>
#include <QSettings>

namespace taa::app {

ThemeSetting::ThemeSetting(QSettings* settings, QObject* parent) : QObject(parent), settings_(settings) {}

void ThemeSetting::choose(ThemeChoice choice) {
  choice_ = choice;
  applyTheme(*qApp, choice);
  if (settings_) settings_->setValue(QStringLiteral("theme"), themeName(choice));
  Q_EMIT changed();
}

} // namespace taa::app
