#include "tests/app/importing/SmallFrames.h"

#include "core/base/Image.h"
#include "core/capture/planes/Planes.h"

#include <cstddef>
#include <string>

namespace taa::app::test::small_frames {

namespace {

/// A picture without repetition within its width that moves one pixel to the right a frame.
float valueAt(int x, int frame) {
  const int place = x - frame + kFrames;
  return static_cast<float>((place * place * 7) % 19) / 19.0f;
}

capture::PlaneData planeOf(int channels) {
  capture::PlaneData plane;
  plane.width = kWidth;
  plane.height = kHeight;
  plane.image = Image(kWidth, kHeight, channels);
  return plane;
}

} // namespace

capture::Manifest manifestOfFrames() {
  capture::Manifest manifest;
  manifest.name = "small";
  manifest.sizePx = {kWidth, kHeight};
  const auto set = [&](capture::PlaneKind kind, const std::string& file, capture::RawFormat raw) {
    manifest.planes[kind].file = file;
    manifest.planes[kind].raw = raw;
  };
  set(capture::PlaneKind::Color, "color.{frame:4}.raw", capture::RawFormat::RGBA32F);
  set(capture::PlaneKind::Motion, "motion.{frame:4}.raw", capture::RawFormat::RG32F);
  set(capture::PlaneKind::Depth, "depth.{frame:4}.raw", capture::RawFormat::R32F);
  manifest.frames.resize(kFrames);
  for (int frame = 0; frame < kFrames; ++frame)
    manifest.frames[static_cast<std::size_t>(frame)].number = frame + 10;
  return manifest;
}

void writeFrames(const std::filesystem::path& folder) {
  const capture::Manifest manifest = manifestOfFrames();
  for (int frame = 0; frame < kFrames; ++frame) {
    capture::PlaneData color = planeOf(4), motion = planeOf(2), depth = planeOf(1);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        for (int channel = 0; channel < 3; ++channel) color.image.at(x, y)[channel] = valueAt(x, frame);
        color.image.at(x, y)[3] = 1.0f;
        motion.image.at(x, y)[0] = 1.0f;
        depth.image.at(x, y)[0] = 0.1f + 0.05f * static_cast<float>(y);
      }
    const auto write = [&](capture::PlaneKind kind, const capture::PlaneData& plane) {
      const capture::PlaneSource& source = manifest.planes.at(kind);
      capture::writeRawPlane(folder / capture::planeFile(source, frame + 10), plane, *source.raw);
    };
    write(capture::PlaneKind::Color, color);
    write(capture::PlaneKind::Motion, motion);
    write(capture::PlaneKind::Depth, depth);
  }
}

} // namespace taa::app::test::small_frames
