// A verdict's values and remedies in words.
#pragma once

#include "core/inspect/VerdictOfShot.h"

#include <QString>

#include <string>

namespace taa::app {

/// "path=value" by the table of settings: "Rectify history ▸ Method: Clip to filtered".
QString changeText(const std::string& assignment);
/// All changes of a remedy, one a line.
QString changesText(const Remedy& remedy);
/// "This pixel, last 4 frames: off by 31.2 → 4.1 of 255"
QString pixelEffectText(const RemedyAnswer& of, const TriedRemedy& tried);
/// "Picture: error 3.1 → 3, ghost 2.4 → 1.1, flicker 1.2 → 1.3, sharpness 92 % → 95 %", the first three of
/// 255
QString pictureEffectText(const RemedyAnswer& of, const TriedRemedy& tried);

/// Both, and whether the verdict names the setting.
QString remedyEffectsText(const RemedyAnswer& of, const TriedRemedy& tried);

/// What decided: "0.31", "0.31, limit 0.1", or a reason in words.
QString rowValueText(const VerdictRow& row);
/// Luma of a part of the error or of all of it, scene-linear: above 0 the pixel is too bright by it.
double partLuma(const glm::dvec3& part);

} // namespace taa::app
