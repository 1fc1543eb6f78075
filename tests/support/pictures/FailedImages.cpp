// Pictures of a comparison that failed.
#include "tests/support/pictures/FailedImages.h"

#include "core/base/Error.h"
#include "core/io/PictureFile.h"
#include "tests/support/Paths.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <memory>
#include <set>
#include <system_error>
#include <vector>

namespace taa::test {

namespace fs = std::filesystem;

namespace {

/// Comparisons of a test that leave pictures; a test that goes wrong in all frames would fill the disk.
constexpr int kMaxComparisons = 4;

std::string nameOfTest() {
  const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
  if (!test) return "no test";
  std::string name = std::string(test->test_suite_name()) + "." + test->name();
  std::ranges::replace(name, '/', '_');
  return name;
}

bool isShownByBytes(const Image& image) {
  return std::ranges::all_of(image.pixels, [](float value) { return value >= 0.0f && value <= 1.0f; });
}

void writeExr(const fs::path& path, const Image& image) {
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create("openexr");
  const OIIO::ImageSpec spec(image.width, image.height, image.channels, OIIO::TypeFloat);
  if (!output || !output->open(path.string(), spec) ||
      !output->write_image(OIIO::TypeFloat, image.pixels.data()) || !output->close())
    throw Error("cannot write " + path.string());
}

std::string write(const fs::path& folder, const std::string& name, const Image& image) {
  const bool isPng = isShownByBytes(image);
  const std::string file = name + (isPng ? ".png" : ".exr");
  if (isPng)
    writeValuesAsPng(folder / file, image);
  else
    writeExr(folder / file, image);
  return file;
}

/// The largest finite difference of a pixel's channels; negative: one of them is finite in one image alone.
float apart(const Image& a, const Image& b, int x, int y) {
  float largest = 0.0f;
  for (int channel = 0; channel < a.channels; ++channel) {
    const float first = a.at(x, y)[channel], second = b.at(x, y)[channel];
    if (first == second || (std::isnan(first) && std::isnan(second))) continue;
    if (!std::isfinite(first) || !std::isfinite(second)) return -1.0f;
    largest = std::max(largest, std::abs(first - second));
  }
  return largest;
}

Image differenceOf(const Image& a, const Image& b) {
  Image image(a.width, a.height, 3);
  float largest = 0.0f;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) largest = std::max(largest, apart(a, b, x, y));
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      const float value = apart(a, b, x, y);
      if (value < 0.0f)
        image.at(x, y)[0] = 1.0f;
      else if (value > 0.0f) // the square root keeps small ones visible beside the largest
        std::fill_n(image.at(x, y), 3, std::sqrt(value / largest));
    }
  return image;
}

std::string freeNumber(const fs::path& folder) {
  for (int number = 1; number <= kMaxComparisons; ++number) {
    const std::string name = std::to_string(number);
    if (!fs::exists(folder / (name + "-actual.png")) && !fs::exists(folder / (name + "-actual.exr")))
      return name;
  }
  return {};
}

} // namespace

fs::path failedImagesOfTest() {
  static std::set<fs::path> asked;
  fs::path folder = binary("").parent_path().parent_path() / "failed-images" / nameOfTest();
  std::error_code ignored;
  if (asked.insert(folder).second) fs::remove_all(folder, ignored);
  return folder;
}

std::string writeFailedImages(const fs::path& folder, const Image& actual, const Image& expected) {
  try {
    fs::create_directories(folder);
    const std::string number = freeNumber(folder);
    if (number.empty()) return {};
    std::string text = "pictures in " + folder.string() + ":";
    if (!expected.empty()) text += " " + write(folder, number + "-expected", expected);
    if (!actual.empty()) text += " " + write(folder, number + "-actual", actual);
    if (actual.width == expected.width && actual.height == expected.height &&
        actual.channels == expected.channels)
      text += " " + write(folder, number + "-difference", differenceOf(actual, expected));
    return text;
  } catch (const std::exception& error) {
    return std::string("no pictures: ") + error.what();
  }
}

void writeValuesAsPng(const fs::path& path, const Image& image) {
  std::vector<std::uint8_t> rgba;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int channel = 0; channel < 4; ++channel) {
        const int from = image.channels == 1 ? 0 : channel;
        const float value = channel == 3 ? 1.0f : from < image.channels ? image.at(x, y)[from] : 0.0f;
        rgba.push_back(static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f)));
      }
  writePng(path, image.width, image.height, rgba);
}

Image readPngValues(const fs::path& path) {
  const auto input = OIIO::ImageInput::open(path.string());
  if (!input) throw Error("cannot read " + path.string() + ": " + OIIO::geterror());
  const OIIO::ImageSpec spec = input->spec();
  Image image(spec.width, spec.height, std::min(spec.nchannels, 3));
  std::vector<std::uint8_t> bytes(image.pixels.size());
  if (!input->read_image(0, 0, 0, image.channels, OIIO::TypeUInt8, bytes.data()))
    throw Error("cannot read " + path.string() + ": " + input->geterror());
  std::ranges::transform(bytes, image.pixels.begin(),
                         [](std::uint8_t value) { return static_cast<float>(value) / 255.0f; });
  return image;
}

} // namespace taa::test
