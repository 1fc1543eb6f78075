#include "app/importing/ImportPage.h"

#include "app/importing/ConventionTable.h"
#include "app/importing/FramePanel.h"
#include "app/importing/GuessSentences.h"
#include "app/importing/PlaneTable.h"
#include "app/importing/ResidualTable.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "app/widgets/ConfirmReplace.h"
#include "app/widgets/Line.h"
#include "app/widgets/areas/FittingArea.h"
#include "app/widgets/bars/ElidedLabel.h"
#include "app/widgets/bars/WorkBar.h"
#include "core/base/Error.h"
#include "core/capture/import/SavedImport.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QShortcut>
#include <QSplitter>
#include <QStackedWidget>
#include <QTabBar>
#include <QVBoxLayout>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace taa::app {

namespace fs = std::filesystem;

namespace {

constexpr int kLeastFrames = 180; ///< logical px
enum TableTab { ConventionsTab, PlanesTab };

std::size_t slotOf(ImportTask task) {
  return static_cast<std::size_t>(task);
}

QHBoxLayout* lineIn(QWidget* widget) {
  auto* line = new QHBoxLayout(widget);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(2 * kUnit);
  return line;
}

} // namespace

ImportPage::ImportPage(QWidget* parent, ImportFunctions functions)
    : QDialog(parent), table_(new ConventionTable), planes_(new PlaneTable), tabs_(new QTabBar),
      residuals_(new ResidualTable), frames_(new FramePanel(residuals_)), sentences_(new GuessSentences),
      like_(new QComboBox), place_(new ElidedLabel), problem_(new QLabel), work_(std::move(functions)) {
  setObjectName(QStringLiteral("import"));
  setWindowTitle(tr("Import frames"));
  setAttribute(Qt::WA_DeleteOnClose);
  problem_->setObjectName(QStringLiteral("problem"));
  problem_->setWordWrap(true);
  problem_->setVisible(false);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(3 * kUnit, 3 * kUnit, 3 * kUnit, 3 * kUnit);
  layout->setSpacing(2 * kUnit);
  layout->addWidget(makeHeader());
  layout->addWidget(makeSides(), 1);
  layout->addWidget(new Line);
  layout->addWidget(sentences_);
  layout->addWidget(problem_);
  layout->addWidget(makeButtons());
  bar_ = new WorkBar(frames_, 0);
  connect(bar_, &WorkBar::stopRequested, this, [this] {
    stop({ImportTask::Guess, ImportTask::Measure, ImportTask::Save});
  });
  makeKeys();
  connectWork();
  showState();
}

QWidget* ImportPage::makeHeader() {
  auto* header = new QWidget;
  auto* line = lineIn(header);
  auto* label = new QLabel(tr("Start &like"));
  label->setBuddy(like_);
  place_->setTextInteractionFlags(Qt::NoTextInteraction);
  place_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  like_->setObjectName(QStringLiteral("like"));
  like_->setAccessibleName(tr("Start like"));
  like_->view()->setAccessibleName(like_->accessibleName());
  like_->addItem(tr("Nothing known"), QString());
  for (const capture::StartingPoint& point : capture::startingPoints()) {
    like_->addItem(qtext(point.label), qtext(point.id));
    like_->setItemData(like_->count() - 1, qtext(point.notes), Qt::ToolTipRole);
  }
  like_->setToolTip(tr("The conventions of an engine or library, to begin with"));
  line->addWidget(place_, 1);
  addButton(header, QStringLiteral("folder"), tr("&Choose a folder…"),
            tr("Look at the frames of another folder"), &ImportPage::askForFolder);
  line->addWidget(label);
  line->addWidget(like_);
  again_ = addButton(header, QStringLiteral("again"), tr("&Guess again"),
                     tr("Guess once more from here; what you have changed is not questioned"),
                     &ImportPage::guessAgain);
  connect(like_, &QComboBox::activated, this, [this] { startLike(like_->currentData().toString()); });
  return header;
}

