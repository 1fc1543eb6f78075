// What jitter and inputs can be: choices that the scene is drawn with.
#pragma once

#include "core/settings/Parameters.h"
#include "core/settings/Used.h"

namespace taa {

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
inline constexpr Choice kDynamicRanges[] = {
    {"hdr", "HDR", "Scene-linear colors as they were shaded, before bloom and tone mapping (manual 1.1).",
     Uses()},
    {"ldr", "LDR",
     "What is brighter than white is white before anything is averaged, as after a tone map that clips: "
     "fireflies are tame, and bright edges lose what lies above (manual 1.2, Playdead). Kept linear.",
     Uses()},
};
// Of noise, wherever it is added.
inline constexpr const char* kGradientNoise =
    "Interleaved gradient noise, another in each of 64 frames; neighbors differ much, along lines (manual "
    "20.1).";
inline constexpr const char* kBlueNoise =
    "A tile of 32×32 by void-and-cluster, moved on by the golden ratio in each of 256 frames: no low "
    "frequencies in space, evenly spread in time, which TAA averages best (manual 20.2, Raptor).";
inline constexpr const char* kWhiteNoise =
    "A hash of pixel and frame, 256 of them: neighbors and frames have nothing to do with each other, which "
    "TAA averages worst (manual §20).";
inline constexpr Choice kInputNoises[] = {
    {"none", "None", "Colors as they were shaded.", Uses()},
    {"gradientNoise", "Gradient noise", kGradientNoise,
     Uses(USED(inputs.noiseAmount), USED(inputs.noiseTriangular))},
    {"blueNoise", "Blue noise", kBlueNoise, Uses(USED(inputs.noiseAmount), USED(inputs.noiseTriangular))},
    {"whiteNoise", "White noise", kWhiteNoise, Uses(USED(inputs.noiseAmount), USED(inputs.noiseTriangular))},
};
inline constexpr Choice kFogNoises[] = {
    {"none", "None",
     "All rays stop at the same distances: as many levels as steps fit into a beam, in bands.", Uses()},
    {"gradientNoise", "Gradient noise", kGradientNoise, Uses(USED(inputs.fogAnimated))},
    {"blueNoise", "Blue noise", kBlueNoise, Uses(USED(inputs.fogAnimated))},
    {"whiteNoise", "White noise", kWhiteNoise, Uses(USED(inputs.fogAnimated))},
};
inline constexpr Choice kShadows[] = {
    {"asScene", "As the scene",
     "As what is open wants them: none where they are no part of what it shows, or where it has no sun.",
     Uses(USED(inputs.sunRadius), USED(inputs.shadowRays), USED(inputs.shadowNoise))},
    {"none", "None", "The sun shines through everything: things seem to float.", Uses()},
    {"hard", "Hard",
     "Of a point-like sun: one texture of depths as the sun sees them, compared in 2×2 texels.", Uses()},
    {"soft", "Soft",
     "Of the sun's disk: sharp where a thing stands, wider with its distance. Rays are traced in the sun's "
     "texture of depths, as Unreal Engine does (shadow map ray tracing); few of them are noise, which TAA "
     "has to average.",
     Uses(USED(inputs.sunRadius), USED(inputs.shadowRays), USED(inputs.shadowNoise))},
};
inline constexpr Choice kShadowNoises[] = {
    {"none", "None", "All pixels send the same rays: the shadow's edge has as many levels as rays, in bands.",
     Uses()},
    {"gradientNoise", "Gradient noise", kGradientNoise, Uses()},
    {"blueNoise", "Blue noise", kBlueNoise, Uses()},
    {"whiteNoise", "White noise", kWhiteNoise, Uses()},
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

} // namespace taa
