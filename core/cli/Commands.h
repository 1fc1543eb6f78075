// The commands of taa-batch. Results go to `out`, nothing else does; mistakes are thrown.
#pragma once

#include "core/base/Progress.h"
#include "core/cli/Arguments.h"

#include <iosfwd>

namespace taa::cli {

/// What there is: intermediates, parameters, presets or built-in scenes.
void runList(const ListArguments& arguments, std::ostream& out);

/// Writes the intermediates of a range of frames; prints the files. Throws UsageError, Error, Cancelled.
void runRender(const RenderArguments& arguments, std::ostream& out, const Progress& progress);

/// Prints every intermediate at one pixel of one frame. Throws UsageError, Error, Cancelled.
void runProbe(const ProbeArguments& arguments, std::ostream& out, const Progress& progress);

/// Prints the samples of the frames before that one pixel of one frame is made of. Throws UsageError, Error,
/// Cancelled.
void runLineage(const LineageArguments& arguments, std::ostream& out, const Progress& progress);

/// Prints what is wrong with one pixel of one frame, since when, and because of what. Throws UsageError,
/// Error, Cancelled.
void runVerdict(const VerdictArguments& arguments, std::ostream& out, const Progress& progress);

/// Prints what is wrong with the frames of a scene or a capture, because of what, and what to change, and
/// writes it as a page where that is asked for. Returns whether nothing is wrong. Throws UsageError, Error,
/// Cancelled.
bool runDoctor(const DoctorArguments& arguments, std::ostream& out, const Progress& progress);

/// Prints intermediates at pixels over a range of frames. Throws UsageError, Error, Cancelled.
void runTrace(const TraceArguments& arguments, std::ostream& out, const Progress& progress);

/// Prints what the passes of frames take, what the settings of each stage of the resolve cost more than the
/// cheapest ones, and the memory. Throws UsageError, Error, Cancelled.
void runProfile(const ProfileArguments& arguments, std::ostream& out, const Progress& progress);

/// Prints metrics of a range of frames: RMSE and PSNR against the reference, and what the resolve did.
/// Throws UsageError, Error, Cancelled.
void runMetrics(const MetricsArguments& arguments, std::ostream& out, const Progress& progress);

/// Writes the resolve of some settings, and the pass after it, as one GLSL file. Throws UsageError, Error.
void runGlsl(const GlslArguments& arguments, std::ostream& out);

/// Says what a folder of somebody's frames is, by names, side files and pixels, and writes it as a capture.
/// Returns whether pixels clearly contradict a convention that is stated. Throws UsageError, Error,
/// Cancelled.
bool runImport(const ImportArguments& arguments, std::ostream& out, const Progress& progress);

/// Measures the points of a sweep that are not there yet, and merges all into tables in their folder; prints
/// how many there were. Returns whether all that were tried here could be measured. Throws UsageError, Error,
/// Cancelled.
bool runSweep(const SweepArguments& arguments, std::ostream& out, const Progress& progress);

/// Looks for settings that serve a goal better, and writes the best as a preset; prints the way there. Throws
/// UsageError, Error; Cancelled, after it has written the best there was until then.
void runTune(const TuneArguments& arguments, std::ostream& out, const Progress& progress);

} // namespace taa::cli