QWidget* ImportPage::makeSides() {
  auto* sides = new QSplitter;
  sides->setHandleWidth(2 * kUnit);
  sides->setChildrenCollapsible(false);
  sides->addWidget(makeTables());
  sides->addWidget(scrolledSideways(frames_, kLeastFrames)); // beside whole rows of large letters
  sides->setStretchFactor(1, 1);
  sides->setSizes({400, 780});
  connect(frames_, &FramePanel::frameChosen, this, &ImportPage::drawPictures);
  connect(table_, &ConventionTable::edited, this, &ImportPage::edit);
  connect(table_, &ConventionTable::entered, residuals_, &ResidualTable::showQuestion);
  connect(planes_, &PlaneTable::stated, this, &ImportPage::statePlane);
  connect(residuals_, &ResidualTable::applied, this, &ImportPage::applyHypothesis);
  return sides;
}

QWidget* ImportPage::makeTables() {
  auto* tables = new QWidget;
  auto* pages = new QStackedWidget;
  pages->addWidget(table_);
  pages->addWidget(planes_);
  tabs_->setAccessibleName(tr("Conventions or planes"));
  tabs_->setDrawBase(false);
  tabs_->setExpanding(false);
  tabs_->setFocusPolicy(Qt::TabFocus);
  tabs_->addTab(tr("Con&ventions"));
  tabs_->addTab(tr("&Planes"));
  tabs_->setTabToolTip(ConventionsTab, tr("How numbers in the pictures are meant (Alt+V)"));
  tabs_->setTabToolTip(PlanesTab, tr("Which pictures hold color, motion, depth and the rest (Alt+P)"));
  auto* column = new QVBoxLayout(tables);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kUnit);
  column->addWidget(tabs_);
  column->addWidget(pages, 1);
  connect(tabs_, &QTabBar::currentChanged, pages, &QStackedWidget::setCurrentIndex);
  return tables;
}

QPushButton* ImportPage::addButton(QWidget* to, const QString& name, const QString& text,
                                   const QString& toolTip, void (ImportPage::*act)()) {
  auto* button = new QPushButton(text);
  button->setObjectName(name);
  button->setToolTip(toolTip);
  button->setAccessibleDescription(toolTip);
  button->setAutoDefault(false);
  connect(button, &QPushButton::clicked, this, act);
  to->layout()->addWidget(button);
  return button;
}

QWidget* ImportPage::makeButtons() {
  auto* row = new QWidget;
  auto* line = lineIn(row);
  reset_ = addButton(row, QStringLiteral("reset"), tr("&Reset to the guess"),
                     tr("All conventions and planes as they were guessed (Ctrl+R); can be undone"),
                     &ImportPage::resetToGuess);
  line->addStretch(1);
  addButton(row, QStringLiteral("cancel"), tr("Cancel"), tr("Leave everything as it is (Esc)"),
            &ImportPage::leave);
  save_ = addButton(row, QStringLiteral("save"), tr("&Save capture.json as…"),
                    tr("Put capture.json and the frames into another folder, and open that (Ctrl+S)"),
                    &ImportPage::askWhereToSave);
  open_ = addButton(row, QStringLiteral("open"), tr("&Open"),
                    tr("Write capture.json beside the frames, and look at them with these conventions "
                       "(Ctrl+Enter)"),
                    &ImportPage::open);
  return row;
}

