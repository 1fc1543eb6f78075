// What being able to look costs who does not look: the resolve with nothing watched beside the same shader
// without any code that exposes.
#include "core/base/EmbeddedFiles.h"
#include "core/base/Median.h"
#include "core/gl/Context.h"
#include "core/taa/TaaPass.h"
#include "tests/bench/Timing.h"
#include "tests/support/ShaderFolder.h"
#include "tests/support/frames/Frames.h"

#include <benchmark/benchmark.h>

#include <cstddef>
#include <string>
#include <vector>

namespace {

constexpr int kWidth = 1280, kHeight = 720;

/// The text without its calls of macros that expose; the semicolons stay.
std::string withoutExposing(std::string text) {
  for (const std::string name : {"expose_", "store_exposed"})
    for (std::size_t begin = text.find(name); begin != std::string::npos; begin = text.find(name, begin)) {
      std::size_t end =
          text.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_", begin);
      if (end == std::string::npos || text[end] != '(') { // a word in a comment
        begin += name.size();
        continue;
      }
      int depth = 0;
      do {
        depth += text[end] == '(' ? 1 : text[end] == ')' ? -1 : 0;
        ++end;
      } while (depth > 0);
      text.erase(begin, end - begin);
    }
  return text;
}

void bare(benchmark::State& state) {
  const taa::gl::Context context;
  const taa::Settings settings;
  taa::test::Player player("builtin:fan", "gltf:front", kWidth, kHeight, settings);
  taa::TaaPass pass, without;
  taa::History out, other;
  for (int frame = 0; frame < 4; ++frame) player.step(pass);
  player.draw();
  const auto resolve = [&](taa::TaaPass& by, taa::History& into) {
    taa::gl::finish();
    return taa::bench::seconds([&] {
      by.resolve(player.inputs(), &player.history(), settings, into);
      taa::gl::finish();
    });
  };
  {
    const taa::test::ShaderFolder folder;
    for (const std::string& path : taa::embeddedPaths("shaders/"))
      folder.write(path.substr(std::string("shaders/").size()), withoutExposing(taa::embeddedText(path)));
    resolve(without, other); // compiles
  }
  resolve(pass, out);
  std::vector<double> ratios;
  bool isFirst = false; // which of the pair goes first changes
  for (auto _ : state) {
    isFirst = !isFirst;
    const double early = resolve(isFirst ? pass : without, isFirst ? out : other);
    const double late = resolve(isFirst ? without : pass, isFirst ? other : out);
    ratios.push_back(isFirst ? early / late : late / early);
    state.SetIterationTime(early);
  }
  state.counters["bare"] = taa::median(ratios);
}

} // namespace

BENCHMARK(bare)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(60);
