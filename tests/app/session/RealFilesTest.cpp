// Sessions, command lines and shaders on the real renderer: the same pictures, byte for byte.
#include "app/commands/Exports.h"
#include "app/panels/MessagesBar.h"
#include "app/session/ShaderWatch.h"
#include "app/session/keeping/SessionKeeper.h"
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"
#include "core/base/Files.h"
#include "core/settings/Parameters.h"
#include "tests/app/WindowFixture.h"
#include "tests/support/Paths.h"
#include "tests/support/Process.h"
#include "tests/support/ShaderFolder.h"

#include <QApplication>
#include <QClipboard>
#include <QColorSpace>
#include <QTemporaryDir>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

using namespace taa;
using namespace taa::app;

namespace {

/// A window on the real renderer, with a small picture of the fan at frame 6.
class RealFiles : public testing::Test {
 protected:
  void open() {
    applyTheme(*qApp, ThemeChoice::Dark);
    session = std::make_unique<Session>();
    window = std::make_unique<app::test::TestWindow>(*session, nullptr);
    window->resize(1280, 800);
    window->show();
    // A note takes room from the views: one that went while a test runs would change the size of their
    // pictures.
    window->messages()->setNoteTime(std::chrono::hours(1));
    session->post(request::SetSize{96, 54});
    session->open("builtin:fan", false);
    session->seek(6);
    settled(6);
  }
  /// The picture of view A once all that was asked for is there.
  std::vector<std::uint8_t> settled(int frame) {
    EXPECT_TRUE(taa::app::test::waitFor([&] {
      const ViewResult* result = session->picture(0).get();
      const Status& status = session->status();
      return session->isOpen() && result && result->frame == frame && result->exact && status.exact &&
             status.settings == session->presets().settings() && session->work().what.empty() &&
             result->request == window->views()->requests()[0] &&
             (!result->request.other || (result->other && result->other->exact));
    })) << window->messages()->text().toStdString();
    QTest::qWait(100); // what was under way may still bring another one
    const ViewResult* result = session->picture(0).get();
    return result ? result->picture.rgba : std::vector<std::uint8_t>();
  }
  void TearDown() override {
    window.reset();
    session.reset();
  }
  void runCommandLine() { run(window->exports()->commandLine().toStdString()); }
  void run(std::string line) {
    const std::string program = "taa-batch ";
    ASSERT_EQ(line.find(program), 0u);
    line = "cd '" + folder.path().toStdString() + "' && " + taa::test::binary("taa-batch").string() + " " +
           line.substr(program.size()) + " --force"; // the same file is written more than once
    const taa::test::ProcessResult result = taa::test::runProcess({"/bin/sh", "-c", line});
    ASSERT_EQ(result.exitCode, 0) << line << "\n" << result.err;
  }
  /// The bytes of a PNG, whatever it says of their color space.
  static QImage pixels(const QString& file) {
    QImage image = QImage(file).convertToFormat(QImage::Format_RGBA8888);
    image.setColorSpace({});
    return image;
  }
  /// One frame of a range, as the dialog asks for it.
  QImage exported(const ViewPanel& view, PictureExtent extent) {
    SequenceRequest request;
    request.target = path("range.png").toStdString();
    request.first = request.last = 6;
    request.picture = view.pictureRequest(window->views()->comparedPresets(), extent);
    const QString file = path("range.0006.png");
    QFile::remove(file);
    window->exports()->writeRange(request);
    EXPECT_TRUE(taa::app::test::waitFor([&] { return QFile::exists(file); }))
        << window->messages()->text().toStdString();
    settled(6);
    return pixels(file);
  }
  /// The screen is the picture for a file, but for what covers it and where nothing is.
  void expectShown(const ViewPanel& view, const std::string& what) {
    const QImage screen = view.viewport()->grab().toImage().convertToFormat(QImage::Format_RGBA8888);
    const QImage plain = view.viewport()->picture(false), more = view.viewport()->picture(true);
    const QRect part = view.viewport()->pictureRect();
    ASSERT_EQ(plain.size(), part.size()) << what;
    const int strips = more.height() - plain.height(), line = view.viewport()->dividerColumn() - part.x();
    const QImage seen = screen.copy(part);
    constexpr int kLabel = 32, kHandle = 14;
    int compared = 0;
    for (int y = 0; y < std::min(part.height(), screen.height() - strips - part.y()); ++y)
      for (int x = 0; x < part.width(); ++x) {
        if (qAlpha(plain.pixel(x, y)) != 255) continue;
        if (y < kLabel || std::abs(x - line) < kHandle) continue;
        ASSERT_EQ(more.pixel(x, y), seen.pixel(x, y)) << what << " with legend " << x << ", " << y;
        ASSERT_EQ(plain.pixel(x, y), seen.pixel(x, y)) << what << " " << x << ", " << y;
        ++compared;
      }
    EXPECT_GT(compared, 10000) << what;
  }
  QString path(const char* name) const { return folder.filePath(QString::fromLatin1(name)); }

