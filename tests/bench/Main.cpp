// Runs the benchmarks; with --write-manual also writes their table into the manual.
#include "core/base/Error.h"
#include "core/gl/Context.h"
#include "tests/bench/Figures.h"
#include "tests/support/Paths.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <string>
#include <vector>

namespace {

/// Whether a benchmark had to stop; Google Benchmark 1.8 gave the member another name.
template <typename Run>
bool wasStopped(const Run& run) {
  if constexpr (requires { run.error_occurred; })
    return run.error_occurred;
  else
    return static_cast<int>(run.skipped) != 0;
}

/// Prints as always and keeps the counters. A figure measured twice keeps the later one.
class FigureReporter : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      failed = failed || wasStopped(run);
      for (const auto& [name, counter] : run.counters) figures[name] = counter.value;
    }
    ConsoleReporter::ReportRuns(runs);
  }

  taa::bench::Figures figures;
  bool failed = false;
};

std::string driverName() {
  const taa::gl::Context context;
  return context.driver().renderer + ", " + context.driver().version;
}

} // namespace

int main(int argc, char** argv) {
  // What is said to be compiled is. Mesa reads its variable once in a process.
  ::setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
  bool write = false;
  for (int index = 1; index < argc; ++index)
    if (std::strcmp(argv[index], "--write-manual") == 0) {
      write = true;
      std::rotate(argv + index, argv + index + 1, argv + argc);
      --argc;
    }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  try {
    taa::bench::registerPresets();
    FigureReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    const std::string table = taa::bench::figuresTable(reporter.figures, driverName());
    std::cout << '\n' << table;
    if (write && !reporter.failed)
      taa::bench::writeFigures(taa::test::rootFolder() / "resources/manual/figures.md", table);
    return reporter.failed ? 1 : 0;
  } catch (const taa::Error& error) {
    std::cerr << "taa_bench: " << error.what() << '\n';
    return 1;
  }
}
