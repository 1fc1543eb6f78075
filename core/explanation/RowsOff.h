// Which intermediates stand still because what they tell of is switched off.
#pragma once

#include "core/settings/Settings.h"
#include "core/taa/Intermediates.h"

namespace taa {

/// Whether the settings switch off what the row tells of, so that it has the value that changes nothing in
/// every pixel of every frame. The explanations of such rows say so: explainRow().
inline bool isRowOff(IntermediateId id, const Settings& settings) {
  const WeightSettings& weight = settings.weight;
  switch (id) {
  case IntermediateId::depthEdge:
    return !isOn(settings.history.bilinearAtEdges);
  case IntermediateId::geometricFlicker:
    return !findsFlicker(settings);
  case IntermediateId::normalAgreement:
    return !isOn(settings.validate.normal);
  case IntermediateId::velocityChange:
    return settings.validate.velocity == VelocityTest::None && !isOn(weight.velocityChange);
  case IntermediateId::lock:
  case IntermediateId::lockLife:
    return !isOn(settings.rectify.locks);
  case IntermediateId::instability:
    return !isOn(settings.rectify.instability);
  case IntermediateId::alphaLumaFlicker:
    return !isOn(weight.lumaFlicker);
  case IntermediateId::alphaNearClamp:
    return !isOn(weight.nearClamp);
  case IntermediateId::alphaHistoryContrast:
    return !isOn(weight.historyContrast);
  case IntermediateId::alphaRelax:
    return !isOn(settings.neighborhood.maskRelax);
  case IntermediateId::alphaSampleDistance:
    return weight.sampleDistance == SampleDistance::None;
  case IntermediateId::alphaMotion:
    return weight.motion == MotionAlpha::None;
  case IntermediateId::alphaVelocityChange:
    return !isOn(weight.velocityChange);
  case IntermediateId::alphaDivergence:
    return !isOn(weight.divergence);
  case IntermediateId::alphaMask:
    return weight.mask == MaskAlpha::Off;
  case IntermediateId::sharpenDetail:
    return settings.output.sharpen == Sharpen::None;
  case IntermediateId::blurTrust:
    return !isOn(settings.output.motionBlur);
  default:
    return false;
  }
}

} // namespace taa
