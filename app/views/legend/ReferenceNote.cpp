#include "app/views/legend/ReferenceNote.h"

#include <QObject>

#include <cmath>

namespace taa::app {

namespace {

QString flickerNote(const ViewResult& result) {
  if (!result.flickerSamples) return QObject::tr("not measured yet: comes while paused");
  if (!result.flicker) return QObject::tr("nothing in this frame was seen before");
  const QString mean = QObject::tr("mean %1").arg(*result.flicker, 0, 'f', 5);
  if (!needsReference(result.request.id)) return mean;
  return QObject::tr("%1 samples · %2").arg(*result.flickerSamples).arg(mean);
}

} // namespace

QString referenceNote(const ViewResult& result) {
  if (isOverTime(result.request.id)) return flickerNote(result);
  if (!isOfReference(result.request.id)) return {};
  if (result.referenceSamples == 0 || !result.error) return QObject::tr("not drawn yet: comes while paused");
  const QString psnr = std::isinf(result.error->psnr)
                           ? QStringLiteral("∞")
                           : QStringLiteral("%1 dB").arg(result.error->psnr, 0, 'f', 1);
  return QObject::tr("%1 samples · RMSE %2 · PSNR %3")
      .arg(result.referenceSamples)
      .arg(result.error->rmse, 0, 'f', 4)
      .arg(psnr);
}

} // namespace taa::app
