// The manual's table of figures: which benchmark gives which, what is wanted, and writing it.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace taa::bench {

/// Medians by figure id, as the benchmarks report them in counters of that name.
using Figures = std::map<std::string, double>;

/// What the ids of the presets' figures begin with.
inline const std::string kPresetFigure = "preset.";

/// Registers a benchmark for each preset; called from main, since the presets stand on tables that are built
/// before it in no order that another file could rely on.
void registerPresets();

/// The table in Markdown, with machine, driver and date below it. Figures that were not measured are left
/// out.
std::string figuresTable(const Figures& figures, const std::string& driver);

/// Replaces what stands between the two markers of a page of the manual. Throws Error when they are not
/// there.
void writeFigures(const std::filesystem::path& page, const std::string& table);

} // namespace taa::bench
