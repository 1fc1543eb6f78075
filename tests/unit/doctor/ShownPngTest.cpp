// Pictures as PNG, and bytes as text.
#include "core/report/doctor/ShownPng.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace taa {

// RFC 4648, chapter 10.
TEST(ShownPng, WritesBase64) {
  EXPECT_EQ(base64Of(""), "");
  EXPECT_EQ(base64Of("f"), "Zg==");
  EXPECT_EQ(base64Of("fo"), "Zm8=");
  EXPECT_EQ(base64Of("foo"), "Zm9v");
  EXPECT_EQ(base64Of("foob"), "Zm9vYg==");
  EXPECT_EQ(base64Of("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64Of("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64Of("\xff\xfe\xfd"), "//79") << "bytes have no sign";
}

TEST(ShownPng, IsAFile) {
  Image picture(3, 2, 3);
  picture.at(1, 1)[0] = 2.0f;
  picture.at(2, 1)[0] = std::nanf("");
  const std::string bytes = pngOfShown(picture);
  EXPECT_EQ(bytes.substr(1, 3), "PNG");
  EXPECT_EQ(bytes.substr(16, 8), std::string("\0\0\0\3\0\0\0\2", 8)) << "width and height of its header";
}

} // namespace taa
