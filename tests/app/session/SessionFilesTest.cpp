// Sessions, autosaves, exports and shaders as the window handles them, on a fake renderer.
#include "app/commands/Exports.h"
#include "app/dialogs/GlslWindow.h"
#include "app/dialogs/RangeDialog.h"
#include "app/dialogs/SourceText.h"
#include "app/menus/CommandLists.h"
#include "app/panels/MessagesBar.h"
#include "app/panels/ProbePanel.h"
#include "app/panels/TimelinePanel.h"
#include "app/session/ShaderWatch.h"
#include "app/session/keeping/Autosave.h"
#include "app/session/keeping/SessionKeeper.h"
#include "app/views/ViewArea.h"
#include "app/widgets/Chooser.h"
#include "app/widgets/bars/OfferBar.h"
#include "core/base/Files.h"
#include "tests/app/WindowFixture.h"
#include "tests/support/ShaderFolder.h"

#include <QAction>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QImage>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLineEdit>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTimer>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <memory>
#include <string>
#include <utility>
#include <vector>

using namespace taa;
using namespace taa::app;

namespace {

/// A window that remembers, in a folder of its own.
class SessionFiles : public taa::app::test::FakeWindow {
 protected:
  QTemporaryDir folder;
  QSettings settings{folder.filePath("taa.ini"), QSettings::IniFormat};
  std::unique_ptr<app::test::TestWindow> own = std::make_unique<app::test::TestWindow>(session, &settings);

  void SetUp() override {
    FakeWindow::SetUp();
    own->show();
    own->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(own.get()));
    settle();
  }
  QString path(const char* name) const { return folder.filePath(QString::fromLatin1(name)); }
  QJsonObject written(const char* name) const {
    QJsonObject all =
        QJsonDocument::fromJson(QByteArray::fromStdString(readFile(path(name).toStdString()))).object();
    const QString part = QStringLiteral("window");
    all[part] = app::test::withoutPlaces(all.value(part).toObject());
    return all;
  }
  void drop(const QString& file) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(file)});
    QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(own.get(), &enter); // says where the drop goes
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent event({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(own.get(), &event);
    settle();
  }
};

TEST_F(SessionFiles, CtrlSAsksOnceAndThenSavesThere) {
  QTest::keyClick(own.get(), Qt::Key_S, Qt::ControlModifier);
  auto* dialog = own->findChild<QFileDialog*>();
  ASSERT_TRUE(dialog);
  dialog->close();
  own->keeper()->saveTo(path("first"));
  EXPECT_EQ(own->keeper()->path(), path("first.taa.json"));
  EXPECT_EQ(readSession(path("first.taa.json").toStdString()).source, "builtin:fan");
  session.seek(12);
  settle();
  own->activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(own.get()));
  QTest::keyClick(own.get(), Qt::Key_S, Qt::ControlModifier);
  EXPECT_EQ(readSession(path("first.taa.json").toStdString()).frame, 12);
  EXPECT_EQ(own->keeper()->recent().front(), path("first.taa.json"));
}

TEST_F(SessionFiles, KeepTheAnimationAndTheLengthThatAreChosenInTheMenu) {
  own->keeper()->openSource(app::test::kFakeAnimated);
  settle();
  session.scene().setCamera("pan");
  session.scene().addCameraTrack({"flown", 0, {CameraPose{}}});
  session.post(request::SetSize{96, 54});
  session.seek(33);
  settle();
  const auto action = [&](const QString& text) {
    for (QAction* each : own->findChildren<QAction*>())
      if (each->text() == text) return each;
    return static_cast<QAction*>(nullptr);
  };
  ASSERT_TRUE(action("run && jump"));
  action("run && jump")->trigger();
  settle();
  EXPECT_EQ(renderer->status.choice, (ShotChoice{"run & jump", 0}));
  session.choose({"run & jump", 1000});
  settle();
  EXPECT_EQ(renderer->status.frameCount, 1000);
  EXPECT_EQ(renderer->status.camera, "flown");
  EXPECT_EQ(renderer->status.width, 96) << "all else stays";
  EXPECT_EQ(renderer->status.info.frame, 33);
  own->keeper()->saveTo(path("chosen.taa.json"));
  session.choose({});
  settle();
  EXPECT_EQ(renderer->status.frameCount, 240);
  drop(path("chosen.taa.json"));
  EXPECT_EQ(renderer->status.choice, (ShotChoice{"run & jump", 1000}));
}

