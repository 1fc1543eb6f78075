#include "core/capture/planes/Planes.h"

#include "core/base/Error.h"
#include "core/base/Parallel.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/capture/planes/PlaneFiles.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <functional>
#include <new>
#include <string>
#include <utility>
#include <vector>

namespace taa::capture {

namespace {

/// What is read at once: a raw plane, or those planes that are in the same part of the same picture.
struct ReadingJob {
  std::vector<PlaneRequest> requests;
  std::vector<PlaneData> planes;
  std::exception_ptr failure;

  bool isRaw() const { return requests.front().source->raw.has_value(); }
  /// Bytes, roughly: large ones begin first.
  std::size_t cost() const {
    return isRaw() ? bytesPerPixel(*requests.front().source->raw) : 64 * requests.size();
  }
};

PlaneRequest requestOf(const Manifest& manifest, const CapturedFrame& frame, PlaneKind kind,
                       const PlaneSource& source) {
  return {kind, &source, planeFile(source, frame.number),
          source.rows.value_or(manifest.conventions.rows) == RowOrder::BottomFirst};
}

std::vector<ReadingJob> jobsOf(const Manifest& manifest, const CapturedFrame& frame) {
  std::vector<ReadingJob> jobs;
  for (std::size_t i = 0; i < kPlaneKinds; ++i) {
    const auto kind = static_cast<PlaneKind>(i);
    const PlaneSource* source = manifest.plane(frame, kind);
    if (!source) continue;
    PlaneRequest request = requestOf(manifest, frame, kind, *source);
    // Channels by their order, or of whichever part has them, are each plane's own matter.
    const auto shares = [&](const ReadingJob& job) {
      const PlaneRequest& other = job.requests.front();
      return !job.isRaw() && other.file == request.file && other.source->part == source->part;
    };
    const auto found = source->raw ? jobs.end() : std::ranges::find_if(jobs, shares);
    if (found == jobs.end())
      jobs.push_back({{std::move(request)}, {}, {}});
    else
      found->requests.push_back(std::move(request));
  }
  std::ranges::stable_sort(jobs,
                           [](const ReadingJob& a, const ReadingJob& b) { return a.cost() > b.cost(); });
  return jobs;
}

std::string sizeText(glm::ivec2 size) {
  return std::to_string(size.x) + " × " + std::to_string(size.y) + " px";
}

/// The part of `size` that begins at a place inside.
template <typename Value>
std::vector<Value> partOf(const std::vector<Value>& values, int width, const glm::ivec2& at,
                          const glm::ivec2& size, int channels) {
  std::vector<Value> out;
  out.reserve(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
              static_cast<std::size_t>(channels));
  for (int y = at.y; y < at.y + size.y; ++y) {
    const auto first = values.begin() + (static_cast<std::ptrdiff_t>(y) * width + at.x) * channels;
    out.insert(out.end(), first, first + static_cast<std::ptrdiff_t>(size.x) * channels);
  }
  return out;
}

void crop(PlaneData& plane, const glm::ivec2& at, const glm::ivec2& size) {
  if (!plane.integers.empty()) plane.integers = partOf(plane.integers, plane.width, at, size, 1);
  if (!plane.image.empty()) {
    plane.image.pixels = partOf(plane.image.pixels, plane.width, at, size, plane.image.channels);
    plane.image.width = size.x;
    plane.image.height = size.y;
  }
  plane.width = size.x;
  plane.height = size.y;
}

void read(const std::filesystem::path& folder, const Manifest& manifest, const CapturedFrame& frame,
          ReadingJob& job) {
  const auto fail = [&](const std::string& reason) {
    return Error(say<"frame %1, %2: %3">(frame.number, planeName(job.requests.front().kind), reason));
  };
  try {
    if (job.isRaw())
      job.planes.push_back(readRawPlane(folder, manifest, job.requests.front()));
    else
      job.planes = readPicture(folder, manifest, job.requests);
    for (std::size_t i = 0; i < job.planes.size(); ++i)
      if (const auto at = job.requests[i].source->atPx)
        crop(job.planes[i], *at, manifest.sizeOf(job.requests[i].kind));
  } catch (const Error& error) {
    throw fail(error.what());
  } catch (const std::bad_alloc&) {
    throw fail(say<"there is not enough memory for %1">(job.requests.front().file));
  } catch (const std::exception& error) { // of libraries that read pictures
    throw fail(say<"cannot read %1: %2">(job.requests.front().file, shownReason(error)));
  }
}

/// Side by side.
void readAll(std::vector<ReadingJob>& jobs, const std::filesystem::path& folder, const Manifest& manifest,
             const CapturedFrame& frame) {
  parallelFor(static_cast<int>(jobs.size()), [&](int i) {
    ReadingJob& job = jobs[static_cast<std::size_t>(i)];
    try {
      read(folder, manifest, frame, job);
    } catch (...) {
      job.failure = std::current_exception();
    }
  });
}

/// The planes, or the error of the first one that has one, whichever thread met it.
FramePlanes collected(std::vector<ReadingJob> jobs) {
  std::ranges::sort(jobs, {}, [](const ReadingJob& job) { return job.requests.front().kind; });
  FramePlanes planes;
  for (ReadingJob& job : jobs) {
    if (job.failure) std::rethrow_exception(job.failure);
    for (std::size_t i = 0; i < job.requests.size(); ++i)
      planes.emplace(job.requests[i].kind, std::move(job.planes[i]));
  }
  return planes;
}

} // namespace

void requireSize(const Manifest& manifest, const PlaneRequest& request, glm::ivec2 size) {
  const glm::ivec2 wanted = manifest.sizeOf(request.kind);
  const bool isWhole = request.kind == PlaneKind::Color || request.kind == PlaneKind::Output;
  if (const auto at = request.source->atPx) {
    if (glm::any(glm::greaterThan(*at + wanted, size)))
      throw Error(say<"it has %1; the part of %2 that begins at %3, %4 goes beyond it">(
          sizeText(size), sizeText(wanted), at->x, at->y));
  } else if (isWhole && size != wanted) {
    throw Error(say<"it has %1; the capture says %2">(sizeText(size), sizeText(wanted)));
  }
  const glm::ivec2 most =
      request.source->atPx ? glm::ivec2(kMaxCaptureSide) : glm::max(manifest.sizePx, manifest.outputSize());
  if (size.x < 1 || size.y < 1 || size.x > most.x || size.y > most.y)
    throw Error(say<"it has %1; the capture's pictures have at most %2">(sizeText(size), sizeText(most)));
  if (static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) > kMaxPlanePixels)
    throw Error(say<"it has %1; at most %2 million pixels are read">(sizeText(size), kMaxPlanePixels >> 20u));
}

