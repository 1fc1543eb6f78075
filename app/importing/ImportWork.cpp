#include "app/importing/ImportWork.h"

#include "app/style/Text.h"
#include "core/base/Error.h"
#include "core/base/ShownText.h"
#include "core/capture/import/SavedImport.h"
#include "core/capture/planes/Planes.h"

#include <QMetaObject>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <exception>
#include <functional>
#include <list>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

namespace taa::app {

namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;
/// Progress is told so often at most: steps can be very short.
constexpr std::chrono::milliseconds kTellEvery{50};

std::size_t taskIndex(ImportTask task) {
  return static_cast<std::size_t>(task);
}

} // namespace

/// Planes of the frames that pictures were made of last, as they are stored: other conventions are decoded
/// without reading them again.
struct ImportWork::PlaneCache {
  struct Entry {
    fs::path folder;
    int reading = 0;
    std::map<capture::PlaneKind, capture::PlaneSource> sources;
    int number = 0;
    capture::RowOrder rows{};
    capture::FramePlanes planes;
  };
  static constexpr std::size_t kKept = 2; ///< a frame and the one before it

  /// Of another `reading` than before, files are thought to be other ones.
  const capture::FramePlanes& of(const fs::path& folder, int reading, const capture::Manifest& manifest,
                                 int index) {
    const capture::CapturedFrame& frame = manifest.frames[static_cast<std::size_t>(index)];
    Entry wanted{folder, reading, sourcesOf(manifest, frame), frame.number, manifest.conventions.rows, {}};
    for (auto at = entries_.begin(); at != entries_.end(); ++at)
      if (at->folder == wanted.folder && at->reading == reading && at->number == wanted.number &&
          at->rows == wanted.rows && at->sources == wanted.sources) {
        entries_.splice(entries_.begin(), entries_, at);
        return entries_.front().planes;
      }
    for (const auto& [kind, source] : wanted.sources)
      wanted.planes.emplace(kind, capture::readPlane(folder, manifest, frame, kind));
    entries_.push_front(std::move(wanted));
    if (entries_.size() > kKept) entries_.pop_back();
    return entries_.front().planes;
  }

 private:
  /// Of what the page shows.
  static std::map<capture::PlaneKind, capture::PlaneSource> sourcesOf(const capture::Manifest& manifest,
                                                                      const capture::CapturedFrame& frame) {
    std::map<capture::PlaneKind, capture::PlaneSource> sources;
    for (const auto kind : {capture::PlaneKind::Color, capture::PlaneKind::Motion, capture::PlaneKind::Depth})
      if (const capture::PlaneSource* source = manifest.plane(frame, kind)) sources.emplace(kind, *source);
    return sources;
  }

  std::list<Entry> entries_; // the newest first
};

ImportWork::ImportWork(ImportFunctions functions, QObject* parent)
    : QObject(parent), functions_(std::move(functions)), planes_(std::make_unique<PlaneCache>()) {}

ImportWork::~ImportWork() = default;

LatestWork& ImportWork::threadOf(ImportTask task) {
  switch (task) {
  case ImportTask::Pictures:
    return pictures_;
  case ImportTask::Save:
    return files_;
  case ImportTask::Guess:
  case ImportTask::Measure:
    break;
  }
  return questions_;
}

void ImportWork::deliver(ImportTask task, int version, const Deliver& deliver) {
  QMetaObject::invokeMethod(
      this,
      [this, task, version, deliver] {
        if (versions_[taskIndex(task)] == version) deliver();
      },
      Qt::QueuedConnection);
}

