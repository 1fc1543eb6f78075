// Colors and type of the window: neutral grays, one accent, three sizes of text.
#pragma once

#include <QColor>
#include <QFont>
#include <QString>

class QApplication;
class QPalette;
class QWidget;

namespace taa::app {

/// What the user wants; System follows the desktop.
enum class ThemeChoice { System, Dark, Light };

struct ThemeColors {
  QColor window, panel, field, line, text, secondary; ///< grays
  QColor surround;                                    ///< around a picture
  QColor accent, onAccent;                            ///< selection, focus, playhead
  QColor hover;                                       ///< a control under the mouse
  QColor wrong, caution, right;                       ///< always beside a shape or a word
};

const ThemeColors& darkColors();
const ThemeColors& lightColors();

/// Whether the desktop asks for dark; dark too when it says nothing.
bool isSystemDark();

/// Sets style, palette, fonts and style sheet of the whole program.
void applyTheme(QApplication& application, ThemeChoice choice);

/// The colors in force where a palette is used.
const ThemeColors& themeColors(const QPalette& palette);
const ThemeColors& themeColors(const QWidget* widget);

/// 9 pt for secondary text, 12 pt for titles; the body's 10 pt is every widget's font. All times textScale().
QFont secondaryFont();
QFont titleFont();
/// Tabular figures; `points` 9, 10 or 12.
QFont numberFont(int points = 9);

inline constexpr int kUnit = 4;                ///< all distances are multiples of it
inline constexpr int kListPadding = 2 * kUnit; ///< at either side of a line of a list, px

/// How large text is now, of the sizes above: 1 to 2 (TextSize.h).
double textScale();
/// A length beside text, px where text has its own size, as it is now.
int scaled(int length);
double scaled(double length);
inline int rowHeight() {
  return scaled(22);
}

/// "dark", "light" or "system"; anything else: nothing is changed and false is returned.
bool parseTheme(const QString& text, ThemeChoice& choice);
QString themeName(ThemeChoice choice);

} // namespace taa::app
