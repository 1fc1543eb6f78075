#include "app/views/Legend.h"

#include "app/Numbers.h"
#include "app/Text.h"
#include "app/Theme.h"
#include "app/views/RangeMath.h"

#include "core/inspect/ColorMap.h"

#include <QFontMetrics>
#include <QImage>
#include <QObject>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace taa::app {

namespace {

constexpr int kBarWidth = 96, kBarHeight = 8;
// Gray as light as the cyclic map, as in shaders/inspect/visual_color.glsl.
constexpr float kNeutral = kCyclicLightness * kCyclicLightness * kCyclicLightness;

QRgb rgbOf(const std::array<float, 3>& linear) {
  const auto byte = [](float value) { return static_cast<int>(std::lround(255.0f * srgbEncoded(value))); };
  return qRgb(byte(linear[0]), byte(linear[1]), byte(linear[2]));
}

QImage mapBar(ColorMap map) {
  QImage bar(kBarWidth * 2, 1, QImage::Format_RGB32);
  for (int x = 0; x < bar.width(); ++x)
    bar.setPixel(x, 0,
                 rgbOf(mapColor(map, (static_cast<float>(x) + 0.5f) / static_cast<float>(bar.width()))));
  return bar;
}

/// Direction as hue, length as saturation: the key to a motion view.
QImage hueDisk(int size) {
  QImage disk(size, size, QImage::Format_ARGB32);
  disk.fill(Qt::transparent);
  const float radius = static_cast<float>(size) / 2;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const float dx = (static_cast<float>(x) + 0.5f) / radius - 1,
                  dy = (static_cast<float>(y) + 0.5f) / radius - 1;
      const float length = std::hypot(dx, dy);
      if (length > 1) continue;
      const float turn = std::atan2(dy, dx) / (2 * std::numbers::pi_v<float>);
      std::array<float, 3> color = mapColor(ColorMap::Cyclic, turn - std::floor(turn));
      for (float& channel : color) channel = kNeutral + length * (channel - kNeutral);
      disk.setPixel(x, y, rgbOf(color));
    }
  return disk;
}

QString channelText(const Intermediate& row, const ViewStyle& style) {
  if (row.channels == 1) return {};
  QString shown;
  const std::vector<std::string> names = channelNames(intermediate(row.id)); // of a difference, too
  for (int channel = 0; channel < row.channels; ++channel)
    if (isShown(style, channel)) {
      if (!shown.isEmpty()) shown += QLatin1Char(' ');
      shown += QString::fromStdString(names[static_cast<std::size_t>(channel)]);
    }
  return shown;
}

/// Writes from the left and moves on; false when there is no room.
class Pen {
 public:
  Pen(QPainter& painter, const QRect& strip)
      : painter_(painter), left_(strip.left() + 2 * kUnit), strip_(strip) {}

  void write(const QString& text, const QFont& font, const QColor& color) {
    const int width = QFontMetrics(font).horizontalAdvance(text);
    if (text.isEmpty() || left_ + width > strip_.right() - kUnit) return;
    painter_.setFont(font);
    painter_.setPen(color);
    painter_.drawText(QRect(left_, strip_.top(), width + 1, strip_.height()),
                      Qt::AlignVCenter | Qt::AlignLeft, text);
    left_ += width + 2 * kUnit;
  }

  /// As write, but cut where it is narrow.
  void writeCut(const QString& text, const QFont& font, const QColor& color) {
    constexpr int kLeast = 48;
    const int room = strip_.right() - kUnit - left_;
    if (room >= kLeast) write(QFontMetrics(font).elidedText(text, Qt::ElideRight, room), font, color);
  }

  /// A picture of `width` with its text, or neither.
  QRect placeWith(int width, int height, const QString& text, const QFont& font) {
    const int both = width + kUnit + 2 + QFontMetrics(font).horizontalAdvance(text);
    return left_ + both > strip_.right() - kUnit ? QRect() : place(width, height);
  }

  /// Room for a picture of `width`, or an empty rectangle.
  QRect place(int width, int height) {
    if (left_ + width > strip_.right() - kUnit) return {};
    const QRect rect(left_, strip_.center().y() - height / 2 + 1, width, height);
    left_ += width + kUnit + 2;
    return rect;
  }

 private:
  QPainter& painter_;
  int left_;
  QRect strip_;
};

void paintGround(QPainter& painter, const QRect& strip, const ThemeColors& colors) {
  QColor ground = colors.panel;
  ground.setAlpha(232);
  painter.fillRect(strip, ground);
}

/// The value farthest from 0 in the range, as in shaders/inspect/visual_color.glsl.
double extent(const ViewStyle& style) {
  return std::max(std::abs(style.low), std::abs(style.high));
}