void ImportPage::makeKeys() {
  const auto add = [this](const QKeySequence& key, auto act) {
    connect(new QShortcut(key, this), &QShortcut::activated, this, act);
  };
  add(QKeySequence::Undo, [this] { undo_.undo(); });
  add(QKeySequence(QStringLiteral("Ctrl+Shift+Z")), [this] { undo_.redo(); });
  add(QKeySequence(QStringLiteral("Ctrl+R")), [this] { resetToGuess(); });
  add(QKeySequence(QStringLiteral("Ctrl+S")), [this] { askWhereToSave(); });
  add(QKeySequence(QStringLiteral("Ctrl+Return")), [this] { open(); });
  add(QKeySequence(QStringLiteral("Ctrl+Enter")), [this] { open(); });
  add(QKeySequence(QStringLiteral("Alt+Left")), [this] { frames_->step(-1); });
  add(QKeySequence(QStringLiteral("Alt+Right")), [this] { frames_->step(1); });
}

void ImportPage::connectWork() {
  connect(&work_, &ImportWork::workChanged, this, &ImportPage::showWork);
  connect(&work_, &ImportWork::guessed, this, &ImportPage::useGuess);
  connect(&work_, &ImportWork::found, this, &ImportPage::useSequences);
  connect(&work_, &ImportWork::measured, this, &ImportPage::useFindings);
  connect(&work_, &ImportWork::drawn, frames_, &FramePanel::setPictures);
  connect(&work_, &ImportWork::failed, this, &ImportPage::fail);
  connect(&work_, &ImportWork::saved, this, [this](const fs::path& folder) {
    Q_EMIT openRequested(QString::fromStdString(folder.string()));
    accept();
  });
}

void ImportPage::askForFolder() {
  auto* dialog = new QFileDialog(this, tr("Folder of frames"), QString::fromStdString(folder_.string()));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::Directory);
  connect(dialog, &QFileDialog::fileSelected, this, &ImportPage::openFolder);
  dialog->open();
}

void ImportPage::openFolder(const QString& folder) {
  table_->dropTyped();
  stop({ImportTask::Guess, ImportTask::Measure, ImportTask::Pictures, ImportTask::Save});
  // Guessed of other frames, it says nothing of these.
  if (guess_) like_->setCurrentIndex(0);
  folder_ = folder.toStdString();
  guess_.reset();
  manifest_ = {};
  changed_.clear();
  stated_.clear();
  statedOfGuess_.clear();
  planes_->clear();
  undo_.clear();
  const QString name = QFileInfo(folder).fileName();
  place_->setTip(folder);
  place_->setWhole(tr("Frames in %1").arg(name), {name});
  useFindings({});
  sentences_->clear();
  frames_->setFrames({});
  frames_->setPictures({});
  say({});
  showState();
  startGuess();
}

bool ImportPage::takeTyped() {
  while (const auto typed = table_->takeTyped())
    if (!edit(typed->first, typed->second)) return false;
  while (const auto typed = planes_->takeTyped()) statePlane(typed->first, typed->second);
  return true;
}

bool ImportPage::edit(const QString& path, const QString& text) {
  const capture::Convention& row = capture::convention(path.toStdString());
  try {
    change(withAssignments(state(), {std::string(row.path) + "=" + text.toStdString()}),
           tr("change %1").arg(qtext(row.label)), std::string(row.path));
  } catch (const Error& error) {
    showState(); // as it was
    say(QString::fromUtf8(error.what()));
    return false;
  }
  return true;
}

void ImportPage::applyHypothesis(const std::vector<std::string>& assignments, const QString& text) {
  if (!takeTyped()) return;
  try {
    change(withAssignments(state(), assignments), tr("use %1").arg(text), {});
  } catch (const Error& error) {
    say(QString::fromUtf8(error.what()));
  }
}

void ImportPage::statePlane(capture::PlaneKind kind, const QString& text) {
  change(withPlane(state(), kind, text.toStdString()),
         tr("say what holds %1").arg(qtext(capture::planeName(kind))), {});
}

void ImportPage::startLike(const QString& id) {
  if (!guess_) {
    guessAgain();
    return;
  }
  change(startedLike(state(), id.toStdString()), tr("start like %1").arg(like_->currentText()), {});
}

void ImportPage::guessAgain() {
  if (!folder_.empty() && takeTyped()) startGuess();
}

