// What happened at a pixel, row by row: a line in words, and the row's formula with the pixel's numbers put
// in.
#pragma once

#include "core/render/FrameInputs.h"
#include "core/settings/Settings.h"
#include "core/taa/twin/Details.h"
#include "core/taa/twin/Twin.h"

#include <string>

namespace taa {

/// A probed pixel with all that formulas are made of.
struct ProbedPixel {
  const twin::PixelRecord& record;
  const twin::Details& details;
  const Settings& settings; ///< that made it
  FrameInfo info;
  glm::ivec2 pixel{0};
};

/// One row. The formula reads "expression = value", in plain arithmetic: + − × / ^ √( |…| min( max( clamp(x,
/// low, high) smooth( exp( log₂( floor( half(, and (a, b, c) for colors and positions. `subject` says
/// of what, where that is not the row's value as it stands: a channel, or a color before it goes back from
/// box space.
struct RowStory {
  std::string words;   ///< "history was pulled 31 % of the way",
  std::string formula; ///< empty where the row is read or searched for, which `words` say
  std::string subject; ///< "Y"; empty: the row itself
};

/// `digits`: significant ones of every number.
RowStory storyOf(IntermediateId id, const ProbedPixel& probed, int digits = 4);

} // namespace taa
