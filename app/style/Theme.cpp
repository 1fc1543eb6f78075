#include "app/style/Theme.h"

#include "app/style/FlatStyle.h"

#include <QApplication>
#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusVariant>
#include <QFontDatabase>
#include <QPalette>
#include <QWidget>

#include <cmath>
#include <optional>
#include <utility>

namespace taa::app {

namespace {

constexpr const char* kStyleSheet = R"(
QMainWindow, QDialog { background: @window; }
QToolTip { background: @panel; color: @text; border: 1px solid @line; padding: 4px; }
QMenuBar { background: @window; color: @text; padding: 0 4px; }
QMenuBar::item { padding: 5px 8px; background: transparent; }
QMenuBar::item:selected, QMenuBar::item:pressed { background: @hover; }
QMenu { background: @panel; color: @text; border: 1px solid @line; padding: 4px 0; }
QMenu::item { padding: 4px 28px 4px 28px; min-height: 14px; }
QMenu::item:selected { background: @accent; color: @onAccent; }
QMenu::item:disabled { color: @secondary; background: transparent; }
QMenu::separator { height: 1px; background: @line; margin: 4px 0; }
QMenu::indicator { left: 8px; width: 12px; height: 12px; }
QMenu::icon { left: 8px; }
QLineEdit { background: @field; border: 1px solid @line; padding: 0 6px; min-height: 20px;
  selection-background-color: @accent; selection-color: @onAccent; }
QLineEdit:focus { border-color: @accent; }
QAbstractSpinBox QLineEdit { border: none; background: transparent; min-height: 0; padding: 0 4px; }
QLineEdit#valueEditor { padding: 0 3px; min-height: 0; border-color: @accent; }
QPushButton { background: @panel; color: @text; border: 1px solid @line; padding: 4px 12px; min-height: @buttonpx; }
QPushButton:hover { background: @hover; }
QPushButton:focus, QPushButton:default { border-color: @accent; }
QPushButton:disabled { color: @secondary; background: transparent; }
QToolButton { background: transparent; border: none; padding: 3px; color: @text; }
QToolButton:hover { background: @hover; }
QToolButton:checked { background: @hover; }
QToolButton:focus { border: 1px solid @accent; padding: 2px; }
QToolButton[popupMode="2"] { padding-right: 16px; }
QToolButton[popupMode="2"]:focus { padding-right: 15px; }
QToolButton::menu-indicator { subcontrol-origin: padding; subcontrol-position: center right; right: 4px; }
QTextBrowser#lessonText { background: @panel; border: none; }
QScrollArea { border: none; background: transparent; }
QScrollBar:vertical { background: transparent; width: 10px; margin: 0; }
QScrollBar:horizontal { background: transparent; height: 10px; margin: 0; }
QScrollBar::handle { background: @line; border-radius: 3px; margin: 2px; }
QScrollBar::handle:vertical { min-height: 24px; }
QScrollBar::handle:horizontal { min-width: 24px; }
QScrollBar::handle:hover { background: @secondary; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
QSplitter::handle { background: @line; }
QMainWindow::separator { background: @window; width: 3px; height: 3px; }
QMainWindow::separator:hover { background: @line; }
QTabBar { background: transparent; border: none; }
QTabBar::tab { background: transparent; color: @secondary; border: none; border-bottom: 2px solid transparent;
  padding: 3px 10px; }
QTabBar::tab:selected { color: @text; border-bottom: 2px solid @accent; }
QTabBar::tab:hover { background: @hover; }
QTabBar::tab:focus { color: @text; background: @hover; }
QFrame#popup { background: @panel; border: 1px solid @line; }
QTreeView, QListWidget { background: @panel; alternate-background-color: @panel; color: @text; border: none;
  outline: none; }
QTreeView::item { padding: 2px 4px; border: none; }
QTreeView::item:selected { background: @hover; color: @text; }
QTreeView::item:selected:active { background: @hover; color: @text; }
QListWidget::item { padding: 3px @listPaddingpx; border: none; }
QListWidget::item:selected { background: @accent; color: @onAccent; }
QHeaderView { background: @panel; }
QHeaderView::section { background: @panel; color: @secondary; border: none; border-bottom: 1px solid @line;
  padding: 2px 4px; font-size: @smallpt; }
)";

constexpr const char* kIsStyled = "hasFlatStyle"; ///< of the application, whose style is set once

QString filled(QString sheet, const ThemeColors& colors) {
  const std::pair<const char*, QColor> names[] = {
      {"@window", colors.window}, {"@panel", colors.panel},       {"@field", colors.field},
      {"@line", colors.line},     {"@text", colors.text},         {"@hover", colors.hover},
      {"@accent", colors.accent}, {"@onAccent", colors.onAccent}, {"@secondary", colors.secondary},
  };
  // The longer of two names with the same beginning must go first; none here is the beginning of another.
  for (const auto& [name, color] : names) sheet.replace(QLatin1String(name), color.name());
  // Of a line of larger letters: this least height holds where a layout has too little room.
  const int button = static_cast<int>(std::lround(14 + 18 * (textScale() - 1.0)));
  sheet.replace(QLatin1String("@listPadding"), QString::number(kListPadding));
  sheet.replace(QLatin1String("@button"), QString::number(button));
  return sheet.replace(QLatin1String("@small"), QString::number(9 * textScale()));
}

QPalette paletteOf(const ThemeColors& colors) {
  QPalette palette;
  palette.setColor(QPalette::Window, colors.window);
  palette.setColor(QPalette::WindowText, colors.text);
  palette.setColor(QPalette::Base, colors.field);
  palette.setColor(QPalette::AlternateBase, colors.panel);
  palette.setColor(QPalette::Text, colors.text);
  palette.setColor(QPalette::PlaceholderText, colors.secondary);
  palette.setColor(QPalette::Button, colors.panel);
  palette.setColor(QPalette::ButtonText, colors.text);
  palette.setColor(QPalette::BrightText, colors.text);
  palette.setColor(QPalette::Light, colors.line);
  palette.setColor(QPalette::Midlight, colors.line);
  palette.setColor(QPalette::Mid, colors.line);
  palette.setColor(QPalette::Dark, colors.line);
  palette.setColor(QPalette::Shadow, colors.window);
  palette.setColor(QPalette::Highlight, colors.accent);
  palette.setColor(QPalette::HighlightedText, colors.onAccent);
  palette.setColor(QPalette::Link, colors.accent);
  palette.setColor(QPalette::ToolTipBase, colors.panel);
  palette.setColor(QPalette::ToolTipText, colors.text);
  for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, colors.secondary);
  return palette;
}

/// What the desktop portal says: 1 dark, 2 light, 0 no wish; nothing without a portal.
std::optional<int> portalScheme() {
  const QDBusConnection bus = QDBusConnection::sessionBus();
  if (!bus.isConnected()) return {};
  QDBusMessage question = QDBusMessage::createMethodCall(
      QStringLiteral("org.freedesktop.portal.Desktop"), QStringLiteral("/org/freedesktop/portal/desktop"),
      QStringLiteral("org.freedesktop.portal.Settings"), QStringLiteral("Read"));
  question << QStringLiteral("org.freedesktop.appearance") << QStringLiteral("color-scheme");
  const QDBusMessage answer = bus.call(question, QDBus::Block, 250);
  if (answer.type() != QDBusMessage::ReplyMessage || answer.arguments().isEmpty()) return {};
  QVariant value = answer.arguments().first();
  while (value.canConvert<QDBusVariant>()) value = value.value<QDBusVariant>().variant();
  return value.toInt();
}

QFont sized(QFont font, int points) {
  font.setPointSizeF(points * textScale());
  return font;
}

} // namespace

