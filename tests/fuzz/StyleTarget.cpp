// Styles of views and settings as flags and files hold them, an assignment a line: their differences from the
// defaults make them again.
#include "core/picture/StyleText.h"
#include "core/settings/Parameters.h"
#include "tests/fuzz/Fuzz.h"

#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>

using namespace taa;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  ViewStyle style, styleAgain;
  Settings settings, settingsAgain;
  std::istringstream lines(fuzz::textOf(bytes, count));
  constexpr int kMaxLines = 3; // a refusal looks for the nearest of all names
  std::string line;
  for (int read = 0; read < kMaxLines && std::getline(lines, line); ++read) {
    fuzz::readsOrRefuses("", [&] { applyStyle(style, line); });
    fuzz::readsOrRefuses("", [&] { applyAssignment(settings, line); });
  }
  fuzz::require(fuzz::readsOrRefuses("",
                                     [&] {
                                       for (const std::string& text : styleDifferences(style, {}))
                                         applyStyle(styleAgain, text);
                                       for (const std::string& text : differences(settings, {}))
                                         applyAssignment(settingsAgain, text);
                                     }) &&
                    styleAgain == style && settingsAgain == settings,
                "what is written of a style or of settings is not read as the same");
  return 0;
}
