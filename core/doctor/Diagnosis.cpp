#include "core/doctor/Diagnosis.h"

#include "core/base/Say.h"

namespace taa::doctor {

Finding faultFinding(Fault fault) {
  const FaultInfo& row = faultInfo(fault);
  Finding out;
  out.id = row.id;
  out.name = sayLabel(row.label);
  out.symptom = sayLabel(row.symptom);
  return out;
}

} // namespace taa::doctor
