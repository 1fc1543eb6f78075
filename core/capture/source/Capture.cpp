#include "core/capture/source/Capture.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/capture/import/Guess.h"
#include "core/capture/planes/Planes.h"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <iterator>
#include <list>
#include <map>
#include <mutex>
#include <new>
#include <optional>
#include <set>
#include <system_error>
#include <thread>
#include <utility>

namespace taa::capture {

namespace fs = std::filesystem;

namespace {

using Frame = std::shared_ptr<const DecodedFrame>;

/// Frames that are kept whatever their size: the one that is shown and the one that comes next.
constexpr std::size_t kAlwaysKept = 2;

std::size_t bytesOf(const DecodedFrame& frame) {
  std::size_t values = frame.objectId.size();
  for (const Image* image : {&frame.color, &frame.motion, &frame.depth, &frame.normal, &frame.previousDepth,
                             &frame.mask, &frame.overlay, &frame.fog, &frame.output, &frame.reference})
    values += image->pixels.size();
  return values * sizeof(float);
}

} // namespace

/// Frames by when they were last asked for, within a budget.
class FrameCache {
 public:
  explicit FrameCache(std::size_t budget) : budget_(budget) {}

  bool contains(int index) const { return find(index) != kept_.end(); }

  /// Null where it is not kept; it becomes the newest.
  Frame take(int index) {
    const auto found = find(index);
    if (found == kept_.end()) return {};
    kept_.splice(kept_.begin(), kept_, found);
    return found->second;
  }

  void keep(int index, Frame frame) {
    kept_.emplace_front(index, std::move(frame));
    std::size_t bytes = 0, frames = 0;
    for (auto at = kept_.begin(); at != kept_.end(); ++frames) {
      if (frames >= kAlwaysKept) bytes += bytesOf(*at->second);
      at = bytes > budget_ ? kept_.erase(at, kept_.end()) : std::next(at);
    }
  }

 private:
  using Entries = std::list<std::pair<int, Frame>>; // the newest first

  Entries::iterator find(int index) { return std::ranges::find(kept_, index, &Entries::value_type::first); }
  Entries::const_iterator find(int index) const {
    return std::ranges::find(kept_, index, &Entries::value_type::first);
  }

  std::size_t budget_;
  Entries kept_;
};

struct Capture::Impl {
  Impl(fs::path folder_, Manifest manifest_, std::size_t budget)
      : folder(std::move(folder_)), manifest(std::move(manifest_)), cache(budget) {}

  const fs::path folder;
  const Manifest manifest;

  std::mutex mutex; // held for a moment only: never while a frame is read
  std::condition_variable changed;
  FrameCache cache;
  std::set<int> onTheWay;                     // frames that a thread reads
  std::map<int, std::exception_ptr> failures; // of frames that were read ahead, till they are asked for
  std::optional<int> ahead;                   // the frame to read next in the background
  int lastAsked = -1;
  bool ends = false;
  std::thread thread; // begun with the first frame to read ahead

