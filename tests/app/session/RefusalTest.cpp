// Errors of the render thread in the window: each takes back what it answers, and nothing else.
#include "app/panels/MessagesBar.h"
#include "app/widgets/Chooser.h"
#include "core/settings/Parameters.h"
#include "tests/app/WindowFixture.h"

#include <QDragEnterEvent>
#include <QDropEvent>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QUrl>

#include <string>
#include <vector>

using namespace taa;
using namespace taa::app;

namespace {

class Refusals : public taa::app::test::FakeWindow {
 protected:
  /// By its command: "rectify.method=none".
  void type(const char* command) {
    key(Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
    auto* field = window.findChild<Chooser*>()->findChild<QLineEdit*>();
    QTest::keyClicks(field, command);
    QTest::keyClick(field, Qt::Key_Return);
    settle();
  }
  /// From now on nothing that is asked for is answered.
  void holdBack() { renderer->holdsBack = true; }
  void goOn() {
    renderer->holdsBack = false;
    renderer->deliver();
    settle();
  }
  /// As the render thread does: an error, then what is in force.
  void fail(const char* sentence, RequestKind kind, RequestId request) {
    renderer->tell(Failure{sentence, kind, request});
    renderer->tell(before);
    settle();
  }
  void SetUp() override {
    FakeWindow::SetUp();
    before = renderer->status;
  }
  Status before;
};

} // namespace

TEST_F(Refusals, AnErrorOfAnExportLeavesWhatIsPendingInForceAndShown) {
  holdBack();
  type("rectify.method=none");
  session.scene().setHidden("floor", true);
  session.scene().setMotionMode("rotor & hub", MotionMode::None);
  fail("cannot write /nowhere", RequestKind::Export, renderer->requests + 1);
  EXPECT_TRUE(window.messages()->text().contains("/nowhere"));
  EXPECT_EQ(session.presets().settings().rectify.method, RectifyMethod::None);
  EXPECT_EQ(session.scene().objectFilter().hidden, std::vector<std::string>{"floor"});
  ASSERT_EQ(session.scene().motionModes().size(), 1u);
  EXPECT_TRUE(window.windowTitle().contains("balanced*")) << window.windowTitle().toStdString();
  goOn();
  EXPECT_EQ(session.presets().settings(), renderer->status.settings);
  EXPECT_EQ(session.presets().settings().rectify.method, RectifyMethod::None);
  EXPECT_EQ(session.scene().objectFilter().hidden, std::vector<std::string>{"floor"});
}

TEST_F(Refusals, SettingsThatAreRefusedGiveWayToThoseInForce) {
  renderer->refused = RequestKind::Settings; // a shader that does not compile, memory that is not there
  type("rectify.method=none");
  EXPECT_EQ(session.presets().settings(), before.settings);
  EXPECT_TRUE(window.messages()->text().contains("refused"));
  EXPECT_FALSE(window.windowTitle().contains("balanced*"));
  renderer->refused = RequestKind::Settings;
  session.presets().setPreset("fsr2");
  settle();
  EXPECT_EQ(session.presets().presetId(), "balanced") << "the name goes back with the values";
  type("rectify.method=none");
  EXPECT_EQ(renderer->status.settings.rectify.method, RectifyMethod::None) << "the next one is taken";
}

TEST_F(Refusals, OnlyTheRefusedValueIsDroppedAndNotANewerOne) {
  holdBack();
  session.scene().setHidden("floor", true);
  const RequestId first = renderer->requests;
  session.scene().setHidden("rotor & hub", true);
  session.scene().setMotionMode("floor", MotionMode::None);
  fail("no such object", RequestKind::Objects, first);
  EXPECT_EQ(session.scene().objectFilter().hidden, (std::vector<std::string>{"floor", "rotor & hub"}));
  fail("no such object", RequestKind::Objects, first + 1);
  EXPECT_TRUE(session.scene().objectFilter().hidden.empty()) << "that one was";
  EXPECT_EQ(session.scene().motionModes().size(), 1u);
}

// A slider that goes there and back while a frame takes long.
TEST_F(Refusals, AnOlderAnswerOfTheSameValueIsNotTakenForTheNewerOne) {
  const QString path = QStringLiteral("weight.minimum");
  holdBack();
  session.presets().setParameter(path, 0.25);
  const Status first = renderer->status;
  session.presets().setParameter(path, 0.5);
  const Status second = renderer->status;
  session.presets().setParameter(path, 0.25);
  for (const Status& older : {first, second}) {
    renderer->tell(older);
    settle();
    EXPECT_EQ(session.presets().settings().weight.minimum, 0.25f);
  }
  goOn();
  EXPECT_EQ(session.presets().settings(), renderer->status.settings);
}

TEST_F(Refusals, AnObjectThatIsHiddenAndShownAgainStaysShown) {
  session.scene().setHidden("floor", true);
  settle();
  holdBack();
  session.scene().setHidden("floor", false);
  const Status shown = renderer->status;
  session.scene().setHidden("floor", true);
  const Status hidden = renderer->status;
  session.scene().setHidden("floor", false);
  for (const Status& older : {shown, hidden}) {
    renderer->tell(older);
    settle();
    EXPECT_TRUE(session.scene().objectFilter().hidden.empty());
  }
  goOn();
  EXPECT_TRUE(session.scene().objectFilter().hidden.empty());
}

TEST_F(Refusals, AMissingFileLeavesWhatWasAskedOfTheSceneThatIsOpen) {
  holdBack();
  session.scene().setMotionMode("floor", MotionMode::None);
  session.scene().setHidden("floor", true);
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile("/nowhere/missing.glb")});
  QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window, &enter);
  QDropEvent event({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window, &event);
  settle();
  EXPECT_TRUE(window.messages()->text().contains("missing.glb"));
  renderer->tell(before);
  settle();
  EXPECT_EQ(session.scene().motionModes().size(), 1u);
  EXPECT_EQ(session.scene().objectFilter().hidden, std::vector<std::string>{"floor"});
  goOn();
  EXPECT_EQ(session.scene().motionModes().size(), 1u);
  session.open("builtin:fence");
  settle();
  EXPECT_TRUE(session.scene().motionModes().empty()) << "another scene has none of it";
  EXPECT_TRUE(session.scene().objectFilter().hidden.empty());
}

