// Frames of another engine on their way in: what was guessed about them, pictures that show whether it fits,
// and a place to say otherwise. Not modal: the window can be used on.
#pragma once

#include "app/importing/ImportState.h"
#include "app/importing/ImportWork.h"
#include "app/undo/UndoStack.h"

#include <QDialog>
#include <QString>

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

class QComboBox;
class QLabel;
class QPushButton;
class QTabBar;

namespace taa::app {

class ConventionTable;
class ElidedLabel;
class FramePanel;
class GuessSentences;
class PlaneTable;
class ResidualTable;
class WorkBar;

class ImportPage : public QDialog {
  Q_OBJECT
 public:
  explicit ImportPage(QWidget* parent, ImportFunctions functions = {});

  /// Begins to guess what is in it.
  void openFolder(const QString& folder);
  void askForFolder();
  /// Whether all that it shows has arrived.
  bool isComplete() const { return work_.isIdle(); }
  /// Empty until something was guessed.
  const capture::Manifest& manifest() const { return manifest_; }
  ConventionTable* table() const { return table_; }
  PlaneTable* planes() const { return planes_; }
  /// Of conventions and planes, in this order.
  QTabBar* tabs() const { return tabs_; }
  ResidualTable* residuals() const { return residuals_; }
  FramePanel* frames() const { return frames_; }
  QSize sizeHint() const override { return {1180, 760}; }

 Q_SIGNALS:
  /// The folder has its capture.json now.
  void openRequested(const QString& folder);

 protected:
  void keyPressEvent(QKeyEvent*) override;

 private:
  // Layout
  QWidget* makeHeader();
  QWidget* makeSides();
  QWidget* makeTables();
  QWidget* makeButtons();
  QPushButton* addButton(QWidget* to, const QString& name, const QString& text, const QString& toolTip,
                         void (ImportPage::*act)());
  void makeKeys();
  void connectWork();
  // Changes
  ImportState state() const { return {manifest_.conventions, manifest_.like, changed_, stated_}; }
  void setState(const ImportState& state);
  void change(const ImportState& next, const QString& what, const std::string& key);
  /// Returns whether the table takes it; else it is said why.
  bool edit(const QString& path, const QString& text);
  /// What is still being typed counts as well; false where the table refuses it.
  bool takeTyped();
  void applyHypothesis(const std::vector<std::string>& assignments, const QString& text);
  void statePlane(capture::PlaneKind kind, const QString& text);
  void startLike(const QString& id);
  void guessAgain();
  void startGuess();
  void resetToGuess();
  // Results
  void useGuess(const std::shared_ptr<const capture::Guess>& guess);
  void useFindings(const std::vector<capture::Finding>& findings);
  void useSequences(const std::vector<capture::PictureSequence>& sequences);
  void fail(ImportTask task, const QString& sentence);
  bool stop(const std::vector<ImportTask>& tasks);
  void showWork(ImportTask task, const QString& what, int done, int total);
  // Display
  void showState();
  void drawPictures();
  void say(const QString& sentence);
  // Out of it
  void leave() { close(); }
  void open();
  void askWhereToSave();
  void saveTo(const std::filesystem::path& folder);

  UndoStack undo_;
  std::filesystem::path folder_;
  std::shared_ptr<const capture::Guess> guess_; ///< null: none yet. Shared with what delivers it
  capture::Manifest manifest_;
  std::set<std::string> changed_;                           ///< see ImportState
  std::string likeOfGuess_;                                 ///< that the guess began with
  std::string likeOfNext_;                                  ///< that one under way begins with
  std::map<capture::PlaneKind, std::string> stated_;        ///< see ImportState::planes
  std::map<capture::PlaneKind, std::string> statedOfGuess_; ///< those of the guess there is
  std::map<capture::PlaneKind, std::string> statedOfNext_;  ///< of that under way
  bool isGuessing_ = false, isSaving_ = false;
  std::array<QString, 4> underWay_; ///< by ImportTask: what is being done, empty: nothing
  ConventionTable* table_;
  PlaneTable* planes_;
  QTabBar* tabs_;
  ResidualTable* residuals_;
  FramePanel* frames_;
  GuessSentences* sentences_;
  QComboBox* like_;
  ElidedLabel* place_;
  QLabel* problem_;
  QPushButton *open_ = nullptr, *save_ = nullptr, *reset_ = nullptr, *again_ = nullptr;
  WorkBar* bar_ = nullptr;
  ImportWork work_; // last: it ends before what it delivers to
};

} // namespace taa::app
