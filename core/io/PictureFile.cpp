#include "core/io/PictureFile.h"

#include "core/base/Files.h"
#include "core/base/Say.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cassert>
#include <memory>
#include <vector>

namespace taa {

void writePng(const std::filesystem::path& path, int width, int height, std::span<const std::uint8_t> rgba) {
  assert(rgba.size() == static_cast<std::size_t>(width) * height * 4);
  OIIO::ImageSpec spec(width, height, 4, OIIO::TypeUInt8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  spec.attribute("oiio:UnassociatedAlpha", 1);
  // Packed in memory, because the packer does not notice a full disk.
  OIIO::Filesystem::IOVecOutput packed;
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create("png");
  if (!output) throw Error(say<"cannot write %1: OpenImageIO was built without PNG">(path.string()));
  if (!output->set_ioproxy(&packed) || !output->open(path.string(), spec) ||
      !output->write_image(OIIO::TypeUInt8, rgba.data()) || !output->close())
    throw Error(say<"cannot write %1: %2">(path.string(), output->geterror()));
  const std::vector<unsigned char>& bytes = packed.buffer();
  writeFile(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

} // namespace taa
