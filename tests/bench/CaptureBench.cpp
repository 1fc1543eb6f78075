// What frames of a capture cost, against those of the scene that it was written of. Every figure is a counter
// named as in Figures.cpp.
#include "core/base/Files.h"
#include "core/base/Median.h"
#include "core/capture/format/Manifest.h"
#include "core/inspect/Inspector.h"
#include "core/report/CaptureExport.h"
#include "tests/bench/Timing.h"
#include "tests/support/Paths.h"

#include <benchmark/benchmark.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <malloc.h>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace fs = std::filesystem;
using taa::Inspector;
using taa::IntermediateId;
using taa::median;
using taa::bench::seconds;

constexpr const char* kScene = "builtin:fan";
constexpr int kFrames = 8;

/// The first frames of the scene as the program writes them in its own conventions; once for a size.
fs::path capturedScene(int width, int height) {
  const fs::path folder = taa::test::temporaryFolder() / ("capture-" + std::to_string(width));
  if (fs::exists(folder / taa::capture::kManifestName)) return folder;
  fs::create_directories(folder);
  Inspector inspector;
  inspector.shot().setSize(width, height);
  inspector.shot().open(kScene);
  taa::CaptureExport files(inspector, {}, 0, kFrames - 1);
  for (int frame = 0; frame < kFrames; ++frame) {
    inspector.shot().seek(frame);
    files.add(folder, {});
  }
  files.finish(folder);
  return folder;
}

/// A frame as a window shows it.
void look(Inspector& inspector, IntermediateId row) {
  benchmark::DoNotOptimize(
      inspector.views().picture(row, {}, {}, inspector.shot().width(), inspector.shot().height()));
}

/// Another source at 1920×1080, at its first frame, with nothing of it kept.
void openLarge(Inspector& inspector, const std::string& source) {
  inspector.shot().setSize(1920, 1080);
  inspector.shot().open(source);
  inspector.views().watch({IntermediateId::resolved});
  look(inspector, IntermediateId::color); // compiles what only looking needs
  look(inspector, IntermediateId::resolved);
}

/// Frames that nobody has read ahead, each the beginning of history: read, decoded and on the screen, without
/// the resolve.
void captureFrame(benchmark::State& state) {
  const std::string folder = capturedScene(1920, 1080).string();
  std::vector<double> times;
  Inspector inspector;
  for (auto _ : state) {
    openLarge(inspector, folder);
    double all = 0.0;
    for (int frame = 2; frame < kFrames; frame += 2) {
      inspector.shot().setRestarts({frame});
      const double time = seconds([&] {
        inspector.shot().seek(frame);
        look(inspector, IntermediateId::color);
      });
      all += time;
      times.push_back(1000.0 * time - inspector.shot().times().resolve);
    }
    state.SetIterationTime(all);
  }
  state.counters["captureFrame"] = median(times);
}

/// All frames one after the other; s.
double playTime(Inspector& inspector) {
  return seconds([&] {
    while (inspector.shot().frame() < kFrames - 1) {
      inspector.shot().advance();
      look(inspector, IntermediateId::resolved);
    }
  });
}

void capturePlay(benchmark::State& state) {
  const std::string folder = capturedScene(1920, 1080).string();
  std::vector<double> ratios;
  Inspector inspector;
  for (auto _ : state) {
    openLarge(inspector, kScene);
    const double scene = playTime(inspector);
    openLarge(inspector, folder);
    const double capture = playTime(inspector);
    ratios.push_back(capture / scene);
    state.SetIterationTime(capture);
  }
  state.counters["capturePlay"] = median(ratios);
}

/// Runs of steps back against as many forward to frames that were not there yet.
void captureStepBack(benchmark::State& state) {
  const std::string folder = capturedScene(1920, 1080).string();
  std::vector<double> ratios;
  Inspector inspector;
  for (auto _ : state) {
    openLarge(inspector, folder);
    const double forward = playTime(inspector);
    const double back = seconds([&] {
      while (inspector.shot().frame() > 0) {
        inspector.shot().seek(inspector.shot().frame() - 1);
        look(inspector, IntermediateId::resolved);
      }
    });
    ratios.push_back(back / forward);
    state.SetIterationTime(back);
  }
  state.counters["captureStepBack"] = median(ratios);
}

/// The same capture with its frames again and again.
void makeLong(const fs::path& folder, int frames) {
  using namespace taa::capture;
  Manifest manifest = readManifest(folder);
  const std::vector<CapturedFrame> few = std::exchange(manifest.frames, {});
  for (int number = 0; number < frames; ++number) {
    CapturedFrame frame = few[static_cast<std::size_t>(number) % few.size()];
    for (const auto& [kind, plane] : manifest.planes) {
      frame.planes[kind] = plane;
      frame.planes[kind].file = planeFile(plane, frame.number);
    }
    frame.cut = number > 0 && frame.number == few.front().number;
    frame.number = number;
    frame.seconds.reset();
    manifest.frames.push_back(std::move(frame));
  }
  taa::writeFile(folder / kManifestName, manifestText(manifest));
}

/// MiB of this process; what the heap keeps only for later is given back first.
double residentMiB() {
  ::malloc_trim(0);
  std::istringstream words(taa::readFile("/proc/self/statm"));
  double all = 0.0, resident = 0.0;
  words >> all >> resident;
  return resident * static_cast<double>(::sysconf(_SC_PAGESIZE)) / (1 << 20);
}

/// Decoded frames are kept within their budget, and so are histories.
void captureMemory(benchmark::State& state) {
  constexpr int kLong = 1000, kSettled = 300;
  const fs::path folder = capturedScene(320, 180);
  makeLong(folder, kLong);
  Inspector inspector;
  inspector.shot().open(folder.string());
  inspector.views().watch({IntermediateId::resolved});
  inspector.shot().setCheckpointBudget(std::size_t(128) << 20);
  const auto playTo = [&](int frame) {
    while (inspector.shot().frame() < frame) inspector.shot().advance();
  };
  playTo(kSettled);
  const double before = residentMiB();
  for (auto _ : state) state.SetIterationTime(seconds([&] { playTo(kLong - 1); }));
  state.counters["captureMemory"] = residentMiB() / before;
}

} // namespace

BENCHMARK(captureFrame)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(6);
BENCHMARK(capturePlay)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(6);
BENCHMARK(captureStepBack)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(6);
BENCHMARK(captureMemory)->UseManualTime()->Unit(benchmark::kSecond)->Iterations(1);
