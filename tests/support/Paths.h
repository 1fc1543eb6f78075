// Where the repository and the programs under test are.
#pragma once

#include <filesystem>
#include <string>

namespace taa::test {

/// The repository; tests run in it.
std::filesystem::path rootFolder();

/// A program of this build: binary("taa-batch").
std::filesystem::path binary(const std::string& name);

/// A folder of this process's own, empty, removed at its end.
std::filesystem::path temporaryFolder();

} // namespace taa::test
