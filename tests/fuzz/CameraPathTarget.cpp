// A camera path, as a file and as the pose of a command line: what is read is written so that it is read as
// the same.
#include "core/base/json/LimitedJson.h"
#include "core/io/CameraTrackJson.h"
#include "tests/fuzz/Fuzz.h"

#include <cstddef>
#include <cstdint>
#include <string>

using namespace taa;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  const std::string text = fuzz::textOf(bytes, count);
  fuzz::readsOrRefuses("", [&] {
    const CameraTrack track = cameraTrackFrom(parseLimited(text));
    const std::string written = cameraTrackJson(track).dump();
    CameraTrack again;
    const bool isRead = fuzz::readsOrRefuses("", [&] { again = cameraTrackFrom(parseLimited(written)); });
    fuzz::require(isRead && again == track, "a camera path changes when it is written: " + written);
  });
  fuzz::readsOrRefuses("", [&] {
    const CameraPose pose = parseCameraPose(text);
    fuzz::require(parseCameraPose(poseText(pose)) == pose, "a pose changes when it is written: " + text);
  });
  return 0;
}
