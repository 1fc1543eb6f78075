#include "core/io/PictureFile.h"

#include "core/base/Files.h"
#include "core/base/Say.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cassert>
#include <memory>
#include <string>
#include <vector>

namespace taa {

namespace {

/// What is packed for: in messages.
std::string packedPngOf(const std::string& place, int width, int height, std::span<const std::uint8_t> rgba) {
  assert(rgba.size() == static_cast<std::size_t>(width) * height * 4);
  OIIO::ImageSpec spec(width, height, 4, OIIO::TypeUInt8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  spec.attribute("oiio:UnassociatedAlpha", 1);
  OIIO::Filesystem::IOVecOutput packed;
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create("png");
  if (!output) throw Error(say<"cannot write %1: OpenImageIO was built without PNG">(place));
  if (!output->set_ioproxy(&packed) || !output->open(place, spec) ||
      !output->write_image(OIIO::TypeUInt8, rgba.data()) || !output->close())
    throw Error(say<"cannot write %1: %2">(place, output->geterror()));
  const std::vector<unsigned char>& bytes = packed.buffer();
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

} // namespace

std::string packedPng(int width, int height, std::span<const std::uint8_t> rgba) {
  return packedPngOf("picture.png", width, height, rgba);
}

// Packed in memory, because the packer does not notice a full disk.
void writePng(const std::filesystem::path& path, int width, int height, std::span<const std::uint8_t> rgba) {
  writeFile(path, packedPngOf(path.string(), width, height, rgba));
}

} // namespace taa
