// Of which rows a record says something.
#pragma once

#include "core/taa/twin/Twin.h"

#include <cmath>

namespace taa {

/// Whether the row tells of history: in a frame without one there is no value. (What is only a factor or a
/// setting of a later stage stays at the value that changes nothing.)
constexpr bool isOfHistory(IntermediateId id) {
  switch (id) {
  case IntermediateId::historyRaw:
  case IntermediateId::historyRawLength:
  case IntermediateId::depthEdge:
  case IntermediateId::historyRectified:
  case IntermediateId::clipAmount:
  case IntermediateId::historyKeptLength:
  case IntermediateId::historyDepth:
  case IntermediateId::depthMismatch:
  case IntermediateId::historyObjectId:
  case IntermediateId::normalAgreement:
  case IntermediateId::velocityChange:
  case IntermediateId::toneWeightHistory:
    return true;
  default:
    return false;
  }
}

namespace twin {

/// Whether there was no history when the record was made.
inline bool isFirst(const PixelRecord& record) {
  return at(record, IntermediateId::rejectReason).x == 1.0f; // RejectReason::NoHistory
}

/// Whether the record says something about the row: not one of the reference where there was none, nor one of
/// history where there is none yet. (Where the reference itself is NaN its rows look as if there was none.)
inline bool isKnown(const PixelRecord& record, IntermediateId id) {
  if (isOfReference(id)) return !std::isnan(at(record, id).x);
  return !isOfHistory(id) || !isFirst(record);
}

} // namespace twin

} // namespace taa
