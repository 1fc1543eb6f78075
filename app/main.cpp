// Starts taa-inspector: a window, or a picture of one.
#include "app/Arguments.h"
#include "app/session/keeping/EndSignals.h"
#include "app/session/keeping/SessionKeeper.h"
#include "app/style/Icons.h"
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"
#include "app/window/MainWindow.h"

#include "core/base/ExistingFiles.h"
#include "core/base/Files.h"
#include "core/base/ShownText.h"
#include "core/io/SessionFile.h"

#include <QApplication>
#include <QSettings>

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <exception>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>

namespace {

using namespace taa::app;

constexpr int kScreenshotFrame = 40; ///< the history has filled up, and the scene has moved

/// Without a display Qt draws into memory; a picture of the window never needs one.
void choosePlatform(bool screenshot) {
  const bool hasDisplay =
      !qEnvironmentVariableIsEmpty("DISPLAY") || !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY");
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM") && (screenshot || !hasDisplay))
    qputenv("QT_QPA_PLATFORM", "offscreen");
}

/// In a build folder of the source tree the shaders are those of the tree, so that edits show.
void chooseShaders(const Arguments& arguments) {
  if (!arguments.shaders.empty()) {
    qputenv("TAA_SHADER_DIR", QByteArray::fromStdString(arguments.shaders));
  } else if (arguments.screenshot.empty() && qEnvironmentVariableIsEmpty("TAA_SHADER_DIR")) {
    std::error_code error;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
    const auto root = program.parent_path() / "../../.."; // build/PRESET/bin
    if (!std::filesystem::exists(root / "shaders/taa/resolve.frag", error)) return;
    const auto shaders = std::filesystem::canonical(root / "shaders", error);
    qputenv("TAA_SHADER_DIR", QByteArray::fromStdString(shaders.string()));
  }
}

/// The frame of a picture of the window: that of a session, unless another one is asked for.
int screenshotFrame(const Arguments& arguments) {
  if (arguments.frame) return *arguments.frame;
  return taa::isSessionName(arguments.source) ? taa::readSession(arguments.source).frame : kScreenshotFrame;
}

/// Qt's own remarks about platforms without windows are of no use to anybody here.
void printMessage(QtMsgType type, const QMessageLogContext&, const QString& message) {
  if (message.startsWith(QLatin1String("This plugin does not support")) ||
      message.startsWith(QLatin1String("QStandardPaths: XDG_RUNTIME_DIR")))
    return;
  if (type != QtDebugMsg && type != QtInfoMsg) std::fprintf(stderr, "%s\n", qPrintable(message));
}

/// Seconds since the system started this process, the loading of its libraries included.
double secondsSinceStart() {
  std::string fields = taa::readFile("/proc/self/stat");
  fields.erase(0, fields.rfind(')') + 1); // the name may hold spaces
  std::istringstream words(fields);
  std::string skipped;
  for (int field = 3; field < 22; ++field) words >> skipped;
  double startTicks = 0.0; // after the boot
  words >> startTicks;
  timespec now{};
  clock_gettime(CLOCK_BOOTTIME, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9 -
         startTicks / static_cast<double>(sysconf(_SC_CLK_TCK));
}

void sayWhenPictureArrives(Session& session) {
  auto* once = new QObject(&session);
  QObject::connect(&session, &Session::pictureArrived, once, [&session, once] {
    std::fprintf(stderr, "first picture after %.2f s\n", secondsSinceStart());
    session.disconnect(once);
    once->deleteLater();
  });
}

void showViews(ViewArea& views, const Arguments& arguments) {
  const std::size_t wanted = std::max(arguments.views.size(), arguments.comparisons.size());
  if (wanted > 0) views.setViewCount(wanted > 2 ? kViewCount : static_cast<int>(wanted));
  for (std::size_t view = 0; view < arguments.views.size(); ++view)
    views.view(static_cast<int>(view))->setIntermediate(arguments.views[view]);
  for (std::size_t view = 0; view < arguments.comparisons.size(); ++view)
    views.view(static_cast<int>(view))->setComparison(arguments.comparisons[view]);
  for (int view = 0; view < kViewCount; ++view) {
    if (arguments.showing) views.view(view)->setShowing(*arguments.showing);
    for (const Overlay overlay : arguments.overlays) views.view(view)->setOverlay(overlay, true);
  }
}

/// As a first start, or as the arguments say.
void openScene(Session& session, const Arguments& arguments) {
  if (arguments.checkpoints)
    session.post(taa::request::SetCheckpointBudget{static_cast<std::size_t>(*arguments.checkpoints) << 20});
  if (arguments.size) session.post(taa::request::SetSize{arguments.size->x, arguments.size->y});
  session.open(QString::fromStdString(arguments.source), arguments.screenshot.empty() && !arguments.frame,
               arguments.choice);
}

/// Whether the render thread may open the scene while the window is still being built. A preset changes what
/// it draws, and is refused in the window when there is none of this name; a session brings settings of its
/// own.
bool opensBeforeWindow(const Arguments& arguments) {
  return arguments.preset.empty() && arguments.lesson.empty() && !taa::isSessionName(arguments.source) &&
         !arguments.reopens;
}

void begin(MainWindow& window, Session& session, const Arguments& arguments) {
  if (!arguments.preset.empty()) session.presets().setPreset(QString::fromStdString(arguments.preset));
  if (!arguments.lesson.empty()) {
    window.openLesson(arguments.lesson, arguments.lessonStep);
    if (!arguments.screenshot.empty()) session.post(taa::request::SetPlaying{false});
    return;
  }
  showViews(window.views(), arguments);
  if (arguments.pixel) session.probes().setPixel(*arguments.pixel);
  if (arguments.reopens)
    window.keeper().reopen();
  else if (taa::isSessionName(arguments.source))
    window.keeper().openSource(QString::fromStdString(arguments.source));
  else if (!opensBeforeWindow(arguments))
    openScene(session, arguments);
  if (arguments.zoom) {
    const glm::dvec2 center = arguments.pixel ? glm::dvec2(*arguments.pixel) + 0.5 : glm::dvec2(0.0);
    for (int view = 0; view < kViewCount; ++view)
      window.views().view(view)->viewport()->setCamera({false, *arguments.zoom, center});
  }
  window.openPage(arguments.panel);
  if (!arguments.camera.empty()) session.scene().setCamera(QString::fromStdString(arguments.camera));
  if (arguments.track) session.scene().addCameraTrack(*arguments.track);
  if (!(arguments.filter == taa::ObjectFilter{})) session.scene().setObjectFilter(arguments.filter);
}

void endScreenshot(int code, const QString& text) {
  if (!text.isEmpty()) std::fprintf(stderr, "taa-inspector: %s\n", qPrintable(text));
  QApplication::exit(code);
}

/// Closes the window as somebody would: what is open is kept, work that runs ends and leaves nothing half.
void closeOnSignals(const EndSignals& signals, MainWindow& window) {
  constexpr int kSignalled = 128; // as a shell reports it
  QObject::connect(&signals, &EndSignals::asked, &window, [&window](int signal) {
    window.close();
    QApplication::exit(kSignalled + signal);
  });
}

int run(QApplication& application, Arguments arguments) {
  const bool isScreenshot = !arguments.screenshot.empty();
  const EndSignals endSignals; // ends after all that they end
  Session session;
  if (arguments.timing) sayWhenPictureArrives(session);
  session.post(taa::request::SetSceneBudget{arguments.sceneBudget});
  QSettings settings(QStringLiteral("taa-inspector"), QStringLiteral("taa-inspector"));
  arguments.reopens = arguments.reopens && !isScreenshot && SessionKeeper::canReopen(settings);
  if (opensBeforeWindow(arguments)) openScene(session, arguments);
  ThemeChoice theme = ThemeChoice::System;
  // A picture of the window looks the same whoever takes it.
  if (isScreenshot)
    theme = ThemeChoice::Dark;
  else
    parseTheme(settings.value(QStringLiteral("theme")).toString(), theme);
  applyTheme(application, arguments.theme.value_or(theme));

  MainWindow window(session, isScreenshot ? nullptr : &settings);
  closeOnSignals(endSignals, window);
  window.setTheme(arguments.theme.value_or(theme));
  if (arguments.textPercent) window.setTextPercent(*arguments.textPercent);
  if (isScreenshot) window.resize(arguments.windowSize.x, arguments.windowSize.y);
  window.show();
  begin(window, session, arguments);
  session.undoStack().clear(); // what was asked for at the start is where it begins
  if (isScreenshot) {
    window.takeScreenshot(QString::fromStdString(arguments.screenshot), screenshotFrame(arguments),
                          arguments.dialog, arguments.figure, [&arguments](int code, const QString& text) {
                            // What a session asks for is the file's fault.
                            endScreenshot(taa::isSessionName(arguments.source) ? std::min(code, 1) : code,
                                          text);
                          });
  } else {
    if (arguments.frame) session.seek(*arguments.frame);
    window.keeper().offerOrphan();
    if (!arguments.reopens) window.offerTour();
  }
  return QApplication::exec();
}

} // namespace

int main(int argc, char** argv) {
  try {
    Arguments arguments;
    if (const auto end = parseArguments(argc, argv, arguments)) {
      std::fputs(end->text.c_str(), end->code == 0 ? stdout : stderr);
      return end->code;
    }
    if (!arguments.screenshot.empty()) taa::requireFolderOf(arguments.screenshot);
    if (!arguments.screenshot.empty() && !arguments.force) taa::refuseToReplace({arguments.screenshot});
    qInstallMessageHandler(printMessage);
    choosePlatform(!arguments.screenshot.empty());
    chooseShaders(arguments);
    QApplication application(argc, argv);
    QApplication::setApplicationName(QStringLiteral("TAA Inspector"));
    return run(application, arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "taa-inspector: %s\n", taa::shownReason(error).c_str());
    return 1;
  }
}
