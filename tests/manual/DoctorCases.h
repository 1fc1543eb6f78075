// Cases that the doctor was tried on, each with what was injected and what it said: a table that a command
// writes and the manual shows.
#pragma once

#include "core/settings/Faults.h"

#include <glm/vec2.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace taa {

/// Frames, and the faults that are injected into them.
struct DoctorCase {
  std::string source; ///< "builtin:gallery"; of a capture the name of its folder
  std::string camera; ///< empty: that of a capture
  glm::ivec2 sizePx{240, 136};
  int frames = 14;           ///< from frame 0 on
  std::vector<Fault> faults; ///< none: healthy frames
  bool isHalf = false;       ///< at half strength, see injectHalf()
  std::string preset = {};   ///< the engine's settings; empty: this program's own

  bool operator==(const DoctorCase&) const = default;
};

struct JudgedCase {
  DoctorCase tried;
  /// Frames differ from those without the fault by what one sees; of several for each, beside the others.
  bool shows = false;
  /// Ids of findings in their order, without those that the healthy frames have as well.
  std::vector<std::string> named;
  std::vector<std::string> same; ///< of `named`: other faults that make the same frames
  /// A question of the fault's part is not decided, with its reason; of several for each that is not named.
  bool isOpen = false;
};

/// What became of a case with one fault.
enum class CaseOutcome : std::uint8_t {
  First,     ///< its name, or that of a fault that makes the same frames, stands first
  Later,     ///< it stands behind another
  Undecided, ///< nothing is named, and a question of its part is said to be open
  Silent,    ///< nothing is named
  Wrong,     ///< something else is named
};
inline constexpr int kCaseOutcomes = 5;

CaseOutcome outcomeOf(const JudgedCase& judged);
/// Whether one of the names says the fault.
bool isNamed(Fault fault, const JudgedCase& judged);

/// Lines of "source,camera,size,frames,preset,faults,strength,shows,named,same,open" below a line of these
/// names; several ids with | between. Throws Error naming `place` and the line.
std::vector<JudgedCase> judgedCasesFrom(const std::string& text, const std::string& place);
/// The heading, with its end of line.
std::string judgedCasesHead();
/// One line, with its end.
std::string judgedCaseText(const JudgedCase& judged);

inline constexpr const char* kDoctorCasesFile = "tests/manual/doctor.csv";
/// Those of that file of the repository. Throws Error.
std::vector<JudgedCase> judgedCases();

} // namespace taa
