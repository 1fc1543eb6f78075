// Answers of the pixels that are known beforehand, in the place of those that the import page would work out.
#pragma once

#include "app/importing/ImportWork.h"

#include <cstddef>
#include <mutex>
#include <string>
#include <vector>

namespace taa::app::test {

/// With what a guess was begun.
struct AskedGuess {
  std::string like;
  std::vector<std::string> assignments;
};

/// What the thread of the guesses is told and asks.
class GuessLog {
 public:
  void add(const AskedGuess& guess) {
    const std::lock_guard lock(mutex_);
    asked_.push_back(guess);
  }
  std::size_t count() const {
    const std::lock_guard lock(mutex_);
    return asked_.size();
  }
  /// Expects that there is one.
  AskedGuess last() const {
    const std::lock_guard lock(mutex_);
    return asked_.back();
  }
  /// What is guessed where no starting point is stated.
  void setLike(const std::string& id) {
    const std::lock_guard lock(mutex_);
    like_ = id;
  }
  std::string like() const {
    const std::lock_guard lock(mutex_);
    return like_;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<AskedGuess> asked_;
  std::string like_;
};

/// Guesses and measures of the small frames. Direction of motion is sure, jitter's meaning is not, and
/// residuals tell by how much is stated, so that each change can be told by them. `log` outlives them.
ImportFunctions knownAnswers(GuessLog& log);

} // namespace taa::app::test
