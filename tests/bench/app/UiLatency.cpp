// How long the window's events wait while a frame takes half a second: posts a thousand and says how long
// each one took from its post until it was handled.
#include "tests/app/FakeRenderer.h"

#include "app/panels/PipelinePanel.h"
#include "app/panels/TimelinePanel.h"
#include "app/session/keeping/SessionKeeper.h"
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"
#include "app/window/MainWindow.h"

#include <QApplication>
#include <QMouseEvent>
#include <QScrollArea>
#include <QScrollBar>
#include <QTest>
#include <QWheelEvent>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <functional>
#include <memory>
#include <mutex>
#include <ratio>
#include <string>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

namespace {

using namespace taa;
using namespace taa::app;
using Clock = std::chrono::steady_clock;

constexpr int kEvents = 1000;
constexpr std::chrono::milliseconds kBetween{8}; ///< of two events: a mouse tells 125 times a second
constexpr std::chrono::milliseconds kFrame{500};

/// Does on a thread of its own what it is asked for, half a second of work before each answer.
class SlowRenderer final : public Renderer {
 public:
  explicit SlowRenderer(Listener listener) : fake_(std::move(listener)), thread_([this] { run(); }) {}
  ~SlowRenderer() override {
    {
      const std::lock_guard lock(mutex_);
      ends_ = true;
    }
    posted_.notify_one();
    thread_.join();
  }

  RequestId post(Request request) override {
    const std::lock_guard lock(mutex_);
    const bool isSource = std::holds_alternative<request::Open>(request);
    requests_.push_back(std::move(request));
    if (isSource) requests_.emplace_back(request::SetSize{1280, 720});
    posted_.notify_one();
    return ++last_;
  }

 private:
  // The last ones are enough: of each kind the real thread takes one.
  void run() {
    for (;;) {
      std::vector<Request> taken;
      {
        std::unique_lock lock(mutex_);
        posted_.wait_for(lock, kFrame, [this] { return ends_ || !requests_.empty(); });
        if (ends_) return;
        taken = std::exchange(requests_, {});
      }
      const auto until = Clock::now() + kFrame;
      while (Clock::now() < until) continue; // a software renderer keeps a core busy
      const std::size_t first = taken.size() > 8 ? taken.size() - 8 : 0;
      for (std::size_t i = first; i < taken.size(); ++i) fake_.post(taken[i]);
      fake_.post(request::Seek{(fake_.status.info.frame + 1) % 240});
    }
  }

  app::test::FakeRenderer fake_;
  std::mutex mutex_;
  std::condition_variable posted_;
  std::vector<Request> requests_;
  RequestId last_ = 0;
  bool ends_ = false;
  std::thread thread_; // last
};

/// What a hand does, one after another: each is a real event to a real widget.
class Hand {
 public:
  Hand(MainWindow& window, Session& session) : window_(window), session_(session) {}
  void act(int number) {
    Viewport* viewport = window_.views().active()->viewport();
    const QPoint place(100 + number % 200, 100 + number % 90);
    switch (number % 8) {
    case 0:
    case 1:
      return move(viewport, place, Qt::NoButton);
    case 2:
      return wheel(viewport, place, number % 16 < 8 ? 120 : -120);
    case 3:
      return QTest::keyClick(viewport, number % 16 < 8 ? Qt::Key_Right : Qt::Key_Left);
    case 4:
      return move(viewport, place, Qt::RightButton);
    case 5:
      return QTest::keyClick(viewport, number % 16 < 8 ? Qt::Key_Period : Qt::Key_Comma);
    case 6:
      return session_.presets().setParameter(QStringLiteral("weight.minimum"), 0.05 + 0.001 * (number % 100));
    default:
      return wheel(window_.findChild<PipelinePanel*>()->findChild<QScrollArea*>()->viewport(), {50, 50},
                   number % 400 < 200 ? -120 : 120);
    }
  }

 private:
  static void move(QWidget* widget, const QPoint& place, Qt::MouseButton button) {
    if (button != Qt::NoButton) QTest::mousePress(widget, button, {}, place);
    QMouseEvent event(QEvent::MouseMove, place, widget->mapToGlobal(place), Qt::NoButton, button, {});
    QApplication::sendEvent(widget, &event);
    if (button != Qt::NoButton) QTest::mouseRelease(widget, button, {}, place);
  }
  static void wheel(QWidget* widget, const QPoint& place, int delta) {
    QWheelEvent event(place, widget->mapToGlobal(place), {}, {0, delta}, {}, {}, Qt::NoScrollPhase, false);
    QApplication::sendEvent(widget, &event);
  }
  MainWindow& window_;
  Session& session_;
};

/// Milliseconds from post to handled of each event, rising.
std::vector<double> measure(MainWindow& window, Session& session) {
  Hand hand(window, session);
  std::vector<double> waits;
  std::thread poster([&] {
    for (int number = 0; number < kEvents; ++number) {
      const auto posted = Clock::now();
      QMetaObject::invokeMethod(
          &window,
          [&, number, posted] {
            hand.act(number);
            waits.push_back(std::chrono::duration<double, std::milli>(Clock::now() - posted).count());
            if (number + 1 == kEvents) QApplication::quit();
          },
          Qt::QueuedConnection);
      std::this_thread::sleep_until(posted + kBetween);
    }
  });
  QApplication::exec();
  poster.join();
  std::ranges::sort(waits);
  return waits;
}

} // namespace

int main(int argc, char** argv) {
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication application(argc, argv);
  applyTheme(application, ThemeChoice::Dark);
  Session session([](Listener listener) { return std::make_unique<SlowRenderer>(std::move(listener)); });
  MainWindow window(session, nullptr);
  window.resize(1600, 900);
  window.show();
  window.keeper().openSource(QStringLiteral("builtin:fan"));
  if (!QTest::qWaitFor([&] { return session.picture(0) != nullptr; }, 20000)) {
    std::fputs("taa_ui_latency: no picture arrived\n", stderr);
    return 1;
  }
  session.probes().setPixel(glm::ivec2(200, 200));
  QTest::qWait(1500); // layouts and first paints are over
  const std::vector<double> waits = measure(window, session);
  const auto at = [&](double share) {
    return waits[static_cast<std::size_t>(share * static_cast<double>(waits.size() - 1))];
  };
  std::printf("%zu events, ms until handled: median %.2f, 99%% %.2f, 99.9%% %.2f, longest %.2f\n",
              waits.size(), at(0.5), at(0.99), at(0.999), waits.back());
  return 0;
}