TEST_F(SessionFiles, TheAnimationAndTheLengthAreStepsOfUndoAmongOthers) {
  own->keeper()->openSource(app::test::kFakeAnimated);
  settle();
  session.scene().setHidden("floor", true);
  session.choose({"run & jump", 0});
  settle();
  session.presets().setParameter("weight.minimum", 0.25);
  session.choose({"run & jump", 1000});
  settle();
  EXPECT_EQ(session.undoStack().undoText(), "choice of the shot's length");
  EXPECT_EQ(renderer->status.filter.hidden, std::vector<std::string>{"floor"});

  session.undo();
  settle();
  EXPECT_EQ(renderer->status.choice, (ShotChoice{"run & jump", 0}));
  session.undo();
  EXPECT_NE(session.presets().settings().weight.minimum, 0.25f);
  EXPECT_EQ(session.undoStack().undoText(), "choice of animation");
  session.undo();
  settle();
  EXPECT_EQ(renderer->status.choice, ShotChoice());
  EXPECT_EQ(renderer->status.filter.hidden, std::vector<std::string>{"floor"});
  session.undo();
  settle();
  EXPECT_TRUE(renderer->status.filter.hidden.empty()) << "what came before the choice is taken back as well";
  EXPECT_FALSE(session.undoStack().canUndo());

  for (int step = 0; step < 4; ++step) {
    session.redo();
    settle();
  }
  EXPECT_EQ(renderer->status.choice, (ShotChoice{"run & jump", 1000}));
  EXPECT_EQ(renderer->status.filter.hidden, std::vector<std::string>{"floor"});
  EXPECT_EQ(session.presets().settings().weight.minimum, 0.25f);

  own->keeper()->openSource("builtin:fan");
  settle();
  EXPECT_EQ(session.choice(), ShotChoice()) << "of another scene";
  EXPECT_NE(session.undoStack().undoText(), "choice of the shot's length");
}

TEST_F(SessionFiles, ADroppedSessionBringsEverythingBack) {
  session.presets().setPreset("fsr2");
  session.presets().setParameter("weight.minimum", 0.25);
  session.scene().setCamera("pan");
  session.post(request::SetSize{96, 54});
  session.scene().setMotionMode("rotor & hub", MotionMode::None);
  session.seek(33);
  settle();
  session.probes().setPixel(glm::ivec2(70, 40));
  session.probes().add(glm::ivec2(12, 9), Follow::Surface);
  own->probe()->setVisible(false);
  own->messages()->setNoteTime(std::chrono::milliseconds(1)); // a note takes room from the panels
  settle();
  own->keeper()->saveTo(path("it.taa.json"));
  const QJsonObject saved = written("it.taa.json");

  session.presets().setPreset("minimal");
  session.scene().setCamera("still");
  session.post(request::SetSize{64, 36});
  session.scene().setMotionMode("rotor & hub", MotionMode::PerObject);
  session.seek(3);
  session.probes().removeAll();
  own->probe()->setVisible(true);
  settle();
  drop(path("it.taa.json"));
  EXPECT_EQ(session.presets().presetId(), "fsr2");
  EXPECT_TRUE(session.presets().isPresetChanged());
  EXPECT_EQ(renderer->status.settings.weight.minimum, 0.25f);
  EXPECT_EQ(renderer->status.camera, "pan");
  EXPECT_EQ(renderer->status.width, 96);
  EXPECT_EQ(renderer->status.info.frame, 33);
  EXPECT_FALSE(renderer->status.playing);
  ASSERT_EQ(renderer->status.motionModes.size(), 1u);
  EXPECT_EQ(renderer->status.motionModes[0].mode, MotionMode::None);
  ASSERT_EQ(session.probes().all().size(), 2u);
  EXPECT_EQ(session.probes().all()[0].pixel, glm::ivec2(70, 40));
  EXPECT_EQ(session.probes().all()[1].follow, Follow::Surface);
  EXPECT_EQ(session.probes().active(), 1);
  settle();
  own->keeper()->saveTo(path("again.taa.json"));
  EXPECT_EQ(written("again.taa.json"), saved);
}

