// The --screenshot command, and the window on the real renderer.
#include "app/models/ProbeModel.h"
#include "app/models/ProbeWords.h"
#include "app/panels/MessagesBar.h"
#include "app/panels/ProbePanel.h"
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"
#include "core/gl/ContextLock.h"
#include "tests/app/WindowFixture.h"
#include "tests/support/Paths.h"

#include <QImage>
#include <QProcess>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>
#include <utility>

using namespace taa;
using namespace taa::app;
namespace fs = std::filesystem;

namespace {

struct Outcome {
  int code = -1;
  QString err;
};

Outcome run(const QStringList& arguments) {
  QProcess process;
  process.start(QString::fromStdString(taa::test::binary("taa-inspector").string()), arguments);
  if (!process.waitForFinished(280000)) process.kill();
  return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
          process.readAllStandardError()};
}

QString fileName(const char* name) {
  return QString::fromStdString((taa::test::temporaryFolder() / name).string());
}

} // namespace

TEST(Screenshot, WritesAPictureOfTheWholeWindow) {
  const QString file = fileName("window.png");
  const Outcome outcome = run(
      {"--screenshot", file, "--window-size", "1280x800", "--size", "160x90", "--frame", "5", "builtin:fan"});
  ASSERT_EQ(outcome.code, 0) << outcome.err.toStdString();
  EXPECT_EQ(outcome.err, "");
  const QImage image(file);
  ASSERT_EQ(image.size(), QSize(1280, 800));
  // A blank window, or one without pictures, has a handful of grays.
  std::set<QRgb> colors;
  for (int y = 0; y < image.height(); y += 4)
    for (int x = 0; x < image.width(); x += 4) colors.insert(image.pixel(x, y));
  EXPECT_GT(colors.size(), 1000u);
}

TEST(Screenshot, WhatTheCallAsksForAndIsNotThereIsItsFault) {
  const QString file = fileName("refused.png");
  for (const auto& [option, value] : {std::pair{"--camera", "nope"},
                                      {"--hide", "nope"},
                                      {"--isolate", "nope"},
                                      {"--animation", "nope"},
                                      {"--preset", "nope"},
                                      {"--figure", "nope"}}) {
    const Outcome outcome = run({"--screenshot", file, "--size", "64x36", option, value, "builtin:fan"});
    EXPECT_EQ(outcome.code, 2) << option << outcome.err.toStdString();
    EXPECT_EQ(outcome.err.count(QLatin1Char('\n')), 1) << outcome.err.toStdString();
    EXPECT_TRUE(outcome.err.startsWith(QLatin1String("taa-inspector: "))) << outcome.err.toStdString();
  }
  EXPECT_EQ(run({"--screenshot", file, "builtin:nope"}).code, 2);
  EXPECT_EQ(run({"--screenshot", file, fileName("nope.gltf")}).code, 1);
  EXPECT_FALSE(fs::exists(file.toStdString()));
}

TEST(Screenshot, ADialogLiesInItsMiddle) {
  const QString plain = fileName("plain.png"), file = fileName("dialog.png");
  const QStringList options = {"--window-size", "1280x800", "--size", "160x90", "--frame", "5"};
  ASSERT_EQ(run(QStringList{"--screenshot", plain} + options).code, 0);
  ASSERT_EQ(run(QStringList{"--screenshot", file, "--dialog", "keys"} + options).code, 0);
  const QImage without(plain), with(file);
  ASSERT_EQ(without.size(), with.size());
  const QRect middle(540, 300, 200, 200);
  EXPECT_NE(without.copy(middle), with.copy(middle));
  EXPECT_EQ(run({"--screenshot", file, "--dialog", "nothing"}).code, 2);
}

TEST(Screenshot, ReplacesAFileOnlyWithForce) {
  const QString file = fileName("mine.png");
  const QByteArray mine("mine");
  QFile kept(file);
  ASSERT_TRUE(kept.open(QIODevice::WriteOnly) && kept.write(mine) == mine.size());
  kept.close();
  const Outcome outcome = run({"--screenshot", file});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_TRUE(outcome.err.contains(file) && outcome.err.contains("--force")) << outcome.err.toStdString();
  ASSERT_TRUE(kept.open(QIODevice::ReadOnly));
  EXPECT_EQ(kept.readAll(), mine);
  kept.close();
  const Outcome forced = run({"--force", "--screenshot", file, "--size", "64x36", "--frame", "0"});
  EXPECT_EQ(forced.code, 0) << forced.err.toStdString();
  EXPECT_FALSE(QImage(file).isNull());
}

