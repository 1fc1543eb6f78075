#include "core/doctor/jitter/RestingPictures.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace taa::doctor {

namespace {

constexpr std::size_t kLeastPictures = 8, kLeastPlaces = 100;
/// Of a picture, in a grid: what is larger is looked at with gaps.
constexpr double kMostPlaces = 40000.0;
constexpr std::array<glm::ivec2, 5> kCross = {{{0, 0}, {-1, 0}, {1, 0}, {0, -1}, {0, 1}}};
/// Luma per px, squared, in the mean: with less along some direction there is nothing to measure.
constexpr double kLeastSlope = 1e-5;

/// A place with detail in the mean of all pictures.
struct DetailedPlace {
  std::size_t index = 0;
  double mean = 0.0;
  glm::dvec2 slope{0.0};
};

} // namespace

RestingPictures::Picture RestingPictures::pictureOf(const DoctorFrame& frame) {
  const glm::ivec2 size = frame.sizePx();
  const double pixels = static_cast<double>(size.x) * size.y;
  const int step = std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels / kMostPlaces))));
  Picture out{frame.frame, {}, {}};
  for (int y = 1 + step / 2; y + 1 < size.y; y += step)
    for (int x = 1 + step / 2; x + 1 < size.x; x += step) {
      for (const glm::ivec2& to : kCross) {
        const glm::ivec2 pixel = glm::ivec2(x, y) + to;
        out.luma.push_back(frame.isCovered(pixel) ? std::numeric_limits<float>::quiet_NaN()
                                                  : *frame.luma.at(pixel.x, pixel.y));
      }
      out.isDrawn.push_back(frame.depth.empty() || *frame.depth.at(x, y) != 0.0f);
    }
  return out;
}

void RestingPictures::add(const DoctorFrame& before, const DoctorFrame& now, bool isResting) {
  const bool isNext = pictures_.empty() || pictures_.back().frame == before.frame;
  hasMoved_ = hasMoved_ || !isResting || !isNext;
  if (hasMoved_) return;
  if (pictures_.empty()) pictures_.push_back(pictureOf(before));
  pictures_.push_back(pictureOf(now));
}

std::map<int, glm::vec2> RestingPictures::displacementsPx() const {
  if (pictures_.size() < kLeastPictures) return {};
  std::vector<double> mean(pictures_.front().luma.size(), 0.0);
  std::vector<bool> isDrawn(pictures_.front().isDrawn.size(), false);
  for (const Picture& picture : pictures_) {
    if (picture.luma.size() != mean.size()) return {};
    for (std::size_t i = 0; i < mean.size(); ++i)
      mean[i] += static_cast<double>(picture.luma[i]) / static_cast<double>(pictures_.size());
    // The sky may rest while all else shifts; its silhouette is that of what stands before it.
    for (std::size_t i = 0; i < isDrawn.size(); ++i) isDrawn[i] = isDrawn[i] || picture.isDrawn[i];
  }
  std::vector<DetailedPlace> places;
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (std::size_t i = 0; i < isDrawn.size(); ++i) {
    const double* cross = mean.data() + i * kCross.size();
    const glm::dvec2 slope(0.5 * (cross[2] - cross[1]), 0.5 * (cross[4] - cross[3]));
    // Comparisons are written so that NaN fails them.
    if (!isDrawn[i] || !(glm::dot(slope, slope) > kLeastSlope) || !std::isfinite(cross[0])) continue;
    places.push_back({i * kCross.size(), cross[0], slope});
    xx += slope.x * slope.x;
    xy += slope.x * slope.y;
    yy += slope.y * slope.y;
  }
  const double determinant = xx * yy - xy * xy;
  const double count = static_cast<double>(places.size());
  if (places.size() < kLeastPlaces || !(determinant > kLeastSlope * kLeastSlope * count * count)) return {};
  std::map<int, glm::vec2> out;
  for (const Picture& picture : pictures_) {
    glm::dvec2 sum(0.0);
    for (const DetailedPlace& place : places)
      sum -= place.slope * (static_cast<double>(picture.luma[place.index]) - place.mean);
    out[picture.frame] =
        glm::vec2((sum.x * yy - sum.y * xy) / determinant, (sum.y * xx - sum.x * xy) / determinant);
  }
  return out;
}

} // namespace taa::doctor
