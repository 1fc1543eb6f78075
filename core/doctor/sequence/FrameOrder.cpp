#include "core/doctor/sequence/FrameOrder.h"

#include "core/base/Median.h"
#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/capture/import/FrameSamples.h"
#include "core/doctor/motion/MotionWords.h"
#include "core/doctor/sequence/DrawnPart.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace taa::doctor {

namespace {

constexpr double kComparedPixels = 20000.0;
constexpr std::size_t kEnoughCompared = 200;
/// Of the pixels: where so many move it is not the same picture a frame later.
constexpr double kMovingShare = 0.02;
/// A frame follows another one than the one before where that leaves so many times less, and of luma so much.
constexpr double kFollowsFactor = 2.0, kFollowsLuma = 0.008;
/// Of the squares that can be asked: in a cut so few are found again, in other pairs so many.
constexpr double kCutShare = 0.15, kUsualShare = 0.5;
constexpr std::size_t kEnoughAsked = 12;
/// A cut leaves so many times as much as the pair in the middle.
constexpr double kCutFactor = 3.0;
/// Detail that is alike by so much is of the same picture in another light.
constexpr double kAlikeDetail = 0.5;

int stepFor(const Image& image) {
  return std::max(
      1, static_cast<int>(std::sqrt(static_cast<double>(image.width) * image.height / kComparedPixels)));
}

/// Median over pixels with detail, by the step of jitter that leaves least of some: where frames are out of
/// order, it may be stated in order or not. Infinite where too few lead into the picture.
double leftBetween(const Image& luma, const Image& motionPx, const Image& other,
                   const std::vector<glm::vec2>& jitterSteps) {
  std::vector<std::vector<double>> left(jitterSteps.size());
  const int step = stepFor(luma);
  const glm::ivec2 size(luma.width, luma.height);
  for (int y = 1; y + 1 < size.y; y += step)
    for (int x = 1; x + 1 < size.x; x += step) {
      const float detail = std::abs(*luma.at(x + 1, y) - *luma.at(x - 1, y)) +
                           std::abs(*luma.at(x, y + 1) - *luma.at(x, y - 1));
      const glm::vec2 motion(motionPx.at(x, y)[0], motionPx.at(x, y)[1]);
      if (detail < kDetailLuma || !isMotion(motion)) continue;
      for (std::size_t i = 0; i < jitterSteps.size(); ++i) {
        const glm::vec2 place = glm::vec2(x, y) + 0.5f - motion + jitterSteps[i];
        if (isInPicture(place, size))
          left[i].push_back(
              static_cast<double>(std::abs(*luma.at(x, y) - capture::betweenPixels(other, place))));
      }
    }
  double least = std::numeric_limits<double>::infinity();
  for (std::vector<double>& one : left)
    if (one.size() >= kEnoughCompared) least = std::min(least, median(std::move(one)));
  return least;
}

/// Correlation of squares with the frame before, along the motion given, the median of those with detail:
/// about 1 of the same picture in any light, about 0 of another one. 0 where too few lead into the picture.
double alikeDetail(const Image& luma, const Image& motionPx, const Image& before,
                   const glm::vec2& jitterStep) {
  constexpr int kSquare = 12;
  constexpr std::size_t kEnoughInSquare = 72, kEnough = 12;
  constexpr double kLeastDeviation = 0.01; // of luma
  const glm::ivec2 size(luma.width, luma.height);
  std::vector<double> correlations;
  for (int top = 0; top + kSquare <= size.y; top += kSquare)
    for (int left = 0; left + kSquare <= size.x; left += kSquare) {
      double count = 0.0, sums[2] = {}, squares[2] = {}, products = 0.0;
      for (int y = top; y < top + kSquare; ++y)
        for (int x = left; x < left + kSquare; ++x) {
          const glm::vec2 motion(motionPx.at(x, y)[0], motionPx.at(x, y)[1]);
          const glm::vec2 place = glm::vec2(x, y) + 0.5f - motion + jitterStep;
          if (!isMotion(motion) || !isInPicture(place, size)) continue;
          const double values[2] = {static_cast<double>(*luma.at(x, y)),
                                    static_cast<double>(capture::betweenPixels(before, place))};
          ++count;
          products += values[0] * values[1];
          for (int i = 0; i < 2; ++i) {
            sums[i] += values[i];
            squares[i] += values[i] * values[i];
          }
        }
      if (count < static_cast<double>(kEnoughInSquare)) continue;
      const auto deviation = [&](int i) {
        return std::sqrt(std::max(0.0, squares[i] / count - sums[i] * sums[i] / (count * count)));
      };
      if (deviation(0) < kLeastDeviation || deviation(1) < kLeastDeviation) continue;
      correlations.push_back((products / count - sums[0] * sums[1] / (count * count)) /
                             (deviation(0) * deviation(1)));
    }
  return correlations.size() < kEnough ? 0.0 : median(std::move(correlations));
}

bool moves(const Image& motionPx) {
  std::size_t moving = 0;
  for (int y = 0; y < motionPx.height; ++y)
    for (int x = 0; x < motionPx.width; ++x) {
      const glm::vec2 motion(motionPx.at(x, y)[0], motionPx.at(x, y)[1]);
      if (isMotion(motion) && glm::length(motion) > kMovesPx) ++moving;
    }
  return static_cast<double>(moving) >=
         kMovingShare * static_cast<double>(motionPx.width) * static_cast<double>(motionPx.height);
}

std::size_t hashOf(const Image& image) {
  return std::hash<std::string_view>()(
      {reinterpret_cast<const char*>(image.pixels.data()), image.pixels.size() * sizeof(float)});
}

FaultWords wordsOf(OrderFault fault) {
  switch (fault) {
  case OrderFault::Doubled:
    return {"frameDoubled", say<"A frame twice">(), say<"Things stand for a frame and then jump.">(),
            say<"Write each frame once; where the picture was not drawn anew, motion is 0 and history does "
                "not go on.">()};
  case OrderFault::Older:
    return {
        "frameOlder", say<"An old frame again">(), say<"Things jump back for a frame.">(),
        say<"Wait until a picture is drawn before it is read or handed on: of a ring of pictures an old one "
            "is taken otherwise.">()};
  case OrderFault::Swapped:
    return {"framesSwapped", say<"Frames in each other's place">(), say<"Things jump back for a frame.">(),
            say<"Number frames in the order in which they were drawn.">()};
  case OrderFault::Partial:
    return {
        "drawnPartChanges", say<"Another part of the picture drawn from frame to frame">(),
        say<"The whole picture jumps when the resolution changes; beyond what was drawn stands what was there.">(),
        say<"A capture has one size: turn dynamic resolution off while you capture, or write the part that was "
            "drawn, enlarged to one size. In the resolve read history with the size that it was drawn with.">()};
  case OrderFault::Cut:
    break;
  }
  return {"cutNotStated", say<"A cut that nobody states">(),
          say<"The picture before the cut shows through for some frames.">(),
          say<"Start history anew in that frame, and state it: \"cut\": true in the manifest.">()};
}

std::string framesOf(std::span<const OrderFound> found, const std::vector<int>& asked,
                     const FrameNames& names) {
  std::vector<int> frames;
  for (const OrderFound& one : found) frames.push_back(one.frame);
  return names.of(frames, asked);
}

/// "288 × 162 px are drawn in frames 3 to 4; 256 × 144 px are drawn in frame 5"
std::string partsOf(const std::vector<OrderFound>& found, const std::vector<int>& asked,
                    const FrameNames& names) {
  std::string text;
  for (auto at = found.begin(); at != found.end();) {
    auto end = at;
    while (end != found.end() && end->drawnPx == at->drawnPx) ++end;
    text += (text.empty() ? "" : "; ") + say<"%1 × %2 px are drawn in %3">(at->drawnPx.x, at->drawnPx.y,
                                                                           framesOf({at, end}, asked, names));
    at = end;
  }
  return text;
}

/// Where to look.
RegionPlace wholeFrame(int frame, const Diagnosis& out) {
  RegionPlace place;
  place.name = say<"frame %1">(out.frameNames.of(frame));
  place.frame = frame;
  place.box = {0, 0, out.sizePx.x, out.sizePx.y};
  place.pixel = out.sizePx / 2;
  place.share = 1.0 / std::max(1, out.frames);
  place.isWholeFrame = true;
  return place;
}

std::string swappedReason(const OrderFound& found, const FrameNames& names) {
  return say<"Along its motion frame %1 continues frame %2, which comes after it, and leaves %3 of the frame "
             "before and %4 of that one (median difference of luma, × 1000).">(
      names.of(found.frame), names.of(found.frame + 1), shortNumber(1000.0 * found.asNumbered),
      shortNumber(1000.0 * found.asFound));
}

/// `found`: of one fault.
std::string reasonOf(const std::vector<OrderFound>& found, const std::vector<int>& asked,
                     const FrameNames& names) {
  std::string text;
  switch (found.front().fault) {
  case OrderFault::Doubled:
    return say<"In %1 each pixel has the color that it had in the frame before, to the last bit, and motion "
               "says that the picture moves.">(framesOf(found, asked, names));
  case OrderFault::Older:
    for (const OrderFound& one : found)
      text +=
          (text.empty() ? "" : " ") +
          say<"Frame %1 has in each pixel the color of frame %2, to the last bit, and does not continue the "
              "frame before.">(names.of(one.frame), names.of(one.earlier));
    return text;
  case OrderFault::Swapped:
    for (const OrderFound& one : found) text += (text.empty() ? "" : " ") + swappedReason(one, names);
    return text;
  case OrderFault::Partial:
    return say<"Right of what is drawn and below it everything is as in the frame before, to the last bit, "
               "where its motion says that it moves: %1.">(partsOf(found, asked, names));
  case OrderFault::Cut:
    break;
  }
  return say<"In %1 hardly anything of the frame before is found again, wherever it may have moved, and in "
             "other frames nearly everything is.">(framesOf(found, asked, names));
}

} // namespace

