// What must be so where the probe uses a phrase: held against the values of every pixel that tests look at.
#pragma once

#include "core/story/ProbeStory.h"
#include "core/taa/twin/Color.h"

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace taa::test {

using Id = IntermediateId;

/// What must be so where a phrase is said.
struct Phrase {
  const char* text;
  bool (*isTrue)(const ProbedPixel& p);
};

inline float valueOf(const ProbedPixel& p, Id id) {
  return twin::at(p.record, id).x;
}
inline float maskOf(const ProbedPixel& p) {
  return std::max(valueOf(p, Id::reactive), valueOf(p, Id::responsive));
}
/// α as it would be had history not been rejected.
inline float alphaAnyway(const ProbedPixel& p) {
  return std::max(valueOf(p, Id::alphaFrameRate) * valueOf(p, Id::sampleConfidence),
                  valueOf(p, Id::alphaMask));
}
inline bool isMoved(const ProbedPixel& p) {
  return twin::at(p.record, Id::historyRaw) != twin::at(p.record, Id::historyRectified);
}

inline constexpr Phrase kPhrases[] = {
    {"raised where history was rejected",
     [](const ProbedPixel& p) {
       return valueOf(p, Id::rejectReason) != 0 && valueOf(p, Id::alpha) > alphaAnyway(p);
     }},
    {"history counts less",
     [](const ProbedPixel& p) {
       return valueOf(p, Id::rejectReason) != 0 && valueOf(p, Id::alpha) > alphaAnyway(p);
     }},
    {"counted no more before", [](const ProbedPixel& p) { return valueOf(p, Id::alpha) == alphaAnyway(p); }},
    {"raised by motion",
     [](const ProbedPixel& p) { return valueOf(p, Id::alphaMotion) > 0 && valueOf(p, Id::speed) > 0; }},
    {"raised where the mask", [](const ProbedPixel& p) { return maskOf(p) > 0; }},
    {"made brighter", [](const ProbedPixel& p) { return valueOf(p, Id::sharpenDetail) > 0; }},
    {"made darker", [](const ProbedPixel& p) { return valueOf(p, Id::sharpenDetail) < 0; }},
    {"smaller by motion",
     [](const ProbedPixel& p) {
       const NeighborhoodSettings& n = p.settings.neighborhood;
       return valueOf(p, Id::speed) > 0 && n.gammaMoving < n.gamma;
     }},
    {"wider by the mask", [](const ProbedPixel& p) { return maskOf(p) > 0; }},
    {"smaller for tall pictures", [](const ProbedPixel& p) { return p.details.picturePx.y > 1188; }},
    {"where the mask relaxes", [](const ProbedPixel& p) { return valueOf(p, Id::alphaRelax) < 1; }},
    {"as long as the frame it is meant for",
     [](const ProbedPixel& p) { return isOn(p.settings.weight.frameRate); }},
    {"another surface",
     [](const ProbedPixel& p) {
       return isOn(p.settings.validate.depth) && valueOf(p, Id::depthMismatch) > valueOf(p, Id::depthAllowed);
     }},
    {"a depth test would allow", [](const ProbedPixel& p) { return !isOn(p.settings.validate.depth); }},
    {"that does not run", [](const ProbedPixel& p) { return !isOn(p.settings.validate.depth); }},
    {"no test runs",
     [](const ProbedPixel& p) {
       return p.settings.validate.offScreen == OffScreen::Keep && !isOn(p.settings.validate.depth);
     }},
    {"no test compares objects",
     [](const ProbedPixel& p) {
       return !isOn(p.settings.validate.object) && !isOn(p.settings.validate.objectClass) &&
              valueOf(p, Id::historyObjectId) == 0;
     }},
    {"at random", [](const ProbedPixel& p) { return isOn(p.settings.history.dither); }},
    {"half float", [](const ProbedPixel& p) { return p.settings.history.precision == Precision::Half; }},
    {"rounded to the 8 bits",
     [](const ProbedPixel& p) {
       return p.settings.history.precision == Precision::Unorm8 && !isOn(p.settings.history.dither);
     }},
    {"nothing moves", [](const ProbedPixel& p) { return valueOf(p, Id::speed) == 0; }},
    {"motion of",
     [](const ProbedPixel& p) {
       return valueOf(p, Id::speed) > 0 || isUpsampled(p.settings) ||
              p.settings.dilate.method != DilateMethod::None || valueOf(p, Id::dilatedMotion) == 0;
     }},
    {"the mask asks for", [](const ProbedPixel& p) { return valueOf(p, Id::alphaMask) > 0; }},
    {"history was kept", [](const ProbedPixel& p) { return valueOf(p, Id::rejectReason) == 0; }},
    {"tests passed", [](const ProbedPixel& p) { return valueOf(p, Id::rejectReason) == 0; }},
    {"history was dropped", [](const ProbedPixel& p) { return valueOf(p, Id::alpha) == 1; }},
    {"less where luma differs", [](const ProbedPixel& p) { return valueOf(p, Id::alphaLumaFlicker) < 1; }},
    {"less where history is near", [](const ProbedPixel& p) { return valueOf(p, Id::alphaNearClamp) < 1; }},
    {"less where the box is large",
     [](const ProbedPixel& p) { return valueOf(p, Id::alphaHistoryContrast) < 1; }},
    {"less the farther", [](const ProbedPixel& p) { return valueOf(p, Id::alphaSampleDistance) < 1; }},
    {"less is applied", [](const ProbedPixel& p) { return valueOf(p, Id::rectifyStrength) < 1; }},
    {"pulled", [](const ProbedPixel& p) { return valueOf(p, Id::clipAmount) > 0 || !isMoved(p); }},
    {"of the way to", [](const ProbedPixel& p) { return valueOf(p, Id::clipAmount) > 0; }},
    {"kept as it is", [](const ProbedPixel& p) { return !isMoved(p); }},
    {"lies inside the box",
     [](const ProbedPixel& p) {
       const glm::vec3 h = twin::toBox(glm::vec3(twin::at(p.record, Id::historyRaw)), p.settings.space);
       const glm::vec3 low(twin::at(p.record, Id::boxMin)), high(twin::at(p.record, Id::boxMax));
       return h == glm::clamp(h, low, high);
     }},
    {"no less than the floor",
     [](const ProbedPixel& p) { return valueOf(p, Id::alpha) == valueOf(p, Id::alphaFloor); }},
    {"the neighbor at",
     [](const ProbedPixel& p) {
       return glm::vec2(twin::at(p.record, Id::dilatedOffset)) != glm::vec2(0.0f);
     }},
    {"of the pixel itself",
     [](const ProbedPixel& p) {
       return glm::vec2(twin::at(p.record, Id::dilatedOffset)) == glm::vec2(0.0f);
     }},
    {"surfaces are blurred", [](const ProbedPixel& p) { return valueOf(p, Id::blurTrust) < 1; }},
    {"no history yet", [](const ProbedPixel& p) { return p.details.isFirst; }},
    {"lies inside",
     [](const ProbedPixel& p) { return valueOf(p, Id::onScreen) == 1 || p.details.isFirst || !isMoved(p); }},
    {"the current frame alone", [](const ProbedPixel& p) { return valueOf(p, Id::alpha) == 1; }},
    {"thin feature at rest", [](const ProbedPixel& p) { return valueOf(p, Id::geometricFlicker) > 0; }},
    {"frames miss", [](const ProbedPixel& p) { return valueOf(p, Id::geometricFlicker) > 0; }},
    {"history starts anew", [](const ProbedPixel& p) { return valueOf(p, Id::alpha) == 1; }},
};

inline void expectTrue(const RowStory& story, const ProbedPixel& probed, const std::string& where) {
  for (const Phrase& phrase : kPhrases)
    if (story.words.find(phrase.text) != std::string::npos) {
      EXPECT_TRUE(phrase.isTrue(probed)) << where << ": " << story.words;
    }
}

} // namespace taa::test
