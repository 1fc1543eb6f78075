#include "app/dialogs/GlslWindow.h"

#include "app/dialogs/SourceText.h"
#include "app/session/ShaderWatch.h"
#include "app/style/DialogSize.h"
#include "app/style/Icons.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "app/widgets/Note.h"
#include "core/base/EmbeddedFiles.h"
#include "core/base/ShownText.h"
#include "core/taa/GlslExport.h"

#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QShortcut>
#include <QThreadPool>
#include <QVBoxLayout>

#include <algorithm>
#include <exception>
#include <string>
#include <vector>

namespace taa::app {

namespace {

// Instead of a file.
const QString kProgram = QStringLiteral("program"), kExport = QStringLiteral("export");

/// The file of a stage where it has one: shaders/taa/ID.glsl.
QString fileOf(const StageInfo& stage) {
  return QStringLiteral("shaders/taa/") + qtext(stage.id) + QStringLiteral(".glsl");
}

QString glslText(const QString& what, const Settings& settings, const std::string& title) {
  try {
    if (what == kProgram) return QString::fromStdString(resolveSource(settings).text());
    if (what == kExport) return QString::fromStdString(exportedGlsl(settings, title));
    return QString::fromStdString(embeddedText(what.toStdString()));
  } catch (const std::exception& error) {
    return QString::fromStdString(shownReason(error));
  }
}

} // namespace

GlslWindow::GlslWindow(Session& session, QWidget* parent)
    : QDialog(parent), session_(session), files_(new QComboBox), text_(new SourceText),
      search_(new QLineEdit), note_(new QLabel) {
  setWindowTitle(tr("GLSL"));
  resize(largeOver(parent, {220 * kUnit, 180 * kUnit}));
  files_->setAccessibleName(tr("What is shown"));
  files_->addItem(tr("The program of these settings, as it is compiled"), kProgram);
  files_->addItem(tr("The file that Export GLSL writes"), kExport);
  files_->insertSeparator(files_->count());
  const std::vector<std::string> paths = embeddedPaths("shaders/");
  for (const StageInfo& stage : kStages)
    if (std::ranges::find(paths, fileOf(stage).toStdString()) != paths.end())
      files_->addItem(tr("%1 (%2)").arg(qtext(stage.label), fileOf(stage)), fileOf(stage));
  files_->insertSeparator(files_->count());
  for (const std::string& path : paths)
    if (files_->findData(QString::fromStdString(path)) < 0)
      files_->addItem(QString::fromStdString(path), QString::fromStdString(path));
  search_->setPlaceholderText(tr("Find; Enter goes on"));
  search_->setAccessibleName(tr("Find in the text"));
  search_->setClearButtonEnabled(true);
  search_->addAction(themedIcon(QStringLiteral("search")), QLineEdit::LeadingPosition);
  setSecondary(*note_);
  note_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(2 * kUnit, 2 * kUnit, 2 * kUnit, 2 * kUnit);
  layout->setSpacing(2 * kUnit);
  for (QWidget* part : {static_cast<QWidget*>(files_), static_cast<QWidget*>(search_)})
    layout->addWidget(part);
  layout->addWidget(text_, 1);
  layout->addWidget(note_);
  connect(files_, &QComboBox::currentIndexChanged, this, &GlslWindow::refresh);
  connect(search_, &QLineEdit::textChanged, this, [this] { find(false); });
  connect(search_, &QLineEdit::returnPressed, this, [this] { find(true); });
  connect(new QShortcut(QKeySequence::Find, this), &QShortcut::activated, search_,
          [this] { search_->setFocus(); });
  connect(&session_.presets(), &PresetChoices::settingsChanged, this, &GlslWindow::refresh);
  session_.onArrival<ShadersRead>(this, [this](const ShadersRead&) { refresh(); });
  refresh();
}

void GlslWindow::openAt(Session& session, Stage stage, QWidget* window) {
  auto* glsl = window->findChild<GlslWindow*>();
  if (!glsl) glsl = new GlslWindow(session, window);
  glsl->showStage(stage);
  glsl->show();
  glsl->raise();
  glsl->activateWindow();
}

void GlslWindow::showStage(Stage stage) {
  const int index = files_->findData(fileOf(stageInfo(stage)));
  files_->setCurrentIndex(std::max(0, index)); // the whole program where a stage has no file
  text_->setFocus();
}

// What is made of the settings takes longer than a key may.
void GlslWindow::refresh() {
  const QString what = files_->currentData().toString();
  const PresetChoices& presets = session_.presets();
  const std::string title = settingsTitle(presets.presetId(), presets.settings(), presets.presetSettings());
  QThreadPool::globalInstance()->start(
      [self = QPointer<GlslWindow>(this), what, title, settings = presets.settings(), asked = ++asked_] {
        const QString text = glslText(what, settings, title);
        QMetaObject::invokeMethod(
            qApp,
            [self, text, asked] {
              if (self && self->asked_ == asked) self->text_->setText(text);
            },
            Qt::QueuedConnection);
      });
  const QString folder = ShaderWatch::folder();
  const bool isFile = what != kProgram && what != kExport;
  if (!isFile)
    note_->setText(tr("It follows the settings."));
  else if (folder.isEmpty())
    note_->setText(tr("Built in. Start with --shaders FOLDER to edit a copy of it."));
  else
    note_->setText(tr("%1 - it is read anew when it is saved.")
                       .arg(QDir(folder).absoluteFilePath(what.mid(QStringLiteral("shaders/").size()))));
}

// From the start when there is no further one below.
void GlslWindow::find(bool fromHere) {
  if (!fromHere) text_->moveCursor(QTextCursor::Start);
  if (text_->find(search_->text())) return;
  text_->moveCursor(QTextCursor::Start);
  text_->find(search_->text());
}

} // namespace taa::app