  Frame frame(int index);
  Frame read(int index, std::unique_lock<std::mutex>& lock, bool isAhead);
  FramePlanes planesAhead(const CapturedFrame& frame);
  void lookAhead(int index);
  void run();
};

/// File by file, so that closing a capture need not wait for a whole frame. Throws Error, Cancelled.
FramePlanes Capture::Impl::planesAhead(const CapturedFrame& frame) {
  return readPlanesInTurn(folder, manifest, frame, [this] {
    const std::lock_guard lock(mutex);
    if (ends) throw Cancelled();
  });
}

/// Expects the lock, and that nobody reads the frame. Throws what reading it throws, with the lock held
/// again.
Frame Capture::Impl::read(int index, std::unique_lock<std::mutex>& lock, bool isAhead) {
  onTheWay.insert(index);
  lock.unlock();
  Frame frame;
  std::exception_ptr failure;
  try {
    const auto at = static_cast<std::size_t>(index);
    const CapturedFrame& stated = manifest.frames[at];
    FramePlanes planes = isAhead ? planesAhead(stated) : readPlanes(folder, manifest, stated);
    frame = std::make_shared<const DecodedFrame>(decode(manifest, at, std::move(planes)));
  } catch (const Error& error) {
    failure =
        std::make_exception_ptr(Error(say<"cannot read the capture %1: %2">(folder.string(), error.what())));
  } catch (const std::bad_alloc&) {
    const int number = manifest.frames[static_cast<std::size_t>(index)].number;
    failure = std::make_exception_ptr(Error(say<"there is not enough memory for frame %1">(number)));
  } catch (...) {
    failure = std::current_exception();
  }
  lock.lock();
  onTheWay.erase(index);
  changed.notify_all();
  if (failure) std::rethrow_exception(failure);
  cache.keep(index, frame);
  return frame;
}

void Capture::Impl::lookAhead(int index) {
  const int next = index < lastAsked ? index - 1 : index + 1;
  lastAsked = index;
  const bool exists = next >= 0 && next < static_cast<int>(manifest.frames.size());
  if (!exists || cache.contains(next) || onTheWay.contains(next) || failures.contains(next)) return;
  ahead = next;
  changed.notify_all();
  if (thread.joinable()) return;
  try {
    thread = std::thread([this] { run(); });
  } catch (const std::system_error&) { // no more threads: frames are read when they are asked for
  }
}

Frame Capture::Impl::frame(int index) {
  std::unique_lock lock(mutex);
  changed.wait(lock, [&] { return !onTheWay.contains(index); });
  if (const auto failed = failures.find(index); failed != failures.end()) {
    // Told once; who asks again has it read again.
    const std::exception_ptr failure = failed->second;
    failures.erase(failed);
    std::rethrow_exception(failure);
  }
  Frame frame = cache.take(index);
  if (!frame) frame = read(index, lock, false);
  lookAhead(index);
  return frame;
}

void Capture::Impl::run() {
  std::unique_lock lock(mutex);
  while (true) {
    changed.wait(lock, [&] { return ends || ahead; });
    if (ends) return;
    const int index = *std::exchange(ahead, {});
    if (cache.contains(index) || onTheWay.contains(index)) continue;
    try {
      read(index, lock, true);
    } catch (const Cancelled&) {
      return;
    } catch (...) {
      failures[index] = std::current_exception();
    }
  }
}

Capture::Capture(fs::path folder, Manifest manifest, std::size_t budget)
    : impl_(std::make_unique<Impl>(std::move(folder), std::move(manifest), budget)) {}

Capture::~Capture() {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->ends = true;
  }
  impl_->changed.notify_all();
  if (impl_->thread.joinable()) impl_->thread.join();
}

const fs::path& Capture::folder() const {
  return impl_->folder;
}

const Manifest& Capture::manifest() const {
  return impl_->manifest;
}

int Capture::frames() const {
  return static_cast<int>(impl_->manifest.frames.size());
}

std::shared_ptr<const DecodedFrame> Capture::frame(int index) const {
  if (index < 0 || index >= frames())
    throw Error(say<"there is no frame %1 in this capture; it has %2">(index, frames()));
  return impl_->frame(index);
}

bool Capture::isReady(int index) const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->cache.contains(index);
}

namespace {

/// A folder may have an ending, too.
bool isManifest(const fs::path& path) {
  std::error_code ignored;
  return path.extension() == ".json" && !fs::is_directory(path, ignored);
}

} // namespace

std::string nameOf(const fs::path& folder) {
  const fs::path whole = fs::absolute(folder).lexically_normal();
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

bool isCapture(const std::string& source) {
  std::error_code ignored;
  return fs::is_directory(source, ignored) || isManifest(source);
}

fs::path folderOf(const std::string& source) {
  const fs::path path(source);
  if (!isManifest(path)) return path;
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

std::shared_ptr<const Capture> openCapture(const std::string& source, const Progress& progress) {
  const fs::path folder = folderOf(source);
  std::error_code ignored;
  const std::string name = isManifest(source) ? fs::path(source).filename().string() : kManifestName;
  const bool isStated = isManifest(source) || fs::exists(folder / name, ignored);
  Manifest manifest = isStated ? readManifest(folder, name) : guessCapture(folder, "", {}, progress).manifest;
  const auto capture = std::make_shared<const Capture>(folder, std::move(manifest));
  static_cast<void>(capture->frame(0));
  return capture;
}

} // namespace taa::capture
