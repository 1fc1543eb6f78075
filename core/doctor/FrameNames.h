// Frames in words: by their place in the sequence, and by the number that an engine gave them.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace taa::doctor {

class FrameNames {
 public:
  /// All are called by their places.
  FrameNames() = default;
  /// `numbers`: of all frames, by their places.
  explicit FrameNames(std::vector<int> numbers);

  /// "7"; "7 (number 1008)" where some number is not its place.
  std::string of(int frame) const;
  /// "all frames", "frame 7", "frames 9 to 16", "frames 3, 5, 8 (3 of 24)": of those that were asked, and
  /// their numbers where some number is not its place. Both rise. Expects one frame at least, and that all
  /// were asked.
  std::string of(const std::vector<int>& frames, const std::vector<int>& asked) const;
  /// Nothing where all are called by their places.
  std::optional<int> number(int frame) const;

 private:
  std::vector<int> numbers_; ///< empty: they are their places
};

} // namespace taa::doctor
