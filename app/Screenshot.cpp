#include "app/Screenshot.h"

#include "app/MainWindow.h"
#include "app/panels/PipelinePanel.h"
#include "app/panels/ProfilerPanel.h"
#include "app/views/ViewArea.h"

#include <QPixmap>

#include <algorithm>
#include <utility>

namespace taa::app {

namespace {
constexpr int kPoll = 20;             ///< ms
constexpr int kQuiet = 10;            ///< polls
constexpr int kLimit = 5 * 60 * 1000; ///< ms; a software renderer on a busy machine is slow, not stuck
} // namespace

Screenshot::Screenshot(MainWindow& window, const QString& file, int frame, Done done)
    : QObject(&window), window_(window), file_(file), frame_(frame), done_(std::move(done)) {
  Session& session = window.session();
  connect(&session, &Session::errorOccurred, this, [this](const QString& sentence) {
    lastError_ = sentence;
    // Nothing will come when nothing could be opened.
    if (!window_.session().isOpen()) finish(1, sentence);
  });
  connect(&poll_, &QTimer::timeout, this, &Screenshot::look);
  connect(&limit_, &QTimer::timeout, this, [this] {
    finish(1, tr("The picture did not get ready within %1 s. %2").arg(kLimit / 1000).arg(lastError_));
  });
  poll_.start(kPoll);
  limit_.setSingleShot(true);
  limit_.start(kLimit);
}

bool Screenshot::isComplete() const {
  const Session& session = window_.session();
  const Status& status = session.status();
  if (status.info.frame != frame_ || !status.exact || status.playing || !session.work().what.empty())
    return false;
  const std::vector<ViewRequest> wanted = window_.views()->requests();
  for (std::size_t view = 0; view < wanted.size(); ++view) {
    const ViewResult* result = session.picture(static_cast<int>(view));
    if (!result || result->frame != frame_ || !result->exact || !(result->request == wanted[view]))
      return false;
    if (isOfReference(wanted[view].id) && result->referenceSamples != status.referenceGoal) return false;
    if (wanted[view].other && !(result->other && result->other->exact)) return false;
  }
  const PipelinePanel* pipeline = window_.pipeline();
  if (pipeline->isVisible() && pipeline->showsThumbnails() && !pipeline->hasThumbnailsOf(frame_))
    return false;
  if (!session.pick()) return true;
  const ProbeResult* probe = session.probe();
  return probe && probe->frame == frame_ && glm::ivec2(probe->x, probe->y) == *session.pick();
}

// The profiler shows the stages, too, which are only measured when somebody asks.
bool Screenshot::areProfilesComplete() {
  const ProfilerPanel* profiler = window_.profiler();
  if (!profiler->isVisible()) return true;
  if (!std::exchange(measures_, true)) window_.session().measureStages();
  return profiler->hasProfile() && profiler->hasStageCosts();
}

void Screenshot::look() {
  Session& session = window_.session();
  if (!session.isOpen()) return;
  if (!asked_) {
    asked_ = true;
    frame_ = std::clamp(frame_, 0, session.status().frameCount - 1);
    session.seek(frame_);
  }
  if (!isComplete() || !areProfilesComplete()) {
    quiet_ = 0;
    return;
  }
  // Layouts settle and late results arrive before the picture is taken.
  if (++quiet_ < kQuiet) return;
  if (window_.grab().save(file_, "PNG"))
    finish(0, {});
  else
    finish(1, tr("cannot write %1: check that its folder exists and can be written").arg(file_));
}

void Screenshot::finish(int code, const QString& text) {
  poll_.stop();
  limit_.stop();
  if (const Done done = std::exchange(done_, nullptr)) done(code, text);
}

} // namespace taa::app
