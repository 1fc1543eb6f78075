// Which tests hold which invariant of the catalogue's list (1 to 67): each has some, and they exist.
#include "core/base/Files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace taa {
namespace {

namespace fs = std::filesystem;

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
      {20, {"ReferenceDilate.SpreadsTheForegroundsMotionByOnePixel"}},
      {21, {"ReferenceDilate.KeepsThePixelItselfAmongEqualsAndInTheSky"}},
      {22, {"SceneRendererTest.WritesReversedDepthWithTheSkyAtZero"}}, // depth is reversed always: nothing to
                                                                       // compare
      {23, {"ReferenceDilate.KeepsThePixelItselfAmongEqualsAndInTheSky"}},
      {24, {"FilterNumbers.TheLongestOfEqualMotionsIsThePixelsOwn"}},
      {25,
       {"ReferenceReproject.StartsAnewWhereTheHistoryPositionIsOutsideOrNoNumber",
        "ResolveTest.RestartsWhatComesFromOffTheScreenOrNowhere"}},
      {26,
       {"ReferenceHistory.CubicWeightsAreCatmullRoms",
        "FilterNumbers.ATunableCubicKeepsConstantsWhateverItsSharpness",
        "FilterNumbers.OnlyTheSharpnessOfCatmullRomKeepsRamps"}},
      {27, {"FilterNumbers.NineTapsAreSixteenTexels", "ReferenceHistory.CubicWeightsAreCatmullRoms"}},
      {28,
       {"ReferenceHistory.NormalizedFiveTapsKeepConstantsExactlyAndRampsClosely",
        "FilterNumbers.FiveTapsAsPrintedDarkenAConstant"}},
      {29, {"ReferenceHistory.OvershootsOnAStepUnlessDeringedAndNeverGoesBelowZero"}},
      {30, {"ReferenceHistory.BilinearAddsAQuarterSquarePixelPerHalfPixelStepAndCatmullRomNothing"}},
      {31,
       {"FilterNumbers.CurrentFiltersHaveThePublishedWeights",
        "FilterNumbers.CurrentFiltersAsPrintedAreNoneAndABoxOfFive",
        "FilterNumbers.CurrentFiltersAreSymmetricWithoutJitterAndTurnWithIt"}},
      {32, {"FilterNumbers.ThePolynomialOfLanczosIsNearItsSinc"}},
      {33, {"FilterNumbers.TheUnjitterTapBringsARampBackExactly"}},
      {34,
       {"ReferenceNeighborhood.AConstantHasNoDeviationAndAPointForABox",
        "ReferenceRectify.AFlatBoxTakesAllHistoryToItself"}},
      {35,
       {"ReferenceNeighborhood.BoxesAreNestedAndGrowWithGamma",
        "BoxNumbers.TheRoundedBoxLiesHalfwayBetweenFiveAndNine"}},
      {36,
       {"ReferenceNeighborhood.KBrightOfNGiveTheirMeanAndDeviation",
        "ReferenceNeighborhood.ABrightPixelIsOutsideItsOwnBoxBelowTheThresholdOfGamma"}},
      {37, {"ReferenceNeighborhood.SmallDeviationsOfBrightPixelsSurvive"}},
      {38,
       {"ReferenceRectify.BringsEverythingIntoTheBoxAndIsIdempotent",
        "ReferenceRectify.ClampFindsTheNearestPointOfTheBox",
        "ReferenceRectify.KeepsColorsInsideTheBoxExactly"}},
      {39, {"ReferenceRectify.ClipsEndOnTheSurfaceAndOnTheLineToTheirTarget"}},
      {40,
       {"ReferenceRectify.ClipsEndOnTheSurfaceAndOnTheLineToTheirTarget",
        "ReferenceRectify.ATargetOutsideIsBroughtIntoTheBoxFirst"}},
      {41,
       {"ReferenceRectify.TheHullIsNeverWiderThanTheBoxOfItsSamples",
        "ReferenceRectify.TheSlabsHoldEveryMixtureOfTheSamples",
        "ReferenceRectify.TheSlabsAreTheBoxWhenItsCornersAreSamples"}},
      {42,
       {"ReferenceNeighborhood.YCoCgGoesThereAndBackAndGraysHaveNoChroma",
        "BoxNumbers.LiftedChromaIsTwiceAsWide", "BoxNumbers.GraysHaveNoChromaInAnySpace"}},
      {43, {"BoxNumbers.ShrunkChromaIsAnEighthOfTheLumaRangeAboutThePixel"}},
      {44,
       {"ReferenceBlend.ConstantAlphaIsTheUnrolledExponentialAverage",
        "ResolveTest.FollowsTheClosedFormOfConstantAlpha"}},
      {45,
       {"ReferenceBlend.EffectiveSamplesFollowTheClosedForm",
        "RenderedNumbersTest.NoiseIsAveragedByAsManySamplesAsTheTableSays"}},
      {46,
       {"ReferenceBlend.GhostsDecayByTheirShareOfHistory", "WeightNumbers.HalfAGhostIsGoneAfterItsHalfLife"}},
      {47,
       {"ConvergenceTest.AConstantAlphaSettlesToACycleWhoseMeanIsTheAverage",
        "WeightNumbers.APeriodSettlesToTheWeightsOfItsSamples"}},
      {48, {"ConvergenceTest.AlphaByLengthOnAStillCameraIsTheAverageOfTheJitteredFrames"}},
      {49, {"RenderedNumbersTest.CoverageOfAnEdgeIsWithinAShareOfThePeriod"}},
      {50,
       {"ReferenceBlend.AlphaByLengthIsTheArithmeticMean",
        "ReferenceBlend.TheFloorOfAlphaEndsTheGrowthOfLength",
        "WeightNumbers.LengthAsPrintedEndsAtTheGoldenRatio"}},
      {51,
       {"ReferenceBlend.ReciprocalLengthIsTheRecursionOfTheWeight",
        "ReferenceBlend.ConfidenceFreezesEarlySamples"}},
      {52, {"ReferenceBlend.EightBitsStallAndDitherTakesTheBiasAway"}},
      {53, {"ReferenceWeight.TwoHalfFramesWeighAsOne"}},
      {54, {"ResolveTest.ForgetsItsHistoryAtACut", "Reference.PoisonedHistoryIsNotReadWhereItIsRejected"}},
      {55,
       {"ReferenceBlend.ToneWeightsBlendAsReinhardSpaceDoes",
        "WeightNumbers.EachToneWeightTamesAFireflyInItsOwnWay"}},
      {56, {"ReferenceBlend.ToneWeightsTameFireflies"}},
      {57,
       {"ReferenceNeighborhood.ToneSpaceGoesThereAndBackWithinItsErrorBound",
        "ToneCurves.GoThereAndBackWithinTheirErrorBound"}},
      {58,
       {"WeightNumbers.TheLumaDifferenceOfPlaydeadTrustsWhatLooksAlike",
        "WeightNumbers.TheLumaDifferenceAsPrintedTrustsWhatDiffers"}},
      {59,
       {"WeightNumbers.NearTheWallsHistoryIsKeptAndFarOutsideItIsNot",
        "WeightNumbers.AddedMotionIsThatOfSource002", "WeightNumbers.SquaredMotionAsPrintedIsNothing"}},
      {60,
       {"Reference.AConstantImageStaysExactlyConstantThroughEveryOption",
        "ResolveTest.KeepsAConstantImageThroughEveryOption"}},
      {61,
       {"Reference.GarbageIsGoneWithinOneFrameAndNeverLeavesTheResolve",
        "ResolveTest.IsFiniteAndNotNegativeWhateverComesIn"}},
      {62,
       {"ReferenceOutput.ConstantsStayExactlyWhateverTheAmount", "ReferenceOutput.AmountZeroIsTheIdentity",
        "ReferenceOutput.RcasStaysWithinItsRange", "OutputTest.NeverGoesIntoHistory"}},
      {63,
       {"TextureReadTest.UnjitteredTexturesStandStillUnderJitter",
        "TextureReadTest.ABiasChoosesBlurredOrSharperLevels"}},
      {64, {"NoiseTest.HasTheMomentsOfItsForm", "NoiseTest.AveragesToNothingInEachPixelOverTime"}},
      {65,
       {"UpsampleTest.NoKernelMattersAtFullSize",
        "UpsampleTest.IsTheNativePathWhereAsManyTexelsAreDrawnAtPixelCenters",
        "ReferenceUpsample.AConfidenceOfNothingKeepsHistory"}},
      {66, {"ResolveTest.IsAPlainLerpWithEveryStageOff"}},
      {67, {"TwinOfVariants.AgreesWithEachChoiceAlone", "TwinOfVariants.AgreesWithRandomCombinations"}},
  };
  return all;
}

/// "Suite.Name" of every test in the sources.
std::set<std::string> tests() {
  std::set<std::string> names;
  const std::regex pattern(R"(\nTEST(?:_[FP])?\((\w+),\s*(\w+)\))");
  for (const fs::directory_entry& entry :
       fs::recursive_directory_iterator(fs::path(TAA_SOURCE_DIR) / "tests")) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string text = readFile(entry.path().string(), 1 << 20);
    for (std::sregex_iterator found(text.begin(), text.end(), pattern), end; found != end; ++found)
      names.insert((*found)[1].str() + "." + (*found)[2].str());
  }
  return names;
}

TEST(Invariants, AreHeldByTestsThatExist) {
  const std::set<std::string> names = tests();
  for (const auto& [number, held] : invariants())
    for (const std::string& name : held) EXPECT_TRUE(names.contains(name)) << number << ": " << name;
}

TEST(Invariants, AllHaveATest) {
  for (int number = 1; number <= 67; ++number) EXPECT_TRUE(invariants().contains(number)) << number;
}

} // namespace
} // namespace taa
