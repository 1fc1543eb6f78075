#include "tests/support/TestNames.h"

#include "core/base/Files.h"

#include <filesystem>
#include <regex>
#include <vector>

namespace taa::test {

namespace fs = std::filesystem;

namespace {

/// What the pattern finds in the sources of tests.
std::vector<std::string> found(const std::regex& pattern, const char* format) {
  std::vector<std::string> all;
  for (const fs::directory_entry& entry :
       fs::recursive_directory_iterator(fs::path(TAA_SOURCE_DIR) / "tests")) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string text = readFile(entry.path().string(), 1 << 20);
    for (std::sregex_iterator each(text.begin(), text.end(), pattern), end; each != end; ++each)
      all.push_back(each->format(format));
  }
  return all;
}

} // namespace

std::set<std::string> testNames() {
  const std::vector<std::string> names = found(std::regex(R"(\nTEST(?:_[FP])?\((\w+),\s*(\w+)\))"), "$1.$2");
  return {names.begin(), names.end()};
}

std::set<std::string> techniquesWithTests() {
  std::set<std::string> techniques;
  const std::regex id("[^, ]+");
  for (const std::string& list : found(std::regex(R"(\n// Techniques: (.*)\.\nTEST(?:_[FP])?\()"), "$1"))
    for (std::sregex_iterator each(list.begin(), list.end(), id), end; each != end; ++each)
      techniques.insert(each->str());
  return techniques;
}

} // namespace taa::test
