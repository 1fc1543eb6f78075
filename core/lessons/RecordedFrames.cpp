#include "core/lessons/RecordedFrames.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/capture/format/Manifest.h"
#include "core/inspect/Inspector.h"
#include "core/io/SessionFile.h"
#include "core/report/SequenceExport.h"

#include <filesystem>
#include <map>
#include <mutex>
#include <random>
#include <string>
#include <system_error>

namespace taa {

namespace fs = std::filesystem;

namespace {

constexpr int kFolderTries = 64;

/// A folder that nobody else has, which goes with it.
class OwnFolder {
 public:
  OwnFolder() {
    std::error_code error;
    std::random_device random;
    for (int tries = 0; tries < kFolderTries; ++tries) {
      path_ = fs::temp_directory_path() / ("taa-inspector-lessons-" + std::to_string(random()));
      if (!fs::create_directory(path_, error)) continue;
      fs::permissions(path_, fs::perms::owner_all);
      return;
    }
    throw Error(say<"cannot make a folder for recorded frames in %1: %2">(path_.parent_path().string(),
                                                                          error.message()));
  }
  ~OwnFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  OwnFolder(const OwnFolder&) = delete;
  OwnFolder& operator=(const OwnFolder&) = delete;

  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// What was recorded since the program started, by the session that it was drawn from.
struct Recordings {
  std::mutex mutex;
  OwnFolder folder;
  std::map<std::string, fs::path> manifests;
};

Recordings& recordings() {
  static Recordings kept;
  return kept;
}

/// What the frames are drawn from.
SessionFile drawnFrom(const LessonState& state) {
  SessionFile drawn = state.shot;
  drawn.frame = 0;
  drawn.settings = {"", {}, state.recording->settings};
  return drawn;
}

void openDrawn(InspectedShot& shot, const SessionFile& drawn, const Progress& progress) {
  shot.open(drawn.source, progress, drawn.choice);
  shot.setSize(drawn.size.x, drawn.size.y);
  if (drawn.track)
    shot.setCameraTrack(*drawn.track);
  else if (!drawn.camera.empty())
    shot.setCamera(drawn.camera);
  shot.setLanes({drawn.settings.settings});
  shot.setObjectFilter(drawn.filter);
  shot.seek(0, progress);
}

fs::path recorded(Inspector& inspector, const SessionFile& drawn, const LessonRecording& recording,
                  const Progress& progress) {
  Recordings& kept = recordings();
  const std::lock_guard lock(kept.mutex);
  const std::string key = sessionToText(drawn) + recording.like + ' ' + std::to_string(recording.frames) +
                          ' ' + std::to_string(recording.referenceSamples);
  if (const auto found = kept.manifests.find(key); found != kept.manifests.end()) return found->second;
  openDrawn(inspector.shot(), drawn, progress);
  const fs::path manifest =
      kept.folder.path() / std::to_string(kept.manifests.size()) / capture::kManifestName;
  SequenceRequest request;
  request.kind = SequenceKind::Capture;
  request.target = manifest;
  request.last = recording.frames - 1;
  request.capture.like = recording.like;
  request.capture.referenceSamples = recording.referenceSamples;
  request.capture.conventions = {"color.preExposed=off"}; // nothing here has an exposure to take out
  request.capture.namesFaults = false;                    // what is wrong is for the reader to find
  exportSequence(inspector, request, progress);
  return kept.manifests.emplace(key, manifest).first->second;
}

} // namespace

LessonState onItsFrames(Inspector& inspector, const LessonState& state, const Progress& progress) {
  if (!state.recording) return state;
  const SessionFile drawn = drawnFrom(state);
  LessonState opened = state;
  opened.recording.reset();
  opened.shot = SessionFile{};
  opened.shot.source = recorded(inspector, drawn, *state.recording, progress).string();
  opened.shot.size = state.shot.size;
  opened.shot.frame = state.shot.frame;
  opened.shot.settings = state.shot.settings;
  opened.shot.restarts = state.shot.restarts;
  return opened;
}

} // namespace taa
