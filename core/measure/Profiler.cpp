// Names of passes for people, and their sums.
#include "core/measure/Profiler.h"

#include "core/gl/Memory.h"

#include <algorithm>
#include <utility>

namespace taa {

namespace {

// The pass's own label (RenderPass), and how it is called where people read it.
constexpr std::pair<std::string_view, std::string_view> kPassNames[] = {
    {"GBufferPass", "G-buffer"},
    {"SkyPass", "Sky"},
    {"GBufferPass blended", "Blended surfaces"},
    {"ReactivePass", "Reactive mask"},
    {"CameraMotionPass", "Camera motion"},
    {"FogPass march", "Fog march"},
    {"FogPass", "Fog"},
    {"ShadowPass", "Shadows, as the sun sees them"},
    {"NoisePass", "Noise and range"},
    {"TaaPass", "Resolve"},
    {"OutputPass", "Output"},
};

std::string timeName(const gl::PassTime& time) {
  if (!time.group.empty()) return time.group;
  const auto* const found =
      std::ranges::find(kPassNames, std::string_view(time.pass), [](const auto& row) { return row.first; });
  return found != std::end(kPassNames) ? std::string(found->second) : time.pass;
}

} // namespace

std::string_view timingWords(gl::TimingMethod method) {
  return method == gl::TimingMethod::Queries ? "timed by timer queries of the GPU"
                                             : "timed by the wall clock with glFinish around each pass, "
                                               "because this driver's timer queries lie";
}

std::vector<std::string_view> passNames() {
  std::vector<std::string_view> names{pass_group::kExposure,   pass_group::kViews,     pass_group::kProbe,
                                      pass_group::kThumbnails, pass_group::kReference, kBetweenPasses};
  for (const auto& [label, name] : kPassNames) names.push_back(name);
  return names;
}

std::vector<PassCost> addedUp(const std::vector<gl::PassTime>& times, double frameMs) {
  std::vector<PassCost> costs;
  double rest = frameMs;
  for (const gl::PassTime& time : times) {
    const std::string name = timeName(time);
    auto row = std::ranges::find(costs, name, &PassCost::name);
    if (row == costs.end()) row = costs.insert(row, {name});
    row->milliseconds += time.milliseconds;
    ++row->runs;
    if (time.group.empty()) rest -= time.milliseconds;
  }
  costs.push_back({std::string(kBetweenPasses), std::max(rest, 0.0), 0});
  return costs;
}

FrameProfile profileOf(gl::PassTimer& timer, int frame, double frameMs, std::size_t checkpointBytes) {
  FrameProfile profile;
  profile.frame = frame;
  profile.method = timer.method();
  profile.passes = addedUp(timer.take(), frameMs);
  for (const PassCost& cost : profile.passes) profile.totalMs += cost.milliseconds;
  for (const gl::MemoryUse& use : gl::memoryUse())
    profile.memory.push_back({use.label, use.bytes, use.objects});
  profile.memoryBytes = gl::memoryInUse();
  profile.checkpointBytes = checkpointBytes;
  return profile;
}

} // namespace taa
