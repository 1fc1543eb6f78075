// Of which frame a plane is: its silhouettes lie on those of the picture that was drawn with it.
#pragma once

#include "core/doctor/Diagnosis.h"
#include "core/doctor/frames/DoctorFrame.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace taa::doctor {

enum class TimedPlane : std::uint8_t { Depth, ObjectIds, Output };
inline constexpr std::size_t kTimedPlanes = 3;

/// A plane that is that of the frame before or after.
struct PlaneTime {
  TimedPlane plane = TimedPlane::Depth;
  int delay = 0; ///< frames: 1: late, it is that of the frame before; −1: early
  /// What is compared of this frame's picture, and of that frame's: steps of luma at silhouettes, of outputs
  /// the difference of luma; means.
  double own = 0.0, other = 0.0;
  int frames = 0, voting = 0; ///< that were compared; that say so
};

class PlaneTimes {
 public:
  /// Three frames one after the other; of the second one.
  void add(const DoctorFrame& before, const DoctorFrame& now, const DoctorFrame& after);
  std::vector<PlaneTime> found() const;

 private:
  struct Sums {
    std::array<double, 3> sums{}; ///< of the pictures of the frame before, this one, the one after
    std::size_t count = 0;
    int frames = 0, late = 0, early = 0;
  };

  void addFrame(TimedPlane plane, const std::array<double, 3>& sums, std::size_t count);

  std::array<Sums, kTimedPlanes> planes_;
};

/// A finding for each.
void tellPlaneTimes(const std::vector<PlaneTime>& found, Diagnosis& out);

/// Frames with depth and object numbers that are their own, where these are those of another frame; one whose
/// own are not there is compared with nothing.
FrameReader withOwnPlanes(FrameReader read, const std::vector<PlaneTime>& found, int first, int frames);

} // namespace taa::doctor
