// Finished pictures one after another as an animated GIF.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

namespace taa {

/// Hundredths of a second that GIF shows a picture of this rate: 2 at least, because viewers slow down what
/// is faster.
int gifDelay(double framesPerSecond);

/// Writes into `path` itself, picture after picture; nothing is promised of the file before finish() returns.
/// Throws Error, and names `shown` in it.
class GifWriter {
 public:
  GifWriter(const std::filesystem::path& path, const std::filesystem::path& shown, int width, int height,
            double framesPerSecond);
  ~GifWriter();
  GifWriter(const GifWriter&) = delete;
  GifWriter& operator=(const GifWriter&) = delete;

  /// width · height RGBA, row 0 the top; what is not covered becomes black.
  void add(std::span<const std::uint8_t> rgba);
  /// Closes the file and makes sure that it is whole.
  void finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace taa
