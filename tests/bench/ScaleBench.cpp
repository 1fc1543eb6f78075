// What size costs: a scene of a million triangles, and the export of everything there is about a frame. Every
// figure is a counter named as in Figures.cpp.
#include "core/base/Error.h"
#include "core/base/Median.h"
#include "core/inspect/Inspector.h"
#include "core/report/FrameExport.h"
#include "core/taa/ChannelNames.h"
#include "tests/bench/Timing.h"
#include "tests/support/Paths.h"

#include <OpenImageIO/imageio.h>
#include <benchmark/benchmark.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using taa::IntermediateId;
using taa::median;
using taa::bench::seconds;

constexpr int kWarmUpFrames = 8;
constexpr int kWidth = 1280, kHeight = 720;

std::unique_ptr<taa::Inspector> openScene(const char* source) {
  auto inspector = std::make_unique<taa::Inspector>();
  inspector->shot().setSize(kWidth, kHeight);
  inspector->shot().open(source);
  inspector->shot().seek(kWarmUpFrames);
  return inspector;
}

/// What the file says besides values.
taa::FrameFile header(const taa::Inspector& inspector) {
  return {inspector.shot().source(),
          inspector.shot().camera(),
          inspector.shot().driver().renderer,
          {{"", inspector.shot().settings(), inspector.shot().info(), {}}},
          {}};
}

void require(bool done, const OIIO::ImageOutput& output) {
  if (!done) throw taa::Error("OpenImageIO cannot write: " + output.geterror());
}

/// What is the least to say to OpenImageIO: parts, channels and the compression, of values in memory.
void writePlainly(const std::vector<IntermediateId>& ids, const std::vector<taa::Image>& images,
                  const fs::path& path) {
  std::vector<OIIO::ImageSpec> specs;
  for (std::size_t index = 0; index < ids.size(); ++index) {
    const taa::Intermediate& row = taa::intermediate(ids[index]);
    OIIO::ImageSpec& spec = specs.emplace_back(kWidth, kHeight, row.channels, OIIO::TypeFloat);
    spec.channelnames = taa::channelNames(row, {});
    spec.attribute("oiio:subimagename", std::string(row.name));
    spec.attribute("compression", "zip:1");
  }
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create("openexr");
  require(output->open(path.string(), static_cast<int>(specs.size()), specs.data()), *output);
  for (std::size_t index = 0; index < specs.size(); ++index) {
    if (index > 0)
      require(output->open(path.string(), specs[index], OIIO::ImageOutput::AppendSubimage), *output);
    require(output->write_image(OIIO::TypeFloat, images[index].pixels.data()), *output);
  }
  require(output->close(), *output);
}

/// Values that are in memory, by our writer and plainly; then the whole export as taa-batch does it, which
/// also runs the resolve and reads back.
void exportExr(benchmark::State& state) {
  const std::unique_ptr<taa::Inspector> inspector = openScene("builtin:fan");
  const std::vector<IntermediateId> all = taa::allRows();
  const std::vector<taa::Image> images = inspector->views().images(all);
  taa::FrameFile frame = header(*inspector);
  for (std::size_t index = 0; index < all.size(); ++index)
    frame.parts.push_back({0, all[index], images[index]});
  const fs::path folder = taa::test::temporaryFolder();
  std::vector<double> ratios, whole;
  for (auto _ : state) {
    const double plain = seconds([&] { writePlainly(all, images, folder / "plain.exr"); });
    const double ours = seconds([&] { taa::writeFrameFile(folder / "ours.exr", frame); });
    const double time =
        seconds([&] { taa::exportFrame(*inspector, header(*inspector), all, folder / "export.exr"); });
    ratios.push_back(ours / plain);
    whole.push_back(time / plain);
    state.SetIterationTime(time);
  }
  state.counters["exportExr"] = median(ratios);
  state.counters["exportWhole"] = median(whole);
}

/// A frame of the crowd after another.
void crowd(benchmark::State& state) {
  const std::unique_ptr<taa::Inspector> inspector = openScene("builtin:crowd");
  std::vector<double> scene;
  for (auto _ : state) {
    const double time = seconds([&] { inspector->shot().advance(); });
    scene.push_back(inspector->shot().times().scene);
    state.SetIterationTime(time);
  }
  state.counters["crowdScene"] = median(scene);
}

} // namespace

BENCHMARK(exportExr)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(15);
BENCHMARK(crowd)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(30);
