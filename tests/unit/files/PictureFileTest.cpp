// PNG files.
#include "core/io/PictureFile.h"

#include "core/base/Error.h"
#include "tests/support/Paths.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <vector>

TEST(PictureFile, ReadsBackTheSameBytes) {
  const std::filesystem::path path = taa::test::temporaryFolder() / "a.png";
  std::vector<std::uint8_t> rgba(3 * 2 * 4);
  for (std::size_t index = 0; index < rgba.size(); ++index)
    rgba[index] = static_cast<std::uint8_t>(index * 11);
  taa::writePng(path, 3, 2, rgba);
  OIIO::ImageSpec keepAlpha;
  keepAlpha.attribute("oiio:UnassociatedAlpha", 1);
  const auto input = OIIO::ImageInput::open(path.string(), &keepAlpha);
  ASSERT_TRUE(input);
  ASSERT_EQ(input->spec().nchannels, 4);
  std::vector<std::uint8_t> read(rgba.size());
  ASSERT_TRUE(input->read_image(0, 0, 0, 4, OIIO::TypeUInt8, read.data()));
  EXPECT_EQ(read, rgba);
}

TEST(PictureFile, SaysWhereItCannotBeWritten) {
  const std::vector<std::uint8_t> rgba(4);
  EXPECT_THROW(taa::writePng("/nowhere/a.png", 1, 1, rgba), taa::Error);
}
