// What looking costs: paired measurements of the façade. Every figure is a counter named as in Figures.cpp.
#include "core/base/Error.h"
#include "core/base/Median.h"
#include "core/inspect/Inspector.h"
#include "core/settings/Parameters.h"
#include "tests/bench/Timing.h"
#include "tests/support/Paths.h"
#include "tests/support/Process.h"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace {

using taa::IntermediateId;
using taa::median;
using taa::bench::seconds;

constexpr int kWarmUpFrames = 24;
constexpr int kWidth = 1280, kHeight = 720;

/// builtin:fan, warmed up; opened anew, so that one benchmark's checkpoints do not help the next.
std::unique_ptr<taa::Inspector> openFan() {
  auto inspector = std::make_unique<taa::Inspector>();
  inspector->shot().setSize(kWidth, kHeight);
  inspector->shot().open("builtin:fan");
  inspector->shot().seek(kWarmUpFrames);
  return inspector;
}

/// One frame on, at the end of the shot back to where the warm-up ended.
void stepForward(taa::Inspector& inspector) {
  const int next = inspector.shot().frame() + 1;
  inspector.shot().seek(next < inspector.shot().frameCount() ? next : kWarmUpFrames);
}

double resolveTime(taa::Inspector& inspector, const std::vector<IntermediateId>& watched) {
  inspector.views().watch(watched);
  stepForward(inspector);
  return inspector.shot().times().resolve;
}

void benchWatching(benchmark::State& state, const std::vector<IntermediateId>& watched, const char* figure) {
  const std::unique_ptr<taa::Inspector> inspector = openFan();
  resolveTime(*inspector, watched); // compiles the exposed program
  std::vector<double> ratios, bare, scene;
  for (auto _ : state) {
    bare.push_back(resolveTime(*inspector, {}));
    scene.push_back(inspector->shot().times().scene);
    const double exposed = resolveTime(*inspector, watched);
    ratios.push_back(exposed / bare.back());
    state.SetIterationTime(exposed / 1000.0);
  }
  state.counters[figure] = median(ratios);
  state.counters["resolve"] = median(bare);
  state.counters["scene"] = median(scene);
}

void watchOne(benchmark::State& state) {
  benchWatching(state, {IntermediateId::historyRectified}, "watchOne");
}

/// Early and late stages, colors and a mask.
void watchFour(benchmark::State& state) {
  benchWatching(state,
                {IntermediateId::motion, IntermediateId::historyRaw, IntermediateId::historyRectified,
                 IntermediateId::alpha},
                "watchFour");
}

void watchAll(benchmark::State& state) {
  benchWatching(state, taa::allRows(), "watchAll");
}

/// RenderDoc 1.24 took 69 ms on a machine of this class for one texture of one pixel: from a script in
/// qrenderdoc, over a capture of a frame, the median of 20 of `controller.SetFrameEvent(event, True)` for
/// another event and back, then `controller.PickPixel(texture, x, y, Subresource(), CompType.Typeless)`.
/// RenderDoc was not installed where the manual's figures were measured. Where it is, run that on a capture
/// of taa-batch beside this.
void probe(benchmark::State& state) {
  const std::unique_ptr<taa::Inspector> inspector = openFan();
  std::vector<double> times;
  int count = 0;
  for (auto _ : state) {
    // Strides that are prime to the size: all over the picture.
    const int x = count * 467 % kWidth, y = count * 311 % kHeight;
    const double time = seconds([&] { benchmark::DoNotOptimize(inspector->probes().probe(x, y)); });
    if (count++ > 0) times.push_back(time * 1000.0); // the first one compiles
    state.SetIterationTime(time);
  }
  state.counters["probe"] = median(times);
}

/// From the choice of another option to its picture, s.
double switchTime(taa::Inspector& inspector, const taa::Settings& settings) {
  return seconds([&] {
    inspector.shot().setSettings(settings);
    benchmark::DoNotOptimize(inspector.views().picture(IntermediateId::resolved, {}, {},
                                                       inspector.shot().width(), inspector.shot().height()));
  });
}

