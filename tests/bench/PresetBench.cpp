// What the resolve of each preset costs beside a plain copy of the same bytes: pairs, one right after the
// other.
#include "core/base/Median.h"
#include "core/gl/Context.h"
#include "core/settings/Presets.h"
#include "core/taa/TaaPass.h"
#include "tests/bench/Figures.h"
#include "tests/bench/Timing.h"
#include "tests/support/frames/Frames.h"

#include <benchmark/benchmark.h>

#include <array>
#include <functional>
#include <vector>

namespace {

constexpr int kWidth = 1280, kHeight = 720;
constexpr int kIterations = 12;

/// Until the driver is done, s.
double finished(const std::function<void()>& act) {
  taa::gl::finish();
  return taa::bench::seconds([&] {
    act();
    taa::gl::finish();
  });
}

/// Reads what a resolve reads and writes what it writes.
class CopyPass {
 public:
  void draw(const taa::FrameInputs& inputs, const taa::History& previous, taa::History& out) {
    const taa::gl::Framebuffer target({{&out.color}, {&out.surface}}, nullptr, "copy");
    taa::gl::RenderPass pass(target, {}, "CopyPass");
    pass.program(program_);
    const std::array<const taa::gl::Texture*, 5> textures{&inputs.color, &inputs.depth, &inputs.motion,
                                                          &previous.color, &previous.surface};
    for (unsigned unit = 0; unit < textures.size(); ++unit) pass.texture(unit, *textures[unit], sampler_);
    pass.drawFullscreen();
  }

 private:
  taa::gl::Program program_{taa::gl::ShaderSource("include/fullscreen.vert"),
                            taa::gl::ShaderSource("bench/copy.frag"), "CopyPass"};
  taa::gl::Sampler sampler_{taa::gl::SamplerState{}};
};

void resolveOfPreset(benchmark::State& state, const taa::Preset& preset) {
  const taa::gl::Context context;
  taa::test::Player player("builtin:fan", "gltf:front", kWidth, kHeight, preset.settings);
  taa::TaaPass pass;
  CopyPass copy;
  for (int frame = 0; frame < 4; ++frame) player.step(pass);
  player.draw();
  taa::History out;
  taa::fitHistory(out, kWidth, kHeight, preset.settings);
  const auto resolve = [&] { pass.resolve(player.inputs(), &player.history(), preset.settings, out); };
  resolve();
  copy.draw(player.inputs(), player.history(), out);
  std::vector<double> ratios;
  for (auto _ : state) {
    const double floor = finished([&] { copy.draw(player.inputs(), player.history(), out); });
    const double time = finished(resolve);
    ratios.push_back(time / floor);
    state.SetIterationTime(time);
  }
  state.counters[taa::bench::kPresetFigure + preset.id] = taa::median(ratios);
}

} // namespace

void taa::bench::registerPresets() {
  for (const Preset& preset : wholePresets())
    benchmark::RegisterBenchmark(("preset/" + preset.id).c_str(),
                                 [&preset](benchmark::State& state) { resolveOfPreset(state, preset); })
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond)
        ->Iterations(kIterations);
}
