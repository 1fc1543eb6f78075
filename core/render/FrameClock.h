// What is known of a frame by its number: time, cuts, restarts, jitter.
#pragma once

#include "core/scene/Scene.h"

#include <span>

namespace taa {

struct FrameInfo;
struct FrameRequest;

/// Seconds since frame 0.
double frameTime(const Scene& scene, int frame);

/// Whether nothing before it is its past: the first frame, and cuts.
bool isCut(const Scene& scene, int frame);

/// Throws Error naming the frames there are where one of `frames` is none of `frameCount`.
void checkRestarts(std::span<const int> frames, int frameCount);

/// Whether no history may be used: the first frame, cuts, and frames at which somebody restarts it.
bool startsHistory(const Scene& scene, std::span<const int> restarts, int frame);

/// The frame motion refers to: the one before, or the frame itself at a cut. Things move on through a
/// restart.
int previousFrame(const Scene& scene, int frame);

/// Number, time, jitter and cut of a frame: all that can be known without drawing.
FrameInfo frameInfo(const Scene& scene, const FrameRequest& request, int frame);

} // namespace taa
