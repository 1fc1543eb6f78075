// What going through time costs, and that it costs no memory: paired measurements of the façade. Every figure
// is a counter named as in Figures.cpp.
#include "core/base/Error.h"
#include "core/base/Files.h"
#include "core/base/Median.h"
#include "core/inspect/Inspector.h"
#include "core/settings/Parameters.h"
#include "tests/bench/Timing.h"

#include <benchmark/benchmark.h>
#include <unistd.h>

#include <algorithm>
#include <malloc.h>
#include <random>
#include <sstream>
#include <vector>

namespace {

using taa::Inspector;
using taa::IntermediateId;
using taa::median;
using taa::bench::seconds;

constexpr int kWidth = 1280, kHeight = 720;
constexpr int kWarmUpFrames = 24;

/// A frame as a window shows it.
void look(Inspector& inspector, const std::vector<IntermediateId>& rows) {
  for (const IntermediateId id : rows)
    benchmark::DoNotOptimize(
        inspector.views().picture(id, {}, {}, inspector.shot().width(), inspector.shot().height()));
}

/// Steps back against steps forward to frames that were not there yet, both until `rows` can be seen.
void benchStepBack(benchmark::State& state, const std::vector<IntermediateId>& rows, const char* figure) {
  Inspector inspector;
  inspector.shot().setSize(kWidth, kHeight);
  inspector.shot().open("builtin:fan");
  inspector.views().watch(rows);
  inspector.shot().seek(kWarmUpFrames);
  look(inspector, rows);
  inspector.shot().seek(kWarmUpFrames - 1);
  look(inspector, rows); // compiles what only looking needs
  inspector.shot().seek(kWarmUpFrames);
  std::vector<double> ratios;
  // Runs of steps and not single ones, for a step back may be dear now and then.
  constexpr int kSteps = 12;
  for (auto _ : state) {
    double times[2] = {};
    for (const int way : {1, -1})
      times[way < 0] = seconds([&] {
        for (int step = 0; step < kSteps; ++step) {
          inspector.shot().seek(inspector.shot().frame() + way);
          look(inspector, rows);
        }
      });
    ratios.push_back(times[1] / times[0]);
    state.SetIterationTime(times[1] / kSteps);
    inspector.shot().seek(inspector.shot().frame() +
                          kSteps); // kept: the next steps forward are to new frames
  }
  state.counters[figure] = median(ratios);
}

void stepBack(benchmark::State& state) {
  benchStepBack(state, {IntermediateId::resolved}, "stepBack");
}

void stepBackInputs(benchmark::State& state) {
  benchStepBack(state, {IntermediateId::color, IntermediateId::motion}, "stepBackInputs");
}

/// Random frames of a played shot, in times of the frames that were played, with the default budget.
void seekPlayed(benchmark::State& state) {
  constexpr int kFrames = 240;
  Inspector inspector;
  inspector.shot().setSize(kWidth, kHeight);
  inspector.shot().open("builtin:fan");
  std::vector<double> frames, seeks;
  while (inspector.shot().frame() < kFrames - 1)
    frames.push_back(seconds([&] { inspector.shot().seek(inspector.shot().frame() + 1); }));
  const double frameTime = median(frames);
  std::minstd_rand random(4);
  for (auto _ : state) {
    const int frame = static_cast<int>(random() % kFrames);
    const double time = seconds([&] { inspector.shot().seek(frame); });
    seeks.push_back(time / frameTime);
    state.SetIterationTime(time);
  }
  state.counters["seekWorst"] = *std::ranges::max_element(seeks);
  state.counters["seekMedian"] = median(seeks);
}

/// Memory of this process, pages; what the heap keeps only for later is given back first.
double residentPages() {
  ::malloc_trim(0);
  std::istringstream words(taa::readFile("/proc/self/statm"));
  double all = 0.0, resident = 0.0;
  words >> all >> resident;
  return resident;
}

/// What a user does, quickly: plays, now and then seeks, changes settings, looks at rows and probes.
class Wanderer {
 public:
  explicit Wanderer(Inspector& inspector) : inspector_(inspector) {}

  /// Returns how many frames it took.
  int goOn() {
    const auto dice = random_() % 20;
    int frames = 1;
    if (dice == 0)
      frames = seek(static_cast<int>(random_() % 24));
    else if (dice == 1)
      changeSettings();
    else if (dice == 2)
      benchmark::DoNotOptimize(inspector_.probes().probe(3, 5));
    else if (dice == 3 || inspector_.shot().frame() == inspector_.shot().frameCount() - 1)
      frames = seek(inspector_.shot().frame() / 2);
    else
      inspector_.shot().advance();
    if (dice % 4 == 0) look(inspector_, {IntermediateId::resolved, IntermediateId::alpha});
    return frames;
  }

 private:
  int seek(int frame) {
    const int frames = std::max(1, inspector_.shot().replayLength(frame));
    inspector_.shot().seek(frame);
    return frames;
  }

  // Among a few, so that all of it is compiled before the first measurement.
  void changeSettings() {
    taa::Settings settings;
    settings.weight.minimum = static_cast<float>(1 + random_() % 50) * 0.002f;
    if (random_() % 2) taa::applyAssignment(settings, "jitter.period=8");
    if (random_() % 2) taa::applyAssignment(settings, "history.precision=full");
    inspector_.shot().setSettings(settings);
  }

  Inspector& inspector_;
  std::minstd_rand random_{7};
};

/// The two moments of one long run, at a picture so small that what is counted is what is forgotten.
void memoryGrowth(benchmark::State& state) {
  constexpr int kSmall = 32;
  Inspector inspector;
  inspector.shot().setSize(kSmall, kSmall);
  inspector.shot().open("builtin:fan");
  inspector.views().watch({IntermediateId::resolved});
  Wanderer wanderer(inspector);
  const auto wander = [&] {
    for (int frames = 0; frames < 1000;) frames += wanderer.goOn();
  };
  wander();
  const double before = residentPages();
  for (auto _ : state) state.SetIterationTime(seconds(wander));
  state.counters["memoryGrowth"] = residentPages() / before;
  state.counters["memoryMiB"] = before * static_cast<double>(::sysconf(_SC_PAGESIZE)) / (1 << 20);
}

} // namespace

BENCHMARK(stepBack)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(5);
BENCHMARK(stepBackInputs)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(5);
BENCHMARK(seekPlayed)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(40);
BENCHMARK(memoryGrowth)->UseManualTime()->Unit(benchmark::kSecond)->Iterations(99);
