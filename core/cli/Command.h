// The commands of taa-batch. Each is one object: a subcommand of CLI11 whose constructor adds its options,
// which are its members, and which runs by them.
#pragma once

#include "core/base/Progress.h"

#include <CLI/CLI.hpp>

#include <iosfwd>
#include <memory>
#include <string>
#include <utility>

namespace taa::cli {

// Exit codes; after a signal 128 and its number, as a shell reports it.
inline constexpr int kDone = 0;
inline constexpr int kWorldsFault = 1;
inline constexpr int kUsage = 2;
inline constexpr int kFindings =
    3; ///< doctor, import --check, lessons --check and verify: something is wrong

class Command : public CLI::App {
 public:
  explicit Command(std::string name) : CLI::App("", std::move(name)) {}
  /// Results go to `out`, nothing else does. Returns the exit code. Throws UsageError, Error, Cancelled.
  virtual int run(std::ostream& out, const Progress& progress) const = 0;
};

// Shared, since CLI11 keeps its subcommands so.
std::shared_ptr<Command> listCommand();
std::shared_ptr<Command> renderCommand();
std::shared_ptr<Command> probeCommand();
std::shared_ptr<Command> lineageCommand();
std::shared_ptr<Command> verdictCommand();
std::shared_ptr<Command> doctorCommand();
std::shared_ptr<Command> traceCommand();
std::shared_ptr<Command> profileCommand();
std::shared_ptr<Command> metricsCommand();
std::shared_ptr<Command> glslCommand();
std::shared_ptr<Command> importCommand();
std::shared_ptr<Command> sweepCommand();
std::shared_ptr<Command> tuneCommand();
std::shared_ptr<Command> lessonsCommand();
std::shared_ptr<Command> verifyCommand();

} // namespace taa::cli
