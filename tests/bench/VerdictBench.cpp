// What a verdict costs where surfaces are dense, when nothing of it is known. Every figure is a counter named
// as in Figures.cpp.
#include "core/base/Median.h"
#include "core/inspect/Inspector.h"
#include "core/measure/Metrics.h"
#include "core/measure/References.h"
#include "core/render/passes/SceneRenderer.h"
#include "core/scene/builtin/SceneSource.h"
#include "tests/bench/Timing.h"

#include <benchmark/benchmark.h>
#include <glm/vec2.hpp>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace {

using taa::median;
using taa::bench::seconds;

constexpr int kFrame = 24, kPixels = 12;
constexpr int kWidth = 960, kHeight = 540;

/// Samples that a verdict has, of one whole frame; new ones each time.
class WholeReference {
 public:
  explicit WholeReference(const char* source)
      : scene_(std::make_shared<const taa::Scene>(taa::openScene(source))), renderer_(scene_) {
    taa::FrameRequest request;
    request.camera = scene_->shot.camera;
    request.width = kWidth;
    request.height = kHeight;
    key_ = {taa::referenceRequest(request), kFrame};
  }
  void draw() {
    taa::References references;
    references.refine(renderer_, key_, taa::kVerdictSamples, {});
  }

 private:
  std::shared_ptr<const taa::Scene> scene_;
  taa::SceneRenderer renderer_;
  taa::ReferenceKey key_;
};

/// On one of pixels below the horizon, far from each other.
taa::VerdictQuestion questionOf(int number, int samples) {
  const int x = number * 467 % kWidth, y = kHeight / 3 + number * 131 % (2 * kHeight / 3);
  return {.frame = kFrame, .pixel = {x, y}, .samples = samples};
}

void benchVerdict(benchmark::State& state, const char* source, const std::string& figure) {
  taa::Inspector inspector;
  inspector.shot().setSize(kWidth, kHeight);
  inspector.shot().open(source);
  inspector.shot().seek(kFrame);
  WholeReference whole(source);
  // References of other numbers of samples are of no use to those that are measured, but compile the same.
  for (int number = 0; number < kPixels; ++number)
    inspector.verdicts().of(questionOf(number, taa::kMinReferenceSamples));
  std::vector<double> times, ratios;
  int number = 0;
  for (auto _ : state) {
    const taa::VerdictQuestion question = questionOf(number++, taa::kVerdictSamples);
    const double drawn = seconds([&] { whole.draw(); });
    const double time = seconds([&] { benchmark::DoNotOptimize(inspector.verdicts().of(question)); });
    state.SetIterationTime(time);
    times.push_back(time * 1000.0);
    ratios.push_back(time / drawn);
  }
  state.counters[figure] = *std::ranges::max_element(times);
  state.counters[figure + "Ratio"] = median(ratios);
}

void verdictCrowd(benchmark::State& state) {
  benchVerdict(state, "builtin:crowd", "verdictCrowd");
}

void verdictFoliage(benchmark::State& state) {
  benchVerdict(state, "builtin:foliage", "verdictFoliage");
}

} // namespace

BENCHMARK(verdictCrowd)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(kPixels);
BENCHMARK(verdictFoliage)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(kPixels);
