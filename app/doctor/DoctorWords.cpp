#include "app/doctor/DoctorWords.h"

#include "app/style/Numbers.h"
#include "app/style/Text.h"
#include "core/settings/Faults.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <string>
#include <utility>

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

QString surenessText(doctor::Sureness sureness) {
  return sureness == doctor::Sureness::Sure ? DoctorWords::tr("sure") : DoctorWords::tr("likely");
}

QString whereText(const doctor::Finding& finding) {
  if (finding.isWholePicture || finding.regions.empty()) return DoctorWords::tr("the whole picture");
  QStringList names;
  for (const doctor::RegionPlace& region : finding.regions) names << qtext(region.name);
  return names.join(QStringLiteral(", "));
}

QString placeText(const doctor::RegionPlace& place) {
  return DoctorWords::tr("%1: %2 of all pixels, largest in frame %3")
      .arg(qtext(place.name), percentText(100.0 * place.share))
      .arg(place.frame);
}

// Findings that no fault of the table makes begin with what they are about.
IntermediateId shownRow(const doctor::Finding& finding) {
  for (const FaultInfo& fault : faultTable())
    if (fault.id == finding.id) return rowOfPart(fault.part);
  const std::pair<const char*, IntermediateId> beginnings[] = {{"jitter", IntermediateId::color},
                                                               {"depth", IntermediateId::depthView},
                                                               {"motion", IntermediateId::motion}};
  const auto* found =
      std::ranges::find_if(beginnings, [&](const auto& each) { return finding.id.starts_with(each.first); });
  return found == std::end(beginnings) ? IntermediateId::resolved : found->second;
}

} // namespace taa::app
