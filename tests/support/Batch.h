// taa-batch of this build, as users and scripts call it.
#pragma once

#include "tests/support/Process.h"

#include <string>
#include <vector>

namespace taa::test {

ProcessResult batch(std::vector<std::string> arguments);

std::vector<std::string> joined(std::vector<std::string> a, const std::vector<std::string>& b);

/// Mistakes of the caller, and of the world: these words on stderr, nothing on stdout, and the exit code.
void expectUsageError(const std::vector<std::string>& arguments, const std::vector<std::string>& words);
void expectFailure(const std::vector<std::string>& arguments, const std::vector<std::string>& words);

} // namespace taa::test