TEST_F(SessionFiles, OneOfALongerShotOpensAtItsFrame) {
  session.seek(200);
  settle();
  const SessionFile far = session.file();
  ASSERT_EQ(far.frame, 200);
  session.choose({.animation = {}, .frames = 20});
  settle();
  ASSERT_EQ(session.status().frameCount, 20);
  session.restore(far);
  settle();
  EXPECT_EQ(session.status().frameCount, 240);
  EXPECT_EQ(renderer->status.info.frame, 200);
}

TEST_F(SessionFiles, OneOfTheVersionBeforeOpensAndSaysWhatHasAnotherName) {
  session.probes().setPixel(glm::ivec2(30, 20));
  session.probes().add(glm::ivec2(12, 9), Follow::Surface);
  session.probes().setActive(0);
  settle();
  own->keeper()->saveTo(path("it.taa.json"));
  std::string text = readFile(path("it.taa.json").toStdString());
  const auto rename = [&](const std::string& now, const std::string& old) {
    const std::size_t at = text.find(now);
    ASSERT_NE(at, std::string::npos) << now;
    text.replace(at, now.size(), old);
  };
  rename("\"probes\"", "\"pins\"");
  rename("\"activeProbe\"", "\"activePin\"");
  rename("\"metric\": \"\"", "\"figure\": \"meanAlpha\"");
  writeFile(path("old.taa.json").toStdString(), text);
  session.probes().removeAll();
  settle();
  QString sentence;
  QObject::connect(own->keeper(), &SessionKeeper::said, own.get(),
                   [&](const QString& said) { sentence = said; });
  drop(path("old.taa.json"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !sentence.isEmpty(); }));
  ASSERT_EQ(session.probes().all().size(), 2u);
  EXPECT_EQ(session.probes().all()[0].pixel, glm::ivec2(30, 20));
  EXPECT_EQ(session.probes().all()[1].follow, Follow::Surface);
  EXPECT_EQ(session.probes().active(), 0);
  EXPECT_EQ(own->timeline()->stripMetric(), Metric::MeanAlpha);
  EXPECT_EQ(
      sentence.toStdString(),
      "The session is of an earlier version: pins is called probes now; activePin is called activeProbe "
      "now; timeline.figure is called timeline.metric now.");
}

TEST_F(SessionFiles, OneThatCannotBeOpenedIsNamedAndChangesNothing) {
  writeFile(path("bad.taa.json").toStdString(), R"({"format": 1, "sauce": 3})");
  session.seek(5);
  settle();
  own->openSource(path("bad.taa.json"));
  settle();
  EXPECT_TRUE(own->messages()->text().contains("sauce")) << own->messages()->text().toStdString();
  EXPECT_EQ(renderer->status.info.frame, 5);
  EXPECT_TRUE(own->keeper()->path().isEmpty());
}

TEST_F(SessionFiles, AnAutosaveGoesWithACleanEnd) {
  own->keeper()->autosave()->save();
  const QString kept = own->keeper()->autosave()->path();
  EXPECT_TRUE(QFile::exists(kept));
  app::test::TestWindow second(session, &settings); // the first one runs
  second.keeper()->offerOrphan();
  EXPECT_FALSE(second.keeper()->offer());
  own.reset();
  EXPECT_FALSE(QFile::exists(kept));
  EXPECT_TRUE(QDir(folder.filePath("autosave")).entryList({"*.taa.json"}, QDir::Files).isEmpty());
}

