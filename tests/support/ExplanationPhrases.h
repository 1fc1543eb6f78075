// What must be so where the probe uses a phrase: held against the values of every pixel that tests look at.
#pragma once

#include "core/explanation/RowExplanation.h"
#include "core/taa/twin/Color.h"
#include "tests/support/Calculator.h"

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string>
#include <utility>

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
inline bool isMoved(const ProbedPixel& p) {
  return twin::at(p.record, Id::historyRaw) != twin::at(p.record, Id::historyRectified);
}

inline constexpr Phrase kPhrases[] = {
    {"TAA is off", [](const ProbedPixel& p) { return !isTaaOn(p.settings); }},
    {"of what was drawn smaller", [](const ProbedPixel& p) { return p.details.upsampleTaps.count > 0; }},
    {"one tap", [](const ProbedPixel& p) { return p.details.historyTaps.count == 1; }},
    {"on the tone curve",
     [](const ProbedPixel& p) {
       return twin::mixesCompressed(p.settings.blend.tone) && valueOf(p, Id::alpha) > 0;
     }},
    {"no test runs",
     [](const ProbedPixel& p) {
       return p.settings.validate.offScreen == OffScreen::Keep && !isOn(p.settings.validate.depth);
     }},
    {"at random", [](const ProbedPixel& p) { return isOn(p.settings.history.dither); }},
    {"half float", [](const ProbedPixel& p) { return p.settings.history.precision == Precision::Half; }},
    {"rounded to the 8 bits",
     [](const ProbedPixel& p) {
       return p.settings.history.precision == Precision::Unorm8 && !isOn(p.settings.history.dither);
     }},
    {"tests passed", [](const ProbedPixel& p) { return valueOf(p, Id::rejectReason) == 0; }},
    {"pulled", [](const ProbedPixel& p) { return valueOf(p, Id::clipAmount) > 0 || !isMoved(p); }},
    {"of the way to", [](const ProbedPixel& p) { return valueOf(p, Id::clipAmount) > 0; }},
    {"kept as it is", [](const ProbedPixel& p) { return !isMoved(p); }},
    {"lies inside the box",
     [](const ProbedPixel& p) {
       const glm::vec3 h = twin::toBox(glm::vec3(twin::at(p.record, Id::historyRaw)), p.settings.space);
       const glm::vec3 low(twin::at(p.record, Id::boxMin)), high(twin::at(p.record, Id::boxMax));
       return h == glm::clamp(h, low, high);
     }},
    {"the neighbor at",
     [](const ProbedPixel& p) {
       return glm::vec2(twin::at(p.record, Id::dilatedOffset)) != glm::vec2(0.0f);
     }},
    {"no history yet", [](const ProbedPixel& p) { return p.details.isFirst; }},
    {"the current frame alone", [](const ProbedPixel& p) { return valueOf(p, Id::alpha) == 1; }},
    {"thin feature at rest", [](const ProbedPixel& p) { return valueOf(p, Id::geometricFlicker) > 0; }},
    {"frames miss", [](const ProbedPixel& p) { return valueOf(p, Id::geometricFlicker) > 0; }},
};

/// `explanation`: of row `id`. What the table says of a row is of no pixel.
inline void expectTrue(IntermediateId id, const RowExplanation& explanation, const ProbedPixel& probed,
                       const std::string& where) {
  if (explanation.words == intermediate(id).description) return;
  for (const Phrase& phrase : kPhrases)
    if (explanation.words.find(phrase.text) != std::string::npos) {
      EXPECT_TRUE(phrase.isTrue(probed)) << where << ": " << explanation.words;
    }
}

/// Each comparison holds between the numbers that it states, and where it names a row of one channel, that
/// row has the number. `digits` of them were asked for: nine tell floats apart.
inline void expectDecisionsHold(const RowExplanation& explanation, const ProbedPixel& probed,
                                const std::string& where) {
  const auto split = [](const std::string& side) {
    const std::size_t space = side.rfind(' ');
    return space == std::string::npos ? std::pair(std::string(), side)
                                      : std::pair(side.substr(0, space), side.substr(space + 1));
  };
  for (const std::string& decision : explanation.because) {
    std::size_t at = std::string::npos;
    for (const char* relation : {" < ", " > ", " = "}) at = std::min(at, decision.find(relation));
    if (at == std::string::npos) {
      EXPECT_NE(decision.find("is no number"), std::string::npos) << where << ": " << decision;
      continue;
    }
    const auto [nameA, textA] = split(decision.substr(0, at));
    const auto [nameB, textB] = split(decision.substr(at + 3));
    const double a = Calculator(textA).result().front(), b = Calculator(textB).result().front();
    const char relation = decision[at + 1];
    EXPECT_TRUE(relation == '<' ? a < b : relation == '>' ? a > b : a == b) << where << ": " << decision;
    for (const auto& [name, number] : {std::pair(nameA, a), std::pair(nameB, b)})
      for (const Intermediate& row : kResolveRows) {
        std::string label(row.label);
        label[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(label[0])));
        if (row.channels != 1 || name != label) continue;
        EXPECT_FLOAT_EQ(static_cast<float>(number), valueOf(probed, row.id)) << where << ": " << decision;
      }
  }
}

} // namespace taa::test
