// The one table of intermediates: GLSL expose macros, views, list, probe rows, EXR parts, JSON and tests
// derive from it.
#pragma once

#include "core/settings/Stage.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace taa {

/// How a view shows it unless told otherwise.
enum class Visual : std::uint8_t {
  Color,    ///< scene-linear RGB, exposed and encoded
  Box,      ///< three channels of the box's color space, shown as they are
  Depth,    ///< one channel, logarithmic
  Scalar,   ///< one channel, sequential color map
  Signed,   ///< one channel, diverging color map around 0
  Vector,   ///< two channels, direction as hue and length as saturation
  Position, ///< two channels, shown as fractions of the picture's size
  Normal,   ///< three channels in −1…1
  Mask,     ///< 0 or 1
  Index,    ///< integers, categorical colors
};

/// What measures rows over several frames: each all of its rows at once.
enum class OverTime : std::uint8_t {
  None,
  Flicker, ///< core/measure/Flicker.h
  Parts,   ///< core/verdict/parts/ErrorParts.h
};

/// What a row is made of besides its frame's own resolve.
struct MadeOf {
  bool isReference = false; ///< the supersampled picture
  bool isEngine = false;    ///< the output of the engine a capture was taken of
  bool isAround = false;    ///< output and reference in the pixels around it, too
  OverTime overTime = OverTime::None;
};
inline constexpr MadeOf kOfReference{.isReference = true};
inline constexpr MadeOf kOfPixelsAround{.isReference = true, .isAround = true};
inline constexpr MadeOf kOfEngine{.isEngine = true};
inline constexpr MadeOf kOfFrames{.overTime = OverTime::Flicker};
inline constexpr MadeOf kOfFlicker{.isReference = true, .overTime = OverTime::Flicker};
inline constexpr MadeOf kOfParts{.isReference = true, .overTime = OverTime::Parts};

