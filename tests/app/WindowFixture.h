// A window on a fake or a real renderer, and ways to wait for it.
#pragma once

#include "app/window/MainWindow.h"
#include "tests/app/FakeRenderer.h"

#include <QJsonObject>
#include <QString>
#include <QTest>
#include <gtest/gtest.h>

namespace taa::app::test {

/// Lets events run until `condition` holds; false after `limit` ms.
template <class Condition>
bool waitFor(Condition condition, int limit = 120000) {
  return QTest::qWaitFor([&] { return condition(); }, limit);
}

/// Of a window's state: less what Qt writes of its panels, which has sizes of hidden ones in it.
inline QJsonObject withoutPlaces(QJsonObject window) {
  const QString docks = QStringLiteral("docks");
  QJsonObject rest = window.value(docks).toObject();
  EXPECT_FALSE(rest.take(QStringLiteral("places")).toString().isEmpty());
  window[docks] = rest;
  return window;
}

/// The window with its parts as tests reach them: by what they are, among its children.
class TestWindow : public MainWindow {
 public:
  using MainWindow::MainWindow;

  ViewArea* views() const;
  Workspace* workspace() const;
  LeftArea* left() const;
  PipelinePanel* pipeline() const;
  ScenePanel* scene() const;
  ProbePanel* probe() const;
  LowerArea* lower() const;
  ProfilerPanel* profiler() const;
  PlotsPanel* plots() const;
  JitterPanel* jitter() const;
  WeightsPanel* weights() const;
  LineagePanel* lineage() const;
  DoctorPanel* doctor() const;
  TimelinePanel* timeline() const;
  MessagesBar* messages() const;
  StatusLine* statusLine() const;
  FlightBar* flightBar() const;
  SessionKeeper* keeper() const;
  Exports* exports() const;
  Flight* flight() const;
  OwnPresets* presets() const;
  ProbeCommands* probeCommands() const;
  DoctorCommands* doctorCommands() const;
  GoToPrompts* prompts() const;
  ViewChoices* choices() const;
  CommandLists* lists() const;

  void openSource(const QString& source);
  /// In the active view.
  void showIntermediate(IntermediateId id);
  /// What a session file keeps of the window.
  QJsonObject state() const;
};

/// The window on a synthetic renderer with "builtin:fan" of 64×36 pixels open.
class FakeWindow : public testing::Test {
 protected:
  FakeWindow();
  ~FakeWindow() override;
  void SetUp() override;

  /// Lets all results arrive.
  void settle() { QTest::qWait(30); }
  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::keyClick(&window, key, modifiers);
    settle();
  }

  FakeRenderer* renderer = nullptr; ///< owned by the session
  Session session;
  TestWindow window;
};

} // namespace taa::app::test
