// How long the window's events wait while a frame takes half a second: posts a thousand and says how long
// each one took from its post until it was handled, then, of gestures, until what they show was painted.
#include "tests/app/FakeRenderer.h"

#include "app/models/ProbeModel.h"
#include "app/panels/PipelinePanel.h"
#include "app/panels/ProbePanel.h"
#include "app/panels/StatusLine.h"
#include "app/panels/TimelinePanel.h"
#include "app/session/keeping/SessionKeeper.h"
#include "app/style/Numbers.h"
#include "app/views/ViewArea.h"
#include "app/views/ViewPanel.h"
#include "app/views/Viewport.h"
#include "app/widgets/parameters/NumberField.h"
#include "app/widgets/parameters/ParameterRow.h"
#include "app/window/MainWindow.h"
#include "core/requests/RequestQueue.h"

#include <QApplication>
#include <QLabel>
#include <QMouseEvent>
#include <QScrollArea>
#include <QScrollBar>
#include <QTest>
#include <QTreeView>
#include <QWheelEvent>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
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
constexpr int kGestures = 50;                              ///< of each kind
constexpr std::chrono::milliseconds kBetweenGestures{130}; ///< so that they fall on every part of a frame
constexpr std::chrono::milliseconds kGivenUp{1500};
constexpr double kLimitMs = 50.0; ///< so long a hand does not notice

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
    requests_.push_back({++last_, std::move(request)});
    if (isSource) requests_.push_back({last_, request::SetSize{1280, 720}});
    posted_.notify_one();
    return last_;
  }

 private:
  // The last ones are enough: of each kind the real thread takes one.
  void run() {
    for (;;) {
      std::vector<PostedRequest> taken;
      {
        std::unique_lock lock(mutex_);
        posted_.wait_for(lock, kFrame, [this] { return ends_ || !requests_.empty(); });
        if (ends_) return;
        taken = std::exchange(requests_, {});
      }
      const auto until = Clock::now() + kFrame;
      while (Clock::now() < until) continue; // a software renderer keeps a core busy
      const std::size_t first = taken.size() > 8 ? taken.size() - 8 : 0;
      for (std::size_t i = first; i < taken.size(); ++i) {
        fake_.requests = taken[i].id - 1; // its own number is that which post() gave
        fake_.post(taken[i].request);
      }
      fake_.post(request::Seek{(fake_.status.info.frame + 1) % 240});
    }
  }

  app::test::FakeRenderer fake_;
  std::mutex mutex_;
  std::condition_variable posted_;
  std::vector<PostedRequest> requests_;
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
      move(viewport, place, Qt::NoButton);
      return;
    case 2:
      wheel(viewport, place, number % 16 < 8 ? 120 : -120);
      return;
    case 3:
      QTest::keyClick(viewport, number % 16 < 8 ? Qt::Key_Right : Qt::Key_Left);
      return;
    case 4:
      move(viewport, place, Qt::RightButton);
      return;
    case 5:
      QTest::keyClick(viewport, number % 16 < 8 ? Qt::Key_Period : Qt::Key_Comma);
      return;
    case 6:
      session_.presets().setParameter(QStringLiteral("weight.minimum"), 0.05 + 0.001 * (number % 100));
      return;
    default:
      wheel(window_.findChild<PipelinePanel*>()->findChild<QScrollArea*>()->viewport(), {50, 50},
            number % 400 < 200 ? -120 : 120);
      return;
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

/// Of what a hand does: its event, and the widget that shows the answer once `isAnswered` holds.
struct Gesture {
  const char* name;
  std::function<void(int number)> act;
  QWidget* shows;
  std::function<bool()> isAnswered;
};

/// Says when a gesture's answer was painted.
class TimedApplication final : public QApplication {
 public:
  using QApplication::QApplication;
  bool notify(QObject* receiver, QEvent* event) override {
    const bool isPaint = event->type() == QEvent::Paint; // afterwards it may be gone
    const bool isTaken = QApplication::notify(receiver, event);
    if (isPaint && watched_ && receiver == watched_->shows && watched_->isAnswered()) {
      watched_ = nullptr;
      painted_.set_value(Clock::now());
    }
    return isTaken;
  }
  /// In the thread of the window.
  void watch(const Gesture& gesture, std::promise<Clock::time_point> painted) {
    watched_ = &gesture;
    painted_ = std::move(painted);
  }

 private:
  const Gesture* watched_ = nullptr;
  std::promise<Clock::time_point> painted_;
};

ParameterRow* rowOf(MainWindow& window, const QString& path) {
  const auto& rows = window.findChild<PipelinePanel*>()->parameterRows();
  return *std::ranges::find_if(rows, [&](const ParameterRow* row) { return row->path() == path; });
}

void sendMove(QWidget* widget, const QPoint& place, Qt::MouseButtons buttons) {
  QMouseEvent event(QEvent::MouseMove, place, widget->mapToGlobal(place), Qt::NoButton, buttons, {});
  QApplication::sendEvent(widget, &event);
}

/// Around the middle, where there is a picture; each is another pixel than the one before.
QPoint placeOf(const QWidget* viewport, int number) {
  return viewport->rect().center() + QPoint(7 * number % 120 - 60, 3 * number % 60 - 30);
}

QString pixelText(const std::optional<glm::ivec2>& pixel) {
  return pixel ? QStringLiteral("(%1, %2)").arg(pixel->x).arg(pixel->y) : QStringLiteral("none");
}

