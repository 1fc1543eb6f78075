// The doctor's page, on an examination that is written by hand: what it is asked for, what is shown of its
// answer, and where a finding leads.
#include "app/doctor/DoctorPanel.h"

#include "app/commands/DoctorCommands.h"
#include "app/doctor/FindingDetails.h"
#include "app/doctor/FindingList.h"
#include "app/doctor/ResidualBars.h"
#include "app/panels/LowerArea.h"
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"
#include "core/base/Error.h"
#include "core/base/Files.h"
#include "core/settings/Parameters.h"
#include "core/settings/Presets.h"
#include "tests/app/PaintedTexts.h"
#include "tests/app/WindowFixture.h"

#include <QFile>
#include <QPushButton>
#include <QSpinBox>
#include <QStackedWidget>
#include <QTemporaryDir>

#include <atomic>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace taa::app::test {
namespace {

using doctor::Diagnosis;
using doctor::Finding;
using doctor::RegionPlace;

/// y of the sky's motion is negated, in frames of half the picture's size.
Finding skyFinding() {
  Finding finding;
  finding.id = "motionNegatedY";
  finding.name = "Motion's y negated";
  finding.regions = {
      RegionPlace{"the sky", 12, {4, 2, 20, 4}, {6, 3}, 0.25, true, 0, {{2, 4, 20}, {3, 4, 20}}}};
  finding.reason = "another explanation leaves less";
  finding.measure = "mean difference of luma";
  finding.residuals = {{"negatedY", "y negated", 2.0, false, true},
                       {"asGiven", "as given", 8.0, true, false}};
  finding.symptom = "Ghosts grow with speed.";
  finding.change = "Negate y.";
  return finding;
}

Diagnosis wrongSky() {
  Diagnosis diagnosis;
  diagnosis.frames = 32;
  diagnosis.pairs = 31;
  diagnosis.sizePx = {32, 18};
  diagnosis.findings = {skyFinding()};
  diagnosis.parts.leaveOpen({"Motion of the floor", "it is plain", "Capture it with a texture."});
  diagnosis.parts.addRight("Jitter", "jitter fits");
  diagnosis.notes = {"frame 0 is not jittered"};
  return diagnosis;
}

/// What the doctor does, for its thread, which may outlive a test.
struct Script {
  std::mutex mutex;
  std::optional<ExaminationRequest> asked;
  std::atomic<bool> isHeld = false; ///< between what the first frames show and all
  std::atomic<bool> fails = false;
  std::atomic<bool> correctionFails = false, isCorrectionHeld = false;
  Diagnosis early = wrongSky(), all = wrongSky();
};

class DoctorPageTest : public FakeWindow {
 protected:
  void SetUp() override {
    FakeWindow::SetUp();
    window.doctor()->work().setExamine([script = script_](const ExaminationRequest& request,
                                                          const doctor::DiagnosisTold& told,
                                                          const Progress& progress) {
      {
        const std::lock_guard lock(script->mutex);
        script->asked = request;
      }
      if (script->fails) throw Error("the capture has no frame 3");
      told(script->early);
      while (script->isHeld) report(progress, "Examining frames", 8, 32);
      return script->all;
    });
    window.doctor()->work().setCorrect([script = script_](const ExaminationRequest&,
                                                          const Diagnosis& diagnosis, const Settings& healthy,
                                                          const Progress& progress) {
      if (script->correctionFails) throw Error("the capture has no frame 3");
      while (script->isCorrectionHeld) report(progress, "Drawing mended frames", 8, 32);
      doctor::CorrectedLook look;
      look.corrected = doctor::corrected(diagnosis.findings, Settings{}, healthy);
      look.pictures = {{0, 12, Image(2, 2, 3), Image(2, 2, 3)}};
      return look;
    });
    key(Qt::Key_F12, Qt::ControlModifier);
  }
  DoctorPanel* panel() const { return window.doctor(); }
  QPushButton* button(const QString& text) const {
    for (QPushButton* each : panel()->findChildren<QPushButton*>())
      if (each->text() == text) return each;
    return nullptr;
  }
  void examine() {
    QTest::mouseClick(button("Examine"), Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return !panel()->work().isRunning(); }));
    settle();
  }
  ExaminationRequest asked() const {
    const std::lock_guard lock(script_->mutex);
    return *script_->asked;
  }
  /// Chooses a line below a heading by a click.
  void choose(int group, int line) {
    FindingList* list = panel()->list();
    const QTreeWidgetItem* item = list->topLevelItem(group)->child(line);
    list->scrollToItem(item);
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(item).center());
  }
  QString rowOf(const QString& of) const {
    for (const FindingDetails::Row& row : panel()->details()->rows())
      if (row.first == of) return row.second;
    return {};
  }
  const std::vector<doctor::OutlineEdge>& outlines() const {
    return window.views()->active()->viewport()->outlines();
  }

  std::shared_ptr<Script> script_ = std::make_shared<Script>();
};