const ThemeColors& darkColors() {
  static const ThemeColors colors{
      QColor(0x20, 0x20, 0x20), QColor(0x26, 0x26, 0x26), QColor(0x1a, 0x1a, 0x1a), QColor(0x3a, 0x3a, 0x3a),
      QColor(0xdc, 0xdc, 0xdc), QColor(0x9a, 0x9a, 0x9a), QColor(0x3c, 0x3c, 0x3c), QColor(0x4f, 0x9f, 0xe8),
      QColor(0x10, 0x10, 0x10), QColor(0x33, 0x33, 0x33), QColor(0xe5, 0x60, 0x4d), QColor(0xd9, 0xa1, 0x3b),
      QColor(0x57, 0xa7, 0x73)};
  return colors;
}

const ThemeColors& lightColors() {
  static const ThemeColors colors{
      QColor(0xf0, 0xf0, 0xf0), QColor(0xf7, 0xf7, 0xf7), QColor(0xff, 0xff, 0xff), QColor(0xcf, 0xcf, 0xcf),
      QColor(0x1c, 0x1c, 0x1c), QColor(0x5f, 0x5f, 0x5f), QColor(0xbd, 0xbd, 0xbd), QColor(0x17, 0x69, 0xb0),
      QColor(0xff, 0xff, 0xff), QColor(0xe2, 0xe2, 0xe2), QColor(0xe5, 0x60, 0x4d), QColor(0xd9, 0xa1, 0x3b),
      QColor(0x57, 0xa7, 0x73)};
  return colors;
}

bool isSystemDark() {
  if (const std::optional<int> scheme = portalScheme()) return *scheme != 2;
  // Without a portal, a desktop still shows its wish by the palette that Qt took from it at the start.
  static const bool startedLight = QGuiApplication::palette().color(QPalette::Window).lightness() > 127;
  return qEnvironmentVariableIsEmpty("XDG_CURRENT_DESKTOP") || !startedLight;
}

void applyTheme(QApplication& application, ThemeChoice choice) {
  const bool dark = choice == ThemeChoice::System ? isSystemDark() : choice == ThemeChoice::Dark;
  const ThemeColors& colors = dark ? darkColors() : lightColors();
  if (!application.property(kIsStyled).toBool()) QApplication::setStyle(new FlatStyle);
  application.setProperty(kIsStyled, true);
  QApplication::setFont(sized(QFontDatabase::systemFont(QFontDatabase::GeneralFont), 10));
  QApplication::setPalette(paletteOf(colors));
  application.setStyleSheet(filled(QLatin1String(kStyleSheet), colors));
}

const ThemeColors& themeColors(const QPalette& palette) {
  return palette.color(QPalette::Window).lightness() < 128 ? darkColors() : lightColors();
}

const ThemeColors& themeColors(const QWidget* widget) {
  return themeColors(widget->palette());
}

QFont secondaryFont() {
  return sized(QApplication::font(), 9);
}

QFont titleFont() {
  return sized(QApplication::font(), 12);
}

QFont numberFont(int points) {
  return sized(QFontDatabase::systemFont(QFontDatabase::FixedFont), points);
}

bool parseTheme(const QString& text, ThemeChoice& choice) {
  for (const ThemeChoice each : {ThemeChoice::System, ThemeChoice::Dark, ThemeChoice::Light})
    if (themeName(each) == text) {
      choice = each;
      return true;
    }
  return false;
}

QString themeName(ThemeChoice choice) {
  switch (choice) {
  case ThemeChoice::Dark:
    return QStringLiteral("dark");
  case ThemeChoice::Light:
    return QStringLiteral("light");
  case ThemeChoice::System:
    break;
  }
  return QStringLiteral("system");
}

} // namespace taa::app
