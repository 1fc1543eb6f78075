// The window's lower part: the timeline's playback and marks, and the pages above it.
#include "app/MainWindow.h"

#include "app/menus/Menus.h"
#include "app/models/PixelHistory.h"
#include "app/panels/JitterPanel.h"
#include "app/panels/LowerArea.h"
#include "app/panels/TimelinePanel.h"
#include "app/panels/WeightsPanel.h"
#include "app/widgets/Prompt.h"

namespace taa::app {

void MainWindow::connectLower() {
  connect(lower_, &LowerArea::changed, this, [this] { menus_->refresh(); });
  connect(timeline_, &TimelinePanel::playbackEdited, &session_, &Session::setPlayback);
  connect(timeline_, &TimelinePanel::playbackEdited, this, [this] { menus_->refresh(); });
  connect(jitter_, &JitterPanel::seekRequested, &session_, &Session::seek);
  connect(weights_, &WeightsPanel::seekRequested, &session_, &Session::seek);
  connect(jitter_, &JitterPanel::shownChanged, this, &MainWindow::showHistory);
  connect(weights_, &WeightsPanel::shownChanged, this, &MainWindow::showHistory);
}

// What jitter and weights are drawn from.
void MainWindow::showHistory() {
  if (!jitter_->isVisible() && !weights_->isVisible()) return;
  const Status& status = session_.status();
  PixelHistory history;
  history.settings = session_.settings();
  history.frame = status.info.frame;
  for (const int cut : status.cuts)
    if (cut <= history.frame) history.start = cut;
  jitter_->setHistory(history);
  weights_->setHistory(history);
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
