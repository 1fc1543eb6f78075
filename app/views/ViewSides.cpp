#include "app/views/ViewSides.h"

#include "app/style/PictureImage.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"

#include "core/inspect/ShownPicture.h"
#include "core/measure/MetricTable.h"

#include <QObject>

#include <cmath>
#include <memory>
#include <optional>
#include <utility>

namespace taa::app {

namespace {

QImage imageOf(const Picture& picture) {
  return imageOver(picture).convertToFormat(QImage::Format_ARGB32_Premultiplied);
}

std::optional<std::vector<float>> valueOf(const Image& values, const gl::Rect& region, glm::ivec2 pixel) {
  const glm::ivec2 at = pixel - glm::ivec2(region.x, region.y);
  if (at.x < 0 || at.y < 0 || at.x >= values.width || at.y >= values.height) return {};
  const float* first = values.at(at.x, at.y);
  return std::vector<float>(first, first + values.channels);
}

Absence absenceIn(const Image& absence, const gl::Rect& region, glm::ivec2 pixel) {
  const auto number = valueOf(absence, region, pixel);
  return number ? static_cast<Absence>(static_cast<int>(number->front())) : Absence::None;
}

QString overTimeNote(const ViewResult& result) {
  if (!result.overTimeSamples) return QObject::tr("not measured yet: comes while paused");
  const std::optional<Metric> metric = metricOfMap(result.request.id);
  if (metric && !result.number) return QObject::tr("nothing in this frame was seen before");
  const QString mean = metric ? QObject::tr("mean %1").arg(*result.number, 0, 'f', 5) : QString();
  if (!needsReference(result.request.id)) return mean;
  if (!metric) return QObject::tr("%1 samples").arg(*result.overTimeSamples);
  return QObject::tr("%1 samples · %2").arg(*result.overTimeSamples).arg(mean);
}

QString errorText(const PictureError& error) {
  const QString psnr =
      std::isinf(error.psnr) ? QStringLiteral("∞") : QStringLiteral("%1 dB").arg(error.psnr, 0, 'f', 1);
  return QObject::tr("RMSE %1 · PSNR %2").arg(error.rmse, 0, 'f', 4).arg(psnr);
}

QString numberText(Metric metric, double number) {
  return QObject::tr("%1 %2").arg(qtext(metricInfo(metric).label)).arg(number, 0, 'f', 4);
}

QString engineNote(const ViewResult& result) {
  if (!result.error) return QObject::tr("only a capture that holds an engine's output has it");
  return QObject::tr("against ours: %1").arg(errorText(*result.error));
}

} // namespace

QString referenceNote(const ViewResult& result) {
  if (isOverTime(result.request.id)) return overTimeNote(result);
  if (isOfEngine(result.request.id)) return engineNote(result);
  if (!isOfReference(result.request.id)) return {};
  if (result.referenceSamples == 0 || !result.error) return QObject::tr("not drawn yet: comes while paused");
  const std::optional<Metric> metric = metricOfMap(result.request.id);
  const QString text =
      metric && result.number ? numberText(*metric, *result.number) : errorText(*result.error);
  if (result.isReferenceGiven) return QObject::tr("the capture's own · %1").arg(text);
  return QObject::tr("%1 samples · %2").arg(result.referenceSamples).arg(text);
}

ViewSides::ViewSides() : content_{intermediate(IntermediateId::resolved), {}, {}} {}

void ViewSides::setResult(std::shared_ptr<const ViewResult> result) {
  const std::shared_ptr<const ViewResult> before = kept_ ? kept_ : result_;
  const bool keeps = !result->other && before && before->other && result->request.other &&
                     result->request.other == before->request.other &&
                     result->request.transform == before->request.transform &&
                     result->picture.width == before->other->picture.width;
  kept_ = keeps ? before : nullptr;
  result_ = std::move(result);
  image_ = imageOf(result_->picture);
  if (!keeps) otherImage_ = result_->other ? imageOf(result_->other->picture) : QImage();
}

const ViewSide* ViewSides::otherSide() const {
  const ViewResult* holder = kept_ ? kept_.get() : result_.get();
  return holder && holder->other ? &*holder->other : nullptr;
}

Showing ViewSides::shown() const {
  if (!other_) return Showing::First;
  if (!peeks_) return showing_;
  return showing_ == Showing::Other ? Showing::First : Showing::Other;
}

bool ViewSides::isResultOfContent() const {
  return result_ && result_->request.id == content_.row.id &&
         result_->request.asDifference == (other_ && showing_ == Showing::Difference);
}

std::optional<std::vector<float>> ViewSides::valueAt(glm::ivec2 pixel) const {
  if (!isResultOfContent()) return {};
  return valueOf(result_->values, result_->region, pixel);
}

std::optional<std::vector<float>> ViewSides::otherValueAt(glm::ivec2 pixel) const {
  if (!other_ || !otherSide() || !result_->request.other) return {};
  if (result_->request.other->id != other_->row.id) return {};
  return valueOf(otherSide()->values, otherRegion(), pixel);
}

Absence ViewSides::absenceAt(glm::ivec2 pixel) const {
  return isResultOfContent() ? absenceIn(result_->absence, result_->region, pixel) : Absence::None;
}

Absence ViewSides::otherAbsenceAt(glm::ivec2 pixel) const {
  return otherSide() ? absenceIn(otherSide()->absence, otherRegion(), pixel) : Absence::None;
}

bool ViewSides::isAlongMotion() const {
  return result_ && result_->request.other && result_->request.other->alongMotion;
}

bool ViewSides::isComparedWithAnotherFrame() const {
  return result_ && result_->request.other && result_->request.other->isOfAnotherFrame();
}

QString ViewSides::label(bool other) const {
  const QString& text = other && other_ ? other_->text : content_.text;
  if (!result_ || (other && !otherSide())) {
    if (other && isComparedWithAnotherFrame() && isOfReference(other_->row.id))
      return tr("%1 · only the frame on show has a reference: go to that frame to see its own").arg(text);
    if (other && isComparedWithAnotherFrame() && playing_)
      return tr("%1 · comes when it is paused").arg(text);
    return tr("%1 · on its way").arg(text);
  }
  const bool exact = other ? otherSide()->exact : result_->exact;
  const QString framed = framedLabel(text, other);
  const bool waits = playing_ && (kept_ || result_->request.asDifference) && isComparedWithAnotherFrame();
  if (other && waits) return tr("%1 · stays until it is paused").arg(framed);
  return exact ? framed : tr("%1 · not exact yet").arg(framed);
}

QString ViewSides::framedLabel(const QString& text, bool other) const {
  if (!other || !isAlongMotion()) {
    const int frame = other ? otherSide()->frame : result_->frame;
    return tr("%1 · frame %2").arg(text).arg(frame);
  }
  if (const Absence absence = otherSide()->allAbsent; absence != Absence::None)
    return tr("%1 · nothing: %2").arg(text, qtext(absenceText(absence)));
  return tr("%1 · frame %2 along the motion").arg(text).arg(otherSide()->frame);
}

// What the checkers over a picture mean.
QString ViewSides::absenceNote() const {
  if (!isAlongMotion() || !otherSide()) return {};
  if (const Absence absence = otherSide()->allAbsent; absence != Absence::None)
    return tr("nothing: %1").arg(qtext(absenceText(absence)));
  return tr("nothing: off screen, or no previous position");
}

bool ViewSides::isPictureComplete() const {
  if (!isResultOfContent() || result_->picture.width == 0 || result_->isPreview) return false;
  const bool needsOther = other_ && (showing_ == Showing::Other || showing_ == Showing::Wipe);
  if (!needsOther) return true;
  return result_->other && !kept_ && result_->request.other && result_->request.other->id == other_->row.id &&
         result_->other->picture.width == result_->picture.width;
}

Picture ViewSides::picture(int dividerColumn) const {
  if (!isPictureComplete()) return {};
  if (!other_ || showing_ == Showing::First || showing_ == Showing::Difference) return result_->picture;
  if (showing_ == Showing::Other) return result_->other->picture;
  return wiped(result_->picture, result_->other->picture, dividerColumn);
}

LegendSide ViewSides::legendSide(bool other, Showing showing) const {
  const ViewContent& content = other ? *other_ : content_;
  LegendSide side{content.row, content.style, !other && showing == Showing::Difference, {}};
  const bool isOfOther =
      other && otherSide() && result_->request.other && result_->request.other->id == content.row.id;
  const bool isOfResult = !other && isResultOfContent();
  if (isOfResult && totalOf(result_->reasons) > 0) side.reasons = &result_->reasons;
  if (isOfOther && totalOf(otherSide()->reasons) > 0) side.reasons = &otherSide()->reasons;
  if (isOfResult) side.note = result_->isPreview ? tr("preview") : referenceNote(*result_);
  if (other || side.isDifference) side.absence = absenceNote();
  side.space = content.space;
  return side;
}

LegendFlow ViewSides::legend(Showing showing, LegendFold fold, const ViewTransform& transform,
                             const ThemeColors& colors) const {
  const LegendSide main = legendSide(showing == Showing::Other, showing);
  LegendFlow flow;
  const ReasonCounts* beside = nullptr;
  if (showing == Showing::Wipe) beside = legendSide(true, showing).reasons;
  if (beside && main.reasons && *beside == *main.reasons) beside = nullptr;
  if (fold == LegendFold::AllButName) {
    addScaleLegend(flow, main, colors);
    return flow;
  }
  if (fold == LegendFold::Nothing) addOverlayLegend(flow, main, beside, transform, colors);
  if (showing == Showing::Wipe && other_->row.id != main.row.id)
    addRowLegend(flow, legendSide(true, showing), colors);
  addRowLegend(flow, main, colors);
  if (fold == LegendFold::Overlays) flow.text(tr("⋯ overlays"), secondaryFont(), colors.accent);
  return flow;
}

} // namespace taa::app
