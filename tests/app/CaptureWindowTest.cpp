// A capture in the window: opened by drag and drop, and what it fixes is disabled with its reason.
#include "tests/app/WindowFixture.h"

#include "app/panels/JitterPanel.h"
#include "app/panels/PipelinePanel.h"
#include "app/views/ViewArea.h"
#include "app/views/ViewPanel.h"
#include "app/widgets/parameters/ParameterRow.h"

#include <QAction>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMenu>
#include <QMimeData>
#include <QUrl>

#include <algorithm>
#include <string>

namespace taa::app::test {
namespace {

class CaptureWindowTest : public FakeWindow {
 protected:
  static constexpr const char* kFolder = "/somewhere/captured";

  void dropCapture() {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(kFolder)});
    QDragEnterEvent enter({300, 300}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &enter);
    ASSERT_TRUE(enter.isAccepted());
    QDropEvent drop({300, 300}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window, &drop);
    settle();
  }

  QAction* action(const QString& text) const {
    for (QAction* each : window.findChildren<QAction*>())
      if (each->text() == text) return each;
    ADD_FAILURE() << "there is no command " << text.toStdString();
    return nullptr;
  }

  ParameterRow* parameterRow(const QString& path) const {
    const auto& rows = window.pipeline()->parameterRows();
    return *std::ranges::find_if(rows, [&](const ParameterRow* row) { return row->path() == path; });
  }
};

TEST_F(CaptureWindowTest, AFolderIsOpenedWhereItIsDropped) {
  dropCapture();
  EXPECT_EQ(session.status().source, kFolder);
  EXPECT_NE(session.status().capture, nullptr);
}

TEST_F(CaptureWindowTest, WhatItFixesIsDisabledAndSaysWhy) {
  const QStringList fixed{"&Fly the camera",          "&Record a flight",  "&Back to the scene's camera",
                          "Open a recorded &camera…", "Show &all objects", "Follow the &surface"};
  dropCapture();
  for (const QString& text : fixed) {
    EXPECT_FALSE(action(text)->isEnabled()) << text.toStdString();
    EXPECT_TRUE(action(text)->toolTip().contains("capture")) << action(text)->toolTip().toStdString();
  }
  for (const QMenu* menu : window.findChildren<QMenu*>())
    for (const QAction* size : menu->title() == "Render si&ze" ? menu->actions() : QList<QAction*>())
      EXPECT_TRUE(!size->isEnabled() && size->toolTip().contains("capture")) << size->text().toStdString();
  for (const QString path : {"jitter.sequence", "jitter.period", "inputs.renderScale", "inputs.mipBias"}) {
    EXPECT_FALSE(parameterRow(path)->isEnabled()) << path.toStdString();
    EXPECT_TRUE(parameterRow(path)->editor()->toolTip().contains("capture")) << path.toStdString();
  }
  EXPECT_TRUE(parameterRow("inputs.precision")->isEnabled());
  EXPECT_TRUE(parameterRow("rectify.method")->isEnabled());

  window.openSource("builtin:fan");
  settle();
  EXPECT_TRUE(action("&Fly the camera")->isEnabled());
  EXPECT_FALSE(action("&Fly the camera")->toolTip().contains("capture"));
  EXPECT_TRUE(parameterRow("jitter.sequence")->isEnabled());
}

TEST_F(CaptureWindowTest, OursIsShownBesideTheEngines) {
  QAction* beside = action("&Ours beside the engine's");
  EXPECT_FALSE(beside->isEnabled()) << "a scene has no engine";
  dropCapture();
  ASSERT_TRUE(beside->isEnabled());
  beside->trigger();
  settle();
  EXPECT_EQ(window.views()->viewCount(), 2);
  EXPECT_EQ(window.views()->view(0)->id(), IntermediateId::resolved);
  EXPECT_EQ(window.views()->view(1)->id(), IntermediateId::engineOutput);
}

} // namespace
} // namespace taa::app::test