TEST_F(SessionFiles, WhatACrashLeftIsOfferedOnce) {
  session.seek(21);
  settle();
  own->keeper()->autosave()->save();
  const QString kept = own->keeper()->autosave()->path(), left = folder.filePath("autosave/77-1.taa.json");
  ASSERT_TRUE(QFile::copy(kept, left)); // nobody holds a lock for it
  session.seek(2);
  settle();
  own->keeper()->offerOrphan();
  settle();
  OfferBar* offer = own->keeper()->offer();
  ASSERT_TRUE(offer && offer->isVisible());
  app::test::TestWindow second(session, &settings);
  second.keeper()->offerOrphan();
  EXPECT_FALSE(second.keeper()->offer()) << "it is offered in the first window";
  QTest::mouseClick(offer->findChild<QPushButton*>("accept"), Qt::LeftButton);
  settle();
  EXPECT_EQ(renderer->status.info.frame, 21);
  EXPECT_FALSE(QFile::exists(left));
  EXPECT_FALSE(own->keeper()->offer());
  EXPECT_TRUE(own->keeper()->path().isEmpty());
}

TEST_F(SessionFiles, WhatIsRefusedIsGone) {
  own->keeper()->autosave()->save();
  const QString left = folder.filePath("autosave/77-1.taa.json");
  ASSERT_TRUE(QFile::copy(own->keeper()->autosave()->path(), left));
  own->keeper()->offerOrphan();
  ASSERT_TRUE(own->keeper()->offer());
  QTest::mouseClick(own->keeper()->offer()->findChild<QPushButton*>("refuse"), Qt::LeftButton);
  EXPECT_FALSE(QFile::exists(left));
}

TEST_F(SessionFiles, ACommandLineIsCopied) {
  session.presets().setParameter("weight.minimum", 0.25);
  session.seek(9);
  settle();
  QTest::keyClick(own.get(), Qt::Key_L, Qt::ControlModifier | Qt::AltModifier);
  EXPECT_EQ(QApplication::clipboard()->text(),
            "taa-batch render builtin:fan --size 64x36 --camera still --preset balanced --set "
            "weight.minimum=0.25 --frames 9 --emit resolved --format png --out .");
}

TEST_F(SessionFiles, AViewIsWrittenAsItIsShown) {
  session.probes().removeAll(); // a legend's picture shows them
  settle();
  const std::shared_ptr<const ViewResult> shown = session.picture(0);
  ASSERT_TRUE(shown);
  own->views()->view(0)->setResult(shown);
  own->exports()->writeView(path("view.png"), false);
  own->exports()->writeView(path("legend.png"), true);
  ASSERT_TRUE(taa::app::test::waitFor(
      [&] { return QFile::exists(path("view.png")) && QFile::exists(path("legend.png")); }));
  const QImage plain = QImage(path("view.png")).convertToFormat(QImage::Format_RGBA8888);
  // 64 x 36 in whole screen pixels each, in the middle of the view, and nothing around it.
  const QSize view(shown->picture.width, shown->picture.height);
  const int zoom = std::min(view.width() / 64, view.height() / 36);
  ASSERT_EQ(plain.size(), zoom * QSize(64, 36));
  const QPoint corner((view.width() - plain.width()) / 2, (view.height() - plain.height()) / 2);
  for (int y = 0; y < plain.height(); ++y) {
    const long long first = 1ll * (corner.y() + y) * view.width() + corner.x();
    ASSERT_EQ(std::memcmp(plain.constScanLine(y), shown->picture.rgba.data() + 4 * first,
                          static_cast<std::size_t>(4) * plain.width()),
              0);
  }
  const QImage more = QImage(path("legend.png")).convertToFormat(QImage::Format_RGBA8888);
  ASSERT_GT(more.height(), plain.height());
  EXPECT_EQ(more.copy(0, 0, plain.width(), plain.height()), plain);
  own->exports()->writeView("/nowhere/view.png", false);
  EXPECT_TRUE(taa::app::test::waitFor([&] { return own->messages()->text().contains("/nowhere/view.png"); }));
}

