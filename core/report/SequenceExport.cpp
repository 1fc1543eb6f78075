#include "core/report/SequenceExport.h"

#include "core/base/Error.h"
#include "core/base/Files.h"
#include "core/base/Say.h"
#include "core/capture/source/Capture.h"
#include "core/inspect/Inspector.h"
#include "core/io/GifFile.h"
#include "core/io/PictureFile.h"
#include "core/report/CaptureExport.h"
#include "core/report/FrameExport.h"

#include <algorithm>
#include <exception>
#include <iomanip>
#include <memory>
#include <sstream>
#include <string_view>
#include <utility>

namespace taa {

namespace fs = std::filesystem;

namespace {

/// A folder for what is not finished, gone with this.
class Workshop {
 public:
  explicit Workshop(const fs::path& target)
      : folder_(temporaryBeside(fs::absolute(target).parent_path() / "taa-export")) {
    std::error_code error;
    isParentNew_ = !fs::exists(folder_.parent_path(), error);
    fs::create_directories(folder_, error);
    if (error) throw Error(say<"cannot write %1: %2">(target.string(), error.message()));
  }
  ~Workshop() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
    if (isParentNew_) fs::remove(folder_.parent_path(), ignored); // unless files are in it
  }
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;
  fs::path place(const fs::path& file) const { return folder_ / file.filename(); }
  /// A sentence about a file in here, told of the place it was to have.
  std::string retold(std::string sentence) const {
    const std::string from = folder_.string() + "/", to = folder_.parent_path().string() + "/";
    for (std::size_t at = sentence.find(from); at != sentence.npos; at = sentence.find(from, at + to.size()))
      sentence.replace(at, from.size(), to);
    return sentence;
  }

  const fs::path& folder() const { return folder_; }

 private:
  fs::path folder_;
  bool isParentNew_ = false; ///< the folder they go to was made for them
};

/// Takes the inspector back to where it was, whatever happens.
class Return {
 public:
  explicit Return(Inspector& inspector) : inspector_(inspector), frame_(inspector.shot().frame()) {}
  ~Return() {
    try {
      inspector_.shot().seek(frame_);
    } catch (const std::exception&) { // the frame on show then says which it is
    }
  }
  Return(const Return&) = delete;
  Return& operator=(const Return&) = delete;