  QTemporaryDir folder;
  std::unique_ptr<Session> session;
  std::unique_ptr<app::test::TestWindow> window;
};

TEST_F(RealFiles, AReopenedSessionShowsTheSamePicture) {
  open();
  session->presets().setPreset("sharp");
  session->presets().setParameter("weight.minimum", 0.3);
  session->scene().setCamera("orbit");
  session->scene().setMotionMode("rotor", MotionMode::None);
  session->post(request::SetSize{120, 68});
  session->seek(9);
  settled(9);
  window->keeper()->saveTo(path("it.taa.json"));
  const auto before = settled(9);
  session->presets().setPreset("minimal");
  session->post(request::SetSize{64, 36});
  session->open("builtin:thin", false);
  session->seek(2);
  EXPECT_NE(settled(2), before);
  window->openSource(path("it.taa.json"));
  ASSERT_TRUE(taa::app::test::waitFor([&] {
    return session->status().source == "builtin:fan" && session->status().width == 120 &&
           session->status().camera == "orbit";
  }));
  EXPECT_EQ(settled(9), before);
  EXPECT_EQ(window->messages()->text().toStdString(), "Saved it.taa.json.");
}

TEST_F(RealFiles, TheCommandLineDrawsWhatIsExported) {
  open();
  session->presets().setPreset("fsr2");
  session->presets().setParameter("weight.minimum", 0.3);
  window->views()->active()->setIntermediate(IntermediateId::alpha);
  window->views()->active()->changeExposure(1.0f);
  window->views()->active()->nextColorMap();
  settled(6);
  SequenceRequest request;
  request.target = path("shot.png").toStdString();
  request.first = request.last = 6;
  request.picture.id = window->views()->active()->id();
  request.picture.style = window->views()->active()->style();
  request.picture.width = 96;
  request.picture.height = 54;
  window->exports()->writeRange(request);
  ASSERT_TRUE(taa::app::test::waitFor([&] { return QFile::exists(path("shot.0006.png")); }));
  runCommandLine();
  EXPECT_EQ(readFile(path("frame.0006.alpha.png").toStdString()),
            readFile(path("shot.0006.png").toStdString()));
}

TEST_F(RealFiles, TheCopiedLineOfARecordedPathDrawsTheSameByItself) {
  open();
  CameraTrack track{"Recorded 1", 2, {}};
  for (int pose = 0; pose < 6; ++pose)
    track.poses.push_back({{0.2f * static_cast<float>(pose), 1.0f, 4.0f}, 3.0f * static_cast<float>(pose)});
  session->scene().addCameraTrack(track);
  ASSERT_TRUE(taa::app::test::waitFor([&] { return session->status().camera == "Recorded 1"; }));
  window->views()->active()->setIntermediate(IntermediateId::resolved);
  settled(6);
  SequenceRequest request;
  request.target = path("shot.png").toStdString();
  request.first = request.last = 6;
  request.picture.style = window->views()->active()->style();
  request.picture.width = 96;
  request.picture.height = 54;
  window->exports()->writeRange(request);
  ASSERT_TRUE(taa::app::test::waitFor([&] { return QFile::exists(path("shot.0006.png")); }));
  window->exports()->copyCommandLine();
  const std::string line = QApplication::clipboard()->text().toStdString();
  EXPECT_NE(line.find("--camera-path " + window->keeper()->cameraFolder().toStdString()), line.npos) << line;
  session->scene().removeCamera("Recorded 1"); // the line does not need it
  run(line);
  EXPECT_EQ(readFile(path("frame.0006.resolved.png").toStdString()),
            readFile(path("shot.0006.png").toStdString()));
}

// The screen, the PNG of the view, the range of frames and the copied command line are one picture.
TEST_F(RealFiles, AComparingViewIsWrittenAsItIsShown) {
  open();
  session->probes().removeAll();
  window->messages()->showNote("a message takes room from the views");
  ViewPanel* view = window->views()->view(0);
  view->setComparison({OtherKind::Preset, {}, "minimal"});
  view->viewport()->setDivider(0.3);
  view->setOverlay(Overlay::Outlines, true);
  std::vector<std::string> seen;
  for (const Showing showing : {Showing::Wipe, Showing::Other, Showing::Difference}) {
    view->setShowing(showing);
    settled(6);
    const std::string name(showingName(showing));
    expectShown(*view, name);
    const QString file = path((name + ".png").c_str());
    window->exports()->writeView(file, false);
    ASSERT_TRUE(taa::app::test::waitFor([&] { return QFile::exists(file); }));
    const QImage written = pixels(file);
    EXPECT_EQ(written, view->viewport()->picture(false)) << name;
    EXPECT_EQ(exported(*view, PictureExtent::Viewport), written) << name;
    const QImage whole = exported(*view, PictureExtent::Whole);
    runCommandLine();
    EXPECT_EQ(pixels(path("frame.0006.resolved.png")), whole) << name;
    seen.push_back(readFile(path("frame.0006.resolved.png").toStdString()));
  }
  EXPECT_NE(seen[0], seen[1]);
  EXPECT_NE(seen[1], seen[2]);
}

TEST_F(RealFiles, AnEditedShaderShowsAndABrokenOneIsNamed) {
  const taa::test::ShaderFolder shaders;
  open();
  const glm::ivec2 pixel(20, 10);
  session->probes().setPixel(pixel);
  // Of a few pixels: messages take room from the views, so that pictures differ in size.
  const auto values = [&] {
    settled(6);
    EXPECT_TRUE(taa::app::test::waitFor([&] {
      const auto& probe = session->probes().result();
      return probe && glm::ivec2(probe->x, probe->y) == pixel && probe->frame == 6 && probe->exact;
    }));
    std::vector<glm::vec4> resolved;
    for (const PixelRecord& record : session->probes().result()->around)
      resolved.push_back(twin::at(record, IntermediateId::resolved));
    return resolved;
  };
  const auto before = values();
  const std::string line = "  o_color = vec4(blended.color, 1.0);";
  shaders.replace("taa/resolve.frag", line, "  o_color = vec4(blended.color.bgr, 1.0);");
  ASSERT_TRUE(taa::app::test::waitFor([&] { return window->messages()->text().contains("read anew"); }));
  const auto edited = values();
  EXPECT_NE(edited, before);
  shaders.replace("taa/resolve.frag", "blended.color.bgr", "blended.colour");
  ASSERT_TRUE(
      taa::app::test::waitFor([&] { return window->messages()->text().contains("taa/resolve.frag:"); }));
  const std::string text = shaders.read("taa/resolve.frag");
  const auto number =
      1 + std::count(text.begin(), text.begin() + static_cast<long>(text.find("blended.colour")), '\n');
  EXPECT_TRUE(window->messages()->text().contains(QStringLiteral("taa/resolve.frag:%1:").arg(number)))
      << window->messages()->text().toStdString();
  session->post(request::Step{1}); // the last good one goes on
  settled(7);
  session->post(request::Step{-1});
  EXPECT_EQ(values(), edited);
  shaders.replace("taa/resolve.frag", "blended.colour", "blended.color");
  ASSERT_TRUE(taa::app::test::waitFor([&] { return window->messages()->text().contains("compile again"); }));
  EXPECT_FALSE(window->messages()->text().contains("taa/resolve.frag:"));
  EXPECT_EQ(values(), before);
}

} // namespace
