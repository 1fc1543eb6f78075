// Faults of an integration that have several forms. None is a technique: each is a mistake that people make.
#pragma once

#include "core/settings/Parameters.h"
#include "core/settings/Used.h"

namespace taa {

inline constexpr Choice kJitterFaults[] = {
    {"none", "As drawn", "The jitter that is reported is the one that the picture is drawn with.", Uses()},
    {"negatedX", "X negated", "(−jx, jy) is reported.", Uses()},
    {"negatedY", "Y negated", "(jx, −jy) is reported: y up taken for y down.", Uses()},
    {"negated", "Negated", "−j is reported: where the picture is sampled, not where it moves.", Uses()},
    {"swapped", "Axes swapped", "(jy, jx) is reported.", Uses()},
    {"unreported", "Not reported", "0 is reported, and the picture is jittered.", Uses()},
    {"late", "A frame late", "The jitter of the frame before is reported.", Uses()},
    {"early", "A frame early", "The jitter of the frame after is reported.", Uses()},
};
inline constexpr Choice kMotionFaults[] = {
    {"none", "As drawn", "Motion vectors are what the renderer or the capture has.", Uses()},
    {"zero", "Zero", "Nothing is written: motion is 0.", Uses()},
    {"cameraOnly", "Camera only", "Objects write none: motion is that of the camera, from depth.", Uses()},
};
inline constexpr Choice kCameraFaults[] = {
    {"none", "The previous one", "Motion is made with the camera of the frame before.", Uses()},
    {"ofNow", "Of this frame", "The previous matrix is this frame's: the camera's motion is missing.",
     Uses()},
    {"turned", "Turned", "The previous matrix is turned about the camera's upright axis.",
     Uses(USED(fault.cameraTurn))},
    {"mirrored", "Of a mirror", "The previous matrix is that of a mirror on the ground, y = 0.", Uses()},
    {"secondView", "Of a second view", "The previous matrix is that of a view half a meter to the right.",
     Uses()},
    {"identity", "Identity", "The previous matrix was never set: it is the identity.", Uses()},
    {"twice", "Added once more", "The camera's motion is added to motion that holds it already.", Uses()},
};
inline constexpr Choice kMotionUnitFaults[] = {
    {"none", "Pixels", "Motion is in px, x right, y down, as it is read.", Uses()},
    {"uv", "Texture coordinates", "v/(W, H) is read as px.", Uses()},
    {"ndc", "Device coordinates", "2v/(W, −H) is read as px.", Uses()},
    {"biased", "Encoded with a bias", "Motion is stored as v/2 + ½ of the picture, and read as it is.",
     Uses()},
    {"root", "Encoded as a root", "Motion is stored as a signed square root of v/(W, H), and read as it is.",
     Uses()},
    {"unwritten", "Not written",
     "The mark of \"not written\", 0 of an encoding with a bias, is decoded: −(W, H).", Uses()},
    {"asUv", "Pixels as texture coordinates", "v(W, H): px are multiplied by the picture's size.", Uses()},
    {"asNdc", "Pixels as device coordinates", "v(W, −H)/2: px are read as device coordinates.", Uses()},
    {"asBiased", "Decoded with a bias", "2v − (W, H): a bias is taken off motion that has none.", Uses()},
    {"asRoot", "Squared", "|v|v/(W, H): motion is squared that is no root.", Uses()},
};
inline constexpr Choice kMotionJitterFaults[] = {
    {"none", "None", "Jitter is removed from motion.", Uses()},
    {"this", "This frame's", "Motion has this frame's jitter in it: v + jₙ.", Uses()},
    {"last", "The last frame's", "Motion has the last frame's jitter in it: v − jₙ₋₁.", Uses()},
    {"both", "Both", "Motion has both in it: v + jₙ − jₙ₋₁.", Uses()},
    {"thisOff", "This frame's taken off", "It is taken off motion that has none in it: v − jₙ.", Uses()},
    {"lastOff", "The last frame's taken off", "Likewise: v + jₙ₋₁.", Uses()},
    {"bothOff", "Both taken off", "Likewise: v − jₙ + jₙ₋₁.", Uses()},
};
inline constexpr Choice kDepthFaults[] = {
    {"none", "As drawn", "Depth is what the renderer or the capture has: reversed, 0 for the sky.", Uses()},
    {"reversed", "The other way", "1 − d: depth that grows with distance is taken for reversed.", Uses()},
    {"linear", "Linear", "View depth in units of 100 m, 1 for the sky, is taken for device depth.", Uses()},
};
inline constexpr Choice kInterfaceFaults[] = {
    {"none", "None", "The color has no interface in it.", Uses()},
    {"still", "Drawn before TAA", "Bars and a grid lie in the color, with the motion of what is behind.",
     Uses()},
    {"jittered", "Drawn with the jitter", "The same, moved by each frame's jitter.", Uses()},
};
inline constexpr Choice kFaultRegions[] = {
    {"everywhere", "Everywhere", "All texels.", Uses()},
    {"sky", "Sky", "What has no object.", Uses()},
    {"surfaces", "Surfaces", "All but the sky.", Uses()},
    {"still", "What rests", "Objects of the class that does not move.", Uses()},
    {"moving", "What moves rigidly", "Objects that move as a whole.", Uses()},
    {"deforming", "What deforms", "Objects with a skin, morph targets, a cache or wind, and characters.",
     Uses()},
    {"object", "One object", "The object of a number.", Uses(USED(fault.object))},
    {"rectangle", "Rectangle", "A part of the picture.",
     Uses(USED(fault.left), USED(fault.top), USED(fault.right), USED(fault.bottom))},
};

} // namespace taa
