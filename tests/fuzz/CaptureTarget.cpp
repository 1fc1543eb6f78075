// A capture.json: what is read is written so that it is read as the same.
#include "core/capture/format/Manifest.h"
#include "tests/fuzz/Fuzz.h"

#include <cstddef>
#include <cstdint>
#include <string>

using namespace taa;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  const std::string place = "capture.json";
  fuzz::readsOrRefuses("cannot open the capture " + place + ": ", [&] {
    const std::string written =
        capture::manifestText(capture::parseManifest(fuzz::textOf(bytes, count), place));
    capture::Manifest again;
    const bool isRead = fuzz::readsOrRefuses("", [&] { again = capture::parseManifest(written, place); });
    fuzz::require(isRead, "a written capture is refused: " + written);
    fuzz::require(capture::manifestText(again) == written,
                  "a capture changes when it is written: " + written);
  });
  return 0;
}
