// A session: what is read is written so that it is read as the same.
#include "core/io/SessionFile.h"
#include "tests/fuzz/Fuzz.h"

#include <cstddef>
#include <cstdint>
#include <string>

using namespace taa;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  const std::string place = "a.taa.json";
  fuzz::readsOrRefuses("cannot open the session " + place + ": ", [&] {
    const std::string written = sessionToText(sessionFromText(fuzz::textOf(bytes, count), place));
    SessionFile again;
    const bool isRead = fuzz::readsOrRefuses("", [&] { again = sessionFromText(written, place); });
    fuzz::require(isRead, "a written session is refused: " + written);
    fuzz::require(sessionToText(again) == written, "a session changes when it is written: " + written);
  });
  return 0;
}
