// taa-batch: the core without a window. The command line, and how the program ends.
#include "core/base/Error.h"
#include "core/base/ShownText.h"
#include "core/cli/Command.h"
#include "core/cli/Options.h"
#include "core/cli/Terminal.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <csignal>
#include <exception>
#include <iostream>
#include <memory>
#include <string>
#include <string_view>
#include <unistd.h>
#include <vector>

namespace {

using namespace taa::cli;

constexpr int kSignalled = 128; // and the number of SIGINT or SIGTERM, as a shell reports it

volatile std::sig_atomic_t interrupted = 0; // the signal; 0: none came

/// One line on a terminal that follows the work and is wiped at the end; silent where stderr is no terminal.
class ProgressLine {
 public:
  ProgressLine() : isTerminal_(::isatty(STDERR_FILENO) == 1) {}
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine() {
    if (isTerminal_) std::cerr << "\r\033[K" << std::flush;
  }
  bool show(std::string_view what, int done, int total) const {
    if (isTerminal_) std::cerr << "\r\033[K" << what << ": " << done << " of " << total << std::flush;
    return interrupted == 0;
  }

 private:
  bool isTerminal_;
};

/// CLI11 only says that a command is missing when the word in its place is none.
void requireCommand(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  if (std::ranges::find(names, argv[1]) == names.end())
    throw UsageError("there is no command \"" + std::string(argv[1]) + "\"; there are " +
                     enumeration(names, " and "));
}

/// In the form of the program's own sentences, with the command whose help says more.
std::string refusalOf(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<CLI::App*> commands = app.get_subcommands();
  const std::string command = commands.empty() ? std::string() : commands.front()->get_name() + " ";
  return std::string(error.what()) + "; taa-batch " + command + "--help says what there is";
}

int run(int argc, char** argv) {
  CLI::App app(
      "Renders frames through TAA, exports any intermediate and answers questions about pixels, without a "
      "window.",
      "taa-batch");
  app.set_version_flag("--version", TAA_VERSION);
  app.require_subcommand(1);
  std::vector<std::shared_ptr<Command>> commands;
  for (const auto make : {listCommand, renderCommand, probeCommand, lineageCommand, verdictCommand,
                          doctorCommand, traceCommand, profileCommand, metricsCommand, glslCommand,
                          importCommand, sweepCommand, tuneCommand, lessonsCommand, verifyCommand}) {
    commands.push_back(make());
    app.add_subcommand(commands.back());
  }
  refuseEmptyValues(app);
  requireCommand(app, argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error); // --help, --version
    throw UsageError(refusalOf(app, error));
  }
  const ProgressLine line;
  const taa::Progress progress = [&line](std::string_view what, int done, int total) {
    return line.show(what, done, total);
  };
  const auto chosen = std::ranges::find_if(commands, [](const auto& command) { return command->parsed(); });
  const int exitCode = (*chosen)->run(std::cout, progress);
  if (!std::cout.flush()) throw taa::Error("cannot write the result to standard output");
  return exitCode;
}

} // namespace

int main(int argc, char** argv) {
  for (const int each : {SIGINT, SIGTERM}) std::signal(each, [](int number) { interrupted = number; });
  try {
    return run(argc, argv);
  } catch (const UsageError& error) {
    tellFailure(error.what());
    return kUsage;
  } catch (const taa::Cancelled&) {
    tellFailure("interrupted; the files written so far are whole");
    return kSignalled + (interrupted != 0 ? interrupted : SIGINT);
  } catch (const std::exception& error) {
    tellFailure(taa::shownReason(error));
    return kWorldsFault;
  }
}
