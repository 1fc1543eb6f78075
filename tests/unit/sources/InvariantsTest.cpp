// Which tests hold which of the manual's invariants: each has some, and they exist.
#include "core/base/EmbeddedFiles.h"
#include "tests/support/TestNames.h"

#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace taa {
namespace {

using Tests = std::vector<std::string>;

const std::map<int, Tests>& invariants() {
  static const std::map<int, Tests> all{
      {1, {"Jitter.GivesTheExactFractionsOfHalton"}},
      {2, {"Jitter.HasTheMeanOfItsPeriod"}},
      {3, {"Jitter.SumsToZeroWhereThePatternIsSymmetric"}},
      {4, {"Jitter.FollowsThePublishedFormulas"}},
      {5,
       {"Jitter.StaysInsideThePixelTimesTheScale",
        "SceneRendererTest.DrawsTheSameBitsWithoutJitterAndWithScaleZero"}},
      {6,
       {"Jitter.MovesContentTheSameWayAtEveryDepth", "Jitter.MovesContentAsEachPrintedFormDoes",
        "JitterProjectionTest.DrawsEachSurfaceWhereTheMatrixPutsIt"}},
      {7,
       {"Jitter.MultipliesTheProjectionFromTheLeft", "Jitter.EditsTheElementsOfEitherProjection",
        "Jitter.ThirdColumnIsTheTranslationWithPerspective"}},
      {8, {"Jitter.DoesNotTouchDepth", "SceneRendererTest.DoesNotLetTheJitterTouchTheDepthOfAFrontalPlane"}},
      {9,
       {"MotionTest.IsExactlyZeroWhereNothingMovesWhateverTheJitter",
        "DeformedMotionTest.IsExactlyZeroWhereNothingMoves"}},
      {10, {"MotionTest.OfTheCameraLeaksTheJitterAsEachVariantDoes"}},
      {11,
       {"MotionTest.OfATranslatingPlaneIsTheSameEverywhere",
        "MotionTest.OfTheCameraIsThatOfThePlaneTheOtherWay",
        "MotionTest.OfAnOrthographicPlaneDependsOnTheWidthAlone",
        "MotionFieldTest.ATranslatingPlaneMovesByItsShareOfThePicture"}},
      {12, {"MotionTest.OfAYawIsThatOfTheDirectionsSkyIncluded", "MotionFieldTest.YawMovesPlaneAndSkyAlike"}},
      {13, {"MotionTest.OfARollTurnsThePicture", "MotionFieldTest.RollTurnsThePictureAboutItsCenter"}},
      {14,
       {"DeformedMotionTest.OfASkinWithOneJointIsThatOfARigidThing",
        "DeformedMotionTest.OfAVertexBetweenTwoJointsIsTheirWeightedMean",
        "DeformedMotionTest.OfAMorphTargetIsTheStepOfItsWeight",
        "DeformedMotionTest.OfACachedVertexIsItsVelocityTimesTheStep",
        "DeformedMotionTest.OfSwayingVerticesIsTheFormulaAtBothTimes"}},
      {15, {"MotionTest.AddsUpOverCameraAndObject", "DeformedMotionTest.AddsTheCameraOnce"}},
      {16,
       {"DeformedMotionTest.IsThatOfTheCameraAloneWhereTheModeSaysSo",
        "DeformedMotionTest.IsNothingWhereTheModeForcesNone",
        "MotionTest.IsTheSameFromObjectsAndFromDepthWhenOnlyTheCameraMoves"}},
      {17,
       {"RenderedNumbersTest.AMoveByWholePixelsIsThePreviousPictureBitForBit",
        "WarpTest.ThePreviousFrameAtPixelMinusMotionIsWhatThePixelWas"}},
      {18, {"RenderedNumbersTest.AHiddenThingsMotionStaysHidden"}},
      {19, {"RenderedNumbersTest.MotionInHalvesIsOffByHalfAStepAtMost"}},
      {20, {"TwinDilate.SpreadsTheForegroundsMotionByOnePixel"}},
      {21, {"TwinDilate.KeepsThePixelItselfAmongEqualsAndInTheSky"}},
      {22, {"SceneRendererTest.WritesReversedDepthWithTheSkyAtZero"}}, // depth is reversed always: nothing to
                                                                       // compare
      {23, {"TwinDilate.KeepsThePixelItselfAmongEqualsAndInTheSky"}},
      {24, {"FilterNumbers.TheLongestOfEqualMotionsIsThePixelsOwn"}},
      {25,
       {"TwinReproject.StartsAnewWhereTheHistoryPositionIsOutsideOrNoNumber",
        "ResolveTest.RestartsWhatComesFromOffTheScreenOrNowhere"}},
      {26,
       {"TwinHistory.CubicWeightsAreCatmullRoms",
        "FilterNumbers.ATunableCubicKeepsConstantsWhateverItsSharpness",
        "FilterNumbers.OnlyTheSharpnessOfCatmullRomKeepsRamps"}},
      {27, {"FilterNumbers.NineTapsAreSixteenTexels", "TwinHistory.CubicWeightsAreCatmullRoms"}},
      {28,
       {"TwinHistory.NormalizedFiveTapsKeepConstantsExactlyAndRampsClosely",
        "FilterNumbers.FiveTapsAsPrintedDarkenAConstant"}},
      {29, {"TwinHistory.OvershootsOnAStepUnlessDeringedAndNeverGoesBelowZero"}},
      {30, {"TwinHistory.BilinearAddsAQuarterSquarePixelPerHalfPixelStepAndCatmullRomNothing"}},
      {31,
       {"FilterNumbers.CurrentFiltersHaveThePublishedWeights",
        "FilterNumbers.CurrentFiltersAsPrintedAreNoneAndABoxOfFive",
        "FilterNumbers.CurrentFiltersAreSymmetricWithoutJitterAndTurnWithIt"}},
      {32, {"FilterNumbers.ThePolynomialOfLanczosIsNearItsSinc"}},
      {33, {"FilterNumbers.TheUnjitterTapBringsARampBackExactly"}},
      {34,
       {"TwinNeighborhood.AConstantHasNoDeviationAndAPointForABox",
        "TwinRectify.AFlatBoxTakesAllHistoryToItself"}},
      {35,
       {"TwinNeighborhood.BoxesAreNestedAndGrowWithGamma",
        "BoxNumbers.TheRoundedBoxLiesHalfwayBetweenFiveAndNine"}},
      {36,
       {"TwinNeighborhood.KBrightOfNGiveTheirMeanAndDeviation",
        "TwinNeighborhood.ABrightPixelIsOutsideItsOwnBoxBelowTheThresholdOfGamma"}},
      {37, {"TwinNeighborhood.SmallDeviationsOfBrightPixelsSurvive"}},
      {38,
       {"TwinRectify.BringsEverythingIntoTheBoxAndIsIdempotent",
        "TwinRectify.ClampFindsTheNearestPointOfTheBox", "TwinRectify.KeepsColorsInsideTheBoxExactly"}},
      {39, {"TwinRectify.ClipsEndOnTheSurfaceAndOnTheLineToTheirTarget"}},
      {40,
       {"TwinRectify.ClipsEndOnTheSurfaceAndOnTheLineToTheirTarget",
        "TwinRectify.ATargetOutsideIsBroughtIntoTheBoxFirst"}},
      {41,
       {"TwinRectify.TheHullIsNeverWiderThanTheBoxOfItsSamples",
        "TwinRectify.TheSlabsHoldEveryMixtureOfTheSamples",
        "TwinRectify.TheSlabsAreTheBoxWhenItsCornersAreSamples"}},
      {42,
       {"TwinNeighborhood.YCoCgGoesThereAndBackAndGraysHaveNoChroma", "BoxNumbers.LiftedChromaIsTwiceAsWide",
        "BoxNumbers.GraysHaveNoChromaInAnySpace"}},
      {43, {"BoxNumbers.ShrunkChromaIsAnEighthOfTheLumaRangeAboutThePixel"}},
      {44,
       {"TwinBlend.ConstantAlphaIsTheUnrolledExponentialAverage",
        "ResolveTest.FollowsTheClosedFormOfConstantAlpha"}},
      {45,
       {"TwinBlend.EffectiveSamplesFollowTheClosedForm",
        "RenderedNumbersTest.NoiseIsAveragedByAsManySamplesAsTheTableSays"}},
      {46, {"TwinBlend.GhostsDecayByTheirShareOfHistory", "WeightNumbers.HalfAGhostIsGoneAfterItsHalfLife"}},
      {47,
       {"ConvergenceTest.AConstantAlphaSettlesToACycleWhoseMeanIsTheAverage",
        "WeightNumbers.APeriodSettlesToTheWeightsOfItsSamples"}},
      {48, {"ConvergenceTest.AlphaByLengthOnAStillCameraIsTheAverageOfTheJitteredFrames"}},
      {49, {"RenderedNumbersTest.CoverageOfAnEdgeIsWithinAShareOfThePeriod"}},
      {50,
       {"TwinBlend.AlphaByLengthIsTheArithmeticMean", "TwinBlend.TheFloorOfAlphaEndsTheGrowthOfLength",
        "WeightNumbers.LengthAsPrintedEndsAtTheGoldenRatio"}},
      {51,
       {"TwinBlend.ReciprocalLengthIsTheRecursionOfTheWeight", "TwinBlend.ConfidenceFreezesEarlySamples"}},
      {52, {"TwinBlend.EightBitsStallAndDitherTakesTheBiasAway"}},
      {53, {"TwinWeight.TwoHalfFramesWeighAsOne"}},
      {54, {"ResolveTest.ForgetsItsHistoryAtACut", "Twin.PoisonedHistoryIsNotReadWhereItIsRejected"}},
      {55,
       {"TwinBlend.ToneWeightsBlendAsReinhardSpaceDoes",
        "WeightNumbers.EachToneWeightTamesAFireflyInItsOwnWay"}},
      {56, {"TwinBlend.ToneWeightsTameFireflies"}},
      {57,
       {"TwinNeighborhood.ToneSpaceGoesThereAndBackWithinItsErrorBound",
        "ToneCurves.GoThereAndBackWithinTheirErrorBound"}},
      {58,
       {"WeightNumbers.TheLumaDifferenceOfPlaydeadTrustsWhatLooksAlike",
        "WeightNumbers.TheLumaDifferenceAsPrintedTrustsWhatDiffers"}},
      {59,
       {"WeightNumbers.NearTheWallsHistoryIsKeptAndFarOutsideItIsNot",
        "WeightNumbers.AddedMotionIsThatOfSource002", "WeightNumbers.SquaredMotionAsPrintedIsNothing"}},
      {60,
       {"Twin.AConstantImageStaysExactlyConstantThroughEveryOption",
        "ResolveTest.KeepsAConstantImageThroughEveryOption"}},
      {61,
       {"Twin.GarbageIsGoneWithinOneFrameAndNeverLeavesTheResolve",
        "ResolveTest.IsFiniteAndNotNegativeWhateverComesIn"}},
      {62,
       {"TwinOutput.ConstantsStayExactlyWhateverTheAmount", "TwinOutput.AmountZeroIsTheIdentity",
        "TwinOutput.RcasStaysWithinItsRange", "OutputTest.NeverGoesIntoHistory"}},
      {63,
       {"TextureReadTest.UnjitteredTexturesStandStillUnderJitter",
        "TextureReadTest.ABiasChoosesBlurredOrSharperLevels"}},
      {64, {"NoiseTest.HasTheMomentsOfItsForm", "NoiseTest.AveragesToNothingInEachPixelOverTime"}},
      {65,
       {"UpsampleTest.NoKernelMattersAtFullSize",
        "UpsampleTest.IsTheNativePathWhereAsManyTexelsAreDrawnAtPixelCenters",
        "TwinUpsample.AConfidenceOfNothingKeepsHistory"}},
      {66, {"ResolveTest.IsAPlainLerpWithEveryStageOff"}},
      {67, {"TwinOfVariants.AgreesWithEachChoiceAlone", "TwinOfVariants.AgreesWithRandomCombinations"}},
  };
  return all;
}

TEST(Invariants, AreHeldByTestsThatExist) {
  const std::set<std::string> names = test::testNames();
  for (const auto& [number, held] : invariants())
    for (const std::string& name : held) EXPECT_TRUE(names.contains(name)) << number << ": " << name;
}

TEST(Invariants, AllHaveATest) {
  std::istringstream lines(embeddedText("resources/manual/invariants.md"));
  const std::regex pattern(R"(([0-9]+)\. \*\*.*)");
  std::smatch found;
  int count = 0;
  for (std::string line; std::getline(lines, line);)
    if (std::regex_match(line, found, pattern)) {
      EXPECT_EQ(std::stoi(found[1]), ++count) << "numbers never change: " << line;
      EXPECT_TRUE(invariants().contains(count)) << line;
    }
  EXPECT_EQ(count, static_cast<int>(invariants().size()));
}

} // namespace
} // namespace taa
