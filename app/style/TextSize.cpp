#include "app/style/TextSize.h"

#include "app/style/Theme.h"

#include <QAbstractButton>
#include <QApplication>
#include <QLayout>
#include <QVariant>
#include <QWidget>

#include <algorithm>
#include <cmath>

namespace taa::app {

namespace {

int gTextPercent = 100; ///< of the one application

/// A limit of this many px and fewer is a line's width, not a text's.
constexpr int kThinPx = 3;

/// A width from here on is that of a column or a list: its lines are wrapped or elided, and what stands
/// beside it keeps room, so it grows by half.
constexpr int kColumnPx = 200;
/// A least height from here on is that of a chart, which may stay as low.
constexpr int kChartPx = 60;
/// A margin from here on makes room for an icon.
constexpr int kIconMarginPx = 20;

/// `length` of an object, which keeps under `name` what it is by design and what it was set to: one that has
/// been changed since counts anew.
int resized(QObject& object, const char* name, int length, double before, bool mayBeColumn = false) {
  if (length <= kThinPx || length >= QWIDGETSIZE_MAX) return length;
  const auto grown = [](double byDesign, double scale, bool isColumn) {
    return byDesign * (isColumn ? 0.5 + 0.5 * scale : scale);
  };
  const QVariantList kept = object.property(name).toList();
  const bool isKept = kept.size() == 2 && kept[1].toInt() == length;
  const bool isColumn =
      mayBeColumn && (isKept ? kept[0].toDouble() : length / grown(1.0, before, true)) >= kColumnPx;
  const double byDesign = isKept ? kept[0].toDouble() : length / grown(1.0, before, isColumn);
  const int set = static_cast<int>(std::lround(grown(byDesign, textScale(), isColumn)));
  object.setProperty(name, QVariantList{byDesign, set});
  return set;
}

void resizeMargins(QLayout& layout, double before) {
  QMargins margins = layout.contentsMargins();
  if (margins.left() < kIconMarginPx) return;
  margins.setLeft(resized(layout, "leftMargin", margins.left(), before));
  layout.setContentsMargins(margins);
}

/// Parts of Qt's own widgets, and windows and docks, which are as small and as large as what they hold.
bool isSizedByQt(const QWidget& widget) {
  return (widget.isWindow() && widget.layout()) || widget.objectName().startsWith(QLatin1String("qt_")) ||
         widget.inherits("QDockWidget");
}

void resizeLimits(QWidget& widget, double before) {
  const QSize least = widget.minimumSize(), most = widget.maximumSize();
  const bool isFixed = least.width() == most.width();
  const QVariantList kept = widget.property("leastHeight").toList();
  const bool isKept = kept.size() == 2 && kept[1].toInt() == least.height();
  const bool isChart = least.height() != most.height() && least.height() >= kChartPx && !isKept;
  widget.setMinimumSize(0, 0); // else the old least would hold the new most up
  widget.setMaximumSize(resized(widget, "mostWidth", most.width(), before),
                        resized(widget, "mostHeight", most.height(), before));
  widget.setMinimumSize(resized(widget, "leastWidth", least.width(), before, !isFixed),
                        isChart ? least.height() : resized(widget, "leastHeight", least.height(), before));
  if (widget.layout()) resizeMargins(*widget.layout(), before);
  auto* button = qobject_cast<QAbstractButton*>(&widget);
  if (!button) return;
  const int icon = resized(widget, "iconSide", button->iconSize().width(), before);
  button->setIconSize({icon, icon});
}

} // namespace

double textScale() {
  return gTextPercent / 100.0;
}

int textPercent() {
  return gTextPercent;
}

int scaled(int length) {
  return static_cast<int>(std::lround(length * textScale()));
}

double scaled(double length) {
  return length * textScale();
}

void resizeText(int percent) {
  const double before = textScale();
  gTextPercent = std::clamp(percent, kMinTextPercent, kMaxTextPercent);
  for (QWidget* widget : QApplication::allWidgets()) {
    if (!isSizedByQt(*widget) && !widget->property(kKeepsLimits).toBool()) resizeLimits(*widget, before);
  }
}

// Fonts of widgets that have none of their own follow the application's. Qt gives fonts back that a widget
// had when a style sheet was first set: what a font is by design is kept here.
void fitFonts(int percentBefore) {
  constexpr double kFineness = 8.0; // sizes stay exact on the way there and back
  constexpr const char* kPoints = "pointsByDesign";
  for (QWidget* widget : QApplication::allWidgets()) {
    QFont font = widget->font();
    if (!widget->testAttribute(Qt::WA_SetFont) || font.pointSizeF() <= 0.0) continue;
    const QVariant kept = widget->property(kPoints);
    const double points = kept.isValid()
                              ? kept.toDouble()
                              : std::round(kFineness * font.pointSizeF() * 100.0 / percentBefore) / kFineness;
    widget->setProperty(kPoints, points);
    font.setPointSizeF(points * textScale());
    widget->setFont(font);
  }
}

} // namespace taa::app