PlaneData makePlane(PlaneKind kind, glm::ivec2 size, int channels) {
  PlaneData plane;
  plane.width = size.x;
  plane.height = size.y;
  if (kind == PlaneKind::ObjectId)
    plane.integers.resize(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  else
    plane.image = Image(size.x, size.y, channels);
  return plane;
}

std::uint32_t idOf(float stored) {
  constexpr float kEnd = 4294967296.0f;
  if (!(stored >= 0.0f && stored < kEnd) || std::trunc(stored) != stored)
    throw Error(say<"it holds %1 where ids are whole numbers from 0">(std::to_string(stored)));
  return static_cast<std::uint32_t>(stored);
}

PlaneData readPlane(const std::filesystem::path& folder, const Manifest& manifest, const CapturedFrame& frame,
                    PlaneKind kind) {
  const PlaneSource* source = manifest.plane(frame, kind);
  if (!source) throw Error(say<"frame %1 has no %2">(frame.number, planeName(kind)));
  ReadingJob job{{requestOf(manifest, frame, kind, *source)}, {}, {}};
  read(folder, manifest, frame, job);
  return std::move(job.planes.front());
}

FramePlanes readPlanes(const std::filesystem::path& folder, const Manifest& manifest,
                       const CapturedFrame& frame) {
  std::vector<ReadingJob> jobs = jobsOf(manifest, frame);
  readAll(jobs, folder, manifest, frame);
  return collected(std::move(jobs));
}

FramePlanes readPlanesInTurn(const std::filesystem::path& folder, const Manifest& manifest,
                             const CapturedFrame& frame, const std::function<void()>& proceed) {
  std::vector<ReadingJob> jobs = jobsOf(manifest, frame);
  for (ReadingJob& job : jobs) {
    proceed();
    read(folder, manifest, frame, job);
  }
  return collected(std::move(jobs));
}

} // namespace taa::capture
