// What the import page has done in the background: guesses, measurements, pictures and files.
#pragma once

#include "app/background/LatestWork.h"
#include "core/base/Progress.h"
#include "core/capture/import/Guess.h"
#include "core/picture/FramePictures.h"

#include <QObject>
#include <QString>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace taa::app {

/// As guessCapture(), measureConventions() and scanFolder(); tests put others in their place.
struct ImportFunctions {
  std::function<capture::Guess(const std::filesystem::path& folder, const std::string& like,
                               const std::vector<std::string>& assignments, const Progress& progress)>
      guess = capture::guessCapture;
  std::function<std::vector<capture::Finding>(const std::filesystem::path& folder,
                                              const capture::Manifest& manifest, const Progress& progress)>
      measure = capture::measureConventions;
  std::function<capture::FolderScan(const std::filesystem::path& folder, const Progress& progress)> scan =
      capture::scanFolder;
};

/// A part of the work. Of each the last request counts; a guess also makes void what was asked of the frames
/// before.
enum class ImportTask { Guess, Measure, Pictures, Save };

/// Lives on the UI thread, which never waits for it but at the end.
class ImportWork : public QObject {
  Q_OBJECT
 public:
  explicit ImportWork(ImportFunctions functions, QObject* parent = nullptr);
  ~ImportWork() override;

  /// Frames may have been written again since: pictures are read anew, too.
  void guess(const std::filesystem::path& folder, const std::string& like,
             const std::vector<std::string>& assignments);
  void measure(const std::filesystem::path& folder, const capture::Manifest& manifest);
  /// `frame`: into the manifest's frames.
  void draw(const std::filesystem::path& folder, const capture::Manifest& manifest, int frame);
  /// See saveImport(); replaces what is there.
  void save(const std::filesystem::path& from, const capture::Manifest& manifest,
            const std::filesystem::path& to);
  /// Nothing of it arrives any more.
  void cancel(ImportTask task);
  /// Whether all has arrived that was asked for.
  bool isIdle() const;

 Q_SIGNALS:
  /// `what`: for people, empty at the end.
  void workChanged(ImportTask task, const QString& what, int done, int total);
  void guessed(const std::shared_ptr<const capture::Guess>& guess);
  /// What there is to choose from where a guess fails; failed() follows.
  void found(const std::vector<capture::PictureSequence>& sequences);
  void measured(const std::vector<capture::Finding>& findings);
  void drawn(const FramePictures& pictures);
  void saved(const std::filesystem::path& folder);
  void failed(ImportTask task, const QString& sentence);

 private:
  struct PlaneCache;
  using Deliver = std::function<void()>;
  /// On a thread of the work; returns what is then done on the UI thread.
  using Piece = std::function<Deliver(const Progress& progress)>;

  void post(ImportTask task, Piece piece);
  Deliver afterFailure(const std::filesystem::path& folder, const QString& sentence,
                       const Progress& progress);
  void deliver(ImportTask task, int version, const Deliver& deliver);
  LatestWork& threadOf(ImportTask task);

  ImportFunctions functions_;
  std::unique_ptr<PlaneCache> planes_; ///< of the thread of pictures
  int reading_ = 0;                    ///< counts guesses: what is drawn after one is read anew
  int versions_[4] = {};               ///< by task: what arrives of an older one is dropped
  bool isAwaited_[4] = {};             ///< by task: the last one asked for has not arrived
  LatestWork questions_, pictures_, files_;
};

} // namespace taa::app