void OrderEvidence::add(const DoctorFrame& frame) {
  if (frame.motionPx.empty()) return;
  constexpr std::size_t kMostKept = 3;
  kept_.push_back({frame.frame, frame.jitterPx, frame.luma, frame.motionPx});
  if (kept_.size() > kMostKept) kept_.pop_front();
  Followed& followed = frames_[frame.frame];
  followed.startsHistory = frame.startsHistory;
  const auto [shown, isNew] = pictures_.try_emplace(hashOf(frame.luma), frame.frame);
  if (!isNew && shown->second < frame.frame - 1 && moves(frame.motionPx)) followed.earlier = shown->second;
  shown->second = frame.frame;
  const Kept& now = kept_.back();
  const auto compare = [&](const Kept& one, const Kept& other) {
    if (one.luma.width != other.luma.width || one.luma.height != other.luma.height) return;
    std::vector<glm::vec2> steps;
    for (const Kept& from : kept_)
      for (const Kept& to : kept_) {
        const glm::vec2 jitterStep = from.jitterPx - to.jitterPx;
        if (std::ranges::find(steps, jitterStep) == steps.end()) steps.push_back(jitterStep);
      }
    frames_[one.frame].left[other.frame - one.frame] = leftBetween(one.luma, one.motionPx, other.luma, steps);
  };
  for (std::size_t i = 0; i + 1 < kept_.size(); ++i) compare(now, kept_[i]);
  if (kept_.size() < 2) return;
  const Kept& before = kept_[kept_.size() - 2];
  compare(before, now);
  followed.alike = alikeDetail(now.luma, now.motionPx, before.luma, before.jitterPx - now.jitterPx);
  followed.drawnPx = drawnPart(now.luma, now.motionPx, before.luma);
  followed.isBefore = now.luma.pixels == before.luma.pixels && moves(now.motionPx);
}

