#include "app/window/Screenshot.h"

#include "app/doctor/DoctorPanel.h"
#include "app/panels/JitterPanel.h"
#include "app/panels/LineagePanel.h"
#include "app/panels/PipelinePanel.h"
#include "app/panels/PlotsPanel.h"
#include "app/panels/ProfilerPanel.h"
#include "app/panels/WeightsPanel.h"
#include "app/session/Session.h"
#include "app/views/ViewArea.h"
#include "app/window/Dialogs.h"

#include "core/base/Error.h"
#include "core/base/Files.h"
#include "core/base/ShownText.h"

#include <QBuffer>
#include <QByteArray>
#include <QPixmap>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <string_view>
#include <utility>
#include <vector>

namespace taa::app {

namespace {
constexpr int kPoll = 20;        ///< ms
constexpr int kQuiet = 10;       ///< polls
constexpr int kDialogQuiet = 40; ///< more of them: some read files
constexpr int kIdle = 500;       ///< polls: 10 s
constexpr int kTracedFrames = 48;
constexpr int kLimit = 5 * 60 * 1000; ///< ms; a software renderer on a busy machine is slow, not stuck
constexpr int kRefused = 2;           ///< as taa-batch ends with, when it is the call that is at fault
} // namespace

Screenshot::Screenshot(ScreenshotPanels of, const QString& file, int frame, Done done)
    : QObject(&of.window), of_(std::move(of)), file_(file), frame_(frame), done_(std::move(done)) {
  connect(&of_.session, &Session::choiceRefused, this, [this] { code_ = kRefused; });
  connect(&of_.session, &Session::errorOccurred, this, [this](const QString& sentence) {
    lastError_ = sentence;
    idle_ = 0;
    // Nothing will come when nothing could be opened, and something else when a choice was refused.
    if (!of_.session.isOpen() || code_ == kRefused) finish(code_, sentence);
  });
  const auto resume = [this] { idle_ = 0; };
  connect(&of_.session, &Session::statusChanged, this, resume);
  connect(&of_.session, &Session::pictureArrived, this, resume);
  connect(&of_.session, &Session::workChanged, this, resume);
  connect(&poll_, &QTimer::timeout, this, &Screenshot::look);
  connect(&limit_, &QTimer::timeout, this, [this] {
    finish(1, tr("The picture did not get ready within %1 s. %2").arg(kLimit / 1000).arg(lastError_));
  });
  poll_.start(kPoll);
  limit_.setSingleShot(true);
  limit_.start(kLimit);
}

bool Screenshot::isComplete() const {
  const Session& session = of_.session;
  const Status& status = session.status();
  if (status.info.frame != frame_ || !status.exact || status.playing || !session.work().what.empty())
    return false;
  const std::vector<ViewRequest> wanted = of_.views.requests();
  for (std::size_t view = 0; view < wanted.size(); ++view) {
    const ViewResult* result = session.picture(static_cast<int>(view)).get();
    if (!result || result->frame != frame_ || !result->exact || !(result->request == wanted[view]))
      return false;
    if (isOverTime(wanted[view].id)
            ? !result->overTimeSamples
            : needsReference(wanted[view].id) && result->referenceSamples != status.referenceGoal)
      return false;
    if (of_.views.view(static_cast<int>(view))->isMeasuring()) return false;
    if (wanted[view].other && !(result->other && result->other->exact)) return false;
  }
  const PipelinePanel& pipeline = of_.pipeline;
  if (pipeline.isVisible() && pipeline.showsThumbnails() && !pipeline.hasThumbnailsOf(frame_)) return false;
  if (!session.verdicts().isComplete()) return false;
  if (!session.probes().pixel()) return true;
  const ProbeResult* probe = session.probes().result();
  return probe && probe->frame == frame_ && glm::ivec2(probe->x, probe->y) == *session.probes().pixel();
}

// The profiler shows the stages, too, which are only measured when somebody asks.
bool Screenshot::areProfilesComplete() {
  const ProfilerPanel& profiler = of_.profiler;
  if (!profiler.isVisible()) return true;
  if (!std::exchange(measures_, true)) of_.session.post(request::MeasureStages{});
  return profiler.hasProfile() && profiler.hasStageCosts();
}

// Plots show what was seen before, which a picture of one frame lacks: the frames up to it are made.
bool Screenshot::areTracesComplete() {
  const PlotsPanel& plots = of_.plots;
  const Session& session = of_.session;
  const bool isShown = plots.isVisible() || of_.jitter.isVisible() || of_.weights.isVisible();
  if (!isShown || session.probes().all().empty()) return true;
  const int first = std::max(0, frame_ - kTracedFrames);
  if (!std::exchange(asksForTraces_, true)) of_.session.post(request::FillTraces{first, frame_});
  if (session.work().kind == WorkKind::Traces) sawTracing_ = true;
  if (sawTracing_) return session.work().what.empty();
  return std::ranges::all_of(session.probes().all(), [&](const Probe& probe) {
    const PixelTrace* trace = plots.traceOf(probe);
    return trace && missingFrames(*trace, first, frame_).empty();
  });
}

bool Screenshot::isLineageComplete() const {
  return !of_.lineage.isVisible() || !of_.session.probes().pixel() || of_.lineage.isCurrent();
}

// What the doctor says is of use, and what it would look at is not.
bool Screenshot::isDoctorComplete() {
  if (!of_.doctor.isVisible()) return true;
  if (!std::exchange(examines_, true)) Q_EMIT of_.doctor.examineRequested();
  return !of_.doctor.work().isRunning();
}

void Screenshot::look() {
  Session& session = of_.session;
  if (!session.isOpen()) return;
  if (!asked_) {
    asked_ = true;
    frame_ = std::clamp(frame_, 0, session.status().frameCount - 1);
    session.seek(frame_);
  }
  // The rest asks about the shot that is shown: a session's size and camera come after its scene.
  if (!isComplete() || !areTracesComplete() || !isLineageComplete() || !isDoctorComplete() ||
      !areProfilesComplete() || !areDialogsComplete()) {
    quiet_ = 0;
    if (isGivenUp()) finish(code_, lastError_);
    return;
  }
  // Layouts settle and late results arrive before the picture is taken.
  if (++quiet_ < kQuiet) return;
  if (!of_.openDialog) {
    take();
    return;
  }
  std::exchange(of_.openDialog, nullptr)();
  quiet_ = -kDialogQuiet;
}

bool Screenshot::isGivenUp() {
  if (lastError_.isEmpty() || !of_.session.work().what.empty()) idle_ = 0;
  return ++idle_ > kIdle;
}

void Screenshot::take() {
  if (of_.writes) {
    takeFigure();
    return;
  }
  QPixmap picture = of_.window.grab();
  paintDialogs(of_.window, picture);
  QByteArray bytes;
  QBuffer buffer(&bytes);
  picture.save(&buffer, "PNG");
  try {
    writeFile(file_.toStdString(),
              std::string_view(bytes.constData(), static_cast<std::size_t>(bytes.size())));
    finish(0, {});
  } catch (const Error& error) {
    finish(1, QString::fromUtf8(error.what()));
  }
}

void Screenshot::takeFigure() {
  try {
    of_.writes();
    finish(0, {});
  } catch (const std::exception& error) {
    finish(1, QString::fromStdString(shownReason(error)));
  }
}

void Screenshot::finish(int code, const QString& text) {
  poll_.stop();
  limit_.stop();
  if (const Done done = std::exchange(done_, nullptr)) done(code, text);
}

} // namespace taa::app
