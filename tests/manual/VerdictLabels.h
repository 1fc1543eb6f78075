// Pixels of which somebody who looked at the frames said what is wrong, and what verdicts say of them: two
// tables, the second written by a test.
#pragma once

#include "core/settings/Stage.h"
#include "core/verdict/pixel/PixelVerdict.h"

#include <glm/vec2.hpp>

#include <string>
#include <vector>

namespace taa {

/// Size of the pictures that were looked at, pixels.
inline constexpr glm::ivec2 kLabelledSize{320, 180};

/// Said from pictures of some frames around it, of the resolve and of the reference, not from a verdict.
struct VerdictLabel {
  std::string scene, preset; ///< "fan" of builtin:fan; a built-in preset
  int frame = 0;
  glm::ivec2 pixel{0};
  VerdictKind kind = VerdictKind::None;
  std::vector<Stage>
      stages;      ///< the one that is to blame; two or three where each of them would have corrected it
  std::string why; ///< what is seen there
};

/// The first remedy that is told of a pixel, or none; all 0 where none was tried.
struct LabelRemedy {
  std::string changes; ///< "rectify.method=clipToFiltered", with blanks between several; empty: none helps
  double pixelBefore = 0.0, pixelAfter = 0.0;     ///< RemedyMeasure::latest of the pixel, in steps of 255
  double pictureBefore = 0.0, pictureAfter = 0.0; ///< RemedyMeasure::error of the whole picture
};

/// A label, and the verdict on its pixel.
struct JudgedLabel {
  VerdictLabel label;
  VerdictKind kind = VerdictKind::None;
  Stage stage = Stage::Reference;
  LabelRemedy remedy;

  bool isKindRight() const { return kind == label.kind; }
  bool isStageRight() const;
};

/// Lines of "scene,preset,frame,x,y,kind,stages,why" below a line of these names; stages with | between.
/// Throws Error naming `place` and the line.
std::vector<VerdictLabel> verdictLabelsFrom(const std::string& text, const std::string& place);

/// The same with what verdicts say before `why`: "named,stage,remedy,pixelBefore,pixelAfter,pictureBefore,
/// pictureAfter".
std::vector<JudgedLabel> judgedLabelsFrom(const std::string& text, const std::string& place);
std::string judgedLabelsText(const std::vector<JudgedLabel>& judged);

inline constexpr const char* kJudgedLabelsFile = "tests/manual/verdicts.csv";
/// Those of that file of the repository. Throws Error.
std::vector<JudgedLabel> judgedLabels();

} // namespace taa