double OrderEvidence::leftOf(int frame, int distance) const {
  const auto followed = frames_.find(frame);
  if (followed == frames_.end()) return std::numeric_limits<double>::infinity();
  const auto left = followed->second.left.find(distance);
  return left == followed->second.left.end() ? std::numeric_limits<double>::infinity() : left->second;
}

std::vector<OrderFound> OrderEvidence::swapped() const {
  const auto follows = [&](int frame, int distance) {
    const double numbered = leftOf(frame, -1), other = leftOf(frame, distance);
    return std::isfinite(numbered) && std::isfinite(other) && numbered >= kFollowsFactor * other &&
           numbered - other >= kFollowsLuma;
  };
  std::vector<OrderFound> out;
  for (const auto& [frame, followed] : frames_) {
    // The second of them continues what comes before both; what comes after both continues the first.
    if (follows(frame, 1) && follows(frame + 1, -2) && follows(frame + 2, -2))
      out.push_back({OrderFault::Swapped, frame, leftOf(frame, -1), leftOf(frame, 1), {}});
  }
  return out;
}

bool OrderEvidence::isCut(int frame) const {
  std::vector<double> usual, left;
  for (const auto& [other, squares] : squares_) {
    if (other == frame || squares.asked < kEnoughAsked) continue;
    usual.push_back(static_cast<double>(squares.found) / static_cast<double>(squares.asked));
    left.push_back(leftOf(other, -1));
  }
  const FoundAgain& squares = squares_.at(frame);
  return squares.asked >= kEnoughAsked && !usual.empty() && median(usual) >= kUsualShare &&
         static_cast<double>(squares.found) <= kCutShare * static_cast<double>(squares.asked) &&
         leftOf(frame, -1) >= kCutFactor * median(left) && leftOf(frame, -1) >= kFollowsLuma &&
         frames_.at(frame).alike < kAlikeDetail;
}

