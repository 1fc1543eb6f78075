// Findings of what pictures refute: where, when, by how much, and the best explanation of it, or none.
#pragma once

#include "core/doctor/CaptureInfo.h"
#include "core/doctor/Diagnosis.h"
#include "core/doctor/flow/FlowFit.h"
#include "core/doctor/flow/Refuted.h"

#include <optional>
#include <string>
#include <vector>

namespace taa::doctor {

inline constexpr double kOffPx = 0.5; ///< what pictures alias by is less

bool isOfMotion(const Finding& finding);

/// Whether what is given is 0 in nearly all of them.
bool areAllZero(const std::vector<const FlowSquare*>& squares);

/// Where pictures move most otherwise than is given, in numbers. Expects squares of `seen`.
std::string exampleOf(const std::vector<const FlowSquare*>& squares, const FlowSeen& seen,
                      const CaptureInfo& captureInfo);

/// Regions, frames and numbers, whatever explains them; its change is an example.
Finding measuredFinding(const std::vector<Refuted>& refuted, const FlowSeen& seen,
                        const CaptureInfo& captureInfo, const Diagnosis& out);

/// Names it by a frame that is missing, else by `fit`, which may be none, else by a zoom, else as unknown.
void nameBest(const std::optional<FlowFit>& fit, const std::vector<Refuted>& refuted, const FlowSeen& seen,
              const CaptureInfo& captureInfo, double tolerancePx, Finding& finding);

/// Of what pictures refute, and whatever explains all of it best.
Finding bestFinding(const std::vector<Refuted>& refuted, const FlowSeen& seen, const CaptureInfo& captureInfo,
                    double tolerancePx, const Diagnosis& out);

} // namespace taa::doctor