TEST_F(SessionFiles, ARangeIsAskedForAndItsEndIsSaid) {
  QTest::keyClick(own.get(), Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
  auto* dialog = own->findChild<RangeDialog*>();
  ASSERT_TRUE(dialog && !dialog->isModal());
  const QList<QSpinBox*> frames = dialog->findChildren<QSpinBox*>();
  frames[0]->setValue(3);
  frames[1]->setValue(8);
  dialog->findChild<QComboBox*>()->setCurrentIndex(1);
  QLineEdit* target = nullptr;
  for (QLineEdit* field : dialog->findChildren<QLineEdit*>())
    if (field->accessibleName() == "File") target = field;
  ASSERT_TRUE(target);
  QPushButton* start = nullptr;
  for (QPushButton* button : dialog->findChildren<QPushButton*>())
    if (button->text().contains("Export")) start = button;
  ASSERT_TRUE(start);
  target->setText("/nowhere/at/all.gif");
  EXPECT_FALSE(start->isEnabled());
  target->setText(path("out"));
  EXPECT_TRUE(start->isEnabled());
  QTest::mouseClick(start, Qt::LeftButton);
  ASSERT_FALSE(renderer->all<request::ExportSequence>().empty());
  EXPECT_EQ(renderer->last<request::ExportSequence>().sequence.kind, SequenceKind::Gif);
  EXPECT_EQ(renderer->last<request::ExportSequence>().sequence.target, path("out.gif").toStdString());
  EXPECT_EQ(renderer->last<request::ExportSequence>().sequence.first, 3);
  EXPECT_EQ(renderer->last<request::ExportSequence>().sequence.last, 8);
  EXPECT_EQ(renderer->last<request::ExportSequence>().sequence.picture.width, 64);
  renderer->tell(ExportResult{path("out.gif").toStdString(), 6});
  settle();
  EXPECT_TRUE(own->messages()->text().contains("out.gif"));
}

TEST_F(SessionFiles, ARangeStartsFromThePartThatIsRepeated) {
  session.setPlayback({.framesPerSecond = 0.0, .speed = 1.0, .range = std::pair(11, 17)});
  settle();
  QTest::keyClick(own.get(), Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
  auto* dialog = own->findChild<RangeDialog*>();
  ASSERT_TRUE(dialog);
  EXPECT_EQ(dialog->request().first, 11);
  EXPECT_EQ(dialog->request().last, 17);
}

// What the view shows as a difference is offered as values.
TEST_F(SessionFiles, ARangeOfValuesMayBeTheDifferenceThatTheViewShows) {
  QTest::keyClick(own.get(), Qt::Key_D, Qt::ShiftModifier);
  QTest::keyClick(own.get(), Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
  auto* dialog = own->findChild<RangeDialog*>();
  ASSERT_TRUE(dialog);
  auto* difference = dialog->findChild<QCheckBox*>();
  ASSERT_TRUE(difference);
  EXPECT_FALSE(difference->isVisible()) << "of pictures the view says it";
  for (QComboBox* each : dialog->findChildren<QComboBox*>())
    if (each->accessibleName() == "Kind of files") each->setCurrentIndex(2);
  EXPECT_TRUE(difference->isVisible() && difference->isEnabled() && difference->isChecked());
  SequenceRequest wanted = dialog->request();
  EXPECT_EQ(wanted.kind, SequenceKind::Exr);
  EXPECT_EQ(wanted.differenceFrom, "motion:-1");
  ASSERT_TRUE(wanted.picture.other);
  EXPECT_TRUE(wanted.picture.other->alongMotion);
  QTest::mouseClick(difference, Qt::LeftButton, {}, {difference->height() / 2, difference->height() / 2});
  EXPECT_EQ(dialog->request().differenceFrom, "") << "the rows themselves";
}

TEST_F(SessionFiles, ARangeAsksOnceBeforeItReplacesFiles) {
  for (const char* name : {"out.0004.png", "out.0006.png"}) writeFile(path(name).toStdString(), "mine");
  QTest::keyClick(own.get(), Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
  auto* dialog = own->findChild<RangeDialog*>();
  ASSERT_TRUE(dialog);
  const QList<QSpinBox*> frames = dialog->findChildren<QSpinBox*>();
  frames[0]->setValue(3);
  frames[1]->setValue(8);
  QPushButton* start = nullptr;
  for (QPushButton* button : dialog->findChildren<QPushButton*>())
    if (button->text().contains("Export")) start = button;
  for (QLineEdit* field : dialog->findChildren<QLineEdit*>())
    if (field->accessibleName() == "File") field->setText(path("out.png"));
  ASSERT_TRUE(start && start->isEnabled());
  const auto answer = [&](const QString& text) {
    QTest::mouseClick(start, Qt::LeftButton);
    const auto boxes = dialog->findChildren<QMessageBox*>();
    ASSERT_EQ(boxes.size(), 1);
    EXPECT_TRUE(boxes[0]->text().contains("2 of 6") && boxes[0]->text().contains("out.0004.png"))
        << boxes[0]->text().toStdString();
    EXPECT_TRUE(renderer->all<request::ExportSequence>().empty());
    for (QAbstractButton* button : boxes[0]->buttons())
      if (button->text().remove('&') == text) QTest::mouseClick(button, Qt::LeftButton);
    QTest::qWait(50);
  };
  answer("Cancel");
  EXPECT_TRUE(renderer->all<request::ExportSequence>().empty());
  ASSERT_TRUE(dialog->isVisible()) << "another place can be chosen";
  answer("Replace");
  ASSERT_FALSE(renderer->all<request::ExportSequence>().empty());
  EXPECT_EQ(renderer->last<request::ExportSequence>().sequence.first, 3);
}

// Without a desktop's own dialogs; those ask by themselves.
TEST_F(SessionFiles, SaveDialogsAskBeforeTheyReplaceAFile) {
  writeFile(path("kept.taa.json").toStdString(), "mine");
  const auto saveAs = [&](const QString& name, const QString& answer) {
    own->keeper()->askWhereToSave();
    auto* dialog = own->findChild<QFileDialog*>();
    ASSERT_TRUE(dialog);
    dialog->setDirectory(folder.path());
    settle(); // it reads the folder, then selects the file that the session came from
    auto* field = dialog->findChild<QLineEdit*>("fileNameEdit");
    field->selectAll();
    QTest::keyClicks(field, name);
    ASSERT_EQ(field->text(), name);
    bool asked = false;
    // Its question has a loop of its own.
    QTimer looks;
    QObject::connect(&looks, &QTimer::timeout, own.get(), [&] {
      for (QWidget* widget : QApplication::topLevelWidgets())
        if (auto* box = qobject_cast<QMessageBox*>(widget); box && box->isVisible() && !asked) {
          for (QAbstractButton* button : box->buttons())
            asked = asked || button->text().remove('&') == answer;
          for (QAbstractButton* button : box->buttons())
            if (button->text().remove('&') == answer || !asked) return button->click();
        }
    });
    looks.start(20);
    QMetaObject::invokeMethod(dialog, "accept");
    EXPECT_TRUE(taa::app::test::waitFor([&] { return asked; }, 5000)) << name.toStdString();
    looks.stop();
    delete own->findChild<QFileDialog*>();
    settle();
  };
  const auto text = [&] { return readFile(path("kept.taa.json").toStdString()); };
  saveAs("kept.taa.json", "No");
  EXPECT_EQ(text(), "mine");
  writeFile(path("kept.old.taa.json").toStdString(), "mine");
  saveAs("kept.old", "Cancel"); // the ending is added after the dialog's own question
  EXPECT_EQ(readFile(path("kept.old.taa.json").toStdString()), "mine");
  saveAs("kept.taa.json", "Yes");
  EXPECT_NE(text(), "mine");
  saveAs("kept.old", "Replace");
  EXPECT_NE(readFile(path("kept.old.taa.json").toStdString()), "mine");
}

TEST_F(SessionFiles, AShaderErrorStaysUntilItIsMended) {
  renderer->tell(ShadersRead{"cannot compile shaders/taa/resolve.frag:\ntaa/blend.glsl:17: error: no"});
  settle();
  EXPECT_TRUE(own->messages()->text().contains("taa/blend.glsl:17: error: no"));
  renderer->tell(ShadersRead{""});
  settle();
  EXPECT_FALSE(own->messages()->text().contains("taa/blend.glsl:17"));
  EXPECT_TRUE(own->messages()->text().contains("compile again"));
}

TEST_F(SessionFiles, TheGlslOfAStageIsRead) {
  own->views()->active()->setIntermediate(IntermediateId::alpha);
  QTest::keyClick(own.get(), Qt::Key_F5, Qt::ShiftModifier);
  auto* glsl = own->findChild<GlslWindow*>();
  ASSERT_TRUE(glsl && glsl->isVisible() && !glsl->isModal());
  EXPECT_EQ(glsl->files()->currentData().toString(), "shaders/taa/blend_weight.glsl");
  const auto shows = [&](const char* words) {
    return taa::app::test::waitFor([&] { return glsl->text()->toPlainText().contains(words); }, 20000);
  };
  EXPECT_TRUE(shows("Weights blendWeight("));
  QTest::keyClicks(glsl->search(), "minWeight");
  EXPECT_EQ(glsl->text()->textCursor().selectedText(), "minWeight");
  const int line = glsl->text()->textCursor().blockNumber();
  QTest::keyClick(glsl->search(), Qt::Key_Return);
  EXPECT_GT(glsl->text()->textCursor().blockNumber(), line);
  glsl->files()->setCurrentIndex(1); // what is exported follows the settings
  EXPECT_TRUE(shows("kWeightMinimum = 0.1;"));
  session.presets().setParameter("weight.minimum", 0.3125);
  EXPECT_TRUE(shows("kWeightMinimum = 0.3125;"));
}

TEST_F(SessionFiles, CommandsHoldTheChoicesOfParameters) {
  own->lists()->choose();
  auto* chooser = own->findChild<Chooser*>();
  ASSERT_TRUE(chooser);
  auto* field = chooser->findChild<QLineEdit*>();
  QTest::keyClicks(field, "rectify.method=none");
  QTest::keyClick(field, Qt::Key_Return);
  settle();
  EXPECT_EQ(renderer->status.settings.rectify.method, RectifyMethod::None);
}

TEST(ShaderWatchTest, SaysOnceThatAFileWasSaved) {
  const taa::test::ShaderFolder shaders;
  ShaderWatch watch(ShaderWatch::folder(), nullptr);
  int changes = 0;
  QObject::connect(&watch, &ShaderWatch::changed, &watch, [&] { ++changes; });
  shaders.replace("taa/blend.glsl", "float blendFactor(", "// edited\nfloat blendFactor(");
  ASSERT_TRUE(taa::app::test::waitFor([&] { return changes > 0; }, 10000));
  QTest::qWait(400);
  EXPECT_EQ(changes, 1);
  shaders.write("taa/blend.glsl", shaders.read("taa/blend.glsl")); // the same again
  QTest::qWait(400);
  EXPECT_EQ(changes, 1);
  shaders.write("taa/blend.glsl", shaders.read("taa/blend.glsl") + "\n"); // replaced once more
  EXPECT_TRUE(taa::app::test::waitFor([&] { return changes == 2; }, 10000));
}

} // namespace
