// The window's lower part: the timeline's playback and marks, and the pages above it.
#include "app/window/MainWindow.h"

#include "app/menus/Menus.h"
#include "app/models/PixelHistory.h"
#include "app/panels/JitterPanel.h"
#include "app/panels/LowerArea.h"
#include "app/panels/MessagesBar.h"
#include "app/panels/PlotsPanel.h"
#include "app/panels/TimelinePanel.h"
#include "app/panels/WeightsPanel.h"
#include "app/widgets/Prompt.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace taa::app {

void MainWindow::connectLower() {
  connect(lower_, &LowerArea::changed, this, [this] { menus_->refresh(); });
  connect(timeline_, &TimelinePanel::playbackEdited, &session_, &Session::setPlayback);
  connect(timeline_, &TimelinePanel::playbackEdited, this, [this] { menus_->refresh(); });
  connect(jitter_, &JitterPanel::seekRequested, &session_, &Session::seek);
  connect(weights_, &WeightsPanel::seekRequested, &session_, &Session::seek);
  connect(jitter_, &JitterPanel::shownChanged, this, &MainWindow::showTraces);
  connect(weights_, &WeightsPanel::shownChanged, this, &MainWindow::showTraces);
  connect(plots_, &PlotsPanel::shownChanged, this, &MainWindow::showTraces);
  connect(plots_, &PlotsPanel::seekRequested, &session_, &Session::seek);
  connect(plots_, &PlotsPanel::fillRequested, &session_, &Session::fillTraces);
  connect(plots_, &PlotsPanel::failed, messages_, &MessagesBar::showError);
  connect(timeline_, &TimelinePanel::figureChosen, this, [this](std::optional<Figure> figure) {
    session_.setFigures(figure ? std::vector<Figure>{*figure} : std::vector<Figure>());
    showFigure();
    menus_->refresh();
  });
  connect(&session_, &Session::figuresArrived, this, [this](const FrameFigures& figures) {
    if (figures_.add(figures)) showFigure();
  });
  connect(&session_, &Session::traceArrived, plots_, &PlotsPanel::addSample);
  connect(&session_, &Session::traceArrived, this, [this](const TraceDelivery& trace) {
    if (trace.frame == session_.status().info.frame) showHistory();
  });
  connect(&session_, &Session::pickChanged, this, &MainWindow::showTraces);
  connect(&session_, &Session::workChanged, this,
          [this] { plots_->setFilling(session_.work().what == "Tracing the probes"); });
}

// Probes are followed over frames as long as somebody looks.
void MainWindow::showTraces() {
  session_.setTracing(plots_->isVisible() || jitter_->isVisible() || weights_->isVisible());
  plots_->setPins(session_.pins(), session_.activePin());
  showHistory();
}

// What jitter and weights are drawn from.
void MainWindow::showHistory() {
  plots_->setStatus(session_.status());
  if (figures_.setSubject(session_.status().subject)) showFigure();
  if (!jitter_->isVisible() && !weights_->isVisible()) return;
  const Status& status = session_.status();
  PixelHistory history;
  history.settings = session_.settings();
  history.frame = status.info.frame;
  if (status.settings.jitter.sequence == JitterSequence::Perpendicular)
    history.jitterWay = status.info.jitterWay;
  for (const std::vector<int>* starts : {&status.cuts, &status.restarts})
    for (const int start : *starts)
      if (start <= history.frame) history.start = std::max(history.start, start);
  if (const int active = session_.activePin(); active >= 0) {
    const ProbePin& pin = session_.pins()[static_cast<std::size_t>(active)];
    if (const PixelTrace* trace = plots_->store().traceOf(pin))
      history.measured = alphasUpTo(*trace, history.frame, kMostFramesBack);
    if (const auto pixel = session_.pick())
      history.place = QStringLiteral("(%1, %2)").arg(pixel->x).arg(pixel->y);
  }
  jitter_->setHistory(history);
  weights_->setHistory(history);
}

void MainWindow::showFigure() {
  if (const auto figure = timeline_->figure())
    timeline_->setStrip(figures_.strip(*figure, session_.status().frameCount));
}

void MainWindow::setLowerPage(LowerPage page, bool shown) {
  lower_->setShown(page, shown);
}

void MainWindow::askForMarkName() {
  if (!session_.isOpen()) return;
  const int frame = timeline_->frame();
  auto* prompt = new Prompt(
      tr("Name of the mark at frame %1").arg(frame), timeline_->marks().nameOf(frame),
      [this](const QString& text) {
        timeline_->nameMark(text);
        return true;
      },
      this);
  prompt->open();
}

} // namespace taa::app
