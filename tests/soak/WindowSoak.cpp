// Random keys, clicks, drags, texts and sizes for the whole window, for so many seconds:
// taa_soak_window SECONDS SEED LOG. It works in a folder of its own, which is its home, too, and opens
// nothing outside of it: file dialogs are closed as soon as they open, and links go nowhere.
#include "app/session/Session.h"
#include "app/style/Theme.h"
#include "app/window/MainWindow.h"
#include "tests/soak/RandomInput.h"
#include "tests/soak/Watch.h"

#include <QApplication>
#include <QDesktopServices>
#include <QDir>
#include <QFileDialog>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <random>
#include <string>
#include <utility>

using namespace taa;
using namespace taa::app;

namespace {

constexpr int kNotRun = 77; ///< as ctest's SKIP_RETURN_CODE
constexpr int kRescueMs = 2000;
constexpr int kFirstPictureMs = 120'000;
constexpr int kStepsBetween = 400; ///< after which the session begins anew, small and cheap
constexpr glm::ivec2 kSize{160, 90};

/// What would lead out of its folder.
class Fence : public QObject {
  Q_OBJECT
 public:
  Fence() {
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    for (const char* scheme : {"http", "https", "file", "mailto"})
      QDesktopServices::setUrlHandler(QLatin1String(scheme), this, "stay");
    qApp->installEventFilter(this);
  }

 public Q_SLOTS:
  void stay(const QUrl&) {}

 protected:
  bool eventFilter(QObject* object, QEvent* event) override {
    if (auto* dialog = qobject_cast<QFileDialog*>(object); dialog && event->type() == QEvent::Show)
      QMetaObject::invokeMethod(dialog, &QDialog::reject, Qt::QueuedConnection);
    return false;
  }
};

/// The platform without a display, with two screens.
QByteArray screensIn(const QString& folder) {
  const QString path = folder + QStringLiteral("/screens.json");
  const auto screen = [](const char* name, int x) {
    return QStringLiteral(
               R"({"name": "%1", "x": %2, "y": 0, "width": 1920, "height": 1200, "logicalDpi": 96,)"
               R"( "logicalBaseDpi": 96, "dpr": 1})")
        .arg(QLatin1String(name))
        .arg(x);
  };
  std::ofstream(path.toStdString())
      << ("{\"screens\": [" + screen("first", 0) + ", " + screen("second", 1920) + "]}").toStdString();
  return "offscreen:configfile=" + path.toLocal8Bit();
}

void beginAnew(Session& session) {
  session.open(QStringLiteral("builtin:fan"), false);
  session.post(request::SetSize{kSize.x, kSize.y});
  session.presets().setPreset(QStringLiteral("balanced"));
}

int goOn(double seconds, unsigned seed, const char* log, const QString& home) {
  const std::string again =
      std::string("taa_soak_window ") + std::to_string(seconds) + " " + std::to_string(seed);
  std::ofstream out(log, std::ios::trunc);
  std::mt19937 random(seed);
  const Fence fence;
  QSettings settings(home + QStringLiteral("/settings.ini"), QSettings::IniFormat);
  Session session;
  MainWindow window(session, &settings);
  window.resize(1280, 800);
  window.show();
  beginAnew(session);
  if (!QTest::qWaitFor([&] { return session.picture(0) != nullptr; }, kFirstPictureMs)) {
    std::fprintf(stderr, "taa_soak_window: there is no first picture\n");
    return std::getenv("TAA_REQUIRE_GL") ? 1 : kNotRun;
  }
  soak::Watch watch(again);
  soak::RandomInput input(random, window);
  // A menu that waits within itself, as that of a scroll bar, would wait for ever.
  QTimer rescue;
  int steps = 0, seen = -1;
  QObject::connect(&rescue, &QTimer::timeout, [&] {
    QWidget* popup = QApplication::activePopupWidget();
    if (std::exchange(seen, steps) == steps && popup) popup->close();
  });
  rescue.start(kRescueMs);
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  for (; std::chrono::steady_clock::now() < end; watch.tick()) {
    out << ++steps << " ";
    input.step([&out](const std::string& text) {
      out << text << '\n';
      out.flush(); // the last line is what it was about
    });
    if (!window.isVisible()) window.show(); // it was closed
    if (steps % kStepsBetween == 0) {
      input.closeAll();
      beginAnew(session);
    }
  }
  input.closeAll();
  window.close();
  std::printf("window: %d steps in %.0f s, nothing found\n", steps, seconds);
  return 0;
}

} // namespace

int main(int count, char** words) {
  if (count != 4) {
    std::fprintf(stderr, "Usage: taa_soak_window SECONDS SEED LOG\n");
    return 2;
  }
  const std::string log = QDir(QString::fromLocal8Bit(words[3])).absolutePath().toStdString();
  const QTemporaryDir folder;
  const QByteArray home = folder.path().toLocal8Bit();
  for (const char* name : {"HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME", "XDG_STATE_HOME"})
    qputenv(name, home);
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", screensIn(folder.path()));
  QDir::setCurrent(folder.path());
  QApplication application(count, words);
  QApplication::setQuitOnLastWindowClosed(false);
  applyTheme(application, ThemeChoice::Dark);
  return goOn(std::stod(words[1]), static_cast<unsigned>(std::stoul(words[2])), log.c_str(), folder.path());
}

#include "WindowSoak.moc"