TEST_F(DoctorPageTest, CutsNothingOfWhatWasFound) {
  examine();
  choose(0, 0);
  for (const QSize size : kWindowSizes) {
    SCOPED_TRACE(size.width());
    window.resize(size);
    settle();
    settle();
    EXPECT_EQ(window.size(), size);
    expectWholeTexts(window);
  }
}

TEST_F(DoctorPageTest, SaysWhatItWillLookAtBeforeAnythingIsKnown) {
  EXPECT_TRUE(window.lower()->shows(LowerPage::Doctor));
  EXPECT_EQ(panel()->note(), "Frames 0 to 31 are looked at, each beside the one before it.");
  EXPECT_FALSE(panel()->saveButton()->isEnabled());
  panel()->setFrames(5, 5);
  EXPECT_EQ(panel()->note(), "At least two frames are examined: each is compared with the one before it.");
  EXPECT_FALSE(button("Examine")->isEnabled());
  key(Qt::Key_F12, Qt::ControlModifier);
  EXPECT_FALSE(panel()->isVisible());
}

TEST_F(DoctorPageTest, ExaminesTheFramesThatAreChosenWithThePresentSettings) {
  session.presets().setParameter("fault.motionY", -1.0);
  settle();
  panel()->setFrames(4, 13);
  examine();
  EXPECT_EQ(asked().shot.source, "builtin:fan");
  EXPECT_EQ(asked().shot.size, glm::ivec2(64, 36));
  EXPECT_EQ(asked().shot.settings.settings.fault.motionY, -1.0f);
  EXPECT_EQ(asked().first, 4);
  EXPECT_EQ(asked().frames, 10);
  EXPECT_EQ(panel()->note(), "32 frames, 31 pairs compared.");
}

TEST_F(DoctorPageTest, AKeyOpensThePageAndBegins) {
  key(Qt::Key_F12, Qt::ControlModifier);
  key(Qt::Key_F12, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(panel()->isVisible());
  ASSERT_TRUE(waitFor([&] { return panel()->isComplete(); }));
}

TEST_F(DoctorPageTest, ShowsTheFirstFindingsWhileItGoesOnAndKeepsThemWhereItIsStopped) {
  script_->isHeld = true;
  script_->early.frames = 8;
  QTest::mouseClick(button("Examine"), Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return panel()->diagnosis().has_value(); }));
  EXPECT_TRUE(panel()->work().isRunning());
  ASSERT_TRUE(panel()->finding());
  EXPECT_EQ(panel()->details()->title(), "Motion's y negated");
  EXPECT_FALSE(panel()->saveButton()->isEnabled()) << "it is not all";
  QTest::mouseClick(button("Stop"), Qt::LeftButton);
  settle();
  EXPECT_FALSE(panel()->work().isRunning());
  EXPECT_TRUE(panel()->finding());
  EXPECT_TRUE(panel()->note().startsWith("8 frames")) << panel()->note().toStdString();
  EXPECT_TRUE(panel()->note().endsWith("stopped before it had seen all.")) << panel()->note().toStdString();
}

TEST_F(DoctorPageTest, ShowsAFindingWithItsEvidence) {
  examine();
  EXPECT_EQ(rowOf("How sure"), "sure");
  EXPECT_EQ(rowOf("Where"), "the sky: 25 % of all pixels, largest in frame 12");
  EXPECT_EQ(rowOf("One sees"), "Ghosts grow with speed.");
  EXPECT_EQ(rowOf("Change"), "Negate y.");
  const ResidualBars* bars = panel()->details()->bars();
  ASSERT_EQ(bars->bars().size(), 2u);
  EXPECT_EQ(bars->bars()[0].mark, "fits");
  EXPECT_EQ(bars->bars()[1].mark, "what is stored");
  EXPECT_EQ(bars->bars()[1].number, "8");
  // Words go first: bars are longer only where they leave room.
  ResidualBars narrow;
  narrow.setResiduals(
      {{"reversed", "the other way around", 0.0, false, true}, {"asStated", "as stated", 1.0, true, false}});
  narrow.resize(375, narrow.sizeHint().height());
  EXPECT_TRUE(narrow.areLabelsWhole()) << "at 1280 px";
  EXPECT_GE(narrow.barRect(1).width(), 48.0);
  // Where nothing is marked, labels go on into the column of marks.
  narrow.setResiduals({{"negatedY", "y negated", 0.0002, false, true},
                       {"asGiven", "as given", 1.41, true, false},
                       {"jitter", "with the jitter of the frame before added", 1.41, false, false}});
  narrow.resize(375, narrow.sizeHint().height());
  EXPECT_TRUE(narrow.areLabelsWhole()) << "at 1280 px";
  // In less room they take more lines, and bars below lie lower.
  narrow.resize(300, narrow.height());
  EXPECT_FALSE(narrow.areLabelsWhole());
  const double before = narrow.barRect(2).y();
  narrow.resize(300, narrow.heightForWidth(300));
  EXPECT_GT(narrow.height(), narrow.sizeHint().height());
  EXPECT_TRUE(narrow.areLabelsWhole());
  EXPECT_EQ(narrow.barRect(2).y(), before) << "the last label is the long one";
  EXPECT_NEAR(bars->barRect(0).width(), 0.25 * bars->barRect(1).width(), 1e-9) << "2 of 8";
}