// What somebody has changed stands as it is. A starting point that was only guessed is no point to start at.
void ImportPage::startGuess() {
  const bool isGuessed = guess_ && manifest_.like == guess_->manifest.like;
  likeOfNext_ = isGuessed ? likeOfGuess_ : like_->currentData().toString().toStdString();
  statedOfNext_ = stated_;
  isGuessing_ = true;
  work_.guess(folder_, likeOfNext_, assignmentsOf(state()));
}

void ImportPage::resetToGuess() {
  table_->dropTyped();
  planes_->dropTyped();
  ImportState guessed = state();
  if (guess_) guessed = {guess_->manifest.conventions, guess_->manifest.like, {}, {}};
  guessed.planes.clear();
  change(guessed, tr("reset to the guess"), {});
  showState();
}

void ImportPage::change(const ImportState& next, const QString& what, const std::string& key) {
  const ImportState before = state();
  if (next == before) return;
  setState(next);
  UndoStep step = stepBackTo<ImportState>(
      before, [this] { return state(); }, [this](const ImportState& state) { setState(state); });
  step.what = what;
  step.key = key;
  undo_.push(std::move(step));
}

// Pictures and residuals follow in the background; only those of the last change arrive. A guess under way
// begins again with what stands now; of other planes everything is guessed again.
void ImportPage::setState(const ImportState& state) {
  manifest_.conventions = state.conventions;
  manifest_.like = state.like;
  changed_ = state.changed;
  stated_ = state.planes;
  say({});
  showState();
  if (isGuessing_ || stated_ != statedOfGuess_) startGuess();
  drawPictures();
  if (guess_ && !isGuessing_) work_.measure(folder_, manifest_);
}

void ImportPage::useGuess(const std::shared_ptr<const capture::Guess>& guess) {
  const ImportState before = state();
  const bool isFirst = !guess_;
  // What is guessed of other planes is taken back with them.
  const bool isOfPlanes = std::exchange(statedOfGuess_, statedOfNext_) != statedOfNext_;
  guess_ = guess;
  likeOfGuess_ = likeOfNext_;
  isGuessing_ = false;
  manifest_ = guess->manifest;
  frames_->setFrames(manifest_.frames);
  sentences_->setGuess(*guess);
  useFindings(guess->findings);
  useSequences(guess->sequences);
  say({});
  showState();
  drawPictures();
  if (isFirst || isOfPlanes || before == state()) return;
  UndoStep step = stepBackTo<ImportState>(
      before, [this] { return state(); }, [this](const ImportState& state) { setState(state); });
  step.what = tr("guess again");
  undo_.push(std::move(step));
}

void ImportPage::useFindings(const std::vector<capture::Finding>& findings) {
  table_->setFindings(findings);
  residuals_->setFindings(findings);
}

void ImportPage::useSequences(const std::vector<capture::PictureSequence>& sequences) {
  planes_->setSequences(sequences);
  planes_->setPlanes(manifest_.planes, statedOfGuess_);
  // Without color there is nothing to look at but the pictures that could be it.
  if (!guess_ && !sequences.empty()) tabs_->setCurrentIndex(PlanesTab);
}

void ImportPage::fail(ImportTask task, const QString& sentence) {
  if (task == ImportTask::Guess) isGuessing_ = false;
  if (task == ImportTask::Save) isSaving_ = false;
  showState();
  if (task == ImportTask::Pictures) frames_->setPictures({});
  if (task == ImportTask::Measure) useFindings({});
  say(sentence);
}

void ImportPage::showWork(ImportTask task, const QString& what, int done, int total) {
  underWay_[slotOf(task)] = what;
  if (!what.isEmpty()) {
    bar_->setWork(what, done, total);
    return;
  }
  const auto other = std::ranges::find_if(underWay_, [](const QString& each) { return !each.isEmpty(); });
  bar_->setWork(other != underWay_.end() ? *other : QString(), 0, 0);
}