TEST_F(Refusals, ASessionWhoseSceneCannotBeReadLeavesEverythingAsItWas) {
  session.presets().setPreset("fsr2");
  session.post(request::SetSize{96, 54});
  session.seek(7);
  settle();
  SessionFile other = session.file();
  other.source = "/nowhere/broken.glb"; // as the render thread finds out
  other.settings = {"minimal", {}, {}};
  other.size = {32, 18};
  other.frame = 30;
  session.restore(other);
  settle();
  EXPECT_EQ(session.presets().presetId(), "fsr2");
  EXPECT_EQ(renderer->status.settings, session.presets().settings());
  EXPECT_EQ(renderer->status.width, 96);
  EXPECT_EQ(renderer->status.info.frame, 7);
  EXPECT_EQ(renderer->status.source, "builtin:fan");
}

TEST_F(Refusals, ASceneBeyondTheBudgetIsOpenedAnywayWhereThatIsAsked) {
  const auto anyway = [this] {
    for (auto* button : window.messages()->findChildren<QPushButton*>())
      if (button->text() == "Open anyway" && !button->isHidden()) return button;
    return static_cast<QPushButton*>(nullptr);
  };
  session.open("/no/such/file.glb");
  settle();
  EXPECT_FALSE(anyway()) << "no budget helps";
  session.open(taa::app::test::kFakeLarge);
  settle();
  EXPECT_TRUE(window.messages()->text().contains("too many triangles"));
  EXPECT_EQ(renderer->status.source, before.source) << "what was open still is";
  ASSERT_TRUE(anyway());
  QTest::mouseClick(anyway(), Qt::LeftButton);
  settle();
  EXPECT_EQ(renderer->status.source, taa::app::test::kFakeLarge);
  EXPECT_EQ(window.messages()->text(), "");
  EXPECT_FALSE(anyway());
  EXPECT_LT(renderer->last<request::SetSceneBudget>().budget.triangles, taa::app::test::kTrianglesOfLarge)
      << "for this source alone";
  session.choose({"", 100});
  settle();
  EXPECT_EQ(renderer->status.frameCount, 100) << "it opens again";
}
