#include "app/doctor/DoctorWords.h"

#include "app/style/Numbers.h"
#include "app/style/Text.h"

#include <QCoreApplication>
#include <QStringList>

namespace taa::app {

namespace {

struct DoctorWords {
  Q_DECLARE_TR_FUNCTIONS(taa::app::DoctorWords)
};

IntermediateId rowOfPart(FaultPart part) {
  switch (part) {
  case FaultPart::Jitter:
    return IntermediateId::color;
  case FaultPart::Motion:
    return IntermediateId::motion;
  case FaultPart::Depth:
    return IntermediateId::depthView;
  case FaultPart::Color:
    return IntermediateId::color;
  case FaultPart::Resolve:
    return IntermediateId::resolved;
  }
  return IntermediateId::resolved;
}

} // namespace

QString confidenceText(doctor::Confidence confidence) {
  return confidence == doctor::Confidence::Sure ? DoctorWords::tr("sure") : DoctorWords::tr("likely");
}

QString whereText(const doctor::Finding& finding) {
  if (finding.isWholePicture || finding.regions.empty()) return DoctorWords::tr("the whole picture");
  QStringList names;
  for (const doctor::RegionPlace& region : finding.regions) names << qtext(region.name);
  return names.join(QStringLiteral(", "));
}

QString placeText(const doctor::RegionPlace& place) {
  if (place.isWholeFrame) return qtext(place.name);
  return DoctorWords::tr("%1: %2 of all pixels, largest in frame %3")
      .arg(qtext(place.name), percentText(100.0 * place.share))
      .arg(place.frame);
}

IntermediateId shownRow(const doctor::Finding& finding) {
  const auto part = doctor::partOf(finding);
  return part ? rowOfPart(*part) : IntermediateId::resolved;
}

} // namespace taa::app
