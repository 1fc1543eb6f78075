#include "app/commands/ThemeSetting.h"

#include "app/style/TextSize.h"

#include <QApplication>
#include <QEvent>
#include <QResizeEvent>
#include <QSettings>
#include <QWidget>

namespace taa::app {

namespace {

QString textPercentKey() {
  return QStringLiteral("textPercent");
}

// Widgets that place what is in them by themselves do so when they are resized.
void layOutAnew() {
  for (QWidget* widget : QApplication::allWidgets()) widget->updateGeometry();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
  for (QWidget* widget : QApplication::allWidgets()) {
    QResizeEvent resized(widget->size(), widget->size());
    if (!widget->isWindow()) QCoreApplication::sendEvent(widget, &resized);
    widget->update();
  }
}

} // namespace

ThemeSetting::ThemeSetting(QSettings* settings, QObject* parent) : QObject(parent), settings_(settings) {}

void ThemeSetting::choose(ThemeChoice choice) {
  choice_ = choice;
  applyTheme(*qApp, choice);
  fitFonts(textPercent());
  if (settings_) settings_->setValue(QStringLiteral("theme"), themeName(choice));
  Q_EMIT changed();
}

void ThemeSetting::showTextPercent(int percent) {
  if (percent == textPercent()) return;
  const int before = textPercent();
  resizeText(percent);
  applyTheme(*qApp, choice_);
  fitFonts(before);
  layOutAnew();
  Q_EMIT changed();
}

void ThemeSetting::setTextPercent(int percent) {
  showTextPercent(percent);
  if (settings_) settings_->setValue(textPercentKey(), textPercent());
}

void ThemeSetting::restoreTextSize() {
  if (settings_) showTextPercent(settings_->value(textPercentKey(), kMinTextPercent).toInt());
}

} // namespace taa::app
