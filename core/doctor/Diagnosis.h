// What the doctor says: findings with their evidence, what could not be decided and why, and what was looked
// at.
#pragma once

#include "core/base/Image.h"
#include "core/doctor/FrameNames.h"
#include "core/doctor/Outline.h"
#include "core/settings/Faults.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace taa::doctor {

inline constexpr int kDoctorFrames = 32; ///< that are examined, unless somebody says otherwise
inline constexpr int kLeastDoctorFrames = 2, kMaxDoctorFrames = 1024;

/// A region by what people call it, and where it was nearly as large as ever.
struct RegionPlace {
  std::string name;    ///< "the sky", "object 7 (wheel)"
  int frame = 0;       ///< the last one like that …
  glm::ivec4 box{0};   ///< … what it lies in: left, top, first beyond right and bottom, px …
  glm::ivec2 pixel{0}; ///< … and one of its pixels
  double share = 0.0;  ///< of all pixels of all frames
  bool isSky = false;
  std::uint32_t objectId = 0;        ///< 0: the sky, or a part that no number says
  std::vector<PixelRun> pixels = {}; ///< all of them in that frame, see outlineOf()
  bool isWholeFrame = false;         ///< a frame, and no region of it
};

/// What one explanation leaves.
struct Residual {
  std::string id, text; ///< for files, for people
  double value = 0.0;
  bool isGiven = false, isBest = false;
};

enum class Confidence : std::uint8_t { Sure, Likely };

struct Finding {
  std::string id;   ///< of the table of faults where that has it: "motionNegatedY"
  std::string name; ///< as a heading
  Confidence confidence = Confidence::Sure;
  bool isWholePicture = false; ///< `regions` are those it was measured in
  std::vector<RegionPlace> regions;
  std::string reason;              ///< a sentence: what it rests on
  std::string measure;             ///< what residuals are: "mean difference of luma, × 1000"
  std::vector<Residual> residuals; ///< by rising value
  std::string symptom;             ///< a sentence: what one sees because of it
  std::string change;              ///< sentences: what to change, in the engine's own convention
  /// Settings that make frames right, "fault.motionY=-1", what is wrong being no fault that they inject;
  /// empty: none do.
  std::vector<std::string> correction;
  std::vector<std::string> alike; ///< ids of what these frames do not tell it from
  bool isKnown = false;           ///< by a baseline: it is no news
};

/// The part that it is of, by the table of faults or, where that does not have it, by how its id begins.
/// Nothing: it is of none.
std::optional<FaultPart> partOf(const Finding& finding);
/// Takes regions by their names out of findings of motion that are not of the whole picture, and findings
/// that have none left then. `mayTake`: empty: of all of these.
void takeOutOfMotion(const std::vector<std::string>& names, std::vector<Finding>& findings,
                     const std::function<bool(const Finding&)>& mayTake = {});
/// A sure one with id, name and symptom of the fault's row.
Finding faultFinding(Fault fault);

/// A part that was examined and is right.
struct RightPart {
  std::string part;     ///< "Jitter"
  std::string sentence; ///< what is right about it
};

/// A part that these frames do not decide.
struct Undecided {
  std::string question;        ///< the part: "Motion of the sky"
  std::string reason;          ///< a sentence
  std::string capture;         ///< a sentence: what to capture instead; may be empty
  std::vector<Fault> faults{}; ///< of the table: those that would not show
  /// Whether what was measured does not fit what is stated; else too little was measured.
  bool isMisfit = false;
};

/// Parts that were examined, each under one status: what is right about a part that is also undecided is said
/// in the sentence that leaves it open.
class ExaminedParts {
 public:
  const std::vector<RightPart>& right() const { return right_; }
  const std::vector<Undecided>& undecided() const { return undecided_; }

  void addRight(std::string part, std::string sentence);
  void leaveOpen(Undecided part);
  /// Takes back what is right about a part.
  void takeBack(std::string_view part);
  /// Takes back what is right beyond what was right earlier.
  void keepRight(const ExaminedParts& earlier);

 private:
  std::vector<RightPart> right_;
  std::vector<Undecided> undecided_;
};

struct Diagnosis {
  int first = 0; ///< of the frames that were looked at
  int frames = 0, pairs = 0;
  glm::ivec2 sizePx{0}; ///< of the frames, which boxes and pixels of regions lie in
  FrameNames frameNames;
  std::vector<Finding> findings;
  ExaminedParts parts;
  std::vector<std::string> notes; ///< sentences: what is worth knowing and no fault
  /// Light that was compared, 0 to 1, of frames in which regions of findings are shown, by frame.
  std::map<int, Image> pictures;

  bool isHealthy() const { return findings.empty(); }
  /// Whether something that was measured does not fit what is stated, and no finding says why.
  bool isMisfit() const;
  /// "32 frames, 31 pairs compared", with the numbers of frames that are not called by their places.
  std::string lookedText() const;
  /// Without findings: that nothing is wrong, as far as it was decided, and what does not fit.
  std::string healthySentence() const;
  /// Whether a finding is not known.
  bool hasNews() const {
    return std::any_of(findings.begin(), findings.end(), [](const Finding& found) { return !found.isKnown; });
  }
};

/// Of frames between two of which pictures are missing: nothing moves from one to the other as is given.
inline constexpr std::string_view kFrameMissingId = "frameMissing";

/// Whether a finding that is not of the whole picture names a region; or one of the whole picture says why
/// its motion is wrong.
bool isRegionTold(std::string_view name, const Diagnosis& out);
bool isMotionTold(std::string_view name, const Diagnosis& out);

} // namespace taa::doctor
