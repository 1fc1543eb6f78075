// The one exception type: the world's mistake (a file, a shader, a driver), told in a sentence.
#pragma once

#include <stdexcept>
#include <string>

namespace taa {

/// Says what happened, where, and what to do next, in one sentence for a user. Our own mistakes assert
/// instead.
class Error : public std::runtime_error {
 public:
  /// Whatever texts of files are in it, it is one line then, as shownLine() makes it.
  explicit Error(const std::string& message);
  /// A sentence with what a compiler says below it; its lines stay lines.
  static Error withLog(const std::string& message);

 private:
  struct Shown {
    std::string text;
  };
  explicit Error(const Shown& shown) : std::runtime_error(shown.text) {}
};

/// Thrown by long work whose progress callback asked it to stop. Nothing is wrong; nothing was changed.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled") {}
};

} // namespace taa
