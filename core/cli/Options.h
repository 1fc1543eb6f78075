// Options that several commands have, and the values that texts of options stand for.
#pragma once

#include "core/base/Error.h"
#include "core/base/ShownText.h"
#include "core/taa/Intermediates.h"

#include <glm/vec2.hpp>
#include <nlohmann/json_fwd.hpp>

#include <iosfwd>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
class Option;
class Validator;
} // namespace CLI

namespace taa::cli {

/// The caller's mistake on the command line, told in a sentence; ends the program with 2.
class UsageError : public std::runtime_error {
 public:
  explicit UsageError(const std::string& message) : std::runtime_error(shownLine(message)) {}
};

/// What `read` returns; its Error is the caller's mistake, in `flag` unless that is empty.
template <typename Read>
auto readOption(const std::string& flag, const Read& read) {
  try {
    return read();
  } catch (const Error& error) {
    throw UsageError(flag + (flag.empty() ? "" : ": ") + error.what());
  }
}

/// First and last frame, both included.
struct FrameRange {
  int first = 0, last = 0;
  int count() const { return last - first + 1; }
};

/// Two numbers from 0 with `separator` between them.
std::optional<glm::ivec2> parsePair(const std::string& text, std::string_view separator);

// Each throws UsageError that says what is expected.
FrameRange parseFrames(const std::string& text); ///< "A..B", or one frame
glm::ivec2 parseSize(const std::string& text);   ///< "WxH"
glm::ivec2 parsePixel(const std::string& text);  ///< "X,Y"
std::vector<IntermediateId> parseEmit(const std::vector<std::string>& names);
void checkReferenceSamples(int samples);

CLI::Option* addJson(CLI::App& command, bool& json);
void addForce(CLI::App& command, bool& force);
void addFrame(CLI::App& command, int& frame);
CLI::Option* addPixel(CLI::App& command, std::string& pixel);
/// `what`: of what, with the range, as it follows "Samples in a pixel ".
void addReferenceSamples(CLI::App& command, int& samples, const std::string& what);

/// As CLI::Range, which lets NaN pass.
CLI::Validator numberFrom(double min, double max);

/// Refuses an empty value of any option of the command and of those below it, as in --baseline "": what is
/// ignored is believed to have had its effect. To be called when all options are there.
void refuseEmptyValues(CLI::App& app);

void print(std::ostream& out, const nlohmann::ordered_json& json);

/// "a, b or c", `last` being " or ".
std::string enumeration(const std::vector<std::string>& names, std::string_view last);
/// What --like takes, as such an enumeration.
std::string startingPointIds();

} // namespace taa::cli
