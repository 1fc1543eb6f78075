#include "tests/bench/Figures.h"

#include "core/base/Files.h"
#include "core/settings/Presets.h"

#include <ctime>
#include <iomanip>
#include <sstream>
#include <string_view>
#include <thread>

namespace taa::bench {

namespace {

constexpr std::string_view kBegin = "<!-- figures: written by taa_bench --write-manual -->\n";
constexpr std::string_view kEnd = "<!-- end of figures -->";

struct Row {
  std::string_view id, label, unit;
  double limit; ///< wanted: at most this; 0 where nothing is promised
  int digits;
};

constexpr Row kRows[] = {
    {"firstPicture",
     "From the start of the program to its first picture, no shader cached (at the size it opens with)", "s",
     3.0, 2},
    {"uiLatency", "What 999 of 1,000 events of the window wait at most while a frame takes 500 ms", "ms",
     16.0, 1},
    {"scene", "Drawing the scene of a frame", "ms", 0.0, 1},
    {"resolve", "Resolving a frame, nothing watched", "ms", 0.0, 1},
    {"watchOne", "The same while one intermediate is watched", "×", 1.15, 2},
    {"watchFour", "The same while four are watched", "×", 1.4, 2},
    {"watchAll", "The same while every intermediate is watched", "×", 2.5, 2},
    {"bare", "Nothing watched, against the same shader without any code that exposes", "×", 1.02, 2},
    {"probe", "Every intermediate of one pixel", "ms", 0.3, 2},
    {"stepBack", "Stepping back a frame, against stepping forward, looking at resolved", "×", 0.5, 2},
    {"stepBackInputs", "The same, looking at color and motion", "×", 1.2, 2},
    {"seekWorst", "Going to a random frame of a played shot of 240 frames, the longest way", "frame times",
     16.0, 1},
    {"seekMedian", "The same, the median way", "frame times", 8.0, 1},
    {"memoryGrowth",
     "Memory after 100,000 frames of playing, seeking and changing settings, against after 1,000", "×", 1.01,
     3},
    {"captureFrame",
     "A frame of a capture of 1920×1080 that was not read ahead: read, decoded and on the screen, without "
     "its resolve",
     "ms", 150.0, 0},
    {"capturePlay", "Playing a capture of 1920×1080, against playing the scene that it was written of", "×",
     1.0, 2},
    {"captureStepBack", "Stepping back through it, against playing it", "×", 0.5, 2},
    {"captureMemory", "Memory after 1,000 frames of a capture, against after 300", "×", 1.01, 3},
    {"switchChoice", "From another choice of a stage to its picture, no shader cached (960×540)", "ms", 300.0,
     0},
    {"switchPrepared", "The same, when the mouse rested on the choice and nothing played", "ms", 300.0, 0},
    {"switchBack", "From there back to a combination that was there before", "ms", 0.0, 0},
    {"crowdScene", "Drawing the scene of a frame of builtin:crowd, a million triangles", "ms", 0.0, 0},
    {"verdictCrowd", "The verdict on a pixel of it (960×540), the slowest of twelve", "ms", 300.0, 0},
    {"verdictCrowdRatio", "The same, the median, against the whole reference of one frame", "×", 0.2, 2},
    {"verdictFoliage", "The verdict on a pixel of builtin:foliage, likewise the slowest", "ms", 300.0, 0},
    {"verdictFoliageRatio", "The same, the median, against the whole reference of one frame", "×", 0.2, 2},
    {"exportExr",
     "Writing every intermediate of a frame as EXR, against OpenImageIO writing the same channels", "×", 1.11,
     2},
    {"exportWhole", "The same with exposing and reading back what is written, against the writing alone", "×",
     0.0, 2},
    {"flip", "FLIP of a picture of 960×540 and its reference, on one core", "ms", 400.0, 0},
    {"hdrFlip", "HDR-FLIP of the same", "ms", 0.0, 0},
    {"ssim", "SSIM of the same", "ms", 0.0, 0},
    {"sharpness", "Sharpness of the same", "ms", 0.0, 0},
    {"rmse", "RMSE, PSNR and the scene-linear RMSE of the same", "ms", 0.0, 0},
    {"relativeMse", "Relative MSE of the same", "ms", 0.0, 0},
    {"ghosts", "Ghost energy of the same", "ms", 0.0, 0},
};

std::string valueText(double value, const Row& row) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(row.digits);
  if (row.unit == "×")
    text << "× " << value;
  else
    text << value << ' ' << row.unit;
  return text.str();
}

std::string processorName() {
  std::istringstream lines(readFile("/proc/cpuinfo"));
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "an unnamed processor";
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  std::ostringstream text;
  text << std::put_time(&parts, "%Y-%m-%d");
  return text.str();
}

/// The presets' resolves as multiples of a copy; empty when none was measured.
std::string presetsTable(const Figures& figures) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(1);
  for (const Preset& preset : wholePresets()) {
    const auto figure = figures.find(kPresetFigure + preset.id);
    if (figure == figures.end()) continue;
    if (text.tellp() == 0)
      text << "\n| resolve of the preset | beside a plain copy of the same bytes |\n|---|---|\n";
    text << "| " << preset.label << " | × " << figure->second << " |\n";
  }
  return text.str();
}

} // namespace

std::string figuresTable(const Figures& figures, const std::string& driver) {
  std::ostringstream text;
  text << "| builtin:fan at 1280×720, preset balanced | measured | wanted |\n|---|---|---|\n";
  for (const Row& row : kRows) {
    const auto figure = figures.find(std::string(row.id));
    if (figure == figures.end()) continue;
    text << "| " << row.label << " | " << valueText(figure->second, row) << " | "
         << (row.limit > 0.0 ? "≤ " + valueText(row.limit, row) : "") << " |\n";
  }
  text << presetsTable(figures);
  text << "\nMedians of one run on " << processorName() << ", " << std::thread::hardware_concurrency()
       << " cores, " << driver << ", " << today()
       << "; each ratio is of pairs measured one right after the other.\n";
  return text.str();
}

void writeFigures(const std::filesystem::path& page, const std::string& table) {
  std::string text = readFile(page);
  const std::size_t begin = text.find(kBegin), end = text.find(kEnd);
  if (begin == std::string::npos || end == std::string::npos || end < begin)
    throw Error(page.string() + " has not the two comments that say where the figures go");
  text.replace(begin + kBegin.size(), end - begin - kBegin.size(), table);
  writeFile(page, text);
}

} // namespace taa::bench
