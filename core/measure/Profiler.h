// Where the time of a frame goes, pass by pass. Nothing is timed before one is made.
#pragma once

#include "core/gl/PassTimer.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace taa {

/// Passes of one kind together.
struct PassCost {
  std::string name; ///< for people
  double milliseconds = 0.0;
  int runs = 0; ///< passes; 0: what no pass accounts for
};

/// Bytes of one kind of resource.
struct MemoryCost {
  std::string name;
  std::size_t bytes = 0;
  int objects = 0;
};

/// The frame made last, and what was looked at of it since.
struct FrameProfile {
  int frame = 0;
  gl::TimingMethod method = gl::TimingMethod::Finish;
  std::vector<PassCost> passes; ///< in the order in which each kind ran first
  double totalMs = 0.0;         ///< their sum
  std::vector<MemoryCost> memory;
  std::size_t memoryBytes = 0;     ///< their sum
  std::size_t checkpointBytes = 0; ///< of it: histories kept for going back
};

/// How times come about, in a sentence for people.
std::string_view timingWords(gl::TimingMethod method);

/// Groups that passes run in while something is looked at (gl::PassGroup), as they are shown.
namespace pass_group {
inline constexpr std::string_view kExposure = "Exposing for views", kViews = "Views", kProbe = "Probe",
                                  kThumbnails = "Thumbnails", kReference = "Reference";
}

/// Every name that a pass, a group or the rest has where people read it; the driver's own words are not.
std::vector<std::string_view> passNames();

/// What `timer` saw since the frame began. `frameMs` as in addedUp().
FrameProfile profileOf(gl::PassTimer& timer, int frame, double frameMs, std::size_t checkpointBytes);

/// What a frame took between its passes.
inline constexpr std::string_view kBetweenPasses = "Between the passes";

/// Adds up passes of a kind. `frameMs`: what making the frame took by the wall clock; what its passes, those
/// in no group, leave of it is the row kBetweenPasses.
std::vector<PassCost> addedUp(const std::vector<gl::PassTime>& times, double frameMs);

} // namespace taa