/// Calls `with` for the settings of every choice of the resolve, each new to the program, on an inspector at
/// the size a software driver opens with.
template <typename Action>
void forEachChoice(Action with) {
  taa::Inspector inspector;
  inspector.shot().open("builtin:fan");
  inspector.views().watch({IntermediateId::resolved});
  inspector.shot().seek(kWarmUpFrames);
  for (const taa::Parameter& row : taa::parameters()) {
    if (row.effect != taa::Effect::Program || row.kind != taa::ParameterKind::Choice) continue;
    taa::Settings settings;
    row.set(settings, row.get(settings) == 0.0 ? 1.0 : 0.0);
    with(inspector, settings);
  }
}

/// There, and back to the choice before.
void switchChoice(benchmark::State& state) {
  std::vector<double> first, again;
  for (auto _ : state) {
    double total = 0.0;
    forEachChoice([&](taa::Inspector& inspector, const taa::Settings& settings) {
      total += first.emplace_back(switchTime(inspector, settings) * 1000.0);
      again.push_back(switchTime(inspector, {}) * 1000.0);
    });
    state.SetIterationTime(total / 1000.0);
  }
  state.counters["switchChoice"] = median(first);
  state.counters["switchBack"] = median(again);
}

/// After somebody has looked at the choice for as long as its compilation takes.
void switchPrepared(benchmark::State& state) {
  std::vector<double> times;
  for (auto _ : state) {
    double total = 0.0;
    forEachChoice([&](taa::Inspector& inspector, const taa::Settings& settings) {
      inspector.shot().prepare(settings);
      total += times.emplace_back(switchTime(inspector, settings) * 1000.0);
      switchTime(inspector, {});
    });
    state.SetIterationTime(total / 1000.0);
  }
  state.counters["switchPrepared"] = median(times);
}

/// What the window says of itself with --timing: seconds from the start of its process to its first picture.
double firstPictureTime(const std::string& picture) {
  const taa::test::ProcessResult result =
      taa::test::runProcess({taa::test::binary("taa-inspector").string(), "--timing", "--force",
                             "--screenshot", picture, "--frame", "0"});
  double time = 0.0;
  if (std::sscanf(result.err.c_str(), "first picture after %lf s", &time) != 1)
    throw taa::Error("taa-inspector did not say how long it took: " + result.err);
  return time;
}

void firstPicture(benchmark::State& state) {
  if (!std::filesystem::exists(taa::test::binary("taa-inspector"))) {
    state.SkipWithError("there is no taa-inspector in this build");
    return;
  }
  const std::string picture = (taa::test::temporaryFolder() / "window.png").string();
  std::vector<double> times;
  for (auto _ : state) {
    times.push_back(firstPictureTime(picture));
    state.SetIterationTime(times.back());
  }
  state.counters["firstPicture"] = median(times);
}

/// What taa_ui_latency says: the 99.9th percentile, ms.
void uiLatency(benchmark::State& state) {
  if (!std::filesystem::exists(taa::test::binary("taa_ui_latency"))) {
    state.SkipWithError("there is no taa_ui_latency in this build");
    return;
  }
  std::vector<double> times;
  for (auto _ : state) {
    const taa::test::ProcessResult result =
        taa::test::runProcess({taa::test::binary("taa_ui_latency").string()});
    double time = 0.0;
    const char* said = std::strstr(result.out.c_str(), "99.9% ");
    if (said == nullptr || std::sscanf(said, "99.9%% %lf", &time) != 1)
      throw taa::Error("taa_ui_latency did not say how long events waited: " + result.err);
    times.push_back(time);
    state.SetIterationTime(time * 1e-3);
  }
  state.counters["uiLatency"] = median(times);
}

} // namespace

BENCHMARK(uiLatency)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(3);
BENCHMARK(firstPicture)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(5);
BENCHMARK(switchChoice)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK(switchPrepared)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK(watchAll)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(20);
BENCHMARK(watchFour)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(40);
BENCHMARK(watchOne)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(60);
BENCHMARK(probe)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(200);