void paintScale(Pen& pen, QPainter& painter, const Intermediate& row, const ViewStyle& style,
                const ThemeColors& colors) {
  const QFont digits = numberFont();
  if (row.visual == Visual::Vector && shownChannels(row, style) > 1) {
    const int size = kLegendHeight - 4;
    if (const QRect place = pen.place(size, size); !place.isEmpty())
      painter.drawImage(place,
                        hueDisk(size * std::max(1, static_cast<int>(painter.device()->devicePixelRatioF()))));
    pen.write(QStringLiteral("≤ %1").arg(shortText(extent(style))), digits, colors.text);
  } else if (row.visual == Visual::Index) {
    const int last = std::min(static_cast<int>(row.high), kCategoryCount - 1);
    for (int number = 0; number <= last; ++number) {
      if (const QRect swatch = pen.place(kBarHeight, kBarHeight); !swatch.isEmpty())
        painter.fillRect(swatch, QColor(rgbOf(categoryColor(number))));
      pen.write(row.id == IntermediateId::rejectReason ? qtext(rejectReasonText(number))
                                                       : QString::number(number),
                row.id == IntermediateId::rejectReason ? secondaryFont() : digits, colors.text);
    }
  } else if (usesColorMap(row, style)) {
    // Signed values have 0 in the middle of their map, whatever the range.
    const bool isSigned = row.visual == Visual::Signed || row.visual == Visual::Vector;
    pen.write(shortText(isSigned ? -extent(style) : style.low), digits, colors.text);
    if (const QRect bar = pen.place(kBarWidth, kBarHeight); !bar.isEmpty())
      painter.drawImage(bar, mapBar(style.map));
    pen.write(shortText(isSigned ? extent(style) : style.high), digits, colors.text);
  } else if (hasRange(row)) {
    pen.write(QObject::tr("range %1 … %2").arg(shortText(style.low), shortText(style.high)), digits,
              colors.text);
  }
}

} // namespace

void paintLegend(QPainter& painter, const QRect& strip, const Intermediate& row, const ViewStyle& style,
                 bool isDifference, const ThemeColors& colors, const QString& note) {
  paintGround(painter, strip, colors);
  Pen pen(painter, strip);
  pen.write(isDifference ? QObject::tr("%1, difference").arg(qtext(row.label)) : qtext(row.label),
            secondaryFont(), colors.text);
  paintScale(pen, painter, row, style, colors);
  pen.write(qtext(row.unit), secondaryFont(), colors.secondary);
  if (row.visual == Visual::Depth) pen.write(QObject::tr("logarithmic"), secondaryFont(), colors.secondary);
  if (hasExposure(row) && style.exposure != 0)
    pen.write(QStringLiteral("EV %1%2").arg(style.exposure > 0 ? QStringLiteral("+") : QString(),
                                            shortText(style.exposure)),
              numberFont(), colors.text);
  pen.write(channelText(row, style), secondaryFont(), colors.secondary);
  pen.write(note, secondaryFont(), colors.text);
  if (isDifference)
    pen.writeCut(row.channels > 1
                     ? QObject::tr("of the values: this minus other, the channel that differs most")
                     : QObject::tr("of the values: this minus other"),
                 secondaryFont(), colors.secondary);
}

namespace {

/// A swatch of a hatch as the shader draws it, rising or falling.
void paintHatch(QPainter& painter, const QRect& place, const std::array<float, 3>& color, bool rises) {
  painter.fillRect(place, QColor(70, 70, 70));
  for (int y = 0; y < place.height(); ++y)
    for (int x = 0; x < place.width(); ++x)
      if ((rises ? x + y : x - y + 6 * place.height()) % 6 < 2)
        painter.fillRect(place.left() + x, place.top() + y, 1, 1, QColor(rgbOf(color)));
}

void paintReasons(QPainter& painter, const QRect& strip, const ThemeColors& colors) {
  paintGround(painter, strip, colors);
  Pen pen(painter, strip);
  const int last = static_cast<int>(intermediate(IntermediateId::rejectReason).high);
  for (int reason = 1; reason <= last; ++reason) {
    const QString text = qtext(rejectReasonText(reason));
    const QRect swatch = pen.placeWith(kBarHeight, kBarHeight, text, secondaryFont());
    if (swatch.isEmpty()) return;
    painter.fillRect(swatch, QColor(rgbOf(categoryColor(reason))));
    pen.write(text, secondaryFont(), colors.text);
  }
}

bool hasArrows(const Intermediate& row, const ViewStyle& style) {
  return style.arrows && row.visual == Visual::Vector;
}

bool hasMarks(const Intermediate& row, const ViewStyle& style) {
  return (style.markClipped && hasRange(row)) || style.outlineObjects || hasArrows(row, style);
}

} // namespace

int overlayLegendLines(const Intermediate& row, const ViewStyle& style) {
  return (hasMarks(row, style) ? 1 : 0) + (style.markRejected ? 1 : 0);
}

void paintOverlayLegend(QPainter& painter, QRect strip, const Intermediate& row, const ViewStyle& style,
                        const ThemeColors& colors) {
  if (style.markRejected) {
    paintReasons(painter, strip, colors);
    strip.translate(0, -kLegendHeight);
  }
  if (!hasMarks(row, style)) return;
  paintGround(painter, strip, colors);
  Pen pen(painter, strip);
  if (hasArrows(row, style)) {
    const QString longest = QStringLiteral("≥ %1 %2").arg(shortText(extent(style)), qtext(row.unit));
    pen.writeCut(row.id == IntermediateId::dilatedOffset
                     ? QObject::tr("arrows: to the neighbor, the longest %1").arg(longest)
                     : QObject::tr("arrows: where it moves to, the longest %1").arg(longest),
                 secondaryFont(), colors.text);
  }
  if (style.markClipped && hasRange(row)) {
    constexpr int kSwatchWidth = 18, kSwatchHeight = 12;
    for (const bool isAbove : {true, false}) {
      const QString text = isAbove ? QObject::tr("above the range") : QObject::tr("below it");
      const QRect place = pen.placeWith(kSwatchWidth, kSwatchHeight, text, secondaryFont());
      if (place.isEmpty()) break;
      paintHatch(painter, place, isAbove ? kAboveColor : kBelowColor, isAbove);
      pen.write(text, secondaryFont(), colors.text);
    }
  }
  if (style.outlineObjects)
    pen.writeCut(QObject::tr("dashes: between objects"), secondaryFont(), colors.text);
}

} // namespace taa::app
