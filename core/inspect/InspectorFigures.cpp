// Figures of the frame on show, and of others beside it.
#include "core/inspect/InspectorParts.h"
#include "core/measure/FigureCursor.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace taa {

namespace {

bool isAgainstReference(Figure figure) {
  return figureInfo(figure).needsReference;
}

/// The row of the frame alone that a figure is made of.
std::optional<IntermediateId> rowOf(Figure figure) {
  const FigureInfo& info = figureInfo(figure);
  return info.isOverTime ? std::nullopt : findIntermediate(info.row);
}

/// The rows that figures are made of.
std::vector<IntermediateId> rowsOf(const std::vector<Figure>& wanted) {
  std::vector<IntermediateId> ids;
  for (const Figure figure : wanted)
    if (const auto id = rowOf(figure)) ids.push_back(*id);
  return inTableOrder(std::move(ids));
}

void addRows(FrameFigures& figures, const std::vector<Figure>& wanted, const std::vector<IntermediateId>& ids,
             const std::vector<Image>& rows) {
  for (const Figure figure : wanted)
    if (const auto id = rowOf(figure))
      figures.at(figure) =
          figureOf(figure, rows[static_cast<std::size_t>(std::ranges::find(ids, *id) - ids.begin())]);
}

void addError(FrameFigures& figures, const std::vector<Figure>& wanted, const PictureError& error) {
  for (const Figure figure : wanted) {
    if (figure == Figure::Rmse) figures.at(figure) = error.rmse;
    if (figure == Figure::Psnr) figures.at(figure) = error.psnr;
    if (figure == Figure::RmseLinear) figures.at(figure) = error.rmseLinear;
  }
}

void addFlicker(FrameFigures& figures, const std::vector<Figure>& wanted, const FlickerMaps& maps,
                int samples) {
  figures.flickerSamples = samples;
  for (const Figure figure : wanted) {
    if (figure == Figure::Deviation) figures.at(figure) = meanOverTime(maps.deviation, maps.frames);
    if (figure == Figure::Flicker && samples > 0)
      figures.at(figure) = meanOverTime(maps.flicker, maps.frames);
  }
}

} // namespace

FrameFigures Inspector::figures(const std::vector<Figure>& wanted, int lane) {
  FrameFigures figures{.frame = frame(), .lane = lane, .exact = isExact(lane), .values = {}};
  const std::vector<IntermediateId> ids = rowsOf(wanted);
  addRows(figures, wanted, ids, images(ids, lane));
  if (const std::optional<int> samples = flickerSamples(lane))
    addFlicker(figures, wanted, parts_->flickers.at(static_cast<std::size_t>(lane)).maps(), *samples);
  ReferenceRows* const reference =
      std::ranges::any_of(wanted, isAgainstReference) ? parts_->referenceRows(lane) : nullptr;
  if (!reference) return figures;
  figures.referenceSamples = reference->samples();
  addError(figures, wanted, reference->error());
  return figures;
}

FrameFigures Inspector::figuresBeside(int frame, const std::vector<Figure>& wanted, int samples,
                                      FigureCursor& cursor, const Progress& progress) {
  Parts& parts = *parts_;
  const Subject subject = parts.onlyLane(0);
  FrameFigures figures{.frame = frame, .values = {}};
  const bool isCompared = std::ranges::any_of(wanted, isAgainstReference);
  const bool isOverTime =
      std::ranges::any_of(wanted, [](Figure figure) { return figureInfo(figure).isOverTime; });
  cursor.references.setBudget(0); // the one that is being drawn
  const Parts::FlickerNeed need{0, frame, std::ranges::count(wanted, Figure::Flicker) > 0 ? samples : 0};
  // First: it is what takes long, and what is there of it stays.
  if (isOverTime) parts.fillFlicker(cursor.flicker, cursor.references, need, progress);
  const ReferencePicture* reference =
      isCompared ? &parts.referenceOf(subject, frame, samples, cursor.references, progress) : nullptr;
  const gl::PassGroup group(pass_group::kExposure);
  ShownFrame made = parts.makeBeside(frame, cursor.trace, progress);
  const std::vector<IntermediateId> ids = rowsOf(wanted);
  std::vector<Image> rows;
  if (!ids.empty()) {
    const Exposure exposure = parts.maker.expose(subject, made, ids, 0);
    for (const IntermediateId id : ids) rows.push_back(exposure.image(id));
  }
  addRows(figures, wanted, ids, rows);
  Image output;
  if (reference || isOverTime)
    output = parts.maker.expose(subject, made, {IntermediateId::output}, 0).image(IntermediateId::output);
  parts.maker.recycle(std::move(made));
  if (reference) {
    figures.referenceSamples = samples;
    addError(figures, wanted, pictureError(output, reference->mean()));
  }
  if (isOverTime) {
    cursor.flicker.frames.at(frame).shown = shownColors(output);
    addFlicker(figures, wanted, flickerMaps(cursor.flicker, parts.firstOfFlicker(frame), frame, progress),
               need.samples);
  }
  return figures;
}

} // namespace taa
