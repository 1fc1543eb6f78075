#include "app/views/legend/Legend.h"

#include "app/style/Numbers.h"
#include "app/style/PictureImage.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "app/views/legend/RangeMath.h"

#include "core/picture/ColorMap.h"
#include "core/taa/ChannelNames.h"

#include <QImage>
#include <QObject>
#include <QPainter>
#include <QPolygonF>
#include <QStringList>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace taa::app {

namespace {

constexpr int kBarWidth = 96, kShortBarWidth = 40, kBarHeight = 8;

QRgb rgbOf(const std::array<float, 3>& linear) {
  return shownColor({linear[0], linear[1], linear[2]}).rgb();
}

QImage mapBar(ColorMap map) {
  QImage bar(scaled(kBarWidth) * 2, 1, QImage::Format_RGB32);
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
      disk.setPixel(x, y, rgbOf(vectorColor({dx, dy}, length)));
    }
  return disk;
}

QString channelText(const LegendSide& side) {
  if (side.row.channels == 1) return {};
  QString shown;
  const std::vector<std::string> names = channelNames(side.row, side.space);
  for (int channel = 0; channel < side.row.channels; ++channel)
    if (isShown(side.style, channel)) {
      if (!shown.isEmpty()) shown += QLatin1Char(' ');
      shown += QString::fromStdString(names[static_cast<std::size_t>(channel)]);
    }
  return shown;
}

/// The value farthest from 0 in the range, as in shaders/inspect/visual_color.glsl.
double extent(const ViewStyle& style) {
  return std::max(std::abs(style.low), std::abs(style.high));
}

/// Writes items of one look.
class Writer {
 public:
  Writer(LegendFlow& flow, const ThemeColors& colors) : flow_(flow), colors_(colors) {}
  void plain(const QString& text) { flow_.text(text, secondaryFont(), colors_.text); }
  void quiet(const QString& text) { flow_.text(text, secondaryFont(), colors_.secondary); }
  void digits(const QString& text) { flow_.text(text, numberFont(), colors_.text); }
  void icon(int width, int height, LegendFlow::PaintIcon paint) {
    flow_.icon({width, height}, std::move(paint));
    flow_.glue();
  }
  void swatch(int category) {
    const QColor color(rgbOf(categoryColor(category)));
    icon(scaled(kBarHeight), scaled(kBarHeight),
         [color, line = colors_.secondary](QPainter& painter, const QRect& place) {
           painter.fillRect(place, line); // the darkest is not seen on a dark ground
           painter.fillRect(place.adjusted(1, 1, -1, -1), color);
         });
  }
  LegendFlow& flow() { return flow_; }

 private:
  LegendFlow& flow_;
  const ThemeColors& colors_;
};

/// "1.2 %", exact enough that nothing that is there is 0.
QString shareText(int count, int total) {
  return percentText(100.0 * count / std::max(1, total));
}

static_assert(kReasonCount == static_cast<int>(intermediate(IntermediateId::rejectReason).high) + 1);

/// The reasons that are in the picture, with their numbers, which large texels hold, and their shares.
void addReasons(Writer& writer, const ReasonCounts& counts, const ReasonCounts* other, bool withKept) {
  bool isAny = false;
  for (int reason = withKept ? 0 : 1; reason < kReasonCount; ++reason) {
    const auto index = static_cast<std::size_t>(reason);
    if (counts[index] == 0 && !(other && (*other)[index] > 0)) continue;
    isAny = true;
    writer.swatch(reason);
    QString share = shareText(counts[index], totalOf(counts));
    if (other) share += QStringLiteral(" | ") + shareText((*other)[index], totalOf(*other));
    writer.plain(QObject::tr("%1 %2 · %3").arg(reason).arg(qtext(rejectReasonText(reason)), share));
  }
  if (!isAny) writer.plain(QObject::tr("nothing is rejected in this picture"));
}

