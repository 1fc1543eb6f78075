// Pixels of which somebody who looked at the frames said what is wrong: what verdicts are held against.
#pragma once

#include "core/settings/Stage.h"
#include "core/verdict/pixel/PixelVerdict.h"

#include <glm/vec2.hpp>

#include <string>
#include <vector>

namespace taa::test {

/// Size of the pictures that were looked at, pixels.
inline constexpr glm::ivec2 kLabelledSize{320, 180};

/// Said from pictures of some frames around it, of the resolve and of the reference, not from a verdict.
struct VerdictLabel {
  std::string scene, preset; ///< "fan" of builtin:fan; a built-in preset
  int frame = 0;
  glm::ivec2 pixel{0};
  VerdictKind kind = VerdictKind::None;
  std::vector<Stage>
      stages;      ///< the one that is to blame; two or three where each of them would have mended it
  std::string why; ///< what is seen there
};

/// Lines of "scene,preset,frame,x,y,kind,stages,why" below a line of these names; stages with | between.
/// Throws Error naming `place` and the line.
std::vector<VerdictLabel> verdictLabelsFrom(const std::string& text, const std::string& place);

/// The table beside this file.
std::vector<VerdictLabel> verdictLabels();

/// A label, and the verdict on its pixel.
struct JudgedLabel {
  VerdictLabel label;
  VerdictKind kind = VerdictKind::None;
  Stage stage = Stage::Reference;

  bool isKindRight() const { return kind == label.kind; }
  bool isStageRight() const;
};

/// Shares that are right, 0 to 1; 0 of no labels.
struct VerdictShares {
  double kind = 0.0, stage = 0.0;
  double faultsStage = 0.0; ///< of the labels that have something wrong
};

VerdictShares sharesRight(const std::vector<JudgedLabel>& judged);

/// A page of the manual: the shares, kinds that were said against kinds that verdicts name, and each label
/// whose verdict is another.
std::string confusionsPage(const std::vector<JudgedLabel>& judged);

} // namespace taa::test
