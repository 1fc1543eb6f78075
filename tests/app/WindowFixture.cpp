#include "tests/app/WindowFixture.h"

#include "app/commands/DoctorCommands.h"
#include "app/commands/Exports.h"
#include "app/commands/Flight.h"
#include "app/commands/GoToPrompts.h"
#include "app/commands/OwnPresets.h"
#include "app/commands/ProbeCommands.h"
#include "app/commands/ViewChoices.h"
#include "app/docks/Workspace.h"
#include "app/doctor/DoctorPanel.h"
#include "app/menus/CommandLists.h"
#include "app/panels/JitterPanel.h"
#include "app/panels/LeftArea.h"
#include "app/panels/LineagePanel.h"
#include "app/panels/LowerArea.h"
#include "app/panels/MessagesBar.h"
#include "app/panels/PipelinePanel.h"
#include "app/panels/PlotsPanel.h"
#include "app/panels/ProbePanel.h"
#include "app/panels/ProfilerPanel.h"
#include "app/panels/ScenePanel.h"
#include "app/panels/StatusLine.h"
#include "app/panels/TimelinePanel.h"
#include "app/panels/WeightsPanel.h"
#include "app/session/keeping/SessionKeeper.h"
#include "app/views/ViewArea.h"
#include "app/widgets/bars/FlightBar.h"

#include <QAbstractItemModelTester>
#include <QApplication>
#include <QJsonDocument>
#include <QTreeView>

#include <memory>
#include <utility>

namespace taa::app::test {

ViewArea* TestWindow::views() const {
  return findChild<ViewArea*>();
}

Workspace* TestWindow::workspace() const {
  return findChild<Workspace*>();
}

LeftArea* TestWindow::left() const {
  return findChild<LeftArea*>();
}

PipelinePanel* TestWindow::pipeline() const {
  return findChild<PipelinePanel*>();
}

ScenePanel* TestWindow::scene() const {
  return findChild<ScenePanel*>();
}

ProbePanel* TestWindow::probe() const {
  return findChild<ProbePanel*>();
}

LowerArea* TestWindow::lower() const {
  return findChild<LowerArea*>();
}

ProfilerPanel* TestWindow::profiler() const {
  return findChild<ProfilerPanel*>();
}

PlotsPanel* TestWindow::plots() const {
  return findChild<PlotsPanel*>();
}

JitterPanel* TestWindow::jitter() const {
  return findChild<JitterPanel*>();
}

WeightsPanel* TestWindow::weights() const {
  return findChild<WeightsPanel*>();
}

LineagePanel* TestWindow::lineage() const {
  return findChild<LineagePanel*>();
}

DoctorPanel* TestWindow::doctor() const {
  return findChild<DoctorPanel*>();
}

TimelinePanel* TestWindow::timeline() const {
  return findChild<TimelinePanel*>();
}

MessagesBar* TestWindow::messages() const {
  return findChild<MessagesBar*>();
}

StatusLine* TestWindow::statusLine() const {
  return findChild<StatusLine*>();
}

FlightBar* TestWindow::flightBar() const {
  return findChild<FlightBar*>();
}

SessionKeeper* TestWindow::keeper() const {
  return findChild<SessionKeeper*>();
}

Exports* TestWindow::exports() const {
  return findChild<Exports*>();
}

Flight* TestWindow::flight() const {
  return findChild<Flight*>();
}

OwnPresets* TestWindow::presets() const {
  return findChild<OwnPresets*>();
}

ProbeCommands* TestWindow::probeCommands() const {
  return findChild<ProbeCommands*>();
}

DoctorCommands* TestWindow::doctorCommands() const {
  return findChild<DoctorCommands*>();
}

GoToPrompts* TestWindow::prompts() const {
  return findChild<GoToPrompts*>();
}

ViewChoices* TestWindow::choices() const {
  return findChild<ViewChoices*>();
}

CommandLists* TestWindow::lists() const {
  return findChild<CommandLists*>();
}

void TestWindow::openSource(const QString& source) {
  keeper()->openSource(source);
}

void TestWindow::showIntermediate(IntermediateId id) {
  views()->active()->setIntermediate(id);
}

QJsonObject TestWindow::state() const {
  return QJsonDocument::fromJson(QByteArray::fromStdString(keeper()->file().window)).object();
}

FakeWindow::FakeWindow()
    : session([this](Listener listener) {
        auto made = std::make_unique<FakeRenderer>(std::move(listener));
        renderer = made.get();
        return made;
      }),
      window(session, nullptr) {}

FakeWindow::~FakeWindow() = default;

void FakeWindow::SetUp() {
  applyTheme(*qApp, ThemeChoice::Dark);
  window.resize(1280, 800);
  window.show();
  window.openSource("builtin:fan");
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  ASSERT_TRUE(waitFor([&] { return session.isOpen() && session.status().playing; }));
  session.post(request::SetPlaying{false});
  for (QAbstractItemModel* model : {window.scene()->tree()->model(), window.probe()->table()->model()})
    new QAbstractItemModelTester(model, QAbstractItemModelTester::FailureReportingMode::Fatal, model);
  QTest::mouseMove(&window, {1, 1}); // not where the last test left it
  settle();
}

} // namespace taa::app::test