void addCategories(Writer& writer, const Intermediate& row) {
  const int last = std::min(static_cast<int>(row.high), kCategoryCount - 1);
  for (int number = 0; number <= last; ++number) {
    writer.swatch(number);
    writer.digits(QString::number(number));
    if (const std::string_view text = categoryText(row.id, number); !text.empty()) {
      writer.flow().glue();
      writer.plain(qtext(text));
    }
  }
}

// Signed values have 0 in the middle of their map, whatever the range.
void addMapScale(Writer& writer, const Intermediate& row, const ViewStyle& style, int width) {
  const bool isSigned = row.visual == Visual::Signed || row.visual == Visual::Vector;
  writer.digits(shortText(isSigned ? -extent(style) : style.low));
  writer.flow().glue();
  writer.icon(scaled(width), scaled(kBarHeight), [map = style.map](QPainter& painter, const QRect& place) {
    painter.drawImage(place, mapBar(map));
  });
  writer.digits(shortText(isSigned ? extent(style) : style.high));
}

void addScale(Writer& writer, const LegendSide& side, int barWidth = kBarWidth) {
  const Intermediate& row = side.row;
  const ViewStyle& style = side.style;
  if (row.visual == Visual::Vector && shownChannels(row, style) > 1) {
    writer.icon(legendHeight() - 4, legendHeight() - 4, [](QPainter& painter, const QRect& place) {
      const int ratio = std::max(1, static_cast<int>(painter.device()->devicePixelRatioF()));
      painter.drawImage(place, hueDisk(place.height() * ratio));
    });
    writer.digits(QStringLiteral("≤ %1").arg(shortText(extent(style))));
  } else if (row.id == IntermediateId::rejectReason && row.visual == Visual::Index && side.reasons) {
    addReasons(writer, *side.reasons, nullptr, true);
  } else if (row.visual == Visual::Index) {
    addCategories(writer, row);
  } else if (usesColorMap(row, style)) {
    addMapScale(writer, row, style, barWidth);
  } else if (hasRange(row)) {
    writer.digits(QObject::tr("range %1 … %2").arg(shortText(style.low), shortText(style.high)));
  }
}

/// The checkers that the shader draws where there is no value.
void addAbsence(Writer& writer, const QString& meaning) {
  constexpr int kCells = 3, kSide = static_cast<int>(kNothingSide);
  writer.icon(kCells * kSide, kCells * kSide, [](QPainter& painter, const QRect& place) {
    for (int cell = 0; cell < kCells * kCells; ++cell) {
      const float light = kNothingLight[cell % 2 == 0 ? 0 : 1];
      painter.fillRect(place.left() + cell % kCells * kSide, place.top() + cell / kCells * kSide, kSide,
                       kSide, QColor(rgbOf({light, light, light})));
    }
  });
  writer.plain(meaning);
}

} // namespace

QString rowName(const LegendSide& side) {
  const QString label = qtext(side.row.label);
  return side.isDifference ? QObject::tr("%1, difference").arg(label) : label;
}

void addRowLegend(LegendFlow& flow, const LegendSide& side, const ThemeColors& colors) {
  const Intermediate& row = side.row;
  const ViewStyle& style = side.style;
  Writer writer(flow, colors);
  flow.startLine();
  writer.plain(rowName(side));
  addScale(writer, side);
  writer.quiet(qtext(row.unit));
  if (row.visual == Visual::Depth) writer.quiet(QObject::tr("logarithmic"));
  if (hasExposure(row) && style.exposure != 0)
    writer.digits(QStringLiteral("EV %1%2").arg(style.exposure > 0 ? QStringLiteral("+") : QString(),
                                                shortText(style.exposure)));
  writer.quiet(channelText(side));
  writer.plain(side.note);
  if (!side.absence.isEmpty()) addAbsence(writer, side.absence);
  if (!side.isDifference) return;
  writer.quiet(row.channels > 1
                   ? QObject::tr("of the values: this minus other, the channel that differs most")
                   : QObject::tr("of the values: this minus other"));
}

