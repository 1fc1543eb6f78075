// Runs a program as a user would and keeps what it said.
#pragma once

#include <string>
#include <vector>

namespace taa::test {

struct ProcessResult {
  int exitCode = -1; ///< 128 + the signal where one ended it
  std::string out, err;
};

/// Runs `command` (the program's path first) without input, terminal or display and waits for its end.
ProcessResult runProcess(const std::vector<std::string>& command);

} // namespace taa::test
