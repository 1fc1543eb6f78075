// How much a pixel moves with each thing that it is made of: exact derivatives of the resolve, by the CPU
// twin.
#pragma once

#include "core/base/Image.h"
#include "core/base/Progress.h"
#include "core/settings/Settings.h"
#include "core/taa/twin/Twin.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace taa {

enum class SensitivityTo : std::uint8_t { Sample, History, Parameter };
std::string_view sensitivityLabel(SensitivityTo to);

/// d resolved / d something, in this frame: history is taken as it is, whatever made it.
struct Sensitivity {
  SensitivityTo to{};
  glm::ivec2 texel{0};        ///< of what was drawn (Sample), of the picture's history (History)
  glm::ivec2 offset{0};       ///< of it from the pixel's own
  std::string_view path = {}; ///< Parameter: "neighborhood.gamma"
  double value = 0.0;         ///< Parameter: the present one
  /// Of R, G and B by it, to the side where it grows; by a texel: by its three channels, brightened alike.
  glm::dvec3 slope{0.0};
  /// Where it falls the slope is another, or may be: two things that are compared are the same here.
  bool isOneSided = false;

  /// A step that one would try: of a parameter a tenth of its value, or of its range where it is 0; of a
  /// texel 1.
  double step() const;
  glm::dvec3 change() const { return slope * step(); } ///< of R, G and B by that step
  double lumaChange() const;                           ///< Rec. 709
};

/// Of everything that the resolve of the pixel reads: samples, texels of history and numbers of the settings;
/// groups in this order, in each what changes luma most first. Left out is what has no slope.
/// Rounding to how history is stored passes slopes on. What is taken in whole steps has none: eighths of a
/// frame (weight.referenceRate) and 256ths of a power (output.amount of logarithms).
std::vector<Sensitivity> sensitivitiesOf(const twin::Inputs& inputs, const Settings& settings,
                                         const glm::ivec2& pixel);

/// d resolved / d a number of the settings, the row of `path` (ParameterKind::Number).
glm::dvec3 sensitivityTo(std::string_view path, const twin::Inputs& inputs, const Settings& settings,
                         const glm::ivec2& pixel);

/// A number of the settings over a picture.
struct SensitivityMap {
  Sensitivity number; ///< its path, its value and the step; of no pixel
  Image change;       ///< of R, G and B of the resolved color by that step, to the side where it grows
  double share = 0.0; ///< of the pixels whose luma moves
  double mean = 0.0, largest = 0.0; ///< |change of luma|
  glm::ivec2 largestAt{0};
};
/// Of the row of `path` (ParameterKind::Number). Inputs are read from several threads: they must be there
/// (TwinReading::Whole). Throws Cancelled.
SensitivityMap sensitivityMap(std::string_view path, const twin::Inputs& inputs, const Settings& settings,
                              const Progress& progress = {});
/// "γ 1 → 1.1 moves luma in 43.2 % of the pixels, by 0.0012 on average and at most by 0.12 at 33, 40".
std::string sensitivityMapText(const SensitivityMap& map);

/// What moves, and by how much: "γ 1 → 1.1", "sample (−1, 0) + 1".
std::string sensitivityText(const Sensitivity& sensitivity);

} // namespace taa
