#include "app/models/PlotRows.h"

#include "app/style/Text.h"

#include "core/render/FrameInputs.h"
#include "core/taa/ChannelNames.h"
#include "core/taa/twin/Known.h"

#include <QCoreApplication>
#include <QJsonObject>

#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace taa::app {

namespace {

constexpr std::array kDashes{Qt::SolidLine, Qt::DashLine, Qt::DotLine, Qt::DashDotLine, Qt::DashDotDotLine};
constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

std::vector<QPointF> pointsOf(const PixelTrace& trace, IntermediateId id, int channel) {
  std::vector<QPointF> points;
  int expected = 0;
  for (const auto& [frame, sample] : trace.samples()) {
    if (!points.empty() && frame != expected) points.emplace_back(expected, kNoValue);
    const float value = twin::at(sample.record, id)[channel];
    const bool isValue =
        twin::isKnown(sample.record, id) && std::isfinite(value) && std::abs(value) < kNoPreviousPosition;
    points.emplace_back(frame, isValue ? static_cast<double>(value) : kNoValue);
    expected = frame + 1;
  }
  return points;
}

QString probeName(std::size_t probe, const Probe& place) {
  return place.follow == Follow::Screen
             ? QStringLiteral("%1 (%2, %3)").arg(probe + 1).arg(place.pixel.x).arg(place.pixel.y)
             : QObject::tr("%1 surface").arg(probe + 1);
}

/// Curves of one intermediate; where two are on one axis their labels tell them apart.
void addCurves(std::vector<Curve>& curves, const PlotRow& row, IntermediateId id, const ProbeTrace& trace,
               std::size_t probe, const SpaceSettings& space) {
  const Intermediate& info = intermediate(id);
  const std::vector<std::string> channels = channelNames(info, space);
  for (int channel = 0; channel < info.channels; ++channel) {
    if (!row.has(channel)) continue;
    QString name = row.beside ? QLatin1Char(' ') + qtext(info.label) : QString();
    if (info.channels > 1)
      name += QLatin1Char(' ') + QString::fromStdString(channels[static_cast<std::size_t>(channel)]);
    const std::size_t number = curves.size();
    curves.push_back({probeName(probe, trace.probe) + name, curveColor(static_cast<int>(number)),
                      kDashes[number % kDashes.size()], pointsOf(trace.trace, id, channel),
                      QString::number(probe + 1) + name});
  }
}

} // namespace

std::vector<PlotRow> firstPlotRows() {
  constexpr unsigned kGreen = 0b10;
  return {{IntermediateId::resolved, kGreen, IntermediateId::currentFiltered},
          {IntermediateId::alpha},
          {IntermediateId::clipAmount},
          {IntermediateId::historyLength}};
}

QJsonArray toJson(const std::vector<PlotRow>& rows) {
  QJsonArray json;
  for (const PlotRow& row : rows) {
    QJsonArray channels;
    for (int channel = 0; channel < intermediate(row.id).channels; ++channel)
      if (row.has(channel)) channels.append(channel);
    QJsonObject object{{QStringLiteral("row"), qtext(intermediate(row.id).name)},
                       {QStringLiteral("channels"), channels}};
    if (row.beside) object.insert(QStringLiteral("beside"), qtext(intermediate(*row.beside).name));
    json.append(object);
  }
  return json;
}

std::vector<PlotRow> plotRowsFromJson(const QJsonArray& json) {
  const auto named = [](const QJsonValue& value) { return findIntermediate(value.toString().toStdString()); };
  std::vector<PlotRow> rows;
  for (const QJsonValue& value : json) {
    const QJsonObject object = value.toObject();
    const auto id = named(object.value(QLatin1String("row")));
    if (!id) continue;
    PlotRow row{.id = *id, .beside = named(object.value(QLatin1String("beside")))};
    const QJsonArray channels = object.value(QLatin1String("channels")).toArray();
    unsigned mask = 0;
    for (const QJsonValue& channel : channels)
      if (channel.toInt(-1) >= 0 && channel.toInt() < intermediate(*id).channels)
        mask |= 1u << channel.toInt();
    if (mask != 0) row.channels = mask;
    rows.push_back(row);
  }
  return rows;
}

QString plotTitle(const PlotRow& row) {
  const Intermediate& info = intermediate(row.id);
  const QString label = qtext(info.label);
  return info.unit.empty() ? label : QStringLiteral("%1, %2").arg(label, qtext(info.unit));
}

std::vector<Curve> plotCurves(const PlotRow& row, const std::vector<ProbeTrace>& traces,
                              const SpaceSettings& space) {
  std::vector<Curve> curves;
  for (std::size_t probe = 0; probe < traces.size(); ++probe) {
    addCurves(curves, row, row.id, traces[probe], probe, space);
    if (row.beside) addCurves(curves, row, *row.beside, traces[probe], probe, space);
  }
  return curves;
}

std::vector<ChartMark> plotMarks(const PixelTrace* active, const std::vector<int>& cuts,
                                 const std::vector<int>& restarts) {
  std::vector<ChartMark> marks;
  for (const int cut : cuts) marks.push_back({static_cast<double>(cut), MarkKind::Cut, QObject::tr("cut")});
  for (const int frame : restarts)
    marks.push_back({static_cast<double>(frame), MarkKind::Cut, QObject::tr("restart")});
  if (!active) return marks;
  for (const auto& [frame, sample] : active->samples()) {
    const int reason = static_cast<int>(twin::at(sample.record, IntermediateId::rejectReason).x);
    if (reason != 0)
      marks.push_back({static_cast<double>(frame), MarkKind::Reject, qtext(rejectReasonText(reason))});
  }
  return marks;
}

} // namespace taa::app
