// A verdict on whatever pixel is asked for: a ghost, what decided, and two remedies.
#pragma once

#include "core/requests/Results.h"
#include "core/settings/Parameters.h"
#include "core/verdict/pixel/VerdictText.h"

#include <initializer_list>
#include <string>

namespace taa::app::test {

/// Of settings that differ from the first ones by these.
inline TriedRemedy fakeRemedy(std::initializer_list<const char*> changes, double error) {
  TriedRemedy tried;
  for (const char* change : changes) {
    tried.remedy.changes.emplace_back(change);
    applyAssignment(tried.remedy.settings, change);
  }
  tried.pixel = {.error = error / 255.0, .sharpness = 1.0};
  tried.picture = {.error = 3.0 / 255.0, .flicker = 1.5 / 255.0, .ghost = 0.5 / 255.0, .sharpness = 0.95};
  return tried;
}

/// The pixel is off by 40 of 255 steps; with the first remedy by 5, with the second by 10.
inline VerdictDelivery fakeVerdict() {
  VerdictDelivery delivery;
  VerdictAnswer& answer = delivery.answer.emplace();
  answer.verdict.kind = VerdictKind::Ghost;
  answer.verdict.stage = Stage::ValidateHistory;
  answer.verdict.rows = {{IntermediateId::alpha, 12, {12, 7}, 0.0625, {}},
                         {IntermediateId::depthMismatch, 9, {11, 7}, 0.5, 0.125},
                         {IntermediateId::rejectReason, 9, {11, 7}, 0.0, {}},
                         {IntermediateId::clipAmount, 12, {12, 7}, 0.25, {}}};
  answer.verdict.causeFrame = 9;
  answer.verdict.causeObject = 1;
  answer.sentence = verdictSentence(answer.verdict, 12, "rotor & hub", {});
  of(answer.error.sum, ErrorPart::Ghost) = glm::dvec3(0.25);
  of(answer.error.sum, ErrorPart::Lag) = glm::dvec3(-0.125);
  answer.error.resolved = glm::dvec3(0.625);
  answer.error.reference = glm::dvec3(0.5);
  RemedyAnswer& remedies = delivery.remedies.emplace();
  remedies.tried = 9;
  remedies.pixel = {.error = 40.0 / 255.0, .sharpness = 1.0};
  remedies.picture = {.error = 4.0 / 255.0, .flicker = 1.0 / 255.0, .ghost = 2.0 / 255.0, .sharpness = 0.9};
  remedies.best = {fakeRemedy({"validate.object=on", "rectify.method=clamp"}, 5.0),
                   fakeRemedy({"rectify.method=clamp"}, 10.0)};
  return delivery;
}

} // namespace taa::app::test
