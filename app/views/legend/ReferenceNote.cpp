#include "app/views/legend/ReferenceNote.h"

#include "app/style/Text.h"
#include "core/measure/MetricTable.h"

#include <QObject>

#include <cmath>
#include <optional>

namespace taa::app {

namespace {

QString overTimeNote(const ViewResult& result) {
  if (!result.overTimeSamples) return QObject::tr("not measured yet: comes while paused");
  const std::optional<Metric> metric = metricOfMap(result.request.id);
  if (metric && !result.number) return QObject::tr("nothing in this frame was seen before");
  const QString mean = metric ? QObject::tr("mean %1").arg(*result.number, 0, 'f', 5) : QString();
  if (!needsReference(result.request.id)) return mean;
  if (!metric) return QObject::tr("%1 samples").arg(*result.overTimeSamples);
  return QObject::tr("%1 samples · %2").arg(*result.overTimeSamples).arg(mean);
}

QString errorText(const PictureError& error) {
  const QString psnr =
      std::isinf(error.psnr) ? QStringLiteral("∞") : QStringLiteral("%1 dB").arg(error.psnr, 0, 'f', 1);
  return QObject::tr("RMSE %1 · PSNR %2").arg(error.rmse, 0, 'f', 4).arg(psnr);
}

QString numberText(Metric metric, double number) {
  return QObject::tr("%1 %2").arg(qtext(metricInfo(metric).label)).arg(number, 0, 'f', 4);
}

QString engineNote(const ViewResult& result) {
  if (!result.error) return QObject::tr("only a capture that holds an engine's output has it");
  return QObject::tr("against ours: %1").arg(errorText(*result.error));
}

} // namespace

QString referenceNote(const ViewResult& result) {
  if (isOverTime(result.request.id)) return overTimeNote(result);
  if (isOfEngine(result.request.id)) return engineNote(result);
  if (!isOfReference(result.request.id)) return {};
  if (result.referenceSamples == 0 || !result.error) return QObject::tr("not drawn yet: comes while paused");
  const std::optional<Metric> metric = metricOfMap(result.request.id);
  const QString text =
      metric && result.number ? numberText(*metric, *result.number) : errorText(*result.error);
  if (result.isReferenceGiven) return QObject::tr("the capture's own · %1").arg(text);
  return QObject::tr("%1 samples · %2").arg(result.referenceSamples).arg(text);
}

} // namespace taa::app
