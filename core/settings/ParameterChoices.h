// The choices of the parameter table, in the order of their enumerators: what each is and where it comes
// from. "As printed" is said of a defect of a well-known source, kept beside the corrected form.
#pragma once

#include "core/settings/Parameters.h"

#include <cstddef>

namespace taa {

/// A field of Settings, as Uses takes it: USED(history.sharpness). A name that there is not is refused.
#define USED(member) (Field{offsetof(Settings, member)})

inline constexpr Choice kJitterSequences[] = {
    {"none", "None", "No jitter: the picture stays aliased (manual J0).", Uses()},
    {"still", "Still", "Always (½, ½): a shift, no pattern (manual J0, Playdead).", Uses(USED(jitter.scale))},
    {"uniform2", "Uniform 2", "Two points on the diagonal (manual J1).",
     Uses(USED(jitter.firstIndex), USED(jitter.scale))},
    {"uniform4", "Uniform 4", "The centers of four quarters, in raster order (manual J2).",
     Uses(USED(jitter.firstIndex), USED(jitter.scale))},
    {"helix", "Helix 4", "The same four, each step across the center (manual J3).",
     Uses(USED(jitter.firstIndex), USED(jitter.scale))},
    {"doubleHelix", "Double helix 8", "The same four in an order of eight (manual J4).",
     Uses(USED(jitter.firstIndex), USED(jitter.scale))},
    {"butterfly", "Skew butterfly", "Two far points and two near ones (manual J5).",
     Uses(USED(jitter.firstIndex), USED(jitter.scale))},
    {"rotatedGrid", "Rotated grid", "RGSS: four points, each alone in its row and column (manual J6).",
     Uses(USED(jitter.firstIndex), USED(jitter.scale))},
    {"poisson10", "Poisson 10", "Ten points of a disc of radius ¼ px, none near another (manual J7).",
     Uses(USED(jitter.firstIndex), USED(jitter.scale))},
    {"pentagram", "Pentagram", "Five points of a star, each step across it (manual J8).",
     Uses(USED(jitter.firstIndex), USED(jitter.scale))},
    {"halton", "Halton", "Halton(2, 3): low discrepancy, the usual choice (manual J9).",
     Uses(USED(jitter.period), USED(jitter.firstIndex), USED(jitter.scale))},
    {"perpendicular", "Across the motion",
     "Two points ¼ px to either side of the way the camera moves, whose direction follows by a fifth in each "
     "frame (manual J10, Playdead's experiment).",
     Uses(USED(jitter.firstIndex), USED(jitter.scale))},
    {"r2", "R2", "Roberts' plastic number sequence: evenly spread at any length (manual J11).",
     Uses(USED(jitter.period), USED(jitter.firstIndex), USED(jitter.scale))},
    {"hammersley", "Hammersley", "Exact in x, radical inverse in y; wants its period known (manual J12).",
     Uses(USED(jitter.period), USED(jitter.firstIndex), USED(jitter.scale))},
    {"gradientNoise", "Gradient noise",
     "Interleaved gradient noise along time: x and y hang together, so it covers badly (manual J13).",
     Uses(USED(jitter.period), USED(jitter.firstIndex), USED(jitter.scale))},
    {"msaa8", "MSAA 8", "The standard pattern of 8×MSAA; its mean is exactly 0 (manual J14).",
     Uses(USED(jitter.firstIndex), USED(jitter.scale))},
    {"blueNoise16", "Blue noise 16", "Sixteen points, each alone in its row and column (manual J15).",
     Uses(USED(jitter.firstIndex), USED(jitter.scale))},
    {"whiteNoise", "White noise", "Hashed random points: what the others are measured against (manual J16).",
     Uses(USED(jitter.period), USED(jitter.firstIndex), USED(jitter.scale))},
};
inline constexpr Choice kJitterProjections[] = {
    {"translation", "Translation",
     "T(δ)·P: the same shift at every depth, with any projection (manual §2.1).", Uses()},
    {"addedAsPrinted", "Third column, sign as printed",
     "As printed in sources 000 to 002: added to the third column, which with OpenGL's w = −z moves the "
     "picture the other way than every filter believes (manual §2.1).",
     Uses()},
    {"columnAsPrinted", "Third column always, as printed",
     "As in Bevy: the third column also for orthographic cameras, where it shears by depth instead of "
     "shifting; the same as Translation with perspective (manual §26, D15).",
     Uses()},
    {"rightAsPrinted", "From the right, as printed",
     "P·T(δ), which source 001 warns of: it moves the world before it is projected, near things far and far "
     "things hardly (manual §2.1).",
     Uses()},
};
inline constexpr Choice kPrecisions[] = {
    {"half", "16-bit", "Half floats, as engines store it.", Uses()},
    {"full", "32-bit", "Full floats, for reference runs.", Uses()},
};
inline constexpr Choice kHistoryPrecisions[] = {
    {"half", "16-bit", "Half floats, as engines store it.", Uses(USED(history.dither))},
    {"full", "32-bit", "Full floats, for reference runs.", Uses()},
    {"unorm8", "8-bit",
     "Multiples of 1/255 from 0 to 1, as Playdead stores it: the average stops half a step over α before its "
     "goal (manual 1.6, 20.6). Kept in 32-bit floats here, which hold them exactly.",
     Uses(USED(history.dither))},
    {"unorm10", "10-bit", "Multiples of 1/1023, likewise (manual 1.6, 20.6).", Uses(USED(history.dither))},
};
inline constexpr Choice kDynamicRanges[] = {
    {"hdr", "HDR", "Scene-linear colors as they were shaded, before bloom and tone mapping (manual 1.1).",
     Uses()},
    {"ldr", "LDR",
     "What is brighter than white is white before anything is averaged, as after a tone map that clips: "
     "fireflies are tame, and bright edges lose what lies above (manual 1.2, Playdead). Kept linear.",
     Uses()},
};
inline constexpr Choice kInputNoises[] = {
    {"none", "None", "Colors as they were shaded.", Uses()},
    {"gradientNoise", "Gradient noise",
     "Interleaved gradient noise, another in each of 64 frames; neighbors differ much, along lines "
     "(manual "
     "20.1).",
     Uses(USED(inputs.noiseAmount), USED(inputs.noiseTriangular))},
    {"blueNoise", "Blue noise",
     "A tile of 32×32 by void-and-cluster, moved on by the golden ratio in each of 256 frames: no low "
     "frequencies in space, evenly spread in time (manual 20.2).",
     Uses(USED(inputs.noiseAmount), USED(inputs.noiseTriangular))},
    {"whiteNoise", "White noise",
     "A hash of pixel and frame, 256 of them: neighbors and frames have nothing to do with each other, what "
     "the others are measured against (manual §20).",
     Uses(USED(inputs.noiseAmount), USED(inputs.noiseTriangular))},
};
inline constexpr Choice kFogNoises[] = {
    {"none", "None", "All rays stop at the same distances: the fog has as many levels as steps, in bands.",
     Uses()},
    {"gradientNoise", "Gradient noise",
     "Interleaved gradient noise, another in each of 64 frames; neighbors differ much, along lines "
     "(manual 20.1).",
     Uses(USED(inputs.fogAnimated))},
    {"blueNoise", "Blue noise",
     "A tile of 32×32, moved on by the golden ratio in each of 256 frames: what TAA averages best (manual "
     "20.2, Raptor).",
     Uses(USED(inputs.fogAnimated))},
    {"whiteNoise", "White noise",
     "A hash of pixel and frame: clumps in space and in time, which TAA averages worst (manual §20).",
     Uses(USED(inputs.fogAnimated))},
};
inline constexpr Choice kFogHistories[] = {
    {"none", "None", "The fog of this frame alone: its noise is left to the resolve.", Uses()},
    {"kept", "Kept",
     "The mean over the last frames: less noise, and where the fog's light moves it drags behind (manual "
     "20.5).",
     Uses(USED(inputs.fogFrames))},
    {"clamped", "Clamped",
     "The mean of the frames before, channel by channel clamped to the smallest and largest of this frame's "
     "3×3, then averaged with it: what moved on leaves no trail (manual 20.5, 10.1, 11.1; Vallario's idea "
     "in source 001).",
     Uses(USED(inputs.fogFrames))},
    {"largestAsPrinted", "Largest, as printed",
     "As in Raptor: the larger one of the mean of the frames before and this frame is averaged with it. "
     "Trails stay, and noise makes the fog brighter than it is (manual 20.5).",
     Uses(USED(inputs.fogFrames))},
};
inline constexpr Choice kMotionSources[] = {
    {"objects", "Objects", "Each object's own motion, the camera's included (manual 3.2 to 3.7).", Uses()},
    {"cameraFromDepth", "Camera from depth", "Camera motion only, reprojected from depth (manual 3.1).",
     Uses()},
    {"rawUv", "Camera, raw position",
     "From the pixel's center instead of where its sample lies: the jitter leaks into the motion, so that it "
     "is j instead of 0 where nothing moves (manual 3.1a, Playdead).",
     Uses()},
    {"jitterDifference", "Camera, jitter subtracted",
     "Both frames with their jitter, whose difference is subtracted again in the same unit (manual "
     "3.1b).",
     Uses()},
    {"singleMatrix", "Camera, one matrix",
     "One matrix from picture to picture, as if samples lay in the pixels' centers: off by the jitter times "
     "the slope of the parallax (manual 3.1c, FSR, Filament).",
     Uses()},
    {"jitterDifferenceAsPrinted", "Camera, jitter subtracted, as printed",
     "As printed in Raptor's chapter 11: the difference in normalized device coordinates is taken for one in "
     "texture coordinates, twice too long and upside down, and half of the jitter is subtracted "
     "(manual §26, D5).",
     Uses()},
    {"objectsAsPrinted", "Objects, as printed",
     "As in source 001's listing of meshes: the current position is not divided by w, and the previous one "
     "uses the current pose, so that objects seem to rest in a picture that flies (manual §26, D6).",
     Uses()},
    {"currentProjectionAsPrinted", "Objects, projection as printed",
     "As in Playdead: the previous view with the projection of now, right until the camera zooms "
     "(manual §26, D16).",
     Uses()},
};
inline constexpr Choice kBlendedAs[] = {
    {"mask", "Mask", "Solid where alpha is at least ½.", Uses()},
    {"dithered", "Dithered",
     "Drawn in as many of sixteen frames as alpha says, in a 4×4 pattern that changes: accumulation makes it "
     "transparent (manual 20.7, 21.6).",
     Uses()},
    {"before", "Blended before",
     "Blended over the opaque picture before the resolve, back to front; motion, depth and id stay those of "
     "what is behind, so that what moves smears (manual 21.2, most engines).",
     Uses()},
    {"beforeWithMotion", "Before, with motion",
     "As before, and the surface in front writes its motion where that comes from objects: it is sharp, and "
     "what is behind it follows the wrong motion (manual 21.3, HDRP).",
     Uses()},
    {"after", "Blended after",
     "Drawn without jitter into a layer that is laid over the output: no smear and no anti-aliasing "
     "(manual 21.1, Bevy, Unity).",
     Uses()},
};
inline constexpr Choice kMaskSources[] = {
    {"none", "None", "No mask is drawn.", Uses()},
    {"material", "Material",
     "Responsive where a material says so: screens, flip-books, particles (manual 21.4, UE4, HDRP).",
     Uses(USED(neighborhood.maskRelax), USED(weight.mask))},
    {"opacity", "Opacity",
     "And reactive by the opacity of what was blended in; of several the largest (manual 21.5, FSR2).",
     Uses(USED(neighborhood.maskRelax), USED(weight.mask))},
    {"autoReactive", "Difference",
     "And reactive by what blending changed: five times the largest difference of the tone-mapped channels, "
     "at most 0.9 (manual 21.5, FSR2).",
     Uses(USED(neighborhood.maskRelax), USED(weight.mask))},
};
inline constexpr Choice kDilateMethods[] = {
    {"none", "None", "The pixel's own motion (manual 4.0).", Uses()},
    {"closest3x3", "Closest 3×3", "Motion of the nearest surface among nine (manual 4.1).",
     Uses(USED(dilate.ties))},
    {"closestCross", "Closest +", "Of the pixel and its four neighbors (manual 4.2).",
     Uses(USED(dilate.ties))},
    {"closestX", "Closest ×", "Of the pixel and its four diagonal neighbors (manual 4.3).",
     Uses(USED(dilate.ties))},
    {"closestX2", "Closest × at 2 px", "Wider; misses what is one pixel thin (manual 4.4, Karis 2014).",
     Uses(USED(dilate.ties))},
    {"longest3x3", "Longest 3×3",
     "The fastest of nine; needs no depth, and fast backgrounds bleed (manual 4.5).", Uses()},
    {"longestCross", "Longest +", "The fastest of five (manual 4.6).", Uses()},
    {"closest3x3AsPrinted", "Closest 3×3, as printed",
     "As printed in Raptor's chapter 11: where all nine are sky the motion of pixel (0, 0) is taken, because "
     "the search starts from there and finds nothing nearer (manual §26, D4).",
     Uses(USED(dilate.ties))},
    {"closestXAsPrinted", "Closest ×, as printed",
     "As in HDRP: with each offset the depth of the next tap is kept, which then is as near as itself and "
     "taken as well, so that the motion of the lower left is read wherever any of the four is no farther "
     "than the pixel (manual §26, D13).",
     Uses()},
    {"farthest3x3", "Farthest 3×3",
     "Motion of the farthest surface among nine: what a test for the smallest depth finds once depth is "
     "reversed, as in Godot since 4.3 (manual 4.1).",
     Uses(USED(dilate.ties))},
};
inline constexpr Choice kDilateTies[] = {
    {"center", "The pixel itself", "Only what is really nearer takes its place (manual 4.1).", Uses()},
    {"first", "The first",
     "The search starts with nothing, from the upper left, so that on what faces the camera the motion of "
     "that neighbor is read (manual 4.1, Playdead, Godot).",
     Uses()},
    {"last", "The last",
     "What is as near takes its place as well, so that the neighbor at the lower right is read (manual "
     "§4, source 002, whose step() holds for equal depths).",
     Uses()},
};
inline constexpr Choice kReprojectMethods[] = {
    {"motion", "Where it was", "The pixel's center minus the motion it follows (manual §5).", Uses()},
    {"inPlace", "In place",
     "The pixel's own center: the accumulation buffer before anybody reprojects. Whatever moves leaves a "
     "trail, and nothing is ever off the screen (manual §5, the step before it).",
     Uses()},
};
inline constexpr Choice kHistoryFilters[] = {
    {"point", "Point", "The nearest texel: no blur, but half a pixel of error (manual 6.0).", Uses()},
    {"bilinear", "Bilinear", "One tap; blurs a little in every moving frame (manual 6.1).", Uses()},
    {"catmullRom5", "Catmull-Rom 5", "Five taps, normalized; stays sharp (manual 6.4, Jimenez 2016).",
     Uses(USED(history.dering), USED(history.bilinearAtEdges))},
    {"catmullRom9", "Catmull-Rom 9", "Nine bilinear taps: the same as sixteen (manual 6.3).",
     Uses(USED(history.dering), USED(history.bilinearAtEdges))},
    {"catmullRom16", "Catmull-Rom 16", "All sixteen texels; reproduces parabolas (manual 6.2).",
     Uses(USED(history.dering), USED(history.bilinearAtEdges))},
    {"cubic", "Cubic", "Sixteen texels with a sharpness to choose (manual 6.5).",
     Uses(USED(history.sharpness), USED(history.dering), USED(history.bilinearAtEdges))},
    {"mitchell", "Mitchell",
     "B = C = ⅓: a little blur, little ringing (manual 6.6, Mitchell and Netravali 1988).",
     Uses(USED(history.dering), USED(history.bilinearAtEdges))},
    {"lanczos", "Lanczos 2", "The polynomial form of FSR2 and Filament (manual 6.7).",
     Uses(USED(history.dering), USED(history.bilinearAtEdges))},
    {"catmullRom5AsPrinted", "Catmull-Rom 5, as printed",
     "As in Bevy: not divided by the sum of its weights, so that moving pictures darken (manual 6.4b, "
     "D15).",
     Uses(USED(history.dering), USED(history.bilinearAtEdges))},
    {"catmullRom5Corners", "Catmull-Rom 5, corners",
     "Each corner taken for the mean of the two taps beside it, so that the weights sum to 1 by themselves "
     "(manual 6.4c, Intel).",
     Uses(USED(history.dering), USED(history.bilinearAtEdges))},
    {"cubic5", "Cubic 5", "Five taps of the cubic of a sharpness, normalized (manual 6.5).",
     Uses(USED(history.sharpness), USED(history.dering), USED(history.bilinearAtEdges))},
    {"cubic5AsPrinted", "Cubic 5, as printed",
     "As in HDRP: the right tap is read in the row above, at its corner, so that steps to the right bend "
     "(manual §26, D13).",
     Uses(USED(history.sharpness), USED(history.dering), USED(history.bilinearAtEdges))},
};
inline constexpr Choice kHistoryBorders[] = {
    {"edge", "Edge", "The nearest pixel of the picture.", Uses()},
    {"black", "Black",
     "As from a sampler with a black border: wide filters darken what lies near it (manual 5.4, Donut).",
     Uses()},
};
inline constexpr Choice kLengthsFrom[] = {
    {"reprojected", "History position", "N of the nearest texel to where the surface was (manual §16).",
     Uses()},
    {"pixelAsPrinted", "Own pixel, as printed",
     "As in Bevy: N of the same pixel a frame ago, whatever was there (manual §26, D15).", Uses()},
    {"bilinear", "Bilinear",
     "N of the four texels around, as colors are read: no hard step where a part of them is new (manual "
     "§16, Godot).",
     Uses()},
};
inline constexpr Choice kCurrentFilters[] = {
    {"center", "Center", "The pixel's own sample (manual 7.0).", Uses()},
    {"gaussian", "Gaussian",
     "Samples weighted by their distance to the pixel's center, jitter included (manual 7.4).",
     Uses(USED(current.variance), USED(current.jitterAware), USED(current.lumaWeighted))},
    {"unjitter", "Unjitter tap", "One bilinear tap where the pixel's center landed (manual 7.1, Playdead).",
     Uses()},
    {"tent", "4-2-1", "Weights 4, 2 and 1 of sixteen, whatever the jitter (manual 7.2).",
     Uses(USED(current.lumaWeighted))},
    {"box", "Box", "All nine alike: blurs (manual 7.3).", Uses(USED(current.lumaWeighted))},
    {"mitchell", "Mitchell", "Cubic of the distance, B = C = ⅓ (manual 7.5).",
     Uses(USED(current.jitterAware), USED(current.lumaWeighted), USED(current.dering))},
    {"catmullRom", "Catmull-Rom", "Cubic of the distance, sharper (manual 7.5).",
     Uses(USED(current.jitterAware), USED(current.lumaWeighted), USED(current.dering))},
    {"blackmanHarris", "Blackman-Harris", "The window itself over 3 px (manual 7.5).",
     Uses(USED(current.jitterAware), USED(current.lumaWeighted))},
    {"lanczos", "Lanczos 2", "Separable, jitter included, as in Filament (manual 7.6).",
     Uses(USED(current.jitterAware), USED(current.lumaWeighted), USED(current.dering))},
    {"distanceAsPrinted", "None, as printed",
     "As printed in Raptor's chapter 11: the weight is the distance, so the pixel itself counts nothing and "
     "its ring is averaged (manual §26, D2).",
     Uses()},
    {"mitchellAsPrinted", "Mitchell, as printed",
     "As printed in Raptor's chapter 11: of twice the distance and without jitter, so all neighbors weigh 0 "
     "or less than nothing and the filter does nothing (manual §26, D3).",
     Uses()},
    {"blackmanHarrisAsPrinted", "Blackman-Harris, as printed",
     "As printed in Raptor's chapter 11: of twice the distance, which makes it nearly a box of five "
     "(manual §26, D3).",
     Uses()},
    {"unjitterAsPrinted", "Unjitter tap, as printed",
     "As in source 002's text: the tap on the other side, uv − j, so that the jitter is doubled instead of "
     "taken out (manual §26, D10).",
     Uses()},
};
inline constexpr Choice kCurrentSharpens[] = {
    {"none", "None", "As filtered.", Uses()},
    {"laplacian", "Laplacian",
     "Minus the mean of the four around: constants keep their brightness (manual 18.2, corrected).",
     Uses(USED(current.sharpenAmount))},
    {"laplacianAsPrinted", "Laplacian, as printed",
     "As printed in source 002: what is flat becomes s times as bright, so only s = 1 keeps brightness, "
     "which "
     "is 4 of the corrected one (manual 18.2).",
     Uses(USED(current.sharpenAmount))},
};
inline constexpr Choice kUpsampleKernels[] = {
    {"sampleWeight", "Nearest sample",
     "The nearest sample alone; it counts the less the farther it lies: κ = max(sat(1 − ‖d‖²/r), "
     "smoothstep(‖v‖)), d in render px, v in px of the picture (manual 22.1, Donut).",
     Uses()},
    {"lanczos2", "Lanczos 2",
     "Nine samples by the separable Lanczos 2 of their distance in px of the picture, κ = Σw; bounded by the "
     "nine (manual 22.2, Filament).",
     Uses()},
    {"hdrp", "HDRP",
     "Nine samples by (0.9656852 x² − 1)², x in px of the picture, at most 1. κ is 1 within HDRP's box, "
     "½/r render px to either side, which holds the nearest sample wherever there is one (manual 22.3).",
     Uses()},
    {"hdrpGaussian", "HDRP, Gaussian",
     "The same, and κ is a Gaussian of the nearest one's distance: 2^(−½(‖x‖/0.4)²)/r², at most 1, x in "
     "px of the picture (manual 22.3).",
     Uses()},
    {"fsr2", "FSR2",
     "Sixteen samples by the radial Lanczos 2 of their distance times min(1/r, 1.99), bounded by the nearest "
     "nine. κ = Σw, 0 where that is negative: the 1/12 of FSR2 is the floor of α here (manual 22.4).",
     Uses()},
};
inline constexpr Choice kColorSpaces[] = {
    {"rgb", "RGB", "Box in red, green, blue (manual 9.1).", Uses()},
    {"yCoCg", "YCoCg", "Box in luma and chroma, tighter around the colors (manual 9.2).",
     Uses(USED(neighborhood.chromaShrink))},
    {"yCoCgLifting", "YCoCg lifting", "The same axes by lifting steps, chroma twice as large (manual 9.3).",
     Uses(USED(neighborhood.chromaShrink))},
    {"yCbCr", "YCbCr", "Rec. 709 luma and two differences (manual 9.4).",
     Uses(USED(neighborhood.chromaShrink))},
    {"yCoCgAsPrinted", "YCoCg, as printed",
     "As in Playdead, Raptor and Bevy: the way back is clamped to 0…1, so that history which was moved is "
     "never brighter than white. Compressed by Reinhard, the largest channel or PQ, colors lie below 1 and "
     "none of it shows (manual §26, D7).",
     Uses(USED(neighborhood.chromaShrink))},
};
inline constexpr Choice kToneSpaces[] = {
    {"linear", "Linear", "Box of scene-linear colors; a highlight opens it wide.", Uses()},
    {"reinhardLuma", "Reinhard luma",
     "Box of colors divided by 1 + luma; highlights stay bounded (manual 15.2).", Uses()},
    {"reinhardChannel", "Reinhard", "Each channel by itself: bounded, and hues shift (manual 15.3).", Uses()},
    {"maxChannel", "Largest channel", "Colors divided by 1 + their largest channel (manual 15.4, Filament).",
     Uses()},
    {"pq", "PQ",
     "SMPTE ST 2084 with 10000 as 1, each channel by itself: steps as the eye sees them. Goes on beyond 1, "
     "where Donut cuts it off (manual 9.6, 15.5, Donut).",
     Uses()},
    {"logarithm", "Logarithm", "log₂(1 + c), each channel by itself (manual 15.7, Intel).", Uses()},
};
inline constexpr Choice kNeighborhoodShapes[] = {
    {"cross", "Cross", "Five samples: tighter box, more flicker (manual 8.1).", Uses()},
    {"square3x3", "3×3", "Nine samples (manual 8.2).", Uses()},
    {"x", "×", "The pixel and its diagonals (manual 8.3).", Uses()},
    {"rounded", "Rounded", "The middle between the bounds of nine and of five (manual 8.4, Playdead).",
     Uses()},
    {"alternate", "Alternating", "+ in even frames, × in odd ones (manual 8.6, Intel).", Uses()},
    {"varying", "Four taps that vary",
     "Four bilinear taps on the diagonals, ⅔ px away at rest and ½ px where things move or are far: "
     "½ + ⅙·sat(½/(‖v‖·z)). z in m, so that a scene in centimeters looks different (manual 8.5, "
     "Playdead).",
     Uses()},
    {"pairs", "Seven, by pairs",
     "One set for both of two columns, as a compute shader shares it: the left pixel, its diagonals and the "
     "two to its right, so that even and odd columns see the box from different places (manual 8.7, "
     "MiniEngine).",
     Uses()},
};
inline constexpr Choice kSpeedUnits[] = {
    {"px", "Pixels", "Of the picture, however many it has.", Uses()},
    {"lines1080", "Pixels of 1080 lines", "‖v‖·1080/H: the same for a picture of any size (DiligentFX).",
     Uses()},
    {"picture1080", "1080ths of the picture",
     "‖(vx/W, vy/H)‖·1080, as of a motion in texture coordinates: across it counts less than down (Godot, "
     "source 002).",
     Uses()},
};
inline constexpr Choice kMomentWeights[] = {
    {"equal", "Equal", "Every sample counts alike.", Uses()},
    {"luma", "Luma", "Samples weighted by 1/(1 + luma): fireflies pull less (manual 10.7).", Uses()},
    {"distance", "Distance", "exp(−¾ r²): near samples count more (manual 10.7, DiligentFX).", Uses()},
    {"boxLuma", "Luma of the box",
     "1/(1 + Y) with the luma of the box's space: of compressed colors all weights lie between ½ and 1 "
     "(manual 10.7, Godot).",
     Uses()},
};
inline constexpr Choice kBoxKinds[] = {
    {"minMax", "Min-max", "From the smallest to the largest sample (manual 10.1).", Uses()},
    {"variance", "Variance", "Mean ± γ deviations (manual 10.2, Salvi 2016).",
     Uses(USED(neighborhood.gamma), USED(neighborhood.motionGamma), USED(neighborhood.resolutionGamma),
          USED(neighborhood.contrastGamma))},
    {"intersection", "Both", "Variance box inside the min-max box (manual 10.3).",
     Uses(USED(neighborhood.gamma), USED(neighborhood.motionGamma), USED(neighborhood.resolutionGamma),
          USED(neighborhood.contrastGamma))},
};
inline constexpr Choice kOffScreens[] = {
    {"keep", "Keep", "Border pixels streak into the picture (manual 5.0).", Uses()},
    {"reject", "Reject", "Outside the picture there is no history (manual 5.1).", Uses()},
    {"margin", "With margin", "Half a pixel earlier, so that no filter reads beyond (manual 5.3, HDRP).",
     Uses()},
    {"oneSided", "One-sided, as printed",
     "As in the first listing of source 002: only the left edge is tested, the others streak; and beyond it "
     "nothing of the current frame is taken, α = 0, instead of nothing of history (manual 5.7, D9).",
     Uses()},
};
inline constexpr Choice kVelocityTests[] = {
    {"none", "None", "Motion may change as it likes.", Uses()},
    {"vector", "Vector", "Length of the difference: ‖v − v′‖ (manual 12.5, CryEngine 3, Godot).",
     Uses(USED(validate.velocityLimit), USED(validate.velocityGain))},
    {"length", "Length", "Difference of the lengths: |‖v‖ − ‖v′‖|; a turn is no change (manual 12.5, HDRP).",
     Uses(USED(validate.velocityLimit), USED(validate.velocityGain))},
};
inline constexpr Choice kDepthDirections[] = {
    {"both", "Nearer and farther", "Whatever is not as far away as expected (manual 12.1).", Uses()},
    {"nearer", "Nearer alone",
     "Only what is nearer can have hidden the surface; what is farther counts as the same (manual 12.1, "
     "MiniEngine, Intel, FSR2).",
     Uses()},
};
inline constexpr Choice kDepthFootprints[] = {
    {"square3x3", "3×3",
     "The texel at the history position and those around it: as wide as the jitter, and alike on all sides.",
     Uses()},
    {"readInMotion", "3×3 at rest",
     "Where something parts, only the texels that a bilinear tap reads, one to four; where nothing does, "
     "3×3. "
     "Keeps less of what hid the surface, at the price of the history's motion.",
     Uses()},
};
inline constexpr Choice kRejectActions[] = {
    {"restart", "Restart", "α = 1 and N = 1: the history is dropped (manual §12, hard).", Uses()},
    {"raiseAlpha", "Raise α",
     "The history stays, and α is at least a value of choice; only what is off the screen or has no history "
     "starts anew (manual §12, soft).",
     Uses(USED(validate.softAlpha))},
    {"decay", "Decay",
     "By the share r that is rejected N falls to N(1 − r) and α rises by r: a whole r starts anew "
     "(manual 12.5, 13.3, Godot).",
     Uses()},
};
inline constexpr Choice kRectifyMethods[] = {
    {"none", "None", "History is taken as it is: everything ghosts (manual 11.0).", Uses()},
    {"clamp", "Clamp", "Nearest point of the box (manual 11.1).", Uses(USED(rectify.relaxAtRest))},
    {"clipToCenter", "To center", "Clip towards the middle of the box (manual 11.2, Playdead).",
     Uses(USED(rectify.relaxAtRest))},
    {"clipToFiltered", "To filtered", "Clip towards the filtered current color (manual 11.3, Karis 2014).",
     Uses(USED(rectify.relaxAtRest))},
    {"shrinkAxes", "Shrink axes", "Towards the mean, one axis after the other (manual 11.5, Godot).",
     Uses(USED(rectify.relaxAtRest))},
    {"clampThenClip", "Clamp, then clip",
     "Clamp to the min-max box, then clip to the center of this one (manual 10.5, Raptor).",
     Uses(USED(rectify.relaxAtRest))},
    {"rayToCurrent", "Ray to current",
     "Along the ray to the current color, unless the box is hit too late (manual 11.4, DiligentFX).",
     Uses(USED(rectify.mostSteps), USED(rectify.relaxAtRest))},
    {"clipToHull", "To filtered, hull",
     "Towards the filtered color until thirteen slabs around the samples hold: nearly their convex hull, "
     "which "
     "no box and no γ widens (manual 10.12).",
     Uses(USED(rectify.relaxAtRest))},
    {"clipToBoth", "To filtered, both boxes",
     "Towards the filtered color until it lies in the min-max boxes of RGB and of the color space (of RGB: "
     "and of YCoCg): six slabs, which no γ widens (manual 9.7, Lottes).",
     Uses(USED(rectify.relaxAtRest))},
    {"clampForget", "Clamp and forget",
     "Nearest point of the box, and history that was moved counts as no more than 1.6 frames, a tenth of "
     "what "
     "FSR2 can accumulate (manual 11.7).",
     Uses(USED(rectify.relaxAtRest))},
    {"select", "Select",
     "The one of the nine samples that is nearest to history takes its place: no color of the past is left, "
     "and no ghost (manual 11.8, 17.6, Godot's proposal).",
     Uses(USED(rectify.relaxAtRest))},
};
inline constexpr Choice kAlphaSources[] = {
    {"constant", "Constant", "The same α everywhere (manual 13.1).", Uses(USED(weight.alpha))},
    {"historyLength", "History length", "1/(N+1): the exact mean until the floor is reached (manual 13.3).",
     Uses()},
    {"lumaDifference", "Luma difference",
     "More of the current frame where its luma differs from history: against ghosts (manual 13.10, "
     "Lottes).",
     Uses(USED(weight.most), USED(weight.least))},
    {"contrast", "Contrast", "Less of it where the box is large against the pixel's luma (manual 13.14).",
     Uses()},
    {"depth", "Depth", "More history far away; none for the sky (manual 13.8).", Uses(USED(weight.alpha))},
    {"lumaDifferenceAsPrinted", "Luma difference, as printed",
     "As printed in Raptor's chapter 11: of colors over 1 + their largest channel, and the weights are "
     "swapped, so that equal luma takes only the current frame and nothing is averaged (manual 13.12, "
     "D1).",
     Uses()},
    {"contrastPerChannel", "Contrast, by channel",
     "Each of red, green and blue by its own contrast, as Raptor's weights are vectors; N counts with the "
     "α of luma (manual 13.14, 14.2).",
     Uses()},
    {"confidence", "Confidence",
     "1 over a confidence that grows by 10 in each frame without motion and is 1 with it, between two "
     "limits. Wants N counted likewise (manual §16, Bevy).",
     Uses(USED(weight.most), USED(weight.least))},
    {"lumaDifferenceCompressed", "Luma difference, compressed",
     "As Luma difference, of colors over 1 + their largest channel: the corrected form of source 001, with "
     "limits of 1 and 0 (manual 13.12).",
     Uses(USED(weight.most), USED(weight.least))},
};
inline constexpr Choice kMotionAlphas[] = {
    {"none", "None", "Motion does not matter.", Uses()},
    {"linear", "Linear", "‖v‖/v₀ (manual 13.6).", Uses(USED(weight.motionSpeed), USED(weight.motionSpeedIn))},
    {"squared", "Squared",
     "(‖v‖/v₀)² with pixels, on top of α, where source 000 starts 0.025 below it (manual 13.4).",
     Uses(USED(weight.motionSpeed), USED(weight.motionSpeedIn))},
    {"squaredAsPrinted", "Squared, as printed",
     "As printed in source 000: from α − 0.025 to 1 by the square of a length in fractions of the picture, "
     "which stays near 0, so that all there is to it is 0.025 less (manual 13.4, D11).",
     Uses()},
    {"doubled", "Doubled", "α grows to 2α at v₀ and no further (manual 13.6, HDRP).",
     Uses(USED(weight.motionSpeed), USED(weight.motionSpeedIn))},
    {"added", "Added",
     "α + ‖v‖/v₀, up to 1: v₀ is 1/k of the picture's width, 19.2 px of 1920 for k = 100, 1.92 px for k = "
     "1000 "
     "(manual 13.5, source 002).",
     Uses(USED(weight.motionSpeed), USED(weight.motionSpeedIn))},
};
inline constexpr Choice kFlickerScales[] = {
    {"relative", "Relative", "Of the larger luma: |Ls − Lh|/(0.001 + max) (manual 13.11, Filament).", Uses()},
    {"compressed", "Compressed",
     "Of lumas after c/(1 + c), 0.299 R + 0.587 G + 0.114 B and at least 0.0001, against 1.001: dark "
     "differences count for little (manual 13.11, Godot).",
     Uses()},
};
inline constexpr Choice kSampleDistances[] = {
    {"none", "None",
     "A sample counts alike wherever in the pixel it lies. Below a render scale of 1 κ weighs its distance, "
     "whatever is chosen here (manual §22).",
     Uses()},
    {"gaussian", "Gaussian", "exp(−‖j‖²/2σ²) with σ² = 0.22 px² (manual 7.7, 7.4, source 004).", Uses()},
    {"parabola", "Parabola, at rest",
     "1 − ‖j‖², and 1 from a motion of 1 px on: max(smoothstep(0, 1, ‖v‖), 1 − ‖j‖²) (manual 13.6, "
     "Donut).",
     Uses()},
    {"gaussianMoving", "Gaussian, in motion",
     "At rest all samples count alike; in motion, fully from 1 px on, those near the center are preferred: "
     "1 − m + m·exp(−‖j‖²/2σ²), m = smoothstep(0, 1, ‖v‖), σ² = 0.22 px² (manual 7.7, source 004).",
     Uses()},
};
inline constexpr Choice kMaskAlphas[] = {
    {"off", "Off", "The mask does not matter.", Uses()},
    {"responsive", "Responsive", "At least α mask times the larger of both masks (manual 21.4, UE4).",
     Uses(USED(weight.maskAlpha))},
    {"reactive", "Reactive", "At least the reactive mask itself (manual 13.18, FSR2).", Uses()},
    {"exclude", "Exclude", "Only the current frame where the responsive mask is set (manual 21.4, HDRP).",
     Uses()},
};
inline constexpr Choice kToneWeights[] = {
    {"none", "None", "Plain blend: a firefly counts as much as it shines (manual 15.0).", Uses()},
    {"luma", "Luma", "Colors weighted by 1/(1 + luma) (manual 15.1, Karis 2014).", Uses()},
    {"reinhardChannel", "Reinhard", "Mixed after c/(1 + c), each channel by itself (manual 15.3).", Uses()},
    {"maxChannel", "Largest channel", "Mixed after c/(1 + largest channel) (manual 15.4, Filament).", Uses()},
    {"lumaAsPrinted", "Luma, as printed",
     "As printed in Raptor's chapter 11: the luma of the compressed color, so that weights only span 1 to ½ "
     "and fireflies stay (manual §26, D19).",
     Uses()},
    {"pq", "PQ",
     "Mixed as SMPTE ST 2084 codes them, 10000 as 1. Goes on beyond 1, where Donut cuts it off (manual "
     "15.5, Donut).",
     Uses()},
    {"logarithm", "Logarithm", "Mixed as log₂(1 + c) (manual 15.7).", Uses()},
    {"whitePoint", "White point",
     "A project's own curve: c(1 + c/W²)/(1 + c), Reinhard's with a white that becomes 1, and its inverse "
     "(manual 15.6, source 002; Reinhard et al. 2002).",
     Uses(USED(blend.white))},
};
inline constexpr Choice kRestarts[] = {
    {"filtered", "Filtered", "Pixels without history show the filtered current color (manual 5.2).", Uses()},
    {"blurred", "Blurred", "They show the mean of the pixel and its diagonals (manual 5.6, 7.8, Intel).",
     Uses()},
};
inline constexpr Choice kLengthRules[] = {
    {"variance", "Variance", "The inverse of the variance that is left (manual §16, eq. 2.4 corrected).",
     Uses()},
    {"count", "Count", "N + 1, as if every frame counted alike (manual §16, eq. 2.3).", Uses()},
    {"varianceAsPrinted", "Variance, as printed",
     "As printed in source 004: without the inverse, so that N falls to 0.618 (manual §26, D12).", Uses()},
    {"confidence", "Confidence",
     "N + 10 where nothing moves, else 1: the count that α from confidence goes by (manual §16, Bevy).",
     Uses()},
    {"reciprocal", "1/α",
     "As if every α were the mean's, so that after motion the count starts low again: w′ = 1/(2 − w) of "
     "history's weight (manual §16, Intel, MiniEngine, DiligentFX).",
     Uses()},
    {"countTo16", "Count to 16",
     "N + 1, and never more than 16; the first frame of all is not counted, so that the second replaces it "
     "(manual §16, Godot).",
     Uses()},
};
inline constexpr Choice kSharpens[] = {
    {"none", "None", "What is resolved is shown.", Uses()},
    {"lumaRatio", "Luma ratio",
     "Luma minus the mean luma of nine, hue kept; black stays black (manual 18.1, Raptor).",
     Uses(USED(output.amount), USED(output.dering))},
    {"laplacian", "Laplacian",
     "Minus the mean of the four around: c + k(c − mean₄) (manual 18.3, HDRP's pass after).",
     Uses(USED(output.amount), USED(output.dering))},
    {"unsharp", "Unsharp mask", "Minus the mean of all nine: c + k(c − mean₉) (manual 18.3, source 000).",
     Uses(USED(output.amount), USED(output.dering))},
    {"rcas", "RCAS",
     "As strong as no channel leaves 0 to 1, of colors divided by 1 + their largest channel, because it "
     "expects those; amounts above 1 count as 1 (manual 18.5, FSR 1, URP).",
     Uses(USED(output.amount), USED(output.dering))},
    {"inResolve", "In the resolve",
     "c + 3k max(0, c − mean of this frame's nine samples over 1 + luma): only brightens (manual 18.6, "
     "HDRP).",
     Uses(USED(output.amount), USED(output.dering))},
    {"logarithm", "Logarithm",
     "Laplacian of log₂(1 + c), as (1 + c)((1 + c)/geometric mean₄)ᵏ − 1 with k in steps of 1/256 "
     "(manual 18.7, Intel, MiniEngine).",
     Uses(USED(output.amount), USED(output.dering))},
    {"reconstruct", "Reconstruct",
     "Resampled by the cubic of Mitchell and Netravali with B = −k: at k = 0 Catmull-Rom, which changes "
     "nothing at a pixel's center (manual 18.4, source 000).",
     Uses(USED(output.amount), USED(output.dering))},
    {"mitchell", "Mitchell, B = C = ⅓",
     "The cubic that Mitchell and Netravali recommend, at the pixels' centers: 1/18, 8/9, 1/18 each way, a "
     "slight blur that calms what flickers; Reconstruct with k = −⅓ (manual 6.6, 18.4, source 000).",
     Uses()},
};

} // namespace taa
