#include "core/inspect/FrameMetrics.h"

#include "core/gl/PassTimer.h"
#include "core/inspect/FlickerOfShot.h"
#include "core/inspect/ReferenceOfShot.h"
#include "core/inspect/Views.h"
#include "core/measure/FigureCursor.h"
#include "core/measure/Profiler.h"
#include "core/replay/ShotPlayer.h"

#include <algorithm>
#include <cstddef>
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

FrameMetrics::FrameMetrics(ShotPlayer& player, Views& views, ReferenceOfShot& reference,
                           FlickerOfShot& flicker, const References& references)
    : player_(player), views_(views), reference_(reference), flicker_(flicker), references_(references) {}

FrameFigures FrameMetrics::figures(const std::vector<Figure>& wanted, int lane) {
  FrameFigures figures{
      .frame = player_.shown().frame, .lane = lane, .exact = player_.lane(lane).exact, .values = {}};
  const std::vector<IntermediateId> ids = rowsOf(wanted);
  addRows(figures, wanted, ids, views_.images(ids, lane));
  if (const std::optional<int> samples = flicker_.samples(lane))
    addFlicker(figures, wanted, flicker_.maps(lane), *samples);
  ReferenceRows* const rows =
      std::ranges::any_of(wanted, isAgainstReference) ? reference_.rows(lane) : nullptr;
  if (!rows) return figures;
  figures.referenceSamples = rows->samples();
  addError(figures, wanted, rows->error());
  return figures;
}

FrameFigures FrameMetrics::figuresBeside(int frame, const std::vector<Figure>& wanted, int samples,
                                         FigureCursor& cursor, const Progress& progress) {
  const ShotState state = player_.onlyLane(0);
  FrameMaker& maker = player_.maker();
  FrameFigures figures{.frame = frame, .values = {}};
  const bool isCompared = std::ranges::any_of(wanted, isAgainstReference);
  const bool isOverTime =
      std::ranges::any_of(wanted, [](Figure figure) { return figureInfo(figure).isOverTime; });
  cursor.references.setBudget(0); // the one that is being drawn
  const FlickerNeed need{0, frame, std::ranges::count(wanted, Figure::Flicker) > 0 ? samples : 0};
  // First: it is what takes long, and what is there of it stays.
  if (isOverTime) flicker_.fill(cursor.flicker, cursor.references, need, progress);
  const ReferenceKey compared{referenceRequest(state.request(0)), frame};
  const ReferencePicture* reference =
      isCompared ? &cursor.references.foundOrDrawn(*state.renderer, compared, samples, references_, progress)
                 : nullptr;
  const gl::PassGroup group(pass_group::kExposure);
  ShownFrame made = player_.makeBeside(frame, cursor.trace, progress);
  const std::vector<IntermediateId> ids = rowsOf(wanted);
  std::vector<Image> rows;
  if (!ids.empty()) {
    const Exposure exposure = maker.expose(state, made, ids, 0);
    for (const IntermediateId id : ids) rows.push_back(exposure.image(id));
  }
  addRows(figures, wanted, ids, rows);
  Image output;
  if (reference || isOverTime)
    output = maker.expose(state, made, {IntermediateId::output}, 0).image(IntermediateId::output);
  maker.recycle(std::move(made));
  if (reference) {
    figures.referenceSamples = samples;
    addError(figures, wanted, pictureError(output, reference->mean()));
  }
  if (isOverTime) {
    cursor.flicker.frames.at(frame).shown = shownColors(output);
    addFlicker(figures, wanted, flicker_.mapsOf(cursor.flicker, frame, progress), need.samples);
  }
  return figures;
}

} // namespace taa