// One row each: id, label, stage, channels, unit, range (lowest, highest shown), visual, description, and of
// stage Reference what else it is made of. Colors are scene-linear Rec. 709; "box space" is the color space
// of parameters space.color and space.tone. Motion is current − previous, x right, y down. Where the scene is
// drawn smaller than the picture, rows show the nearest render texel; "render px" are pixels of that size,
// "px" those of the picture.
#define TAA_INTERMEDIATES(ROW)                                                                               \
  ROW(color, "Color", Inputs, 3, "", 0, 1, Color, "This frame's jittered samples, scene-linear.")            \
  ROW(depth, "Depth", Inputs, 1, "", 0, 1, Depth, "Device depth: reversed, 0 is the sky.")                   \
  ROW(depthView, "View depth", Inputs, 1, "m", 0, 20, Depth,                                                 \
      "Distance along the view axis; 0 stands for the sky.")                                                 \
  ROW(motion, "Motion", Inputs, 2, "px", -16, 16, Vector,                                                    \
      "Where the surface came from, render px: current minus previous position, jitter removed; 65504 "      \
      "where there is no previous.")                                                                         \
  ROW(normal, "Normal", Inputs, 3, "", -1, 1, Normal, "Shading normal in world space.")                      \
  ROW(objectId, "Object id", Inputs, 1, "", 0, 255, Index, "Number of the drawn object; 0 is the sky.")      \
  ROW(reactive, "Reactive", Inputs, 1, "", 0, 1, Scalar,                                                     \
      "Mask of what was blended into the color; 0 where none is drawn.")                                     \
  ROW(responsive, "Responsive", Inputs, 1, "", 0, 1, Scalar,                                                 \
      "Mask of materials that change without motion: screens, flip-books, particles; 0 where none is "       \
      "drawn.")                                                                                              \
  ROW(overlay, "Overlay", Inputs, 3, "", 0, 1, Color,                                                        \
      "What is laid over the output, without jitter, times its opacity; 0 where nothing is.")                \
  ROW(overlayAlpha, "Overlay opacity", Inputs, 1, "", 0, 1, Scalar,                                          \
      "How much of the output the overlay hides.")                                                           \
  ROW(fog, "Fog", Inputs, 3, "", 0, 1, Color, "Light that fog adds to the color; 0 where there is none.")    \
  ROW(fogOpacity, "Fog opacity", Inputs, 1, "", 0, 1, Scalar,                                                \
      "How much of the surface's light the fog takes: 1 − transmittance.")                                   \
  ROW(objectClass, "Object class", Inputs, 1, "", 0, 4, Index,                                               \
      "What the object is: 0 the sky, 1 still, 2 moves rigidly, 3 deforms, 4 a character.")                  \
  ROW(forwardCount, "Forward count", Inputs, 1, "", -1, 4, Index,                                            \
      "Pixels of the last frame whose surface lies here now, render px: 0 a hole of forward reprojection, "  \
      "2 and more a collision; −1 where inputs.forward is off or frames do not say it.")                     \
  ROW(dilatedOffset, "Dilated offset", DilateMotion, 2, "px", -1, 1, Vector,                                 \
      "Which neighbor lends its motion: the step to it, in render px; (0, 0) is the pixel itself.")          \
  ROW(dilatedDepth, "Dilated depth", DilateMotion, 1, "", 0, 1, Depth, "Device depth of that neighbor.")     \
  ROW(dilatedMotion, "Dilated motion", DilateMotion, 2, "px", -16, 16, Vector,                               \
      "Motion of that neighbor, from here on in px of the picture.")                                         \
  ROW(historyPosition, "History position", Reproject, 2, "px", 0, 0, Position,                               \
      "Where this pixel was in the previous frame: the pixel center minus the dilated motion.")              \
  ROW(onScreen, "On screen", Reproject, 1, "", 0, 1, Mask,                                                   \
      "Whether history can exist there: 1 where the history position lies inside the picture.")              \
  ROW(speed, "Speed", Reproject, 1, "px", 0, 16, Scalar, "Length of the dilated motion.")                    \
  ROW(historyRaw, "History", SampleHistory, 3, "", 0, 1, Color,                                              \
      "The accumulated color, read at the history position before anything is done to it.")                  \
  ROW(historyRawLength, "History length before", SampleHistory, 1, "frames", 0, 20, Scalar,                  \
      "How many frames of samples history holds there (N).")                                                 \
  ROW(depthEdge, "Depth edge", SampleHistory, 1, "", 0, 1, Mask,                                             \
      "1 where history was read by one bilinear tap because of an edge in depth; 0 when off.")               \
  ROW(currentFiltered, "Current filtered", FilterCurrent, 3, "", 0, 1, Color,                                \
      "This frame's color, filtered to the pixel's center.")                                                 \
  ROW(sampleConfidence, "κ", FilterCurrent, 1, "", 0, 1, Scalar,                                             \
      "How much this frame's samples say about the pixel, a factor on α; 1 when drawn at full size.")        \
  ROW(neighborhoodMean, "Mean", Neighborhood, 3, "", 0, 1, Box, "Mean of the neighborhood, box space.")      \
  ROW(neighborhoodDeviation, "Deviation", Neighborhood, 3, "", 0, 1, Box,                                    \
      "Standard deviation of the neighborhood, box space.")                                                  \
  ROW(neighborhoodMin, "Minimum", Neighborhood, 3, "", 0, 1, Box, "Smallest of each channel, box space.")    \
  ROW(neighborhoodMax, "Maximum", Neighborhood, 3, "", 0, 1, Box, "Largest of each channel, box space.")     \
  ROW(boxGamma, "γ used", Neighborhood, 1, "σ", 0, 4, Scalar,                                                \
      "How wide the color box is: standard deviations from the mean to its wall, after motion and "          \
      "contrast.")                                                                                           \
  ROW(boxMin, "Box minimum", Neighborhood, 3, "", 0, 1, Box,                                                 \
      "Lower corner of the color box that history is clipped to, box space.")                                \
  ROW(boxMax, "Box maximum", Neighborhood, 3, "", 0, 1, Box,                                                 \
      "Upper corner of the color box that history is clipped to, box space.")                                \
  ROW(depthExpected, "Depth expected", ValidateHistory, 1, "m", 0, 20, Depth,                                \
      "How far away this surface was in the previous frame (view depth).")                                   \
  ROW(historyDepth, "History depth", ValidateHistory, 1, "m", 0, 20, Depth,                                  \
      "Depth stored with the history, the best match of the texels around that are asked; 0: the sky.")      \
  ROW(depthMismatch, "Depth mismatch", ValidateHistory, 1, "", 0, 0.1, Scalar,                               \
      "Relative difference of expected and stored depth, 0 for what is farther where that does not count; "  \
      "the depth test rejects what is above the allowed one.")                                               \
  ROW(depthAllowed, "Depth allowed", ValidateHistory, 1, "", 0, 0.1, Scalar,                                 \
      "How much depth may differ for history to be kept: the tolerance, and more on surfaces that "          \
      "recede.")                                                                                             \
  ROW(geometricFlicker, "Geometric flicker", ValidateHistory, 1, "", 0, 1, Mask,                             \
      "1 where depth differs at rest because single frames miss a thin feature: history is kept.")           \
  ROW(historyObjectId, "History object id", ValidateHistory, 1, "", 0, 255, Index,                           \
      "Object stored with the history: that of this pixel when it is one of the nine texels around, else "   \
      "the nearest one; 0: the sky, or not kept.")                                                           \
  ROW(normalAgreement, "Normal agreement", ValidateHistory, 1, "", -1, 1, Signed,                            \
      "Cosine between the normals of now and then, the best of nine; 1 when off.")                           \
  ROW(velocityChange, "Velocity change", ValidateHistory, 1, "px", 0, 16, Scalar,                            \
      "Change of motion since the previous frame, the smallest of nine; 0 when off.")                        \
  ROW(rejectReason, "Reject reason", ValidateHistory, 1, "", 0, 9, Index,                                    \
      "Why history was rejected: 0 kept, 1 no history, 2 no previous position, 3 off screen, 4 depth, 5 "    \
      "too fast, 6 another object, 7 another class, 8 another normal, 9 another velocity.")                  \
  ROW(historyRectified, "History rectified", RectifyHistory, 3, "", 0, 1, Color,                             \
      "History after it was clipped to the color box.")                                                      \
  ROW(clipAmount, "Clip amount", RectifyHistory, 1, "", 0, 1, Scalar,                                        \
      "How far history was moved towards its target: 0 not at all, 1 the whole distance.")                   \
  ROW(rectifyStrength, "Rectify strength", RectifyHistory, 1, "", 0, 1, Scalar,                              \
      "How much of the correction is applied: 1 is all of it.")                                              \
  ROW(lock, "Lock", RectifyHistory, 1, "", 0, 1, Scalar,                                                     \
      "How much of the correction a lock takes back; 0 when off.")                                           \
  ROW(lockLife, "Lock life", RectifyHistory, 1, "", 0, 2, Scalar,                                            \
      "How long the lock still lasts: 2 when it was set in this frame, below 1 it does nothing, 0 "          \
      "is no lock.")                                                                                         \
  ROW(instability, "Luma instability", RectifyHistory, 1, "", 0, 1, Mask,                                    \
      "1 where luma comes and goes, which takes back all of the correction; 0 when off.")                    \
  ROW(historyKeptLength, "History length kept", RectifyHistory, 1, "frames", 0, 20, Scalar,                  \
      "How many frames of samples are left after rectification (N); less than before only where "            \
      "it forgets.")                                                                                         \
  ROW(alphaBase, "α base", BlendWeight, 1, "", 0, 1, Scalar,                                                 \
      "How much this frame counts by the chosen source alone, before any other term.")                       \
  ROW(alphaFloor, "α floor", BlendWeight, 1, "", 0, 1, Scalar,                                               \
      "The smallest α that the terms before motion may lead to.")                                            \
  ROW(alphaLumaFlicker, "α damping luma", BlendWeight, 1, "", 0, 1, Scalar,                                  \
      "Factor on α where luma differs from history; 1 when off.")                                            \
  ROW(alphaNearClamp, "α damping clamp", BlendWeight, 1, "", 0, 1, Scalar,                                   \
      "Factor on α by the distance of history to the box's walls; 1 when off.")                              \
  ROW(alphaHistoryContrast, "α damping contrast", BlendWeight, 1, "", 0, 1, Scalar,                          \
      "Factor on α by the size of the box; 1 when off.")                                                     \
  ROW(alphaRelax, "α relax", BlendWeight, 1, "", 0, 1, Scalar,                                               \
      "Factor on α where the mask is set; 1 when off.")                                                      \
  ROW(alphaSampleDistance, "α sample distance", BlendWeight, 1, "", 0, 1, Scalar,                            \
      "Factor on α by how far the sample is from the pixel's center; 1 when off.")                           \
  ROW(alphaFlicker, "α at flicker", BlendWeight, 1, "", 0, 1, Scalar,                                        \
      "Factor on α, after its floor, at geometric flicker; 1 elsewhere and when off.")                       \
  ROW(alphaMotion, "α motion", BlendWeight, 1, "", 0, 1, Scalar, "What motion adds to α; 0 when off.")       \
  ROW(alphaVelocityChange, "α velocity change", BlendWeight, 1, "", 0, 1, Scalar,                            \
      "What a change of motion adds to α; 0 when off.")                                                      \
  ROW(alphaDivergence, "α divergence", BlendWeight, 1, "", 0, 1, Scalar,                                     \
      "What motion that parts adds to α; 0 when off.")                                                       \
  ROW(alphaFrameRate, "α by frame rate", BlendWeight, 1, "", 0, 1, Scalar,                                   \
      "α after motion, for the time this frame took; unchanged when off.")                                   \
  ROW(alphaMask, "α mask", BlendWeight, 1, "", 0, 1, Scalar,                                                 \
      "The least that the mask asks of α; 0 when off.")                                                      \
  ROW(alphaInvalid, "α invalid", BlendWeight, 1, "", 0, 1, Scalar,                                           \
      "How much this frame has to count because history was rejected: 1 drops history, 0 keeps "             \
      "it.")                                                                                                 \
  ROW(alpha, "α", BlendWeight, 1, "", 0, 1, Scalar,                                                          \
      "How much this frame counts: 0.1 is one tenth, the rest is history. Base times the damping "           \
      "factors, not below the floor; then motion, frame time and κ; not below α mask and α "              \
      "invalid.")                                                                                            \
  ROW(alphaChannels, "α of channels", BlendWeight, 3, "", 0, 1, Color,                                       \
      "How much this frame counts in red, green and blue: α in each, unless the source of α has "          \
      "one per channel.")                                                                                    \
  ROW(toneWeightCurrent, "Tone weight current", Blend, 1, "", 0, 1, Scalar,                                  \
      "1/(1+luma) of the current color, 1 without tone weighting.")                                          \
  ROW(toneWeightHistory, "Tone weight history", Blend, 1, "", 0, 1, Scalar,                                  \
      "1/(1+luma) of the rectified history, 1 without tone weighting.")                                      \
  ROW(blendFactor, "Blend factor", Blend, 1, "", 0, 1, Scalar,                                               \
      "How much of the result is this frame, after bright colors were weighed down.")                        \
  ROW(historyLength, "History length", Blend, 1, "frames", 0, 20, Scalar,                                    \
      "How many frames of samples the pixel holds from now on (N).")                                         \
  ROW(resolved, "Resolved", Blend, 3, "", 0, 1, Color,                                                       \
      "The result of TAA for this frame; the next frame reads it as history.")                               \
  ROW(sharpenDetail, "Sharpening", Output, 1, "", -0.1, 0.1, Signed,                                         \
      "Luma that sharpening adds to the resolved color; 0 when off.")                                        \
  ROW(blurTrust, "Blur trust", Output, 1, "", 0, 1, Scalar,                                                  \
      "Share of the resolved color in what is shown; the rest is this frame blurred along its motion.")      \
  ROW(output, "Output", Output, 3, "", 0, 1, Color,                                                          \
      "What is shown: the resolved color sharpened, or blurred where it moves fast, and the overlay over "   \
      "it; the same as resolved when all are off.")                                                          \
  ROW(reference, "Reference", Reference, 3, "", 0, 1, Color,                                                 \
      "The same instant drawn many times over the pixel's square, without mip bias and noise, at full "      \
      "size: the mean, scene-linear.",                                                                       \
      kOfReference)                                                                                          \
  ROW(referenceError, "Error", Reference, 1, "", -0.25, 0.25, Signed,                                        \
      "Luma of the output less luma of the reference, scene-linear: above 0 the output is too bright.",      \
      kOfReference)                                                                                          \
  ROW(referenceErrorAbs, "Absolute error", Reference, 1, "", 0, 0.25, Scalar,                                \
      "Largest difference of output and reference in red, green or blue, scene-linear.", kOfReference)       \
  ROW(relativeError, "Relative error", Reference, 1, "", 0, 1, Scalar,                                       \
      "Squared difference of output and reference over the reference's own square + 0.01, scene-linear: "    \
      "the "                                                                                                 \
      "mean over red, green and blue.",                                                                      \
      kOfReference)                                                                                          \
  ROW(flip, "FLIP", Reference, 1, "", 0, 1, Scalar,                                                          \
      "How much a person who flips between output and reference sees of their difference, on a screen with " \
      "67 pixels per degree: 0 nothing, 1 all there can be.",                                                \
      kOfPixelsAround)                                                                                       \
  ROW(ssimMap, "1 − SSIM", Reference, 1, "", 0, 1, Scalar,                                                   \
      "How unlike output and reference are in structure, by luma as it is shown in 11 × 11 pixels: 0 "      \
      "alike, "                                                                                              \
      "1 nothing in common, 2 the negative.",                                                                \
      kOfPixelsAround)                                                                                       \
  ROW(ghost, "Ghost", Reference, 1, "", 0, 0.25, Scalar,                                                     \
      "Part of the error that lies towards what was shown a frame ago where history was read: of what is "   \
      "shown (sRGB, 0 to 1), without what a blur of the reference could have made.",                         \
      kOfFlicker)                                                                                            \
  ROW(flicker, "Flicker", Reference, 1, "", 0, 0.05, Scalar,                                                 \
      "Standard deviation over the last frames of what is shown (sRGB, 0 to 1), followed along the motion, " \
      "without what the reference has of it: the root of the difference of variances.",                      \
      kOfFlicker)                                                                                            \
  ROW(deviationOverTime, "Deviation over time", Reference, 1, "", 0, 0.05, Scalar,                           \
      "The same with what really changes: the reference is not taken off.", kOfFrames)                       \
  ROW(framesFollowed, "Frames followed", Reference, 1, "frames", 0, 16, Scalar,                              \
      "Frames that flicker is taken over: fewer where the surface was hidden, off screen or cut off "        \
      "before.",                                                                                             \
      kOfFrames)                                                                                             \
  ROW(errorGhost, "Ghost part", Reference, 1, "", -0.1, 0.1, Signed,                                         \
      "Luma of the resolved color's error, scene-linear, that comes of history of something else: of "       \
      "surfaces that were in front, or of a place beside that of the surface.",                              \
      kOfParts)                                                                                              \
  ROW(errorLag, "Lag part", Reference, 1, "", -0.1, 0.1, Signed,                                             \
      "Luma of the error that comes of changes on the surface since history was made: light, shadow, what "  \
      "lies over it.",                                                                                       \
      kOfParts)                                                                                              \
  ROW(errorBlur, "Blur part", Reference, 1, "", -0.1, 0.1, Signed,                                           \
      "Luma of the error that comes of reading history between its pixels.", kOfParts)                       \
  ROW(errorAliasing, "Aliasing part", Reference, 1, "", -0.1, 0.1, Signed,                                   \
      "Luma of the error that single frames' samples have, with their noise.", kOfParts)                     \
  ROW(errorRectification, "Rectification part", Reference, 1, "", -0.1, 0.1, Signed,                         \
      "Luma of the error that no other part has: of clamping and clipping, with locks, deringing, mixing "   \
      "of "                                                                                                  \
      "compressed colors, rounding and dithering.",                                                          \
      kOfParts)                                                                                              \
  ROW(errorOlder, "Older part", Reference, 1, "", -0.1, 0.1, Signed,                                         \
      "Luma of the error from before the frames that the others are followed over.", kOfParts)               \
  ROW(verdictMap, "History verdict", Reference, 1, "", 0, 3, Index,                                          \
      "Whether history had to be removed, being off by more than 8/255 of what is shown, and was, by "       \
      "rejection or by more than that: 0 rightly kept, 1 wrong history removed, 2 wrong history let "        \
      "through, "                                                                                            \
      "3 good history thrown away.",                                                                         \
      kOfParts)                                                                                              \
  ROW(geometryVerdict, "Geometry verdict", Reference, 1, "", 0, 3, Index,                                    \
      "The same of rejection alone: whether history was of something else, by the scene's geometry, and "    \
      "was rejected.",                                                                                       \
      kOfParts)                                                                                              \
  ROW(engineOutput, "Engine's output", Reference, 3, "", 0, 1, Color,                                        \
      "What the engine's own TAA made of the frame, scene-linear; only captures that hold it have it.",      \
      kOfEngine)                                                                                             \
  ROW(engineDifference, "Engine difference", Reference, 1, "", -0.25, 0.25, Signed,                          \
      "Luma of the resolved color less luma of the engine's output, scene-linear: above 0 ours is "          \
      "brighter.",                                                                                           \
      kOfEngine)                                                                                             \
  ROW(engineDifferenceAbs, "Engine distance", Reference, 1, "", 0, 0.25, Scalar,                             \
      "Largest difference of the resolved color and the engine's output in red, green or blue, "             \
      "scene-linear.",                                                                                       \
      kOfEngine)