void ImportPage::showState() {
  const bool isThere = guess_ != nullptr;
  const bool isGuessOfPlanes = isThere && stated_ == statedOfGuess_;
  table_->display(manifest_.conventions, isThere ? guess_->manifest.conventions : manifest_.conventions);
  planes_->display(stated_);
  residuals_->setConventions(manifest_.conventions);
  if (isThere) like_->setCurrentIndex(std::max(0, like_->findData(QString::fromStdString(manifest_.like))));
  const std::string contradiction = capture::contradiction(capture::normalized(manifest_.conventions));
  if (!contradiction.empty()) say(QString::fromStdString(contradiction));
  // What is being written is not changed meanwhile.
  for (QWidget* needsGuess : {static_cast<QWidget*>(table_), static_cast<QWidget*>(residuals_)})
    needsGuess->setEnabled(isThere && !isSaving_);
  reset_->setEnabled((isThere || !stated_.empty()) && !isSaving_);
  planes_->setEnabled(!folder_.empty() && !isSaving_);
  like_->setEnabled(!isSaving_);
  again_->setEnabled(!folder_.empty() && !isSaving_);
  open_->setEnabled(isGuessOfPlanes && contradiction.empty() && !isSaving_);
  save_->setEnabled(open_->isEnabled());
}

void ImportPage::drawPictures() {
  if (guess_ && !manifest_.frames.empty()) work_.draw(folder_, manifest_, frames_->frame());
}

void ImportPage::say(const QString& sentence) {
  problem_->setText(sentence);
  problem_->setVisible(!sentence.isEmpty());
}

// Esc ends one thing at a time: what is under way before the page.
void ImportPage::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Escape) {
    QDialog::keyPressEvent(event);
    return;
  }
  if (!stop({ImportTask::Guess, ImportTask::Save})) reject();
}

bool ImportPage::stop(const std::vector<ImportTask>& tasks) {
  const bool wasMeasuring = !underWay_[slotOf(ImportTask::Measure)].isEmpty();
  for (const ImportTask task : tasks) work_.cancel(task);
  const auto has = [&](ImportTask task) { return std::ranges::find(tasks, task) != tasks.end(); };
  const bool stopsGuess = has(ImportTask::Guess) && std::exchange(isGuessing_, false);
  const bool stopsSaving = has(ImportTask::Save) && std::exchange(isSaving_, false);
  if (wasMeasuring && has(ImportTask::Measure)) useFindings({}); // they are of other conventions
  showState();
  if (stopsGuess) say(tr("Stopped. Guess again goes on; Esc closes the page."));
  if (stopsSaving) say(tr("Stopped; what was put there already stays. Esc closes the page."));
  return stopsGuess || stopsSaving;
}

void ImportPage::open() {
  if (!takeTyped() || !open_->isEnabled()) return;
  if (QFileInfo(QString::fromStdString(folder_.string())).isWritable()) {
    saveTo(folder_);
    return;
  }
  say(tr("Nothing can be written into %1; save capture.json in another folder.")
          .arg(QString::fromStdString(folder_.string())));
}

void ImportPage::askWhereToSave() {
  if (!takeTyped() || !save_->isEnabled()) return;
  auto* dialog = new QFileDialog(this, tr("Folder for capture.json and the frames"),
                                 QString::fromStdString(folder_.parent_path().string()));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::Directory);
  connect(dialog, &QFileDialog::fileSelected, this,
          [this](const QString& folder) { saveTo(folder.toStdString()); });
  dialog->open();
}

void ImportPage::saveTo(const fs::path& folder) {
  confirmReplace(this, capture::importedFiles(folder_, manifest_, folder), [this, folder] {
    isSaving_ = true;
    showState();
    work_.save(folder_, withNoteOfChanges(manifest_, guess_->manifest.conventions), folder);
  });
}

} // namespace taa::app
