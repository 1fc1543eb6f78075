// What most of a pixel's error is, and where an error came in that is older than the frames that were
// followed. No GL.
#pragma once

#include "core/base/Progress.h"
#include "core/verdict/parts/ErrorParts.h"
#include "core/verdict/pixel/PixelError.h"

#include <optional>

namespace taa {

struct MainPart {
  ErrorPart part{};
  double share = 0.0; ///< of the error that it explains; more than 1 where others work against it
};

/// The part that most of the error is. What is older than the frames that are followed is the part's that
/// they go on making it by: which, made at that rate from the start, comes to half of it or more.
MainPart mainPart(const PixelError& error);

/// Times that an error is followed on, by as many frames as before, until it is known what it is.
inline constexpr int kOlderSteps = 3;

/// Where most of the error is older than what was followed: the error at its place before that, followed on
/// along the pixels that count there, and again where that is older still. Nothing: most of it is not, or
/// history starts there.
std::optional<PixelError> olderError(EvidenceSource& source, const PixelError& error,
                                     const Progress& progress = {});

} // namespace taa