// What is thrown is told; nothing leaves the thread.
void ImportWork::post(ImportTask task, Piece piece) {
  const int version = ++versions_[taskIndex(task)];
  isAwaited_[taskIndex(task)] = true;
  threadOf(task).post([this, task, version, piece = std::move(piece)](const LatestWork::IsWanted& isWanted) {
    const auto tell = [&](const QString& what, int done, int total) {
      deliver(task, version,
              [this, task, what, done, total] { Q_EMIT workChanged(task, what, done, total); });
    };
    std::optional<Clock::time_point> told;
    const Progress progress = [&](std::string_view what, int done, int total) {
      const Clock::time_point now = Clock::now();
      if (!told || now - *told >= kTellEvery) {
        told = now;
        tell(qtext(what), done, total);
      }
      return isWanted();
    };
    Deliver outcome;
    try {
      outcome = piece(progress);
    } catch (const Cancelled&) {
    } catch (const std::exception& error) {
      outcome = [this, task, sentence = QString::fromStdString(shownReason(error))] {
        Q_EMIT failed(task, sentence);
      };
    }
    tell({}, 0, 0);
    deliver(task, version, [this, task, outcome] {
      isAwaited_[taskIndex(task)] = false;
      if (outcome) outcome();
    });
  });
}

void ImportWork::cancel(ImportTask task) {
  ++versions_[taskIndex(task)];
  isAwaited_[taskIndex(task)] = false;
  threadOf(task).cancel();
  Q_EMIT workChanged(task, {}, 0, 0);
}

bool ImportWork::isIdle() const {
  return std::ranges::none_of(isAwaited_, std::identity());
}

void ImportWork::guess(const fs::path& folder, const std::string& like,
                       const std::vector<std::string>& assignments) {
  cancel(ImportTask::Measure);
  cancel(ImportTask::Pictures);
  ++reading_;
  post(ImportTask::Guess, [this, folder, like, assignments](const Progress& progress) -> Deliver {
    try {
      const auto guess =
          std::make_shared<const capture::Guess>(functions_.guess(folder, like, assignments, progress));
      return [this, guess] { Q_EMIT guessed(guess); };
    } catch (const Error& error) {
      return afterFailure(folder, QString::fromStdString(shownReason(error)), progress);
    }
  });
}

// Somebody may know what the pictures are of which nothing could be guessed.
ImportWork::Deliver ImportWork::afterFailure(const fs::path& folder, const QString& sentence,
                                             const Progress& progress) {
  std::vector<capture::PictureSequence> sequences;
  try {
    sequences = functions_.scan(folder, progress).sequences;
  } catch (const Error&) { // then there is nothing to choose from, and `sentence` says why
  }
  return [this, sequences, sentence] {
    Q_EMIT found(sequences);
    Q_EMIT failed(ImportTask::Guess, sentence);
  };
}

void ImportWork::measure(const fs::path& folder, const capture::Manifest& manifest) {
  post(ImportTask::Measure, [this, folder, manifest](const Progress& progress) -> Deliver {
    return [this, findings = functions_.measure(folder, manifest, progress)] { Q_EMIT measured(findings); };
  });
}

void ImportWork::draw(const fs::path& folder, const capture::Manifest& manifest, int frame) {
  post(ImportTask::Pictures, [this, folder, manifest, frame, reading = reading_](const Progress&) -> Deliver {
    const auto decoded = [&](int index) {
      return capture::decode(manifest, static_cast<std::size_t>(index),
                             planes_->of(folder, reading, manifest, index));
    };
    const capture::DecodedFrame shown = decoded(frame);
    std::optional<capture::DecodedFrame> previous;
    if (frame > 0 && !shown.startsHistory) previous = decoded(frame - 1);
    return [this, pictures = drawFrame(shown, previous ? &*previous : nullptr)] { Q_EMIT drawn(pictures); };
  });
}

void ImportWork::save(const fs::path& from, const capture::Manifest& manifest, const fs::path& to) {
  post(ImportTask::Save, [this, from, manifest, to](const Progress& progress) -> Deliver {
    capture::saveImport(from, manifest, to, true, progress);
    return [this, to] { Q_EMIT saved(to); };
  });
}

} // namespace taa::app
