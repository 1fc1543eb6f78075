// What a surface's last moments say by themselves. No GL.
#pragma once

#include "core/taa/Intermediates.h"
#include "core/taa/twin/HistoryStages.h"
#include "core/verdict/pixel/Evidence.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <vector>

namespace taa {

double largestMagnitude(const glm::dvec3& value);

/// First channel of a row.
double recordValue(const twin::PixelRecord& record, IntermediateId id);

/// The upper quartile of how much more each moment stands out from those beside it than truth does there, as
/// shown, 0 to 1, or where there are few of them what no single one makes: what comes and goes with the
/// jitter, not what comes once and fades, nor what a moving edge or texture does.
double flickerOf(const std::vector<SurfaceMoment>& moments);

/// Whether white is exceeded anywhere, by truth, by single samples or by those around that the filter takes
/// in.
bool isHighlight(const std::vector<SurfaceMoment>& moments);

/// Whether its sample, or what the filter makes of it, exceeds white in a channel.
bool isBrighterThanWhite(const SurfaceMoment& moment);

/// How many moments do, and in how many of them the sample itself does not: the filter took that in beside
/// it.
struct BrightFrames {
  int all = 0, filtered = 0;
};
BrightFrames brightFrames(const std::vector<SurfaceMoment>& moments);

/// A jitter pattern of no more places has shown all of them twice in the frames that are followed.
inline constexpr int kFewJitterPlaces = 8;

/// Which test rejected history, or why there was none.
twin::RejectReason rejectReasonOf(const twin::PixelRecord& record);

/// The frame's sample as it would be shown, unfiltered.
glm::dvec3 shownSample(const SurfaceMoment& moment);

/// The middle one of the weights of the current frame where tests keep history; 0 where they seldom do.
double usualWeight(const std::vector<SurfaceMoment>& moments);

/// Whether the samples since the start are weighed so unequally that they do the work of less than three
/// quarters of them: (Σw)²/Σw² of their weights.
bool areWeighedUnevenly(const std::vector<SurfaceMoment>& moments);

/// Whether no history counts.
bool isRestart(const twin::PixelRecord& record);

/// How many of them, from the latest, could have been averaged: back to where there was no history, or where
/// it was given up while something came into sight there, by the scene's geometry.
std::size_t availableSamples(const std::vector<SurfaceMoment>& moments);

/// Largest channel of what the mean of the colors that `row` has of the latest `count` is off, as shown, 0
/// to 1.
double errorOfMean(const std::vector<SurfaceMoment>& moments, std::size_t count, IntermediateId row);

} // namespace taa
