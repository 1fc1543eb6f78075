// Figures of the frame on show, and of others beside it.
#include "core/InspectorParts.h"
#include "core/inspect/FigureCursor.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace taa {

namespace {

bool isAgainstReference(Figure figure) {
  return figureInfo(figure).needsReference;
}

/// The rows that figures are made of.
std::vector<IntermediateId> rowsOf(const std::vector<Figure>& wanted) {
  std::vector<IntermediateId> ids;
  for (const Figure figure : wanted)
    if (const auto id = findIntermediate(figureInfo(figure).row)) ids.push_back(*id);
  return inTableOrder(std::move(ids));
}

void addRows(FrameFigures& figures, const std::vector<Figure>& wanted, const std::vector<IntermediateId>& ids,
             const std::vector<Image>& rows) {
  for (const Figure figure : wanted)
    if (const auto id = findIntermediate(figureInfo(figure).row))
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

} // namespace

FrameFigures Inspector::figures(const std::vector<Figure>& wanted, int lane) {
  FrameFigures figures{.frame = frame(), .lane = lane, .exact = isExact(lane), .values = {}};
  const std::vector<IntermediateId> ids = rowsOf(wanted);
  addRows(figures, wanted, ids, images(ids, lane));
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
  const Subject subject = parts.firstLane();
  FrameFigures figures{.frame = frame, .values = {}};
  const bool isCompared = std::ranges::any_of(wanted, isAgainstReference);
  const ReferencePicture* reference = nullptr;
  if (isCompared) { // first: it is what takes long, and what is there of it stays
    const gl::PassGroup group(pass_group::kReference);
    const ReferenceSubject drawn{referenceRequest(subject.request(0)), frame};
    reference = parts.references.find(drawn);
    if (!reference || reference->samples != samples) {
      cursor.references.setBudget(0); // the one that is being drawn
      cursor.references.refine(*subject.renderer, drawn, samples, progress);
      reference = cursor.references.find(drawn);
    }
  }
  const gl::PassGroup group(pass_group::kExposure);
  ShownFrame made = parts.makeBeside(frame, cursor.trace, progress);
  const std::vector<IntermediateId> ids = rowsOf(wanted);
  std::vector<Image> rows;
  if (!ids.empty()) {
    const Exposure exposure = parts.maker.expose(subject, made, ids, 0);
    for (const IntermediateId id : ids) rows.push_back(exposure.image(id));
  }
  addRows(figures, wanted, ids, rows);
  if (reference) {
    figures.referenceSamples = samples;
    const Image output =
        parts.maker.expose(subject, made, {IntermediateId::output}, 0).image(IntermediateId::output);
    addError(figures, wanted, pictureError(output, reference->mean()));
  }
  parts.maker.recycle(std::move(made));
  return figures;
}

} // namespace taa
