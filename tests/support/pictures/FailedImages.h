// Pictures of a comparison that failed: expected, actual and their difference.
#pragma once

#include "core/base/Image.h"

#include <filesystem>
#include <string>

namespace taa::test {

/// Where pictures of the running test go: failed-images/SUITE.NAME in the build's folder. What an earlier
/// run of the test left there is gone when it is asked for the first time.
std::filesystem::path failedImagesOfTest();

/// Writes N-expected, N-actual and N-difference into `folder`, N being the first that is free: PNG where all
/// values of a picture are within 0 and 1, else EXR. The difference is the largest of the pixel's channels,
/// white where it is largest; red where only one of the two values is finite. Images of different sizes have
/// none. Names the files, or says why there are none; nothing after the first few comparisons of a test.
std::string writeFailedImages(const std::filesystem::path& folder, const Image& actual,
                              const Image& expected);

/// Writes values within 0 and 1 as they are: no transfer function. One channel is gray, of four the last is
/// left out. Throws Error.
void writeValuesAsPng(const std::filesystem::path& path, const Image& image);

/// The values of an 8-bit picture without its alpha, 0 to 1. Throws Error when it cannot be read.
Image readPngValues(const std::filesystem::path& path);

} // namespace taa::test
