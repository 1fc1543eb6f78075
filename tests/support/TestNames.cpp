#include "tests/support/TestNames.h"

#include "core/base/Files.h"

#include <filesystem>
#include <regex>

namespace taa::test {

namespace fs = std::filesystem;

std::set<std::string> testNames() {
  std::set<std::string> names;
  const std::regex pattern(R"(\nTEST(?:_[FP])?\((\w+),\s*(\w+)\))");
  for (const fs::directory_entry& entry :
       fs::recursive_directory_iterator(fs::path(TAA_SOURCE_DIR) / "tests")) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string text = readFile(entry.path().string(), 1 << 20);
    for (std::sregex_iterator found(text.begin(), text.end(), pattern), end; found != end; ++found)
      names.insert((*found)[1].str() + "." + (*found)[2].str());
  }
  return names;
}

} // namespace taa::test
