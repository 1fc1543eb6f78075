#include "core/inspect/WorstOfShot.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/inspect/ReferenceOfShot.h"
#include "core/inspect/Views.h"
#include "core/verdict/parts/VerdictMaps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

namespace taa {

namespace {
constexpr int kMaxWorst = 64; // that a key goes through

/// Categories in the order in which they are looked for; `now`: that of the pixel probed, 0 where it is none.
std::vector<int> categoryOrder(const Intermediate& row, int now, WorstStep step) {
  const int high = static_cast<int>(row.high);
  std::vector<int> order;
  if (step == WorstStep::Category && now > 0) {
    for (int away = 1; away <= high; ++away) order.push_back((now - 1 + away) % high + 1);
    return order;
  }
  if (now > 0) order.push_back(now);
  if (row.id != IntermediateId::rejectReason) order.push_back(static_cast<int>(HistoryVerdict::LetThrough));
  for (int category = 1; category <= high; ++category) order.push_back(category);
  return order;
}
} // namespace

WorstOfShot::WorstOfShot(Views& views, ReferenceOfShot& reference) : views_(views), reference_(reference) {}

IntermediateId WorstOfShot::rowOf(IntermediateId shown, WorstStep step) {
  if (step == WorstStep::Rejected) return IntermediateId::rejectReason;
  if (step == WorstStep::Clipped) return IntermediateId::clipAmount;
  if (step == WorstStep::NoNumber) return shown;
  const Visual visual = intermediate(shown).visual;
  const bool isAmount = visual == Visual::Scalar || visual == Visual::Signed;
  const bool isCategories = !categoryText(shown, 0).empty();
  return isCategories || (isOfReference(shown) && isAmount) ? shown : IntermediateId::referenceErrorAbs;
}

WorstQuestion WorstOfShot::questionOf(IntermediateId shown, int lane, const std::optional<glm::ivec2>& after,
                                      WorstStep step) {
  WorstQuestion question{.row = rowOf(shown), .count = kMaxWorst, .lane = lane};
  const Intermediate& row = intermediate(shown);
  const bool isCategories = !categoryText(shown, 0).empty();
  if (!isCategories && step == WorstStep::Category)
    throw Error(
        say<"%1 has no classes to go through: show a verdict or the reject reason instead">(row.label));
  if (!isCategories) return question;
  const Image image = views_.image(shown, lane);
  const int now = after ? static_cast<int>(*image.at(after->x, after->y)) : 0;
  const std::vector<int> order = categoryOrder(row, now, step);
  const auto isWrong = [&](int category) {
    return std::ranges::find(image.pixels, static_cast<float>(category)) != image.pixels.end();
  };
  const auto found = std::ranges::find_if(order, isWrong);
  question.category = found == order.end() ? 0 : *found;
  return question;
}

namespace {

bool isByError(WorstStep step) {
  return step == WorstStep::Pixel || step == WorstStep::Category;
}

/// 1 where a channel is no number.
Badness missingNumbers(const Image& row) {
  Badness badness(row.width, row.height, 1);
  const auto channels = static_cast<std::size_t>(row.channels);
  for (std::size_t value = 0; value < row.pixels.size(); ++value)
    if (!std::isfinite(row.pixels[value])) badness.pixels[value / channels] = 1.0f;
  return badness;
}

std::string whyNoneFound(WorstStep step, IntermediateId row) {
  const std::string_view label = intermediate(row).label;
  switch (step) {
  case WorstStep::Rejected:
    return say<"history is rejected nowhere in this frame">();
  case WorstStep::Clipped:
    return say<"rectification moves history nowhere in this frame">();
  case WorstStep::NoNumber:
    return say<"no pixel of %1 is NaN or infinite in this frame">(label);
  default:
    return say<"nothing is wrong in this picture by %1">(label);
  }
}

} // namespace

Image WorstOfShot::errorOf(const Image& like, int lane) {
  constexpr IntermediateId kError = IntermediateId::referenceErrorAbs;
  return reference_.has(kError, lane) ? views_.image(kError, lane) : Image(like.width, like.height, 1);
}

std::vector<WorstPixel> WorstOfShot::searched(IntermediateId shown, int lane, WorstStep step) {
  constexpr int kApartPx = WorstQuestion{}.apartPx;
  const Image row = views_.image(rowOf(shown, step), lane);
  if (step == WorstStep::NoNumber) return worstPixels(missingNumbers(row), kMaxWorst, kApartPx);
  if (step == WorstStep::Clipped) return worstPixels(amounts(row), kMaxWorst, kApartPx);
  Image isRejected(row.width, row.height, 1);
  for (std::size_t pixel = 0; pixel < row.pixels.size(); ++pixel)
    isRejected.pixels[pixel] = row.pixels[pixel] > 0.0f ? 1.0f : 0.0f;
  return worstPixels(ofCategory(isRejected, 1, errorOf(row, lane)), kMaxWorst, kApartPx);
}

FoundWorst WorstOfShot::next(IntermediateId shown, int lane, const std::optional<glm::ivec2>& after,
                             WorstStep step) {
  const WorstQuestion question = isByError(step)
                                     ? questionOf(shown, lane, after, step)
                                     : WorstQuestion{.row = rowOf(shown, step), .category = {}, .lane = lane};
  const std::vector<WorstPixel> worst = !isByError(step)         ? searched(shown, lane, step)
                                        : question.category == 0 ? std::vector<WorstPixel>()
                                                                 : of(question);
  if (worst.empty()) throw Error(whyNoneFound(step, question.row));
  const auto now =
      std::ranges::find_if(worst, [&](const WorstPixel& one) { return after && one.pixel == *after; });
  const std::size_t next =
      now == worst.end() ? 0 : (static_cast<std::size_t>(now - worst.begin()) + 1) % worst.size();
  return {question, worst[next], step, static_cast<int>(next) + 1, static_cast<int>(worst.size())};
}

std::vector<WorstPixel> WorstOfShot::of(const WorstQuestion& question) {
  const Image row = views_.image(question.row, question.lane);
  if (!question.category) return worstPixels(amounts(row), question.count, question.apartPx);
  return worstPixels(ofCategory(row, *question.category, errorOf(row, question.lane)), question.count,
                     question.apartPx);
}

} // namespace taa