enum class IntermediateId : int {
#define TAA_ROW(id, ...) id,
  TAA_INTERMEDIATES(TAA_ROW)
#undef TAA_ROW
};

struct Intermediate {
  IntermediateId id;
  std::string_view name; ///< the id as text
  std::string_view label;
  Stage stage;
  int channels;
  std::string_view unit;
  float low, high; ///< range shown at first; equal: the visual decides
  Visual visual;
  std::string_view description;
  MadeOf madeOf{};
};

inline constexpr auto kIntermediates = std::to_array<Intermediate>({
#define TAA_ROW(id, label, stage, channels, unit, low, high, visual, ...)                                    \
  {IntermediateId::id, #id,         label,          Stage::stage, channels, unit,                            \
   float(low),         float(high), Visual::visual, __VA_ARGS__},
    TAA_INTERMEDIATES(TAA_ROW)
#undef TAA_ROW
});
inline constexpr std::size_t kIntermediateCount = kIntermediates.size();

constexpr const Intermediate& intermediate(IntermediateId id) {
  return kIntermediates[static_cast<std::size_t>(id)];
}

/// Whether the row comes from the supersampled picture, from other frames or from the engine's own picture,
/// not from the frame's own resolve. There is a value only where those were made or are part of the capture
/// (ReferenceOfShot::makeRows).
constexpr bool isOfReference(IntermediateId id) {
  return intermediate(id).stage == Stage::Reference;
}
/// What measures those of them that are of the frames before, too.
constexpr OverTime overTime(IntermediateId id) {
  return intermediate(id).madeOf.overTime;
}
constexpr bool isOverTime(IntermediateId id) {
  return overTime(id) != OverTime::None;
}
/// All that measures some of `ids`.
std::vector<OverTime> kindsOverTime(std::span<const IntermediateId> ids);
/// Those of them that need the output of the engine a capture was taken of.
constexpr bool isOfEngine(IntermediateId id) {
  return intermediate(id).madeOf.isEngine;
}
/// Those of them whose value in a pixel needs output and reference around it, too.
constexpr bool needsPixelsAround(IntermediateId id) {
  return intermediate(id).madeOf.isAround;
}
/// Those of them that need a reference.
constexpr bool needsReference(IntermediateId id) {
  return intermediate(id).madeOf.isReference;
}

