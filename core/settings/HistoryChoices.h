// What can be chosen of the box around the colors, and where history is validated and rectified.
#pragma once

#include "core/settings/Parameters.h"
#include "core/settings/Used.h"

namespace taa {

inline constexpr Choice kColorSpaces[] = {
    {"rgb", "RGB", "Box in red, green, blue (manual 9.1).", Uses(), "toAxes"},
    {"yCoCg", "YCoCg", "Box in luma and chroma, tighter around the colors (manual 9.2).",
     Uses(USED(neighborhood.chromaShrink)), "toAxes"},
    {"yCoCgLifting", "YCoCg lifting", "The same axes by lifting steps, chroma twice as large (manual 9.3).",
     Uses(USED(neighborhood.chromaShrink)), "toAxes"},
    {"yCbCr", "YCbCr", "Rec. 709 luma and two differences (manual 9.4).",
     Uses(USED(neighborhood.chromaShrink)), "toAxes"},
    {"yCoCgAsPrinted", "YCoCg, as printed",
     "As in Playdead, Raptor and Bevy: the way back is clamped to 0…1, so that history which was moved is "
     "never brighter than white. Compressed by Reinhard, the largest channel or PQ, colors lie below 1 and "
     "none of it shows (manual §26, D7).",
     Uses(USED(neighborhood.chromaShrink)), "fromAxes"},
};
inline constexpr Choice kToneSpaces[] = {
    {"linear", "Linear", "Box of scene-linear colors; a highlight opens it wide.", Uses(), "toBox"},
    {"reinhardLuma", "Reinhard luma",
     "Box of colors divided by 1 + luma; highlights stay bounded (manual 15.2).", Uses(), "toBox"},
    {"reinhardChannel", "Reinhard", "Each channel by itself: bounded, and hues shift (manual 15.3).", Uses(),
     "toBox"},
    {"maxChannel", "Largest channel", "Colors divided by 1 + their largest channel (manual 15.4, Filament).",
     Uses(), "toBox"},
    {"pq", "PQ",
     "SMPTE ST 2084 with 10000 as 1, each channel by itself: steps as the eye sees them. Goes on beyond 1, "
     "where Donut cuts it off (manual 9.6, 15.5, Donut).",
     Uses(), "toBox"},
    {"logarithm", "Logarithm", "log₂(1 + c), each channel by itself (manual 15.7, Intel).", Uses(), "toBox"},
    {"gamma", "Gamma",
     "Encoded as for a screen, by the curve of sRGB, each channel by itself, and on beyond 1: with YCbCr the "
     "Y'CbCr of gamma colors (manual 9.4, source 003; IEC 61966-2-1).",
     Uses(), "toBox"},
};
inline constexpr Choice kWeightLumas[] = {
    {"rec709", "Rec. 709", "0.2126 R + 0.7152 G + 0.0722 B (manual 15.1).", Uses(), "weightLuma"},
    {"yCoCg", "Y of YCoCg", "(R + 2G + B)/4: red and blue weigh alike (manual 9.2, 15.1, source 000).",
     Uses(), "weightLuma"},
};
inline constexpr Choice kNeighborhoodShapes[] = {
    {"cross", "Cross", "Five samples: tighter box, more flicker (manual 8.1).", Uses(), "measureSamples"},
    {"square3x3", "3×3", "Nine samples (manual 8.2).", Uses(), "measureSamples"},
    {"x", "×", "The pixel and its diagonals (manual 8.3).", Uses(), "measureSamples"},
    {"rounded", "Rounded", "The middle between the bounds of nine and of five (manual 8.4, Playdead).",
     Uses(), "measureSamples"},
    {"alternate", "Alternating", "+ in even frames, × in odd ones (manual 8.6, Intel).", Uses(),
     "measureSamples"},
    {"varying", "Four taps that vary",
     "Four bilinear taps on the diagonals, ⅔ px away at rest and ½ px where things move or are far: "
     "½ + ⅙·sat(½/(‖v‖·z)). z in m, so that a scene in centimeters looks different (manual 8.5, "
     "Playdead).",
     Uses(), "varyingTaps"},
    {"pairs", "Seven, by pairs",
     "One set for both of two columns, as a compute shader shares it: the left pixel, its diagonals and the "
     "two to its right, so that even and odd columns see the box from different places (manual 8.7, "
     "MiniEngine).",
     Uses(), "pairSamples"},
};
inline constexpr Choice kSpeedUnits[] = {
    {"px", "Pixels", "Of the picture, however many it has.", Uses()},
    {"lines1080", "Pixels of 1080 lines", "‖v‖·1080/H: the same for a picture of any size (DiligentFX).",
     Uses(), "speedOfLines"},
    {"picture1080", "1080ths of the picture",
     "‖(vx/W, vy/H)‖·1080, as of a motion in texture coordinates: across it counts less than down (Godot, "
     "source 002).",
     Uses(), "speedOfPicture"},
};
inline constexpr Choice kMomentWeights[] = {
    {"equal", "Equal", "Every sample counts alike.", Uses(), "momentWeight"},
    {"luma", "Luma", "Samples weighted by 1/(1 + luma): fireflies pull less (manual 10.7).",
     Uses(USED(space.luma)), "momentWeight"},
    {"distance", "Distance", "exp(−¾ r²): near samples count more (manual 10.7, DiligentFX).", Uses(),
     "momentWeight"},
    {"boxLuma", "Luma of the box",
     "1/(1 + Y) with the luma of the box's space: of compressed colors all weights lie between ½ and 1 "
     "(manual 10.7, Godot).",
     Uses(), "momentWeight"},
};
inline constexpr Choice kBoxKinds[] = {
    {"minMax", "Min-max", "From the smallest to the largest sample (manual 10.1).", Uses(), "boundByMoments"},
    {"variance", "Variance", "Mean ± γ deviations (manual 10.2, Salvi 2016).",
     Uses(USED(neighborhood.gamma), USED(neighborhood.motionGamma), USED(neighborhood.resolutionGamma),
          USED(neighborhood.contrastGamma)),
     "boundByMoments"},
    {"intersection", "Both", "Variance box inside the min-max box (manual 10.3).",
     Uses(USED(neighborhood.gamma), USED(neighborhood.motionGamma), USED(neighborhood.resolutionGamma),
          USED(neighborhood.contrastGamma)),
     "boundByMoments"},
};
inline constexpr Choice kOffScreens[] = {
    {"keep", "Keep", "Border pixels streak into the picture (manual 5.0).", Uses(), "isOutside"},
    {"reject", "Reject", "Outside the picture there is no history (manual 5.1).", Uses(), "isOutside"},
    {"margin", "With margin", "Half a pixel earlier, so that no filter reads beyond (manual 5.3, HDRP).",
     Uses(), "isOutside"},
    {"oneSided", "One-sided, as printed",
     "As in the first listing of source 002: only the left edge is tested, the others streak; and beyond it "
     "nothing of the current frame is taken, α = 0, instead of nothing of history (manual 5.7, D9).",
     Uses(), "isOutside"},
};
inline constexpr Choice kVelocityTests[] = {
    {"none", "None", "Motion may change as it likes.", Uses()},
    {"vector", "Vector", "Length of the difference: ‖v − v′‖ (manual 12.5, CryEngine 3, Godot).",
     Uses(USED(validate.velocityLimit), USED(validate.velocityGain)), "changeOf"},
    {"length", "Length", "Difference of the lengths: |‖v‖ − ‖v′‖|; a turn is no change (manual 12.5, HDRP).",
     Uses(USED(validate.velocityLimit), USED(validate.velocityGain)), "changeOf"},
};
inline constexpr Choice kDepthDirections[] = {
    {"both", "Nearer and farther", "Whatever is not as far away as expected (manual 12.1).", Uses(),
     "depthMismatch"},
    {"nearer", "Nearer alone",
     "Only what is nearer can have hidden the surface; what is farther counts as the same (manual 12.1, "
     "MiniEngine, Intel, FSR2).",
     Uses(), "depthMismatch"},
};
inline constexpr Choice kDepthFootprints[] = {
    {"square3x3", "3×3",
     "The texel at the history position and those around it: as wide as the jitter, and alike on all sides.",
     Uses(), "compareDepth"},
    {"readInMotion", "3×3 at rest",
     "Where something parts, only the texels that a bilinear tap reads, one to four; where nothing does, "
     "3×3. "
     "Keeps less of what hid the surface, at the price of the history's motion.",
     Uses(), "compareDepth"},
};
inline constexpr Choice kRejectActions[] = {
    {"restart", "Restart", "α = 1 and N = 1: the history is dropped (manual §12, hard).", Uses(),
     "validateHistory"},
    {"raiseAlpha", "Raise α",
     "The history stays, and α is at least a value of choice; only what is off the screen or has no history "
     "starts anew (manual §12, soft).",
     Uses(USED(validate.softAlpha)), "validateHistory"},
    {"decay", "Decay",
     "By the share r that is rejected N falls to N(1 − r) and α rises by r: a whole r starts anew "
     "(manual 12.5, 13.3, Godot).",
     Uses(), "lengthLeft"},
};
inline constexpr Choice kRectifyMethods[] = {
    {"none", "None", "History is taken as it is: everything ghosts (manual 11.0).", Uses()},
    {"clamp", "Clamp", "Nearest point of the box (manual 11.1).", Uses(USED(rectify.relaxAtRest)),
     "clampToBox"},
    {"clipToCenter", "Clip to center", "Towards the middle of the box (manual 11.2, Playdead).",
     Uses(USED(rectify.relaxAtRest)), "clipToCenter"},
    {"clipToFiltered", "Clip to filtered", "Towards the filtered current color (manual 11.3, Karis 2014).",
     Uses(USED(rectify.relaxAtRest)), "clipToFiltered"},
    {"shrinkAxes", "Clip by shrinking axes",
     "Towards the mean, one axis after the other (manual 11.5, Godot).", Uses(USED(rectify.relaxAtRest)),
     "shrinkAxes"},
    {"clampThenClip", "Clamp, then clip",
     "Clamp to the min-max box, then clip to the center of this one (manual 10.5, Raptor).",
     Uses(USED(rectify.relaxAtRest)), "clampThenClip"},
    {"rayToCurrent", "Clip along ray to current",
     "Along the ray to the current color, unless the box is hit too late (manual 11.4, DiligentFX).",
     Uses(USED(rectify.maxSteps), USED(rectify.relaxAtRest)), "rayToCurrent"},
    {"clipToHull", "Clip to filtered, hull",
     "Towards the filtered color until thirteen slabs around the samples hold: nearly their convex hull, "
     "which "
     "no box and no γ widens (manual 10.12).",
     Uses(USED(rectify.relaxAtRest)), "clipToSlabs"},
    {"clipToBoth", "Clip to filtered, both boxes",
     "Towards the filtered color until it lies in the min-max boxes of RGB and of the color space (of RGB: "
     "and of YCoCg): six slabs, which no γ widens (manual 9.7, Lottes).",
     Uses(USED(rectify.relaxAtRest)), "clipToSlabs"},
    {"clampForget", "Clamp and forget",
     "Nearest point of the box, and history that was moved counts as no more than 1.6 frames, a tenth of "
     "what "
     "FSR2 can accumulate (manual 11.7).",
     Uses(USED(rectify.relaxAtRest)), "lengthKept"},
    {"select", "Select",
     "The one of the nine samples that is nearest to history takes its place: no color of the past is left, "
     "and no ghost (manual 11.8, 17.6, Godot's proposal).",
     Uses(USED(rectify.relaxAtRest)), "selected"},
};

} // namespace taa
