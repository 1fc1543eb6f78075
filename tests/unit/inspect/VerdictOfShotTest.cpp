// Which verdicts stand on a reference that is uncertain.
#include "core/inspect/VerdictOfShot.h"

#include <gtest/gtest.h>

using taa::ErrorPart;
using taa::PixelError;
using taa::PixelVerdict;
using taa::VerdictKind;

namespace {

constexpr double kStep = 1.0 / 255.0;

/// Of two parts, which with the error's size are all of it.
PixelError madeOf(double ghost, double blur) {
  PixelError error;
  of(error.sum, ErrorPart::Ghost) = glm::dvec3(ghost);
  of(error.sum, ErrorPart::Blur) = glm::dvec3(blur);
  error.resolved = glm::dvec3(ghost + blur);
  return error;
}

PixelVerdict ghostOff(double error, double flicker) {
  PixelVerdict verdict;
  verdict.kind = VerdictKind::Ghost;
  verdict.error = error * kStep;
  verdict.flicker = flicker * kStep;
  return verdict;
}

bool isDoubtful(double referenceError, const PixelVerdict& verdict,
                const PixelError& origin = madeOf(0.2, 0.0)) {
  return isInDoubt({.error = referenceError * kStep}, verdict, origin);
}

} // namespace

// Visible are 8 steps; twice the standard error counts.
TEST(ReferenceDoubt, IsWhetherTheErrorIsVisible) {
  EXPECT_TRUE(isDoubtful(2.0, ghostOff(11.9, 0.0)));
  EXPECT_FALSE(isDoubtful(2.0, ghostOff(12.1, 0.0)));
  EXPECT_TRUE(isDoubtful(2.0, ghostOff(4.1, 0.0)));
  PixelVerdict none = ghostOff(3.9, 0.0);
  none.kind = VerdictKind::None;
  EXPECT_FALSE(isDoubtful(2.0, none));
  EXPECT_FALSE(isDoubtful(0.0, ghostOff(8.0, 5.0))) << "a flat color is certain";
}

// Visible are 5 steps.
TEST(ReferenceDoubt, IsWhetherFlickerIsVisibleWhereTheReferenceChanges) {
  EXPECT_TRUE(isDoubtful(2.0, ghostOff(90.0, 8.9)));
  EXPECT_FALSE(isDoubtful(2.0, ghostOff(90.0, 9.1)));
  EXPECT_FALSE(isInDoubt({.error = 2.0 * kStep, .isMoving = false}, ghostOff(90.0, 8.9), madeOf(0.2, 0.0)));
}

// Of 40 steps the ghost is 60 %, the blur 40: it leads by 8, of which √2 · 2 standard errors may be noise.
TEST(ReferenceDoubt, IsWhetherAnotherPartLeads) {
  EXPECT_FALSE(isDoubtful(2.8, ghostOff(40.0, 90.0), madeOf(0.12, 0.08)));
  EXPECT_TRUE(isDoubtful(2.9, ghostOff(40.0, 90.0), madeOf(0.12, 0.08)));
}
