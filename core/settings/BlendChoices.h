// What can be chosen of the weight of the current frame, of the mix and of what is shown.
#pragma once

#include "core/settings/Parameters.h"
#include "core/settings/Used.h"

namespace taa {

inline constexpr Choice kAlphaSources[] = {
    {"constant", "Constant", "The same α everywhere (manual 13.1).", Uses(USED(weight.alpha)), "baseWeight"},
    {"historyLength", "History length", "1/(N+1): the exact mean until the floor is reached (manual 13.3).",
     Uses(), "baseWeight"},
    {"lumaDifference", "Luma difference",
     "More of the current frame where its luma differs from history: against ghosts (manual 13.10, "
     "Lottes).",
     Uses(USED(weight.sourceMax), USED(weight.sourceMin), USED(space.luma)), "lumaLikeness"},
    {"contrast", "Contrast", "Less of it where the box is large against the pixel's luma (manual 13.14).",
     Uses(), "contrastWeight"},
    {"depth", "Depth", "More history far away; none for the sky (manual 13.8).", Uses(USED(weight.alpha)),
     "baseWeight"},
    {"lumaDifferenceAsPrinted", "Luma difference, as printed",
     "As printed in Raptor's chapter 11: of colors over 1 + their largest channel, and the weights are "
     "swapped, so that equal luma takes only the current frame and nothing is averaged (manual 13.12, "
     "D1).",
     Uses(USED(space.luma)), "lumaLikeness"},
    {"contrastPerChannel", "Contrast, by channel",
     "Each of red, green and blue by its own contrast, as Raptor's weights are vectors; N counts with the "
     "α of luma (manual 13.14, 14.2).",
     Uses(), "channelWeights"},
    {"confidence", "Confidence",
     "1 over a confidence that grows by 10 in each frame without motion and is 1 with it, between two "
     "limits. Wants N counted likewise (manual §16, Bevy).",
     Uses(USED(weight.sourceMax), USED(weight.sourceMin)), "confidenceAfter"},
    {"lumaDifferenceCompressed", "Luma difference, compressed",
     "As Luma difference, of colors over 1 + their largest channel: the corrected form of source 001, with "
     "limits of 1 and 0 (manual 13.12).",
     Uses(USED(weight.sourceMax), USED(weight.sourceMin), USED(space.luma)), "lumaLikeness"},
};
inline constexpr Choice kMotionAlphas[] = {
    {"none", "None", "Motion does not matter.", Uses()},
    {"linear", "Linear", "‖v‖/v₀ (manual 13.6).", Uses(USED(weight.motionSpeed), USED(weight.motionSpeedIn)),
     "motionWeight"},
    {"squared", "Squared",
     "(‖v‖/v₀)² with pixels, on top of α, where source 000 starts 0.025 below it (manual 13.4).",
     Uses(USED(weight.motionSpeed), USED(weight.motionSpeedIn)), "motionWeight"},
    {"squaredAsPrinted", "Squared, as printed",
     "As printed in source 000: from α − 0.025 to 1 by the square of a length in fractions of the picture, "
     "which stays near 0, so that all there is to it is 0.025 less (manual 13.4, D11).",
     Uses(), "motionWeight"},
    {"doubled", "Doubled", "α grows to 2α at v₀ and no further (manual 13.6, HDRP).",
     Uses(USED(weight.motionSpeed), USED(weight.motionSpeedIn)), "motionWeight"},
    {"added", "Added",
     "α + ‖v‖/v₀, up to 1: v₀ is 1/k of the picture's width, 19.2 px of 1920 for k = 100, 1.92 px for k = "
     "1000 "
     "(manual 13.5, source 002).",
     Uses(USED(weight.motionSpeed), USED(weight.motionSpeedIn)), "movedWeight"},
};
inline constexpr Choice kFlickerScales[] = {
    {"relative", "Relative", "Of the larger luma: |Ls − Lh|/(0.001 + max) (manual 13.11, Filament).",
     Uses(USED(space.luma)), "lumaFlickerFactor"},
    {"compressed", "Compressed",
     "Of lumas after c/(1 + c), 0.299 R + 0.587 G + 0.114 B and at least 0.0001, against 1.001: dark "
     "differences count for little (manual 13.11, Godot).",
     Uses(), "lumaFlickerFactor"},
};
inline constexpr Choice kSampleDistances[] = {
    {"none", "None",
     "A sample counts alike wherever in the pixel it lies. Below a render scale of 1 κ weighs its distance, "
     "whatever is chosen here (manual §22).",
     Uses()},
    {"gaussian", "Gaussian", "exp(−‖j‖²/2σ²) with σ² = 0.22 px² (manual 7.7, 7.4, source 004).", Uses(),
     "sampleDistanceFactor"},
    {"parabola", "Parabola, at rest",
     "1 − ‖j‖², and 1 from a motion of 1 px on: max(smoothstep(0, 1, ‖v‖), 1 − ‖j‖²) (manual 13.6, "
     "Donut).",
     Uses(), "sampleDistanceFactor"},
    {"gaussianMoving", "Gaussian, in motion",
     "At rest all samples count alike; in motion, fully from 1 px on, those near the center are preferred: "
     "1 − m + m·exp(−‖j‖²/2σ²), m = smoothstep(0, 1, ‖v‖), σ² = 0.22 px² (manual 7.7, source 004).",
     Uses(), "sampleDistanceFactor"},
};
inline constexpr Choice kMaskAlphas[] = {
    {"off", "Off", "The mask does not matter.", Uses()},
    {"responsive", "Responsive", "At least α mask times the larger of both masks (manual 21.4, UE4).",
     Uses(USED(weight.maskAlpha)), "maskWeight"},
    {"reactive", "Reactive", "At least the reactive mask itself (manual 13.18, FSR2).", Uses(), "maskWeight"},
    {"exclude", "Exclude", "Only the current frame where the responsive mask is set (manual 21.4, HDRP).",
     Uses(), "maskWeight"},
};
inline constexpr Choice kToneWeights[] = {
    {"none", "None", "Plain blend: a firefly counts as much as it shines (manual 15.0).", Uses()},
    {"luma", "Luma", "Colors weighted by 1/(1 + luma) (manual 15.1, Karis 2014).", Uses(USED(space.luma)),
     "toneWeight"},
    {"reinhardChannel", "Reinhard", "Mixed after c/(1 + c), each channel by itself (manual 15.3).", Uses(),
     "compress"},
    {"maxChannel", "Largest channel", "Mixed after c/(1 + largest channel) (manual 15.4, Filament).", Uses(),
     "compress"},
    {"lumaAsPrinted", "Luma, as printed",
     "As printed in Raptor's chapter 11: the luma of the compressed color, so that weights only span 1 to ½ "
     "and fireflies stay (manual §26, D19).",
     Uses(USED(space.luma)), "toneWeight"},
    {"pq", "PQ",
     "Mixed as SMPTE ST 2084 codes them, 10000 as 1. Goes on beyond 1, where Donut cuts it off (manual "
     "15.5, Donut).",
     Uses(), "compress"},
    {"logarithm", "Logarithm", "Mixed as log₂(1 + c) (manual 15.7).", Uses(), "compress"},
    {"whitePoint", "White point",
     "A project's own curve: c(1 + c/W²)/(1 + c), Reinhard's with a white that becomes 1, and its inverse "
     "(manual 15.6, source 002; Reinhard et al. 2002).",
     Uses(USED(blend.white)), "compress"},
};
inline constexpr Choice kRestarts[] = {
    {"filtered", "Filtered", "Pixels without history show the filtered current color (manual 5.2).", Uses()},
    {"blurred", "Blurred", "They show the mean of the pixel and its diagonals (manual 5.6, 7.8, Intel).",
     Uses(), "blurredRestart"},
};
inline constexpr Choice kLengthRules[] = {
    {"variance", "Variance", "The inverse of the variance that is left (manual §16, eq. 2.4 corrected).",
     Uses(), "lengthAfter"},
    {"count", "Count", "N + 1, as if every frame counted alike (manual §16, eq. 2.3).", Uses(),
     "lengthAfter"},
    {"varianceAsPrinted", "Variance, as printed",
     "As printed in source 004: without the inverse, so that N falls to 0.618 (manual §26, D12).", Uses(),
     "lengthAfter"},
    {"confidence", "Confidence",
     "N + 10 where nothing moves, else 1: the count that α from confidence goes by (manual §16, Bevy).",
     Uses(), "lengthAfter"},
    {"reciprocal", "1/α",
     "As if every α were the mean's, so that after motion the count starts low again: w′ = 1/(2 − w) of "
     "history's weight (manual §16, Intel, MiniEngine, DiligentFX).",
     Uses(), "lengthAfter"},
    {"countTo16", "Count to 16",
     "N + 1, and never more than 16; the first frame of all is not counted, so that the second replaces it "
     "(manual §16, Godot).",
     Uses(), "lengthAfter"},
};
inline constexpr Choice kSharpens[] = {
    {"none", "None", "What is resolved is shown.", Uses()},
    {"lumaRatio", "Luma ratio",
     "Luma minus the mean luma of nine, hue kept; black stays black (manual 18.1, Raptor).",
     Uses(USED(output.amount), USED(output.dering)), "sharpenedByLuma"},
    {"laplacian", "Laplacian",
     "Minus the mean of the four around: c + k(c − mean₄) (manual 18.3, HDRP's pass after).",
     Uses(USED(output.amount), USED(output.dering)), "sharpenedByLaplacian"},
    {"unsharp", "Unsharp mask", "Minus the mean of all nine: c + k(c − mean₉) (manual 18.3, source 000).",
     Uses(USED(output.amount), USED(output.dering)), "unsharpMasked"},
    {"rcas", "RCAS",
     "As strong as no channel leaves 0 to 1, of colors divided by 1 + their largest channel, because it "
     "expects those; amounts above 1 count as 1 (manual 18.5, FSR 1, URP).",
     Uses(USED(output.amount), USED(output.dering)), "sharpenedByRcas"},
    {"inResolve", "In the resolve",
     "c + 3k max(0, c − mean of this frame's nine samples over 1 + luma): only brightens (manual 18.6, "
     "HDRP).",
     Uses(USED(output.amount), USED(output.dering)), "brightenedInResolve"},
    {"logarithm", "Logarithm",
     "Laplacian of log₂(1 + c), as (1 + c)((1 + c)/geometric mean₄)ᵏ − 1 with k in steps of 1/256 "
     "(manual 18.7, Intel, MiniEngine).",
     Uses(USED(output.amount), USED(output.dering)), "sharpenedInLogarithms"},
    {"reconstruct", "Reconstruct",
     "Resampled by the cubic of Mitchell and Netravali with B = −k: at k = 0 Catmull-Rom, which changes "
     "nothing at a pixel's center (manual 18.4, source 000).",
     Uses(USED(output.amount), USED(output.dering)), "reconstructed"},
    {"mitchell", "Mitchell, B = C = ⅓",
     "The cubic that Mitchell and Netravali recommend, at the pixels' centers: 1/18, 8/9, 1/18 each way, a "
     "slight blur that calms what flickers; Reconstruct with k = −⅓ (manual 6.6, 18.4, source 000).",
     Uses(), "mitchellFiltered"},
};

} // namespace taa