void addScaleLegend(LegendFlow& flow, const LegendSide& side, const ThemeColors& colors) {
  Writer writer(flow, colors);
  flow.startLine();
  // Word by word: a long name goes on in the next line.
  for (const QString& word : rowName(side).split(QLatin1Char(' '))) writer.plain(word);
  if (side.row.visual != Visual::Index) addScale(writer, side, kShortBarWidth);
  flow.glue();
  flow.text(QStringLiteral("⋯"), secondaryFont(), colors.accent);
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

/// An arrow as the shader draws it, white with a dark edge; `place` is as long as it is.
void paintArrow(QPainter& painter, const QRect& place) {
  constexpr double kHead = 6, kHalfShaft = 0.75;
  const double left = place.left(), right = left + place.width(), y = place.center().y() + 0.5;
  const double neck = right - std::min(kHead, place.width() / 2.0), half = (right - neck) / 2;
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(Qt::black, 2));
  painter.setBrush(Qt::white);
  const QPolygonF outline({{left, y - kHalfShaft},
                           {neck, y - kHalfShaft},
                           {neck, y - half},
                           {right, y},
                           {neck, y + half},
                           {neck, y + kHalfShaft},
                           {left, y + kHalfShaft}});
  painter.drawPolygon(outline);
  painter.setPen(Qt::NoPen);
  painter.drawPolygon(outline);
  painter.setRenderHint(QPainter::Antialiasing, false);
}

void paintDot(QPainter& painter, const QRect& place) {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(Qt::black, 1));
  painter.setBrush(Qt::white);
  painter.drawEllipse(QRectF(place).center(), 1.5, 1.5);
  painter.setRenderHint(QPainter::Antialiasing, false);
}

/// How long an arrow is, what a dot means, and which way they point.
void addArrows(Writer& writer, const Intermediate& row, const ViewStyle& style,
               const ViewTransform& transform) {
  const ArrowScale scale = arrowScale(transform);
  const QString unit = qtext(row.unit);
  writer.icon(static_cast<int>(std::lround(scale.longest)), legendHeight() - 8, paintArrow);
  writer.plain(QObject::tr("= %1 %2 or more, shorter in proportion").arg(shortText(extent(style)), unit));
  writer.icon(6, 6, paintDot);
  writer.plain(QObject::tr("= still: less than %1 %2")
                   .arg(shortText(extent(style) * static_cast<double>(scale.minShare), 2), unit));
  writer.quiet(row.id == IntermediateId::dilatedOffset ? QObject::tr("arrows point to the neighbor")
                                                       : QObject::tr("arrows point where it moves to"));
}

void addHatches(Writer& writer) {
  constexpr int kSwatchWidth = 18, kSwatchHeight = 12;
  for (const bool isAbove : {true, false}) {
    writer.icon(scaled(kSwatchWidth), scaled(kSwatchHeight),
                [isAbove](QPainter& painter, const QRect& place) {
                  paintHatch(painter, place, isAbove ? kAboveColor : kBelowColor, isAbove);
                });
    writer.plain(isAbove ? QObject::tr("above the range") : QObject::tr("below it"));
  }
}

} // namespace

void addOverlayLegend(LegendFlow& flow, const LegendSide& side, const ReasonCounts* other,
                      const ViewTransform& transform, const ThemeColors& colors) {
  const Intermediate& row = side.row;
  const ViewStyle& style = side.style;
  Writer writer(flow, colors);
  flow.startLine();
  if (style.arrows && row.visual == Visual::Vector && !side.isDifference)
    addArrows(writer, row, style, transform);
  if (style.markClipped && hasRange(row)) addHatches(writer);
  if (style.outlineObjects) writer.plain(QObject::tr("dashes: between objects"));
  if (!style.markRejected || !side.reasons) return;
  flow.startLine();
  addReasons(writer, *side.reasons, other, false);
}

} // namespace taa::app