bool OrderEvidence::follows(int frame) const {
  std::vector<double> left;
  for (const auto& [other, followed] : frames_)
    if (other != frame && std::isfinite(leftOf(other, -1))) left.push_back(leftOf(other, -1));
  const double own = leftOf(frame, -1);
  return left.empty() || !(own >= kFollowsFactor * median(std::move(left)) && own >= kFollowsLuma);
}

// What stands in all frames is an interface, or the frame around a picture.
bool OrderEvidence::changesDrawnPart() const {
  std::vector<std::optional<glm::ivec2>> sizes;
  for (const auto& [frame, followed] : frames_)
    if (frame != frames_.begin()->first) sizes.push_back(followed.drawnPx);
  return std::ranges::any_of(sizes, [&](const auto& size) { return size != sizes.front(); });
}

std::vector<OrderFound> OrderEvidence::found() const {
  std::vector<OrderFound> out = swapped();
  const auto isTold = [&](int frame) {
    return std::ranges::any_of(out, [frame](const OrderFound& one) {
      return one.fault == OrderFault::Swapped && frame >= one.frame && frame <= one.frame + 2;
    });
  };
  std::vector<OrderFound> others;
  const bool isChanging = changesDrawnPart();
  for (const auto& [frame, followed] : frames_) {
    if (followed.startsHistory || isTold(frame)) continue;
    if (followed.drawnPx && isChanging)
      others.push_back({OrderFault::Partial, frame, 0.0, 0.0, *followed.drawnPx});
    else if (followed.isBefore)
      others.push_back({OrderFault::Doubled, frame, leftOf(frame, -1), 0.0, {}});
    else if (followed.earlier && !follows(frame))
      others.push_back({OrderFault::Older, frame, leftOf(frame, -1), 0.0, {}, *followed.earlier});
    else if (squares_.contains(frame) && isCut(frame))
      others.push_back({OrderFault::Cut, frame, leftOf(frame, -1), 0.0, {}});
  }
  out.insert(out.end(), others.begin(), others.end());
  std::ranges::sort(out, {}, &OrderFound::frame);
  return out;
}

std::vector<int> OrderEvidence::asked() const {
  std::vector<int> out;
  for (const auto& [frame, followed] : frames_) out.push_back(frame);
  return out;
}

void tellOrder(const std::vector<OrderFound>& found, const std::vector<int>& asked, Diagnosis& out) {
  for (const OrderFault fault :
       {OrderFault::Doubled, OrderFault::Older, OrderFault::Swapped, OrderFault::Cut, OrderFault::Partial}) {
    std::vector<OrderFound> alike;
    std::ranges::copy_if(found, std::back_inserter(alike),
                         [fault](const OrderFound& one) { return one.fault == fault; });
    if (alike.empty()) continue;
    Finding finding;
    nameBy(wordsOf(fault), finding);
    finding.confidence = fault == OrderFault::Cut ? Confidence::Likely : Confidence::Sure;
    finding.reason = reasonOf(alike, asked, out.frameNames);
    for (const OrderFound& one : alike) finding.regions.push_back(wholeFrame(one.frame, out));
    out.findings.push_back(std::move(finding));
  }
}

FrameReader inOrder(FrameReader read, const std::vector<OrderFound>& found) {
  std::map<int, int> places;
  std::vector<int> starts;
  for (const OrderFound& one : found) {
    if (one.fault == OrderFault::Swapped) {
      places[one.frame] = one.frame + 1;
      places[one.frame + 1] = one.frame;
      // Whether jitter and matrices have changed places, too, nobody knows.
      starts.insert(starts.end(), {one.frame, one.frame + 1, one.frame + 2});
    } else {
      starts.push_back(one.frame);
      if (one.fault == OrderFault::Partial || one.fault == OrderFault::Older) starts.push_back(one.frame + 1);
    }
  }
  return [read = std::move(read), places = std::move(places), starts = std::move(starts)](int frame) {
    const auto place = places.find(frame);
    DoctorFrame out = read(place == places.end() ? frame : place->second);
    out.frame = frame;
    if (std::ranges::count(starts, frame) > 0) out.startsHistory = true;
    return out;
  };
}

} // namespace taa::doctor