 private:
  Inspector& inspector_;
  int frame_;
};

void writeValues(Inspector& inspector, const SequenceRequest& request, const fs::path& path,
                 const Progress& stop) {
  FrameFile frame{
      inspector.shot().source(), inspector.shot().camera(), inspector.shot().driver().renderer, {}, {}};
  for (int lane = 0; lane < inspector.shot().laneCount(); ++lane) {
    const std::string name =
        inspector.shot().laneCount() > 1 ? std::string(1, static_cast<char>('A' + lane)) : "";
    frame.lanes.push_back({name, inspector.shot().usedSettings(lane), inspector.shot().info(lane),
                           inspector.views().inputs(lane).block});
  }
  if (!request.differenceFrom.empty()) {
    exportDifferences(inspector, std::move(frame), request.ids, request.picture, request.differenceFrom, path,
                      stop);
    return;
  }
  for (int lane = 0; lane < inspector.shot().laneCount(); ++lane)
    inspector.reference().makeRows(request.ids, request.picture.referenceSamples, stop, lane);
  exportFrame(inspector, std::move(frame), request.ids, path);
}

/// What is written from frame to frame.
struct Writers {
  std::unique_ptr<GifWriter> gif;
  std::unique_ptr<CaptureExport> capture;
};

Writers writersOf(Inspector& inspector, const SequenceRequest& request, const Workshop& workshop) {
  Writers writers;
  const glm::ivec2 sizePx = writtenSize(request.picture);
  if (request.kind == SequenceKind::Gif)
    writers.gif = std::make_unique<GifWriter>(workshop.place(request.target), request.target, sizePx.x,
                                              sizePx.y, request.framesPerSecond);
  if (request.kind == SequenceKind::Capture)
    writers.capture =
        std::make_unique<CaptureExport>(inspector, request.capture, request.first, request.last);
  return writers;
}

void writeFrame(Inspector& inspector, const SequenceRequest& request, const Workshop& workshop,
                const Writers& writers, const Progress& stop) {
  if (writers.capture) {
    writers.capture->add(workshop.folder(), stop);
    return;
  }
  const fs::path path = workshop.place(sequenceFile(request, inspector.shot().frame()));
  if (request.kind == SequenceKind::Exr) {
    writeValues(inspector, request, path, stop);
    return;
  }
  const Picture picture = shownPicture(inspector, request.picture, stop);
  if (writers.gif)
    writers.gif->add(picture.rgba);
  else
    writePng(path, picture.width, picture.height, picture.rgba);
}

/// Their names.
std::vector<std::string> makeFiles(Inspector& inspector, const SequenceRequest& request,
                                   const Workshop& workshop, const Progress& progress) {
  const Writers writers = writersOf(inspector, request, workshop);
  const int count = request.last - request.first + 1;
  for (int frame = request.first; frame <= request.last; ++frame) {
    const auto tell = [&] { return !progress || progress(say<"Exporting">(), frame - request.first, count); };
    if (!tell()) throw Cancelled();
    const Progress stop = [&](std::string_view, int, int) { return tell(); };
    inspector.shot().seek(frame, stop); // to the first one it may be long
    writeFrame(inspector, request, workshop, writers, stop);
  }
  report(progress, say<"Exporting">(), count, count);
  if (writers.capture) return writers.capture->finish(workshop.folder());
  if (writers.gif) writers.gif->finish();
  std::vector<std::string> names;
  for (const fs::path& file : sequenceFiles(request)) names.push_back(file.filename().string());
  return names;
}

/// Throws Error where its frames would be replaced, from which the rest of the session is made.
void refuseOpenCapture(const InspectedShot& shot, const fs::path& manifest) {
  if (!shot.capture()) return;
  const fs::path folder = manifest.has_parent_path() ? manifest.parent_path() : fs::path(".");
  std::error_code ignored;
  if (fs::equivalent(capture::folderOf(shot.source()), folder, ignored))
    throw Error(
        say<"cannot write a capture into %1: it is the folder of the one that is open; choose another">(
            folder.string()));
}

void moveIntoPlace(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error) throw Error(say<"cannot write %1: %2">(to.string(), error.message()));
}

} // namespace

fs::path sequenceFile(const SequenceRequest& request, int frame) {
  if (request.kind == SequenceKind::Gif || request.kind == SequenceKind::Capture) return request.target;
  std::ostringstream name;
  name << request.target.stem().string() << '.' << std::setw(4) << std::setfill('0') << frame
       << request.target.extension().string();
  fs::path path = request.target;
  return path.replace_filename(name.str());
}

std::vector<fs::path> sequenceFiles(const SequenceRequest& request) {
  if (request.kind == SequenceKind::Gif) return {request.target};
  if (request.kind == SequenceKind::Capture)
    return captureFiles(request.target.parent_path(), request.first, request.last);
  std::vector<fs::path> files;
  for (int frame = request.first; frame <= request.last; ++frame)
    files.push_back(sequenceFile(request, frame));
  return files;
}

std::vector<fs::path> exportSequence(Inspector& inspector, const SequenceRequest& request,
                                     const Progress& progress) {
  if (request.kind == SequenceKind::Capture) refuseOpenCapture(inspector.shot(), request.target);
  const Return back(inspector);
  const Workshop workshop(request.target);
  std::vector<std::string> names;
  try {
    names = makeFiles(inspector, request, workshop, progress);
  } catch (const Error& error) {
    throw Error::withLog(workshop.retold(error.what()));
  }
  // Planes of one capture are nothing under the capture.json of another, which is written last.
  if (request.kind == SequenceKind::Capture) {
    std::error_code ignored;
    fs::remove(request.target, ignored);
  }
  std::vector<fs::path> files;
  for (const std::string& name : names) {
    files.push_back(request.target.parent_path() / name);
    moveIntoPlace(workshop.place(name), files.back());
  }
  return files;
}

} // namespace taa
