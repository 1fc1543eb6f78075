// The rows of the table of conventions: one for each number, switch and choice of Conventions.
#include "core/capture/format/ConventionText.h"

#include <span>
#include <string_view>

namespace taa::capture {

namespace {

using K = ConventionKind;

#define FIELD(path, member)                                                                                  \
  [](const Conventions& stated) { return valueText(convention(path), stated.member); },                      \
      [](Conventions& stated, std::string_view text) { assignValue(convention(path), text, stated.member); }

constexpr std::span<const ConventionChoice> kNoChoices;

/// Any number that fits a float: values of planes are floats.
constexpr double kAnyValue = 3.4028234663852886e38;

constexpr ConventionChoice kDirections[] = {
    {"currentMinusPrevious", "Current − previous",
     "Motion points from where the surface was to where it is. Where it was is the pixel minus its motion."},
    {"previousMinusCurrent", "Previous − current",
     "Motion points from where the surface is to where it was. Where it was is the pixel plus its motion."},
};

constexpr ConventionChoice kMotionUnits[] = {
    {"pixels", "Pixels", "1 is the width of a pixel."},
    {"uv", "Texture coordinates", "1 is the width or the height of the whole picture."},
    {"ndc", "Device coordinates",
     "2 is the width or the height of the whole picture: normalized device coordinates, −1 to 1."},
};

constexpr ConventionChoice kPixelsOf[] = {
    {"render", "Render size", "Pixels are those of the picture that the engine draws."},
    {"output", "Output size", "Pixels are those of the picture that the engine shows, after upsampling."},
};

constexpr ConventionChoice kVerticalAxes[] = {
    {"down", "Down", "A larger y is lower in the picture, as rows of textures count in Direct3D and Vulkan."},
    {"up", "Up", "A larger y is higher in the picture, as in OpenGL and in normalized device coordinates."},
};

constexpr ConventionChoice kEncodings[] = {
    {"plain", "Plain", "The stored number times the scale is the motion."},
    {"unreal", "Unreal's 16 bits",
     "Unreal's: the square root of the motion with its sign, scaled to 16 bits without sign. Decoded it is "
     "in "
     "device coordinates with y up."},
    {"offset", "Scale and offset",
     "The offset is taken off what is stored, and the rest times the scale is the motion; for formats "
     "without "
     "sign."},
};

constexpr ConventionChoice kJittersInMotion[] = {
    {"removed", "Removed", "A camera that stands still has motion 0 everywhere."},
    {"both", "Both frames'",
     "Both positions were taken with jitter: a surface at rest has the jitter of this frame minus that of "
     "the "
     "frame before."},
    {"current", "This frame's", "Only the current position was taken with jitter."},
    {"previous", "The previous frame's", "Only the previous position was taken with jitter."},
};

constexpr ConventionChoice kFallbacks[] = {
    {"camera", "Of the camera",
     "The motion that a surface at rest has there, made from depth and the matrices of both frames."},
    {"zero", "None", "The pixel has not moved."},
    {"noPrevious", "No previous position", "The pixel has no history: it was nowhere in the previous frame."},
};

constexpr ConventionChoice kJitterUnits[] = {
    {"pixels", "Pixels", "1 is the width of a pixel of the render size."},
    {"uv", "Texture coordinates", "1 is the width or the height of the whole picture."},
    {"ndc", "Device coordinates",
     "2 is the width or the height of the whole picture: what is added to clip positions over w."},
};

constexpr ConventionChoice kJitterMeanings[] = {
    {"content", "Content moves", "The content of the picture is displaced by the jitter."},
    {"sample", "Sample moves",
     "Each pixel samples the picture at its center plus the jitter, so that content is displaced by minus "
     "the "
     "jitter."},
};

constexpr ConventionChoice kDepthKinds[] = {
    {"window", "Depth buffer", "What the projection leaves, z over w, as a depth buffer holds it."},
    {"planar", "Distance along the axis", "The distance from the camera along its viewing axis: view depth."},
    {"radial", "Distance from the eye", "The length of the way from the camera to the surface."},
};

constexpr ConventionChoice kClipRanges[] = {
    {"zeroToOne", "0 to 1", "Direct3D, Vulkan, Metal, WebGPU, and what a depth buffer of OpenGL stores."},
    {"minusOneToOne", "−1 to 1", "Device coordinates of OpenGL and WebGL."},
};

constexpr ConventionChoice kMatrixOrders[] = {
    {"rowMajor", "Rows", "The first four of the 16 numbers are the first row."},
    {"columnMajor", "Columns", "The first four of the 16 numbers are the first column."},
};

constexpr ConventionChoice kVectorSides[] = {
    {"column", "Columns", "Positions are columns: clip = projection · view · position."},
    {"row", "Rows", "Positions are rows: clip = position · view · projection."},
};

constexpr ConventionChoice kForwardAxes[] = {
    {"negativeZ", "−z", "What is before the camera has a negative z in view space, as in OpenGL."},
    {"positiveZ", "+z", "What is before the camera has a positive z in view space, as in Direct3D."},
};

constexpr ConventionChoice kColorEncodings[] = {
    {"linear", "Linear", "Values are proportional to light."},
    {"srgb", "sRGB", "Values are encoded for a screen; they are decoded before anything is computed."},
};

constexpr ConventionChoice kRowOrders[] = {
    {"topFirst", "Top first", "The first row that a file holds is the highest of the picture."},
    {"bottomFirst", "Bottom first",
     "The first row that a file holds is the lowest of the picture, as OpenGL reads pictures back."},
};

// path, label, kind, choices, unit, minimum, maximum, tooltip, when, text and assign
const Convention kConventions[] = {
    {"motion.direction", "Direction", K::Choice, kDirections, "", 0, 0,
     "Which way motion points: from the previous position to this one or back.", "",
     FIELD("motion.direction", motion.direction)},
    {"motion.unit", "Unit", K::Choice, kMotionUnits, "", 0, 0,
     "What 1 means in motion, after decoding and scaling.", "", FIELD("motion.unit", motion.unit)},
    {"motion.pixelOf", "Pixels of", K::Choice, kPixelsOf, "", 0, 0,
     "Which picture's pixels motion counts, where the engine draws smaller than it shows.",
     "motion.unit=pixels", FIELD("motion.pixelOf", motion.pixelOf)},
    {"motion.yAxis", "y goes", K::Choice, kVerticalAxes, "", 0, 0,
     "Whether something that falls has a positive or a negative motion in y.", "",
     FIELD("motion.yAxis", motion.yAxis)},
    {"motion.encoding", "Encoding", K::Choice, kEncodings, "", 0, 0,
     "How the numbers of motion were changed to fit their format.", "",
     FIELD("motion.encoding", motion.encoding)},
    {"motion.scaleX", "Scale x", K::Number, kNoChoices, "", -1e9, 1e9,
     "What the decoded x is multiplied with to be in the unit above. A negative number mirrors it.", "",
     FIELD("motion.scaleX", motion.scale.x)},
    {"motion.scaleY", "Scale y", K::Number, kNoChoices, "", -1e9, 1e9,
     "What the decoded y is multiplied with to be in the unit above. A negative number mirrors it.", "",
     FIELD("motion.scaleY", motion.scale.y)},
    {"motion.offsetX", "Offset x", K::Number, kNoChoices, "", -1e9, 1e9,
     "The stored x of a surface at rest; it is taken off before scaling.", "motion.encoding=offset",
     FIELD("motion.offsetX", motion.offset.x)},
    {"motion.offsetY", "Offset y", K::Number, kNoChoices, "", -1e9, 1e9,
     "The stored y of a surface at rest; it is taken off before scaling.", "motion.encoding=offset",
     FIELD("motion.offsetY", motion.offset.y)},
    {"motion.jitter", "Jitter in it", K::Choice, kJittersInMotion, "", 0, 0,
     "Whether motion also holds the difference of the two frames' jitter. It should not.", "",
     FIELD("motion.jitter", motion.jitter)},
    {"motion.includesCamera", "Camera's motion in it", K::Toggle, kNoChoices, "", 0, 1,
     "On: motion holds what the camera does as well. Off: only what objects do by themselves, and the "
     "camera's motion is added from depth and matrices.",
     "", FIELD("motion.includesCamera", motion.includesCamera)},
    {"motion.notWritten", "Not written", K::OptionalNumber, kNoChoices, "", -kAnyValue, kAnyValue,
     "The stored number, in both components, of pixels for which the engine wrote no motion. none: it wrote "
     "all.",
     "", FIELD("motion.notWritten", motion.notWritten)},
    {"motion.fallback", "Motion where not written", K::Choice, kFallbacks, "", 0, 0,
     "What pixels move by for which the engine wrote no motion.", "motion.notWritten!=none",
     FIELD("motion.fallback", motion.fallback)},
    {"motion.whereNothing", "Motion of the sky", K::OptionalChoice, kFallbacks, "", 0, 0,
     "What pixels move by where nothing was drawn, by their depth. none: the motion stored there is right.",
     "", FIELD("motion.whereNothing", motion.whereNothing)},

    {"jitter.unit", "Unit", K::Choice, kJitterUnits, "", 0, 0, "What 1 means in the jitter of a frame.", "",
     FIELD("jitter.unit", jitter.unit)},
    {"jitter.meaning", "Meaning", K::Choice, kJitterMeanings, "", 0, 0,
     "What is displaced by the jitter: the content of the picture, or the place where a pixel samples it. "
     "The "
     "one is the other's negative.",
     "", FIELD("jitter.meaning", jitter.meaning)},
    {"jitter.yAxis", "y goes", K::Choice, kVerticalAxes, "", 0, 0,
     "Whether a positive y of the jitter goes down or up in the picture.", "",
     FIELD("jitter.yAxis", jitter.yAxis)},
    {"jitter.delay", "Delay", K::Integer, kNoChoices, "frames", -1, 1,
     "The jitter that is stated with a frame is that of the frame so many later: 1 where it was read after "
     "the engine had moved on to the next one.",
     "", FIELD("jitter.delay", jitter.delay)},

    {"depth.kind", "Kind", K::Choice, kDepthKinds, "", 0, 0, "What the numbers of depth measure.", "",
     FIELD("depth.kind", depth.kind)},
    {"depth.reversed", "Reversed", K::Toggle, kNoChoices, "", 0, 1,
     "On: what is nearer has the larger value. Off: the smaller.", "depth.kind=window",
     FIELD("depth.reversed", depth.reversed)},
    {"depth.range", "Range", K::Choice, kClipRanges, "", 0, 0, "The values that depth is stored in.",
     "depth.kind=window", FIELD("depth.range", depth.range)},
    {"depth.nearPlane", "Near plane", K::Number, kNoChoices, "units", 0, 1e15,
     "The distance of the near plane in the world's units. 0: near and far are what the projection matrix "
     "says.",
     "depth.kind=window", FIELD("depth.nearPlane", depth.nearPlane)},
    {"depth.farPlane", "Far plane", K::Number, kNoChoices, "units", 0, 1e15,
     "The distance of the far plane in the world's units. 0: it is infinitely far, or what the projection "
     "matrix says.",
     "depth.kind=window", FIELD("depth.farPlane", depth.farPlane)},
    {"depth.scale", "Scale", K::Number, kNoChoices, "", -1e15, 1e15,
     "What is stored times this is a distance in the world's units. Negative where z of view space is "
     "stored, "
     "which is negative before the camera.",
     "depth.kind=planar|radial", FIELD("depth.scale", depth.scale)},
    {"depth.nothing", "Nothing there", K::OptionalNumber, kNoChoices, "", -kAnyValue, kAnyValue,
     "The stored value where nothing was drawn, as for the sky. In a depth buffer the far plane says it, "
     "too.",
     "", FIELD("depth.nothing", depth.nothing)},
    {"depth.jittered", "Drawn with jitter", K::Toggle, kNoChoices, "", 0, 1,
     "On: depth was drawn with the frame's jitter, as color is. Off: without.", "",
     FIELD("depth.jittered", depth.jittered)},

    {"matrices.order", "Order", K::Choice, kMatrixOrders, "", 0, 0,
     "How the 16 numbers of a matrix lie in the file.", "", FIELD("matrices.order", matrices.order)},
    {"matrices.vectors", "Positions are", K::Choice, kVectorSides, "", 0, 0,
     "From which side matrices are multiplied.", "", FIELD("matrices.vectors", matrices.vectors)},
    {"matrices.clipZ", "z of clip space", K::Choice, kClipRanges, "", 0, 0,
     "Between which values of z over w the projection puts what it keeps.", "",
     FIELD("matrices.clipZ", matrices.clipZ)},
    {"matrices.clipY", "y of clip space", K::Choice, kVerticalAxes, "", 0, 0,
     "Whether the projection puts what is higher in the picture at a larger or a smaller y.", "",
     FIELD("matrices.clipY", matrices.clipY)},
    {"matrices.forward", "Camera looks along", K::Choice, kForwardAxes, "", 0, 0,
     "The axis of view space along which the camera looks.", "", FIELD("matrices.forward", matrices.forward)},
    {"matrices.jittered", "Hold the jitter", K::Toggle, kNoChoices, "", 0, 1,
     "On: projections hold their frame's jitter, which is taken out. Off: they are without.", "",
     FIELD("matrices.jittered", matrices.jittered)},
    {"matrices.metersPerUnit", "Meters per unit", K::Number, kNoChoices, "m", 1e-9, 1e9,
     "The length of the world's unit: 0.01 where it is a centimeter.", "",
     FIELD("matrices.metersPerUnit", matrices.metersPerUnit)},

    {"color.encoding", "Encoding", K::Choice, kColorEncodings, "", 0, 0,
     "How color is stored. TAA works before tone mapping, on light.", "",
     FIELD("color.encoding", color.encoding)},
    {"color.preExposed", "Pre-exposed", K::Toggle, kNoChoices, "", 0, 1,
     "On: color was multiplied with the frame's preExposure, which is taken out, so that frames of different "
     "exposure can be compared.",
     "", FIELD("color.preExposed", color.preExposed)},

    {"rows", "Rows", K::Choice, kRowOrders, "", 0, 0,
     "Which row of the picture comes first in files. A plane can say otherwise.", "", FIELD("rows", rows)},
};

#undef FIELD

} // namespace

std::span<const Convention> conventions() {
  return kConventions;
}

} // namespace taa::capture