/// The rows that a resolve gives, with the pass after it: the table without those of the reference, which are
/// its last.
inline constexpr std::span<const Intermediate> kResolveRows =
    std::span(kIntermediates)
        .first(static_cast<std::size_t>(std::ranges::count_if(
            kIntermediates, [](const Intermediate& row) { return row.stage != Stage::Reference; })));
inline constexpr std::size_t kResolveRowCount = kResolveRows.size();
/// Their ids.
std::vector<IntermediateId> allRows();

/// The row named `name`, or nothing.
std::optional<IntermediateId> findIntermediate(std::string_view name);
/// As above; throws Error naming those there are.
IntermediateId intermediateNamed(std::string_view name);

/// The row that says most about a stage, or nothing; and those of all stages, in their order.
std::optional<IntermediateId> mainRow(Stage stage);
std::vector<IntermediateId> mainRows();

/// The same set in the order of the table, each row once.
std::vector<IntermediateId> inTableOrder(std::vector<IntermediateId> ids);

/// A reject reason in words ("kept", "off screen", …).
std::string_view rejectReasonText(int reason);
/// What a number of a row of visual Index stands for, in words; empty where it is a number.
std::string_view categoryText(IntermediateId id, int number);

/// Whether the pass after the resolve gives the row, from the resolved picture, not the resolve itself.
constexpr bool isOfOutput(IntermediateId id) {
  return intermediate(id).stage == Stage::Output;
}
/// The rows of `watched` that the pass after the resolve gives, or those that the resolve gives.
std::vector<IntermediateId> rowsOfOutput(const std::vector<IntermediateId>& watched);
std::vector<IntermediateId> rowsOfResolve(const std::vector<IntermediateId>& watched);

/// Color targets of the resolve that are always the history's; see historyTargets().
inline constexpr std::size_t kHistoryTargets = 2;

} // namespace taa
