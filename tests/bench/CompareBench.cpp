// What comparing a picture with its reference costs on one core: each figure is a counter named as in
// Figures.cpp.
#include "core/base/Median.h"
#include "core/measure/PictureComparison.h"
#include "core/measure/compare/GhostEnergy.h"
#include "tests/bench/Timing.h"
#include "tests/unit/compare/Pictures.h"

#include <benchmark/benchmark.h>

#include <functional>
#include <string>
#include <vector>

namespace {

using taa::Image;
using taa::Metric;

constexpr int kWidth = 960, kHeight = 540;

Image bars(float contrast) {
  return taa::test::pictureOf(kWidth, kHeight, [contrast](int x, int y) {
    return 0.5f + contrast * (taa::test::patternColor(x / 8, y / 8) - 0.5f);
  });
}

/// One of them, in a comparison in which nothing else was asked for yet.
void compare(benchmark::State& state, Metric metric, const std::string& figure) {
  const Image picture = bars(0.9f), reference = bars(1.0f);
  std::vector<double> times;
  for (auto _ : state) {
    taa::PictureComparison both(picture, reference);
    times.push_back(taa::bench::seconds([&] { benchmark::DoNotOptimize(both.metric(metric)); }));
    state.SetIterationTime(times.back());
  }
  state.counters[figure] = 1e3 * taa::median(times);
}

void flip(benchmark::State& state) {
  compare(state, Metric::Flip, "flip");
}
void hdrFlip(benchmark::State& state) {
  compare(state, Metric::HdrFlip, "hdrFlip");
}
void ssim(benchmark::State& state) {
  compare(state, Metric::Ssim, "ssim");
}
void sharpnessOfEdges(benchmark::State& state) {
  compare(state, Metric::Sharpness, "sharpness");
}
void errorOfPixels(benchmark::State& state) {
  compare(state, Metric::Rmse, "rmse");
}
void relativeErrorOfPixels(benchmark::State& state) {
  compare(state, Metric::RelativeMse, "relativeMse");
}

void ghosts(benchmark::State& state) {
  const Image picture = bars(0.9f), reference = bars(1.0f);
  Image positions(kWidth, kHeight, 2);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      positions.at(x, y)[0] = float(x) + 0.25f;
      positions.at(x, y)[1] = float(y) + 0.75f;
    }
  std::vector<double> times;
  for (auto _ : state) {
    times.push_back(taa::bench::seconds([&] {
      benchmark::DoNotOptimize(taa::ghostEnergy(taa::ghostMap({picture, reference, picture, positions})));
    }));
    state.SetIterationTime(times.back());
  }
  state.counters["ghosts"] = 1e3 * taa::median(times);
}

} // namespace

BENCHMARK(flip)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(9);
BENCHMARK(hdrFlip)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(3);
BENCHMARK(ssim)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(9);
BENCHMARK(sharpnessOfEdges)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(9);
BENCHMARK(errorOfPixels)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(9);
BENCHMARK(relativeErrorOfPixels)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(9);
BENCHMARK(ghosts)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(9);
