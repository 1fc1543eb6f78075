// A preset: what is read is written so that it is read as the same.
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"
#include "tests/fuzz/Fuzz.h"

#include <cstddef>
#include <cstdint>
#include <string>

using namespace taa;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  const std::string place = "own.json";
  fuzz::readsOrRefuses("cannot read preset " + place + ": ", [&] {
    const Preset read = presetFromText(fuzz::textOf(bytes, count), place);
    const std::string written = presetToText(read);
    Preset again;
    const bool isRead = fuzz::readsOrRefuses("", [&] { again = presetFromText(written, place); });
    fuzz::require(isRead, "a written preset is refused: " + written);
    fuzz::require(again.settings == read.settings && presetToText(again) == written,
                  "a preset changes when it is written: " + written);
  });
  return 0;
}
