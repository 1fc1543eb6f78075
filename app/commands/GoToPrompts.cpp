#include "app/commands/GoToPrompts.h"

#include "app/panels/TimelinePanel.h"
#include "app/session/Session.h"
#include "app/views/MeasuredRegion.h"
#include "app/views/ViewArea.h"
#include "app/views/Viewport.h"
#include "app/widgets/Prompt.h"

#include "core/picture/RegionSpreadText.h"

#include <optional>

namespace taa::app {

GoToPrompts::GoToPrompts(Session& session, ViewArea& views, TimelinePanel& timeline, QWidget* window)
    : QObject(window), session_(session), views_(views), timeline_(timeline), window_(window) {}

void GoToPrompts::askForPixel() {
  const auto probed = session_.probes().pixel();
  const QString now = probed ? QStringLiteral("%1, %2").arg(probed->x).arg(probed->y) : QString();
  auto* prompt = new Prompt(
      tr("Go to pixel (x, y)"), now,
      [this](const QString& text) {
        int x = 0, y = 0;
        if (!parsePair(text, x, y)) return false;
        session_.probes().setPixel(glm::ivec2(x, y));
        if (session_.probes().pixel()) views_.active()->viewport()->reveal(*session_.probes().pixel());
        return true;
      },
      window_);
  prompt->open();
}

void GoToPrompts::askForRegion() {
  MeasuredRegion* measured = views_.active()->measured();
  const std::optional<gl::Rect>& now = measured->region();
  auto* prompt = new Prompt(
      tr("Statistics of a region (x, y, width × height, or nothing for none)"),
      now ? QStringLiteral("%1, %2, %3×%4").arg(now->x).arg(now->y).arg(now->width).arg(now->height)
          : QString(),
      [this, measured](const QString& text) {
        if (text.trimmed().isEmpty()) {
          measured->set({});
          return true;
        }
        const Status& status = session_.status();
        const std::optional<gl::Rect> asked = parseRegion(text.toStdString());
        const std::optional<gl::Rect> region =
            asked ? insidePicture(*asked, status.width, status.height) : std::nullopt;
        if (region) measured->set(region);
        return region.has_value();
      },
      window_);
  prompt->open();
}

void GoToPrompts::askForFrame() {
  const Status& status = session_.status();
  auto* prompt = new Prompt(
      tr("Go to frame (0 to %1)").arg(status.frameCount - 1), QString::number(status.info.frame),
      [this](const QString& text) {
        bool understood = false;
        const int frame = text.trimmed().toInt(&understood);
        if (understood) session_.seek(frame);
        return understood;
      },
      window_);
  prompt->open();
}

void GoToPrompts::askForLength() {
  const Status& status = session_.status();
  auto* prompt = new Prompt(
      tr("Length of the shot (1 to %1 frames, or nothing for the scene's own)").arg(kMaxShotFrames),
      QString::number(status.frameCount),
      [this](const QString& text) {
        bool isNumber = false;
        const int frames = text.trimmed().toInt(&isNumber);
        const bool isOwn = text.trimmed().isEmpty();
        if (!isOwn && (!isNumber || frames < 1 || frames > kMaxShotFrames)) return false;
        session_.choose({session_.status().choice.animation, isOwn ? 0 : frames});
        return true;
      },
      window_);
  prompt->open();
}

void GoToPrompts::askForSize() {
  const Status& status = session_.status();
  auto* prompt = new Prompt(
      tr("Render size (width × height, px)"), QStringLiteral("%1×%2").arg(status.width).arg(status.height),
      [this](const QString& text) {
        int width = 0, height = 0;
        if (!parsePair(text, width, height)) return false;
        session_.post(request::SetSize{width, height});
        return true;
      },
      window_);
  prompt->setHint([this](const QString& text) {
    int width = 0, height = 0;
    if (!parsePair(text, width, height) || width == 0 || height == 0) return tr("width and height");
    return tr("takes %1 of memory").arg(session_.memoryText({width, height}));
  });
  prompt->open();
}

void GoToPrompts::askForMarkName() {
  if (!session_.isOpen()) return;
  const int frame = timeline_.frame();
  auto* prompt = new Prompt(
      tr("Name of the mark at frame %1").arg(frame), timeline_.marks().nameOf(frame),
      [this](const QString& text) {
        timeline_.nameMark(text);
        return true;
      },
      window_);
  prompt->open();
}

} // namespace taa::app
