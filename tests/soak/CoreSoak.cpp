// Random requests to the render thread, for so many seconds: taa_soak_core SECONDS SEED LOG [FROM]. Every so
// often the shot is made what it was at the beginning, and has to look as it did: whatever was asked for in
// between.
#include "core/base/ShownText.h"
#include "core/jobs/RenderThread.h"
#include "tests/soak/RandomRequests.h"
#include "tests/soak/Watch.h"

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <mutex>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

using namespace taa;

namespace {

constexpr int kWidth = 32, kHeight = 18, kFrame = 5, kStepsBetween = 60;

void finding(const std::string& sentence) {
  std::fprintf(stderr, "FINDING: %s\n", sentence.c_str());
  std::abort();
}

/// The last picture of the first view, and whether all that is said can be shown.
class Listening {
 public:
  /// `watch`: something goes on while answers come.
  explicit Listening(soak::Watch& watch) : watch_(watch) {}

  Listener listener() {
    return [this](Answer answer) {
      watch_.tick();
      std::visit([this](const auto& result) { take(result); }, answer.result);
    };
  }
  std::vector<std::uint8_t> picture() {
    const std::lock_guard lock(mutex_);
    return picture_;
  }
  int failures() {
    const std::lock_guard lock(mutex_);
    return failures_;
  }
  /// What that picture is of, and the last failure.
  std::string said() {
    const std::lock_guard lock(mutex_);
    return said_ + (failure_.empty() ? "" : "; the last refusal: " + failure_);
  }

 private:
  template <typename Result>
  void take(const Result& result) {
    const std::lock_guard lock(mutex_);
    if constexpr (std::is_same_v<Result, ViewResult>) {
      if (result.view == 0) {
        picture_ = result.picture.rgba;
        said_ = std::to_string(result.picture.width) + "x" + std::to_string(result.picture.height) +
                " px of frame " + std::to_string(result.frame) + (result.exact ? ", exact" : ", not exact");
      }
    } else if constexpr (std::is_same_v<Result, Failure>) {
      ++failures_;
      failure_ = result.sentence;
      if (!isPlainText(result.sentence)) finding("a failure is not one plain line: " + result.sentence);
    } else if constexpr (std::is_same_v<Result, Status>) {
      if (result.frameCount > 0 && (result.info.frame < 0 || result.info.frame >= result.frameCount))
        finding("frame " + std::to_string(result.info.frame) + " is not in the shot");
    }
  }

  soak::Watch& watch_;
  std::mutex mutex_;
  std::vector<std::uint8_t> picture_;
  std::string said_, failure_;
  int failures_ = 0;
};

/// The picture of one frame of a shot that nothing was changed about.
std::vector<std::uint8_t> knownPicture(RenderThread& thread, Listening& listening) {
  ViewRequest view;
  view.style = defaultStyle(intermediate(view.id));
  view.width = kWidth;
  view.height = kHeight;
  const std::vector<Request> plain{request::Cancel{},
                                   request::SetViews{},
                                   request::SetReferenceSamples{4}, // metrics want one of each frame
                                   request::SetRecording{false},
                                   request::SetPlaying{false},
                                   request::SetSettings{},
                                   request::SetOtherLanes{},
                                   request::Open{"builtin:fan"},
                                   request::SetSize{kWidth, kHeight}, // a capture has its own
                                   request::SetMotionModes{},
                                   request::SetObjectFilter{},
                                   request::SetObjectClasses{},
                                   request::SetRestarts{},
                                   request::SetFlownCameras{{{}, "orbit"}},
                                   request::Seek{kFrame}};
  for (const Request& each : plain) {
    thread.post(each);
    thread.waitUntilIdle();
  }
  thread.post(request::SetViews{{view}});
  thread.waitUntilIdle();
  return listening.picture();
}

/// What was asked for before step `from` is left out.
int goOn(double seconds, unsigned seed, const char* log, int from) {
  const std::string again =
      std::string("taa_soak_core ") + std::to_string(seconds) + " " + std::to_string(seed);
  std::ofstream out(log, std::ios::trunc);
  std::mt19937 random(seed);
  soak::Watch watch(again);
  Listening listening(watch);
  RenderThread thread(listening.listener());
  const std::vector<std::uint8_t> first = knownPicture(thread, listening);
  if (first.empty()) finding("there is no first picture");
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  int steps = 0, comparisons = 0;
  for (; std::chrono::steady_clock::now() < end; watch.tick()) {
    ++steps;
    soak::RandomRequest next = soak::randomRequest(random);
    if (steps < from) {
      random(); // as below
      continue;
    }
    out << steps << " " << next.text << '\n';
    out.flush(); // the last line is what it was about
    thread.post(std::move(next.request));
    const bool waits = random() % 4 == 0;
    if (waits) thread.waitUntilIdle();
    if (steps % kStepsBetween != 0) continue;
    if (knownPicture(thread, listening) != first)
      finding("the shot looks otherwise than at the beginning after step " + std::to_string(steps) + " of " +
              again + ": " + listening.said());
    ++comparisons;
  }
  std::printf("core: %d requests in %.0f s, %d refused, %d times back at the beginning, nothing found\n",
              steps, seconds, listening.failures(), comparisons);
  return 0;
}

} // namespace

int main(int count, char** words) {
  if (count != 4 && count != 5) {
    std::fprintf(stderr,
                 "Usage: taa_soak_core SECONDS SEED LOG [FROM]\nFROM: the first step that is taken\n");
    return 2;
  }
  return goOn(std::stod(words[1]), static_cast<unsigned>(std::stoul(words[2])), words[3],
              count == 5 ? std::stoi(words[4]) : 1);
}