// What a page that comes into view makes anybody ask is answered from the diagnosis that it shows.
TEST_F(DoctorPageTest, AnotherExaminationWithoutFindingsKeepsNoChoiceOfTheLast) {
  examine();
  ASSERT_TRUE(panel()->finding());
  script_->early.findings.clear();
  script_->all.findings.clear();
  auto* const pages = panel()->findChild<QStackedWidget*>();
  int asked = 0;
  QObject::connect(pages, &QStackedWidget::currentChanged, panel(), [&] {
    ++asked;
    EXPECT_FALSE(panel()->finding());
    EXPECT_TRUE(panel()->places().empty());
  });
  examine();
  EXPECT_EQ(asked, 2) << "away from the last one, and to this one";
  EXPECT_FALSE(panel()->finding());
}

TEST_F(DoctorPageTest, EnterGoesToFrameAndPlaneAndOutlinesTheRegion) {
  examine();
  EXPECT_TRUE(outlines().empty()) << "in frame 0 it lies elsewhere";
  panel()->list()->setFocus();
  QTest::keyClick(panel()->list(), Qt::Key_Return);
  settle();
  EXPECT_EQ(renderer->status.info.frame, 12);
  EXPECT_EQ(window.views()->active()->id(), IntermediateId::motion);
  const std::vector<doctor::OutlineEdge> around{
      {{8, 4}, {40, 4}}, {{8, 4}, {8, 8}}, {{40, 4}, {40, 8}}, {{8, 8}, {40, 8}}};
  EXPECT_EQ(outlines(), around) << "the picture is twice as large";
  session.seek(13);
  settle();
  EXPECT_TRUE(outlines().empty());
  QTest::mouseClick(panel()->details()->goButton(), Qt::LeftButton);
  settle();
  EXPECT_EQ(renderer->status.info.frame, 12);
  key(Qt::Key_F12, Qt::ControlModifier);
  EXPECT_TRUE(outlines().empty()) << "nobody looks";
}

TEST_F(DoctorPageTest, ComparesWithWhatItWouldBeIfTheFindingWereRight) {
  EXPECT_FALSE(window.doctorCommands()->whyNotCorrected().isEmpty()) << "nothing is found";
  session.presets().setParameter("fault.motionY", -1.0);
  examine();
  EXPECT_TRUE(panel()->details()->correctedButton()->isEnabled());
  QTest::mouseClick(panel()->details()->correctedButton(), Qt::LeftButton);
  settle();
  const Comparison shown = window.views()->active()->comparison();
  ASSERT_EQ(shown.kind, OtherKind::Preset);
  EXPECT_EQ(window.views()->active()->id(), IntermediateId::resolved);
  EXPECT_EQ(renderer->status.info.frame, 12);
  const Preset corrected = preset(shown.preset);
  EXPECT_EQ(differences(corrected.settings, session.presets().settings()),
            std::vector<std::string>{"fault.motionY=1"});
  EXPECT_EQ(corrected.label, "Mended: Motion's y negated");
  std::filesystem::remove(shown.preset);
}

TEST_F(DoctorPageTest, SaysWhyAFindingCannotBeShownMended) {
  examine();
  EXPECT_FALSE(panel()->details()->correctedButton()->isEnabled())
      << "it says no settings, and none are faulty";
  key(Qt::Key_M, Qt::AltModifier);
  EXPECT_FALSE(window.views()->active()->comparison());
  script_->early.findings[0].correction = script_->all.findings[0].correction = {"fault.motionY=-1"};
  examine();
  EXPECT_TRUE(panel()->details()->correctedButton()->isEnabled());
}

TEST_F(DoctorPageTest, SaysWhyItIsUndecidedAndWhatToCapture) {
  examine();
  choose(1, 0);
  EXPECT_EQ(panel()->details()->title(), "Motion of the floor");
  EXPECT_EQ(rowOf("Not decided"), "It is plain.");
  EXPECT_EQ(rowOf("Capture"), "Capture it with a texture.");
  EXPECT_FALSE(panel()->finding());
  choose(3, 0);
  EXPECT_EQ(rowOf(""), "Frame 0 is not jittered.");
  EXPECT_TRUE(panel()->details()->goButton()->isHidden());
}

