// Animated GIFs through OpenImageIO, which does not notice a full disk: the file is looked at when it is
// done.
#include "core/io/GifFile.h"

#include "core/base/Error.h"
#include "core/base/Files.h"
#include "core/base/Say.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

namespace taa {

namespace fs = std::filesystem;

int gifDelay(double framesPerSecond) {
  return std::max(2, static_cast<int>(std::lround(100.0 / framesPerSecond)));
}

namespace {

/// Sets what each picture of a GIF is shown for, in hundredths of a second: OpenImageIO 2.5 writes 100
/// whatever rate it is given. Stops where the file ends or is none (GIF89a specification, Appendix A).
void setDelays(std::string& gif, int delay) {
  const auto byteAt = [&gif](std::size_t at) -> std::size_t { return static_cast<unsigned char>(gif[at]); };
  const auto tableBytes = [](std::size_t flags) {
    return flags & 0x80 ? std::size_t(3) << ((flags & 7) + 1) : 0;
  };
  if (gif.size() < 13) return;
  std::size_t at = 13 + tableBytes(byteAt(10));
  while (at + 9 < gif.size()) {
    const bool isExtension = byteAt(at) == 0x21;
    if (!isExtension && byteAt(at) != 0x2C) return;
    if (isExtension && byteAt(at + 1) == 0xF9) {
      gif[at + 4] = static_cast<char>(delay & 0xFF);
      gif[at + 5] = static_cast<char>(delay >> 8);
    }
    at += isExtension ? 2 : 10 + tableBytes(byteAt(at + 9)) + 1; // to the first block of data
    while (at < gif.size() && byteAt(at) != 0) at += byteAt(at) + 1;
    ++at;
  }
}

} // namespace

struct GifWriter::Impl {
  fs::path path, shown;
  OIIO::ImageSpec spec;
  std::unique_ptr<OIIO::ImageOutput> output;
  int pictures = 0;
  int delay = 0; ///< hundredths of a second
  std::vector<std::uint8_t> opaque;

  [[noreturn]] void fail(const std::string& why) const {
    throw Error(say<"cannot write %1: %2">(shown.string(), why));
  }
};

GifWriter::GifWriter(const fs::path& path, const fs::path& shown, int width, int height,
                     double framesPerSecond)
    : impl_(std::make_unique<Impl>()) {
  impl_->path = path;
  impl_->shown = shown;
  impl_->spec = OIIO::ImageSpec(width, height, 4, OIIO::TypeUInt8);
  impl_->delay = gifDelay(framesPerSecond);
  impl_->output = OIIO::ImageOutput::create("gif");
  if (!impl_->output) impl_->fail(say<"OpenImageIO was built without GIF">());
  // Its own words about a file that cannot be made leave the reason out.
  const std::ofstream probe(path, std::ios::binary);
  if (!probe) impl_->fail(std::strerror(errno));
}

GifWriter::~GifWriter() = default;

void GifWriter::add(std::span<const std::uint8_t> rgba) {
  assert(rgba.size() == static_cast<std::size_t>(impl_->spec.width) * impl_->spec.height * 4);
  std::vector<std::uint8_t>& opaque = impl_->opaque;
  opaque.assign(rgba.begin(), rgba.end());
  for (std::size_t at = 0; at < opaque.size(); at += 4) {
    for (std::size_t channel = 0; channel < 3; ++channel)
      opaque[at + channel] = static_cast<std::uint8_t>(opaque[at + channel] * opaque[at + 3] / 255);
    opaque[at + 3] = 255;
  }
  const auto mode = impl_->pictures++ == 0 ? OIIO::ImageOutput::Create : OIIO::ImageOutput::AppendSubimage;
  OIIO::ImageOutput& output = *impl_->output;
  if (!output.open(impl_->path.string(), impl_->spec, mode) ||
      !output.write_image(OIIO::TypeUInt8, opaque.data()))
    impl_->fail(output.geterror());
}

void GifWriter::finish() {
  if (!impl_->output->close()) impl_->fail(impl_->output->geterror());
  std::ifstream file(impl_->path, std::ios::binary);
  file.seekg(-1, std::ios::end);
  constexpr char kTrailer = 0x3B;
  const auto input = OIIO::ImageInput::open(impl_->path.string());
  if (file.get() != kTrailer || !input || !input->seek_subimage(impl_->pictures - 1, 0))
    impl_->fail(say<"not all of it could be stored; is the disk full?">());
  file.close();
  std::string bytes = readFile(impl_->path);
  setDelays(bytes, impl_->delay);
  writeFile(impl_->path, bytes);
}

} // namespace taa