// The scene that is not there would be told of later.
TEST(Screenshot, AFolderThatIsNotThereIsToldBeforeAnythingIsDrawn) {
  const Outcome outcome = run({"--screenshot", "/nowhere/at/all.png", "/nowhere/none.glb"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(outcome.err.toStdString(),
            "taa-inspector: cannot write /nowhere/at/all.png: there is no folder /nowhere/at\n");
}

TEST(Screenshot, AFileThatCannotBeOpenedIsNamed) {
  const Outcome outcome = run({"--screenshot", fileName("none.png"), "/nowhere/none.glb"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_TRUE(outcome.err.contains("/nowhere/none.glb")) << outcome.err.toStdString();
}

// Of shaders that draw what is looked at, and of those that make the frame.
TEST(Screenshot, AShaderThatDoesNotCompileIsNamedAndNotWaitedFor) {
  const fs::path shaders = taa::test::temporaryFolder() / "shaders";
  for (const char* file : {"inspect/visualize.frag", "taa/resolve.frag"}) {
    fs::remove_all(shaders);
    fs::copy(fs::path(TAA_SOURCE_DIR) / "shaders", shaders, fs::copy_options::recursive);
    std::ofstream(shaders / file, std::ios::app) << "this does not compile\n";
    const Outcome outcome = run({"--screenshot", fileName("none.png"), "--shaders",
                                 QString::fromStdString(shaders.string()), "--size", "64x36"});
    EXPECT_EQ(outcome.code, 1) << file;
    EXPECT_TRUE(outcome.err.contains(file)) << outcome.err.toStdString();
    EXPECT_FALSE(outcome.err.contains("did not get ready")) << outcome.err.toStdString();
  }
}

TEST(Screenshot, AShaderThatIncludesItselfIsReadOnce) {
  const fs::path shaders = taa::test::temporaryFolder() / "circle";
  fs::copy(fs::path(TAA_SOURCE_DIR) / "shaders", shaders, fs::copy_options::recursive);
  std::ofstream(shaders / "taa/inputs.glsl", std::ios::app) << "#include \"taa/inputs.glsl\"\n";
  const QString file = fileName("circle.png");
  const Outcome outcome =
      run({"--screenshot", file, "--shaders", QString::fromStdString(shaders.string()), "--size", "64x36"});
  EXPECT_EQ(outcome.code, 0) << outcome.err.toStdString();
  EXPECT_FALSE(QImage(file).isNull());
}

TEST(Screenshot, WrongUsageEndsWithTwo) {
  EXPECT_EQ(run({"--size", "huge"}).code, 2);
  EXPECT_EQ(run({"--view", "nothing"}).code, 2);
  EXPECT_EQ(run({"--no-such-option"}).code, 2);
  EXPECT_EQ(run({"--help"}).code, 0);
}

TEST(RealWindow, ProbesWhatTheInspectorProbes) {
  applyTheme(*qApp, ThemeChoice::Dark);
  Session session;
  app::test::TestWindow window(session, nullptr);
  window.resize(1280, 800);
  window.show();
  session.post(request::SetSize{96, 54});
  session.open("builtin:fan", false);
  session.seek(6);
  const glm::ivec2 pixel(60, 20);
  ASSERT_TRUE(taa::app::test::waitFor([&] {
    return session.isOpen() && session.status().info.frame == 6 && session.status().exact;
  })) << window.messages()->text().toStdString();
  Viewport* viewport = window.views()->view(0)->viewport();
  const glm::dvec2 place = screenFromPicture(viewport->transform(), glm::dvec2(pixel) + 0.5);
  QTest::mouseClick(viewport, Qt::RightButton, {},
                    QPoint(static_cast<int>(place.x), static_cast<int>(place.y)));
  ASSERT_TRUE(taa::app::test::waitFor([&] {
    return session.probes().result() && session.probes().result()->frame == 6 &&
           session.probes().result()->x == 60;
  }));

  const gl::ContextLock lock; // the window judges the pixel meanwhile
  Inspector inspector;
  inspector.shot().open("builtin:fan");
  inspector.shot().setSize(96, 54);
  inspector.shot().seek(6);
  const PixelRecord record = inspector.probes().probe(pixel.x, pixel.y);
  const ProbeResult& shown = *session.probes().result();
  ASSERT_EQ(shown.around.size(), 9u);
  for (const IntermediateId id : allRows()) {
    const glm::vec4 inWindow = twin::at(shown.around[4], id), inCore = twin::at(record, id);
    EXPECT_EQ(0, std::memcmp(&inWindow, &inCore, sizeof(inCore))) << intermediate(id).name;
    const QString value = window.probe()->valueText(id);
    EXPECT_EQ(value, rowText(intermediate(id), twin::at(record, id))) << intermediate(id).name;
  }
}

TEST(RealWindow, StepsBackToTheSamePicture) {
  applyTheme(*qApp, ThemeChoice::Dark);
  Session session;
  app::test::TestWindow window(session, nullptr);
  window.resize(1280, 800);
  window.show();
  session.post(request::SetSize{96, 54});
  session.open("builtin:fan", false);
  const auto pictureOf = [&](int frame) {
    EXPECT_TRUE(taa::app::test::waitFor([&] {
      const ViewResult* result = session.picture(0).get();
      return session.isOpen() && result && result->frame == frame && result->exact &&
             result->request == window.views()->requests()[0];
    })) << frame;
    return session.picture(0)->picture.rgba;
  };
  session.seek(4);
  const auto before = pictureOf(4);
  session.post(request::Step{1});
  EXPECT_NE(pictureOf(5), before);
  session.post(request::Step{-1});
  EXPECT_EQ(pictureOf(4), before);
}
