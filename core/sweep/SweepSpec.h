// What a sweep goes over, as a file says it: sources × settings × values × cameras, and what is measured of
// each (manual, sweep).
#pragma once

#include "core/measure/Metrics.h"
#include "core/settings/Parameters.h"
#include "core/settings/Settings.h"

#include <glm/vec2.hpp>

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace taa {

/// What a file may ask for, so that one that nobody has looked at costs neither time nor memory.
inline constexpr std::size_t kMaxSweepBytes = std::size_t(1) << 20;
inline constexpr std::size_t kMaxSweepEntries = 1000; ///< of one list, and steps of a range
inline constexpr std::size_t kMaxSweepPoints = 100'000;
inline constexpr int kMaxSweepFrame = 1'000'000;

/// A glTF file, "builtin:NAME" or a capture.
struct SweepSource {
  std::string name;           ///< as the file has it: the same on every machine
  std::filesystem::path path; ///< a relative one is below the folder of the file
};

/// What the values of the ranges are put into.
struct SweepSettings {
  std::string name; ///< a preset's id, or as the file calls it
  Settings settings;
};

/// A parameter and the values it takes, each once.
struct SweepRange {
  const Parameter* row = nullptr;
  std::vector<double> values;
};

struct SweepSpec {
  std::vector<SweepSource> sources;
  std::vector<SweepSettings> settings;
  std::vector<SweepRange> ranges;
  std::vector<std::string> cameras{""}; ///< empty: the source's own
  int first = 0, last = 0;              ///< frames that are measured, both included
  std::optional<glm::ivec2> size;       ///< nothing: kSweepSize, of a capture its own
  std::vector<Metric> metrics;
  int referenceSamples = kReferenceSamples; ///< 0: nothing is compared with a reference
  int flickerFrames = 16;
  std::array<Metric, 2> tradeOff{}; ///< whose Pareto front is drawn; both are among `metrics`

  std::size_t pointCount() const;
};

/// Of scenes, where the file says nothing.
inline constexpr glm::ivec2 kSweepSize{1280, 720};

/// `place`: of the text, for messages; `folder`: which relative paths are below. Throws Error naming the
/// place and what is wrong: no JSON, a key that is not known, a value out of range, more points than allowed.
SweepSpec sweepSpecFromText(const std::string& text, const std::string& place,
                            const std::filesystem::path& folder);
/// The same of a file.
SweepSpec readSweepSpec(const std::filesystem::path& file);

/// From `from` to `to`, both included, in even steps or by a constant factor, each as the row holds it and
/// once. Throws Error where the row has no such values; expects a number, two steps at least, and of a factor
/// two ends above 0.
std::vector<double> valuesBetween(const Parameter& row, double from, double to, int steps, bool isByFactor);

/// How much a picture ghosts and how much it flickers, by the best metrics of `there` that say so. Expects
/// two at least.
std::array<Metric, 2> defaultTradeOff(const std::vector<Metric>& there);

} // namespace taa