TEST_F(DoctorPageTest, SaysThatNothingIsWrong) {
  Diagnosis healthy;
  healthy.frames = 32;
  healthy.pairs = 31;
  healthy.parts.addRight("Jitter", "jitter fits");
  script_->early = script_->all = healthy;
  examine();
  EXPECT_EQ(panel()->details()->title(), "Nothing wrong was found.");
  EXPECT_EQ(rowOf("Right"), "Jitter fits.");
  EXPECT_TRUE(outlines().empty());
}

TEST_F(DoctorPageTest, SaysWhatWentWrongWithTheExamination) {
  script_->fails = true;
  examine();
  EXPECT_EQ(panel()->note(), "the capture has no frame 3");
  EXPECT_TRUE(button("Examine")->isEnabled());
}

TEST_F(DoctorPageTest, SavesTheReportOnceAllIsKnown) {
  const QTemporaryDir folder;
  const QString path = folder.filePath("doctor.html");
  EXPECT_FALSE(window.doctorCommands()->whyNoReport().isEmpty());
  examine();
  EXPECT_TRUE(window.doctorCommands()->whyNoReport().isEmpty());
  EXPECT_TRUE(panel()->saveButton()->isEnabled());
  window.doctorCommands()->writeReport(path);
  const std::string text = readFile(path.toStdString());
  EXPECT_NE(text.find("Motion's y negated"), std::string::npos) << text;
  EXPECT_NE(text.find("builtin:fan"), std::string::npos);
}

TEST_F(DoctorPageTest, SavesPicturesOfWhatCanBeMendedWithTheReport) {
  script_->all.findings[0].correction = {"fault.motionY=-1"};
  const QTemporaryDir folder;
  const QString path = folder.filePath("doctor.html");
  examine();
  script_->isCorrectionHeld = true;
  window.doctorCommands()->writeReport(path);
  settle();
  EXPECT_FALSE(QFile::exists(path)) << "its pictures are being drawn";
  EXPECT_FALSE(panel()->saveButton()->isEnabled());
  EXPECT_FALSE(window.doctorCommands()->whyNoReport().isEmpty());
  script_->isCorrectionHeld = false;
  ASSERT_TRUE(waitFor([&] { return !panel()->work().isRunning(); }));
  settle();
  const std::string text = readFile(path.toStdString());
  EXPECT_NE(text.find("Frame 12 mended"), std::string::npos);
  EXPECT_NE(text.find("data:image/png;base64,"), std::string::npos);
  EXPECT_TRUE(panel()->saveButton()->isEnabled());
}

TEST_F(DoctorPageTest, SavesTheReportWithoutPicturesWhereTheyCannotBeDrawnAndNoneWhereTheyAreStopped) {
  script_->all.findings[0].correction = {"fault.motionY=-1"};
  const QTemporaryDir folder;
  const QString path = folder.filePath("doctor.html"), other = folder.filePath("other.html");
  examine();
  script_->correctionFails = true;
  window.doctorCommands()->writeReport(path);
  ASSERT_TRUE(waitFor([&] { return !panel()->work().isRunning(); }));
  settle();
  const std::string text = readFile(path.toStdString());
  EXPECT_NE(text.find("Motion's y negated"), std::string::npos);
  EXPECT_EQ(text.find("data:image/png"), std::string::npos);
  script_->correctionFails = false;
  script_->isCorrectionHeld = true;
  window.doctorCommands()->writeReport(other);
  settle();
  QTest::mouseClick(button("Stop"), Qt::LeftButton);
  script_->isCorrectionHeld = false;
  ASSERT_TRUE(waitFor([&] { return !panel()->work().isRunning(); }));
  settle();
  EXPECT_FALSE(QFile::exists(other));
  EXPECT_TRUE(panel()->diagnosis()) << "what was found stays";
}

TEST_F(DoctorPageTest, SaysThatSettingsHaveChangedAndForgetsAnotherShot) {
  examine();
  session.presets().setParameter("fault.motionX", 2.0);
  settle();
  EXPECT_EQ(panel()->note(), "32 frames, 31 pairs compared; settings have changed since.");
  session.presets().setParameter("fault.motionX", 1.0);
  settle();
  EXPECT_EQ(panel()->note(), "32 frames, 31 pairs compared.");
  window.openSource("builtin:fence");
  ASSERT_TRUE(waitFor([&] { return session.status().source == "builtin:fence"; }));
  settle();
  EXPECT_FALSE(panel()->diagnosis());
}

} // namespace
} // namespace taa::app::test
