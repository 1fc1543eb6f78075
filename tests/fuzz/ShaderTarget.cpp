// Shaders of a folder of somebody's own that include each other. The input is the first one, and after each
// line "//// NAME" the next.
#include "core/base/EmbeddedFiles.h"
#include "core/gl/Program.h"
#include "tests/fuzz/Fuzz.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <sstream>
#include <string>

using namespace taa;

namespace {

ShaderTexts textsOf(const std::string& input) {
  ShaderTexts texts;
  std::string name = "main.frag";
  std::istringstream lines(input);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("//// "))
      name = line.substr(5);
    else
      texts["shaders/" + name] += line + "\n";
  return texts;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  useShaders(std::make_shared<const ShaderTexts>(textsOf(fuzz::textOf(bytes, count))));
  fuzz::readsOrRefuses("", [&] {
    const gl::ShaderSource source("main.frag", "const bool kOn = false;");
    fuzz::require(source.text().size() <= source.fullText().size(), "a shader grows by what is left out");
    source.readableLog(source.fullText());
    source.readableLog("2:17(3): error\n2(17) : error\n0:200017(3): error");
  });
  return 0;
}