/// A number is dragged, a pixel is picked, the mouse passes over the picture, the wheel turns there.
std::vector<Gesture> gesturesOf(MainWindow& window, Session& session) {
  Viewport* viewport = window.views().active()->viewport();
  auto* panel = window.findChild<ProbePanel*>();
  auto* field = qobject_cast<NumberField*>(rowOf(window, QStringLiteral("weight.minimum"))->editor());
  QLabel* place = panel->head()->findChild<QLabel*>(QStringLiteral("place"));
  auto* line = window.findChild<StatusLine*>();
  QLabel* hover = line->findChild<QLabel*>(QStringLiteral("hover"));
  const IntermediateId shown = window.views().active()->id();
  const auto before = std::make_shared<QString>(); // of the gesture under way; each of them reads it
  const auto isPicked = [viewport, panel, &session, shown] {
    const auto values = viewport->valueAt(*session.probes().pixel());
    const QModelIndex cell = panel->model()->indexOf(shown, ProbeModel::Value);
    return values && cell.data().toString().contains(roundedText(values->front()));
  };
  const auto pick = [viewport](int number) {
    QTest::mouseClick(viewport, Qt::RightButton, {}, placeOf(viewport, number));
  };
  return {{"slider",
           [field, before](int number) {
             *before = QString::number(field->value());
             sendMove(field, {field->width() / 2 + (number % 2 == 0 ? 8 : -8), field->height() / 2},
                      Qt::LeftButton);
           },
           field, [field, before] { return QString::number(field->value()) != *before; }},
          {"pick's place", pick, place,
           [place, &session] { return place->text().contains(pixelText(session.probes().pixel())); }},
          {"pick's values", [pick](int number) { pick(number + 50); }, panel->table()->viewport(), isPicked},
          {"hover", [viewport](int number) { sendMove(viewport, placeOf(viewport, number), Qt::NoButton); },
           hover, [hover, viewport] { return hover->text().contains(pixelText(viewport->hovered())); }},
          {"zoom",
           [viewport, before](int number) {
             *before = QString::number(viewport->zoom());
             const QPoint at = placeOf(viewport, number);
             QWheelEvent event(at, viewport->mapToGlobal(at), {}, {0, number % 8 < 4 ? 120 : -120}, {}, {},
                               Qt::NoScrollPhase, false);
             QApplication::sendEvent(viewport, &event);
           },
           viewport, [viewport, before] { return QString::number(viewport->zoom()) != *before; }}};
}

/// Milliseconds from post to painted, rising; an answer that has not come after kGivenUp counts as that.
std::vector<double> paintTimes(TimedApplication& application, const Gesture& gesture) {
  std::vector<double> times;
  std::thread poster([&] {
    for (int number = 0; number < kGestures; ++number) {
      std::promise<Clock::time_point> promise;
      std::future<Clock::time_point> painted = promise.get_future();
      const auto posted = Clock::now();
      const auto act = [&, number, kept = std::make_shared<decltype(promise)>(std::move(promise))] {
        application.watch(gesture, std::move(*kept));
        gesture.act(number);
      };
      QMetaObject::invokeMethod(&application, act, Qt::QueuedConnection);
      const bool isPainted = painted.wait_for(kGivenUp) == std::future_status::ready;
      const auto end = isPainted ? painted.get() : posted + kGivenUp;
      times.push_back(std::chrono::duration<double, std::milli>(end - posted).count());
      std::this_thread::sleep_for(kBetweenGestures);
    }
    QMetaObject::invokeMethod(
        &application, [] { QApplication::exit(); }, Qt::QueuedConnection);
  });
  QApplication::exec();
  poster.join();
  std::ranges::sort(times);
  return times;
}

void sayGestures(TimedApplication& application, MainWindow& window, Session& session) {
  auto* pipeline = window.findChild<PipelinePanel*>();
  pipeline->setAllExpanded(true);
  window.views().active()->viewport()->fit(); // each place of a gesture is another pixel
  ParameterRow* row = rowOf(window, QStringLiteral("weight.minimum"));
  QTest::qWait(200);
  pipeline->findChild<QScrollArea*>()->ensureWidgetVisible(row);
  QTest::qWait(1500);
  for (const Gesture& gesture : gesturesOf(window, session)) {
    const bool drags = gesture.shows == row->editor();
    if (drags) QTest::mousePress(row->editor(), Qt::LeftButton, {}, row->editor()->rect().center());
    const std::vector<double> times = paintTimes(application, gesture);
    if (drags) QTest::mouseRelease(row->editor(), Qt::LeftButton, {}, row->editor()->rect().center());
    const auto late = std::ranges::count_if(times, [](double time) { return time > kLimitMs; });
    std::printf("%s: %zu, ms until painted: median %.1f, 95%% %.1f, longest %.1f; over %.0f ms: %td\n",
                gesture.name, times.size(), times[times.size() / 2], times[times.size() * 19 / 20],
                times.back(), kLimitMs, late);
  }
}

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
            if (number + 1 == kEvents) QApplication::exit(); // quit() would close the window
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
  TimedApplication application(argc, argv);
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
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  const std::vector<double> waits = measure(window, session);
  const auto at = [&](double share) {
    return waits[static_cast<std::size_t>(share * static_cast<double>(waits.size() - 1))];
  };
  std::printf("%zu events, ms until handled: median %.2f, 99%% %.2f, 99.9%% %.2f, longest %.2f\n",
              waits.size(), at(0.5), at(0.99), at(0.999), waits.back());
  sayGestures(application, window, session);
  return 0;
}
