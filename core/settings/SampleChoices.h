// What can be chosen where motion is dilated, history is read and the current frame is filtered.
#pragma once

#include "core/settings/Parameters.h"
#include "core/settings/Used.h"

namespace taa {

inline constexpr Choice kDilateMethods[] = {
    {"none", "None", "The pixel's own motion (manual 4.0).", Uses()},
    {"closest3x3", "Closest 3×3", "Motion of the nearest surface among nine (manual 4.1).",
     Uses(USED(dilate.ties)), "findClosest"},
    {"closestCross", "Closest +", "Of the pixel and its four neighbors (manual 4.2).",
     Uses(USED(dilate.ties)), "findClosest"},
    {"closestX", "Closest ×", "Of the pixel and its four diagonal neighbors (manual 4.3).",
     Uses(USED(dilate.ties)), "findClosest"},
    {"closestX2", "Closest × at 2 px", "Wider; misses what is one pixel thin (manual 4.4, Karis 2014).",
     Uses(USED(dilate.ties)), "findClosest"},
    {"longest3x3", "Longest 3×3",
     "The fastest of nine; needs no depth, and fast backgrounds bleed (manual 4.5).", Uses(), "findLongest"},
    {"longestCross", "Longest +", "The fastest of five (manual 4.6).", Uses(), "findLongest"},
    {"closest3x3AsPrinted", "Closest 3×3, as printed",
     "As printed in Raptor's chapter 11: where all nine are sky the motion of pixel (0, 0) is taken, because "
     "the search starts from there and finds nothing nearer (manual §26, D4).",
     Uses(USED(dilate.ties)), "findClosest"},
    {"closestXAsPrinted", "Closest ×, as printed",
     "As in HDRP: with each offset the depth of the next tap is kept, which then is as near as itself and "
     "taken as well, so that the motion of the lower left is read wherever any of the four is no farther "
     "than the pixel (manual §26, D13).",
     Uses(), "findClosestXAsPrinted"},
    {"farthest3x3", "Farthest 3×3",
     "Motion of the farthest surface among nine: what a test for the smallest depth finds once depth is "
     "reversed, as in Godot since 4.3 (manual 4.1).",
     Uses(USED(dilate.ties)), "findClosest"},
};
inline constexpr Choice kDilateTies[] = {
    {"center", "The pixel itself", "Only what is really nearer takes its place (manual 4.1).", Uses(),
     "findClosest"},
    {"first", "The first",
     "The search starts with nothing, from the upper left, so that on what faces the camera the motion of "
     "that neighbor is read (manual 4.1, Playdead, Godot).",
     Uses(), "findClosest"},
    {"last", "The last",
     "What is as near takes its place as well, so that the neighbor at the lower right is read (manual "
     "§4, source 002, whose step() holds for equal depths).",
     Uses(), "findClosest"},
};
inline constexpr Choice kReprojectMethods[] = {
    {"motion", "Where it was", "The pixel's center minus the motion it follows (manual §5).", Uses(),
     "reproject"},
    {"inPlace", "In place",
     "The pixel's own center: the accumulation buffer before anybody reprojects. Whatever moves leaves a "
     "trail, and nothing is ever off the screen (manual §5, the step before it).",
     Uses(), "reproject"},
};
inline constexpr Choice kHistoryFilters[] = {
    {"point", "Point", "The nearest texel: no blur, but half a pixel of error (manual 6.0).", Uses(),
     "filteredHistory"},
    {"bilinear", "Bilinear", "One tap; blurs a little in every moving frame (manual 6.1).", Uses(),
     "bilinearHistory"},
    {"catmullRom5", "Catmull-Rom 5", "Five taps, normalized; stays sharp (manual 6.4, Jimenez 2016).",
     Uses(USED(history.dering), USED(history.bilinearAtEdges)), "fiveTaps", "catmullRomWeights"},
    {"catmullRom9", "Catmull-Rom 9", "Nine bilinear taps: the same as sixteen (manual 6.3).",
     Uses(USED(history.dering), USED(history.bilinearAtEdges)), "nineTaps", "catmullRomWeights"},
    {"catmullRom16", "Catmull-Rom 16", "All sixteen texels; reproduces parabolas (manual 6.2).",
     Uses(USED(history.dering), USED(history.bilinearAtEdges)), "sixteenTexels", "catmullRomWeights"},
    {"cubic", "Cubic", "Sixteen texels with a sharpness to choose (manual 6.5).",
     Uses(USED(history.sharpness), USED(history.dering), USED(history.bilinearAtEdges)), "sixteenTexels",
     "sharpnessWeights"},
    {"mitchell", "Mitchell",
     "B = C = ⅓: a little blur, little ringing (manual 6.6, Mitchell and Netravali 1988).",
     Uses(USED(history.dering), USED(history.bilinearAtEdges)), "sixteenTexels", "mitchellWeights"},
    {"lanczos", "Lanczos 2", "The polynomial form of FSR2 and Filament (manual 6.7).",
     Uses(USED(history.dering), USED(history.bilinearAtEdges)), "sixteenTexels", "lanczosWeights"},
    {"catmullRom5AsPrinted", "Catmull-Rom 5, as printed",
     "As in Bevy: not divided by the sum of its weights, so that moving pictures darken (manual 6.4b, "
     "D15).",
     Uses(USED(history.dering), USED(history.bilinearAtEdges)), "fiveTaps", "catmullRomWeights"},
    {"catmullRom5Corners", "Catmull-Rom 5, corners",
     "Each corner taken for the mean of the two taps beside it, so that the weights sum to 1 by themselves "
     "(manual 6.4c, Intel).",
     Uses(USED(history.dering), USED(history.bilinearAtEdges)), "fiveTaps", "catmullRomWeights"},
    {"cubic5", "Cubic 5", "Five taps of the cubic of a sharpness, normalized (manual 6.5).",
     Uses(USED(history.sharpness), USED(history.dering), USED(history.bilinearAtEdges)), "fiveTaps",
     "sharpnessWeights"},
    {"cubic5AsPrinted", "Cubic 5, as printed",
     "As in HDRP: the right tap is read in the row above, at its corner, so that steps to the right bend "
     "(manual §26, D13).",
     Uses(USED(history.sharpness), USED(history.dering), USED(history.bilinearAtEdges)), "fiveTaps",
     "sharpnessWeights"},
};
inline constexpr Choice kHistoryBorders[] = {
    {"edge", "Edge", "The nearest pixel of the picture.", Uses(), "storedColor"},
    {"black", "Black",
     "As from a sampler with a black border: wide filters darken what lies near it (manual 5.4, Donut).",
     Uses(), "storedColor"},
};
inline constexpr Choice kLengthsFrom[] = {
    {"reprojected", "History position", "N of the nearest texel to where the surface was (manual §16).",
     Uses(), "sampleHistory"},
    {"pixelAsPrinted", "Own pixel, as printed",
     "As in Bevy: N of the same pixel a frame ago, whatever was there (manual §26, D15).", Uses(),
     "sampleHistory"},
    {"bilinear", "Bilinear",
     "N of the four texels around, as colors are read: no hard step where a part of them is new (manual "
     "§16, Godot).",
     Uses(), "bilinearLength"},
};
inline constexpr Choice kHistoryPrecisions[] = {
    {"half", "16-bit", "Half floats, as engines store it.", Uses(USED(history.dither)), "asStored"},
    {"full", "32-bit", "Full floats, for reference runs.", Uses(), "asStored"},
    {"unorm8", "8-bit",
     "Multiples of 1/255 from 0 to 1, as Playdead stores it: the average stops half a step over α before its "
     "goal (manual 1.6, 20.6). Kept in 32-bit floats here, which hold them exactly.",
     Uses(USED(history.dither)), "asStored"},
    {"unorm10", "10-bit", "Multiples of 1/1023, likewise (manual 1.6, 20.6).", Uses(USED(history.dither)),
     "asStored"},
};
inline constexpr Choice kCurrentFilters[] = {
    {"center", "Center", "The pixel's own sample (manual 7.0).", Uses(), "filterCurrent"},
    {"gaussian", "Gaussian",
     "Samples weighted by their distance to the pixel's center, jitter included (manual 7.4).",
     Uses(USED(current.variance), USED(current.jitterAware), USED(current.lumaWeighted)), "weightedSamples",
     "gaussianKernel"},
    {"unjitter", "Unjitter tap", "One bilinear tap where the pixel's center landed (manual 7.1, Playdead).",
     Uses(), "unjitteredTap"},
    {"tent", "4-2-1", "Weights 4, 2 and 1 of sixteen, whatever the jitter (manual 7.2).",
     Uses(USED(current.lumaWeighted)), "weightedSamples", "tentKernel"},
    {"box", "Box", "All nine alike: blurs (manual 7.3).", Uses(USED(current.lumaWeighted)), "weightedSamples",
     "boxKernel"},
    {"mitchell", "Mitchell", "Cubic of the distance, B = C = ⅓ (manual 7.5).",
     Uses(USED(current.jitterAware), USED(current.lumaWeighted), USED(current.dering)), "weightedSamples",
     "mitchellKernel"},
    {"catmullRom", "Catmull-Rom", "Cubic of the distance, sharper (manual 7.5).",
     Uses(USED(current.jitterAware), USED(current.lumaWeighted), USED(current.dering)), "weightedSamples",
     "catmullRomKernel"},
    {"blackmanHarris", "Blackman-Harris", "The window itself over 3 px (manual 7.5).",
     Uses(USED(current.jitterAware), USED(current.lumaWeighted)), "weightedSamples", "blackmanHarrisKernel"},
    {"lanczos", "Lanczos 2", "Separable, jitter included, as in Filament (manual 7.6).",
     Uses(USED(current.jitterAware), USED(current.lumaWeighted), USED(current.dering)), "weightedSamples",
     "lanczosKernel"},
    {"distanceAsPrinted", "None, as printed",
     "As printed in Raptor's chapter 11: the weight is the distance, so the pixel itself counts nothing and "
     "its ring is averaged (manual §26, D2).",
     Uses(), "weightedSamples", "distanceAsPrinted"},
    {"mitchellAsPrinted", "Mitchell, as printed",
     "As printed in Raptor's chapter 11: of twice the distance and without jitter, so all neighbors weigh 0 "
     "or less than nothing and the filter does nothing (manual §26, D3).",
     Uses(), "weightedSamples", "mitchellAsPrinted"},
    {"blackmanHarrisAsPrinted", "Blackman-Harris, as printed",
     "As printed in Raptor's chapter 11: of twice the distance, which makes it nearly a box of five "
     "(manual §26, D3).",
     Uses(), "weightedSamples", "blackmanHarrisAsPrinted"},
    {"unjitterAsPrinted", "Unjitter tap, as printed",
     "As in source 002's text: the tap on the other side, uv − j, so that the jitter is doubled instead of "
     "taken out (manual §26, D10).",
     Uses(), "unjitteredTap"},
};
inline constexpr Choice kCurrentSharpens[] = {
    {"none", "None", "As filtered.", Uses()},
    {"laplacian", "Laplacian",
     "Minus the mean of the four around: constants keep their brightness (manual 18.2, corrected).",
     Uses(USED(current.sharpenAmount)), "sharpenedCurrent"},
    {"laplacianAsPrinted", "Laplacian, as printed",
     "As printed in source 002: what is flat becomes s times as bright, so only s = 1 keeps brightness, "
     "which "
     "is 4 of the corrected one (manual 18.2).",
     Uses(USED(current.sharpenAmount)), "sharpenedCurrent"},
};
inline constexpr Choice kUpsampleKernels[] = {
    {"sampleWeight", "Nearest sample",
     "The nearest sample alone; it counts the less the farther it lies: κ = max(sat(1 − ‖d‖²/r), "
     "smoothstep(‖v‖)), d in render px, v in px of the picture (manual 22.1, Donut).",
     Uses(), "nearestConfidence"},
    {"lanczos2", "Lanczos 2",
     "Nine samples by the separable Lanczos 2 of their distance in px of the picture, κ = Σw; bounded by the "
     "nine (manual 22.2, Filament).",
     Uses(), "upsample", "lanczos2Weight"},
    {"hdrp", "HDRP",
     "Nine samples by (0.9656852 x² − 1)², x in px of the picture, at most 1. κ is 1 within HDRP's box, "
     "½/r render px to either side, which holds the nearest sample wherever there is one (manual 22.3).",
     Uses(), "boxConfidence", "hdrpWeight"},
    {"hdrpGaussian", "HDRP, Gaussian",
     "The same, and κ is a Gaussian of the nearest one's distance: 2^(−½(‖x‖/0.4)²)/r², at most 1, x in "
     "px of the picture (manual 22.3).",
     Uses(), "gaussianConfidence", "hdrpWeight"},
    {"fsr2", "FSR2",
     "Sixteen samples by the radial Lanczos 2 of their distance times min(1/r, 1.99), bounded by the nearest "
     "nine. κ = Σw, 0 where that is negative: the 1/12 of FSR2 is the floor of α here (manual 22.4).",
     Uses(), "upsample", "fsr2Weight"},
};

} // namespace taa
