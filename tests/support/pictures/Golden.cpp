// Golden pictures: read, compared, and written by a command.
#include "tests/support/pictures/Golden.h"

#include "tests/support/Paths.h"
#include "tests/support/pictures/FailedImages.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>

namespace taa::test {

namespace fs = std::filesystem;

namespace {

bool isUpdating() {
  const char* value = std::getenv("TAA_UPDATE_GOLDEN");
  return value && *value;
}

/// With the values that a file of 8 bits holds.
Image rounded(Image image) {
  for (float& value : image.pixels)
    value = static_cast<float>(static_cast<int>(std::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f)) / 255.0f;
  return image;
}

void update(const fs::path& file, const Image& actual, const Limits& limits) {
  if (fs::exists(file) && compare(rounded(actual), readPngValues(file), limits).agrees) return;
  fs::create_directories(file.parent_path());
  writeValuesAsPng(file, actual);
  std::cout << "wrote " << file.string() << std::endl;
}

} // namespace

fs::path goldenFolder() {
  return rootFolder() / "tests" / "image" / "golden";
}

std::string differenceFromGolden(const std::string& name, const Image& actual, const Limits& limits,
                                 const fs::path& folder) {
  const fs::path file = folder / (name + ".png");
  if (isUpdating()) {
    update(file, actual, limits);
    return {};
  }
  if (!fs::exists(file))
    return "there is no " + file.string() + ": look at the picture that tests/golden writes and commit it; " +
           writeFailedImages(failedImagesOfTest(), actual, {});
  const std::string text = difference(rounded(actual), readPngValues(file), limits);
  return text.empty() ? text : "not what " + file.string() + " shows: " + text;
}

std::set<std::string> goldenNames(const std::string& prefix, const fs::path& folder) {
  std::set<std::string> names;
  if (!fs::exists(folder)) return names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".png" && entry.path().stem().string().starts_with(prefix))
      names.insert(entry.path().stem().string());
  return names;
}

Image averaged(const Image& image, int side) {
  Image means(image.width / side, image.height / side, image.channels);
  const auto texels = static_cast<float>(side * side);
  for (int y = 0; y < means.height * side; ++y)
    for (int x = 0; x < means.width * side; ++x)
      for (int channel = 0; channel < image.channels; ++channel)
        means.at(x / side, y / side)[channel] += image.at(x, y)[channel] / texels;
  return means;
}

} // namespace taa::test
