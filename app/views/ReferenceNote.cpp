#include "app/views/ReferenceNote.h"

#include <QObject>

#include <cmath>

namespace taa::app {

QString referenceNote(const ViewResult& result) {
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
