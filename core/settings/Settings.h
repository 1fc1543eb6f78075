// Everything a user can choose about the pipeline, as plain structs; the table in Parameters.h describes each
// field.
#pragma once

#include <cstdint>

namespace taa {

// All fields are 4 bytes wide, so that a test can prove that every one has its row in the table.
// The order of enumerators is the order of the choices in the table.

enum class Switch : std::int32_t { Off, On };
constexpr bool isOn(Switch value) {
  return value == Switch::On;
}

enum class JitterSequence : std::int32_t {
  None,
  Still,
  Uniform2,
  Uniform4,
  Helix,
  DoubleHelix,
  Butterfly,
  RotatedGrid,
  Poisson10,
  Pentagram,
  Halton,
  Perpendicular,
  R2,
  Hammersley,
  GradientNoise,
  Msaa8,
  BlueNoise16,
  WhiteNoise,
};
/// How the offset gets into the projection (manual §2.1).
enum class JitterProjection : std::int32_t { Translation, AddedAsPrinted, ColumnAsPrinted, RightAsPrinted };
struct JitterSettings {
  JitterSequence sequence = JitterSequence::Halton;
  std::int32_t period = 16;    ///< frames until the pattern repeats, 1 to 1024; fixed patterns have their own
  std::int32_t firstIndex = 1; ///< index of the sequence at frame 0; index 0 is the corner (−½, −½)
  float scale = 1.0f;          ///< of the offsets, 0 to 1
  JitterProjection projection = JitterProjection::Translation;
  Switch taa = Switch::On; ///< off: no jitter, and what is drawn is shown as it is
  bool operator==(const JitterSettings&) const = default;
};

enum class Precision : std::int32_t { Half, Full, Unorm8, Unorm10 }; ///< inputs have the first two
enum class MotionSource : std::int32_t {
  Objects,
  CameraFromDepth,
  RawUv,
  JitterDifference,
  SingleMatrix,
  JitterDifferenceAsPrinted,
  ObjectsAsPrinted,
  CurrentProjectionAsPrinted,
};
enum class BlendedAs : std::int32_t { Mask, Dithered, Before, BeforeWithMotion, After };
enum class MaskSource : std::int32_t { None, Material, Opacity, AutoReactive };
enum class DynamicRange : std::int32_t { Hdr, Ldr };
enum class InputNoise : std::int32_t { None, Gradient, Blue, White };
enum class Shadows : std::int32_t { AsScene, None, Hard, Soft };
enum class FogHistory : std::int32_t { None, Kept, Clamped, LargestAsPrinted };
struct InputSettings {
  Precision precision = Precision::Half; ///< color and motion as 16 or 32-bit floats
  MotionSource motion = MotionSource::Objects;
  float mipBias = 0.0f;                  ///< added to the level of detail of every texture
  Switch unjitterTextures = Switch::Off; ///< textures are read at the pixel's center, whatever the jitter
  BlendedAs blended = BlendedAs::Mask;   ///< how transparent materials are drawn
  MaskSource mask = MaskSource::None;    ///< where the masks of special content come from
  Switch forward = Switch::Off;          ///< counts where the last frame's pixels are now
  float renderScale = 1.0f;            ///< r, size of what is drawn to that of the picture, a side; 0.5 to 1
  InputNoise noise = InputNoise::None; ///< added to the shaded color
  float noiseAmount = 1.0f;            ///< width of the noise, 1/255
  DynamicRange range = DynamicRange::Hdr; ///< of the shaded color
  Switch noiseTriangular = Switch::On;    ///< two noises summed: twice as wide, variance the same everywhere
  // Of scenes with fog.
  std::int32_t fogSteps = 12;               ///< of the march through it, 0 to 128; 0: the integral itself
  float fogDensity = 1.0f;                  ///< factor on the scene's, 0 to 8
  InputNoise fogNoise = InputNoise::Blue;   ///< where in its step a ray's samples lie
  Switch fogAnimated = Switch::On;          ///< another noise in each frame
  FogHistory fogHistory = FogHistory::None; ///< what becomes of the fog of frames before
  std::int32_t fogFrames = 8;               ///< that are averaged then, with this one; 2 to 16
  // Of scenes with a sun or a directional light.
  Shadows shadows = Shadows::AsScene;        ///< that it casts
  float sunRadius = 1.0f;                    ///< degrees, 0 to 5
  std::int32_t shadowRays = 1;               ///< of a pixel to the disk of the sun, 1 to 16
  InputNoise shadowNoise = InputNoise::Blue; ///< where on the disk they end
  bool operator==(const InputSettings&) const = default;
};

enum class DilateMethod : std::int32_t {
  None,
  Closest3x3,
  ClosestCross,
  ClosestX,
  ClosestX2,
  Longest3x3,
  LongestCross,
  Closest3x3AsPrinted,
  ClosestXAsPrinted,
  Farthest3x3,
};
enum class DilateTies : std::int32_t { Center, First, Last };
struct DilateSettings {
  DilateMethod method = DilateMethod::Closest3x3;
  DilateTies ties = DilateTies::Center; ///< which of equally near ones
  Switch upLeft = Switch::Off;          ///< motion is read one texel up and to the left of that
};

enum class ReprojectMethod : std::int32_t { Motion, InPlace };
struct ReprojectSettings {
  ReprojectMethod method = ReprojectMethod::Motion; ///< where a pixel's history lies
};

enum class HistoryFilter : std::int32_t {
  Point,
  Bilinear,
  CatmullRom5,
  CatmullRom9,
  CatmullRom16,
  Cubic,
  Mitchell,
  Lanczos,
  CatmullRom5AsPrinted,
  CatmullRom5Corners,
  Cubic5,
  Cubic5AsPrinted,
};
enum class HistoryBorder : std::int32_t { Edge, Black };
enum class LengthFrom : std::int32_t { Reprojected, PixelAsPrinted, Bilinear };
struct HistorySettings {
  HistoryFilter filter = HistoryFilter::CatmullRom5;
  Switch dering = Switch::On;            ///< clamp to the filter's own taps; cubics and Lanczos
  Precision precision = Precision::Half; ///< of the stored history
  float sharpness = 0.5f;                ///< c of the tunable cubic, 0 to 1; 0.5 is Catmull-Rom
  Switch bilinearAtEdges = Switch::Off;  ///< one tap instead of the filter where depth has an edge
  float edgeDepth = 0.1f; ///< range of view depth over 3×3 that is an edge, relative to the farthest
  HistoryBorder border = HistoryBorder::Edge;  ///< what is read outside of the picture
  LengthFrom length = LengthFrom::Reprojected; ///< where N is read
  Switch dither = Switch::Off;                 ///< round up or down at random, so that the mean is kept
};

enum class CurrentFilter : std::int32_t {
  Center,
  Gaussian,
  Unjitter,
  Tent,
  Box,
  Mitchell,
  CatmullRom,
  BlackmanHarris,
  Lanczos,
  DistanceAsPrinted,
  MitchellAsPrinted,
  BlackmanHarrisAsPrinted,
  UnjitterAsPrinted,
};
enum class CurrentSharpen : std::int32_t { None, Laplacian, LaplacianAsPrinted };
enum class UpsampleKernel : std::int32_t { SampleWeight, Lanczos2, Hdrp, HdrpGaussian, Fsr2 };
struct CurrentSettings {
  CurrentFilter filter = CurrentFilter::Gaussian;
  float variance = 0.22f;            ///< σ² of the Gaussian, px²
  Switch jitterAware = Switch::On;   ///< distances from where the samples really lie
  Switch lumaWeighted = Switch::Off; ///< samples also weighted by 1/(1 + luma)
  Switch dering = Switch::Off;       ///< clamp to the nine samples
  CurrentSharpen sharpen = CurrentSharpen::None;
  float sharpenAmount = 1.0f;                         ///< s, 0 to 4
  UpsampleKernel upsample = UpsampleKernel::Lanczos2; ///< in place of the filter where renderScale < 1
};

enum class ColorSpace : std::int32_t { Rgb, YCoCg, YCoCgLifting, YCbCr, YCoCgAsPrinted };
enum class ToneSpace : std::int32_t {
  Linear,
  ReinhardLuma,
  ReinhardChannel,
  MaxChannel,
  Pq,
  Logarithm,
  Gamma
};
/// Luma that weights of colors are made of; the box's own is the first axis of its space.
enum class WeightLuma : std::int32_t { Rec709, YCoCg };
struct SpaceSettings {
  ColorSpace color = ColorSpace::YCoCg;
  ToneSpace tone = ToneSpace::ReinhardLuma;
  WeightLuma luma = WeightLuma::Rec709; ///< of weights by luma, in all stages
};

/// What a speed is counted in: px, px of a picture of 1080 lines, or 1080ths of the picture across and down.
enum class SpeedUnit : std::int32_t { Pixels, Lines1080, Picture1080 };
enum class NeighborhoodShape : std::int32_t { Cross, Square3x3, X, Rounded, Alternate, Varying, Pairs };
enum class MomentWeights : std::int32_t { Equal, Luma, Distance, BoxLuma };
enum class BoxKind : std::int32_t { MinMax, Variance, Intersection };
struct NeighborhoodSettings {
  NeighborhoodShape shape = NeighborhoodShape::Square3x3;
  BoxKind box = BoxKind::Intersection;
  float gamma = 1.0f;                   ///< deviations from the mean to the wall of a variance box
  Switch includeFiltered = Switch::On;  ///< grow the box to hold the filtered current color
  Switch motionGamma = Switch::Off;     ///< γ shrinks with speed
  float gammaMoving = 0.75f;            ///< γ at full speed
  float gammaSpeed = 128.0f;            ///< px a frame that count as full speed
  Switch resolutionGamma = Switch::Off; ///< γ shrinks with the picture's height
  Switch contrastGamma = Switch::Off;   ///< γ grows where current and history differ in luma
  float contrastGrowth = 1.75f;         ///< most that is added to γ
  Switch chromaShrink = Switch::Off;    ///< chroma no wider than an eighth of the luma range
  MomentWeights weights = MomentWeights::Equal;
  Switch maskRelax = Switch::Off; ///< wider box and less of the current frame where the mask is set
  Switch unjitter = Switch::Off;  ///< samples around where the pixel's center landed
  SpeedUnit gammaSpeedIn = SpeedUnit::Pixels; ///< unit of gammaSpeed
};

enum class OffScreen : std::int32_t { Keep, Reject, Margin, OneSided };
enum class VelocityTest : std::int32_t { None, Vector, Length };
enum class RejectAction : std::int32_t { Restart, RaiseAlpha, Decay };
enum class DepthDirection : std::int32_t { Both, Nearer };
enum class DepthFootprint : std::int32_t { Square3x3, ReadInMotion };
struct ValidateSettings {
  OffScreen offScreen = OffScreen::Reject;
  Switch depth = Switch::On;
  float depthTolerance = 0.03f;     ///< τ, relative to the expected view depth
  float slopeAllowance = 2.0f;      ///< render px along the depth slope that count as the same depth
  Switch speed = Switch::Off;       ///< reject what moves faster than the limit
  float speedLimit = 128.0f;        ///< px a frame
  Switch object = Switch::Off;      ///< reject the history of another object
  Switch objectClass = Switch::Off; ///< reject the history of another class: still, moving, deforming
  Switch normal = Switch::Off;      ///< reject the history of a surface that faces another way
  float normalLimit = 0.9f;         ///< least cosine between the normals
  VelocityTest velocity = VelocityTest::None;
  float velocityLimit = 2.5f; ///< px a frame of change that count nothing
  float velocityGain = 0.01f; ///< share of history that is lost for each px beyond
  RejectAction action = RejectAction::Restart;
  float softAlpha = 0.5f;                               ///< α of rejected history where it is not dropped
  DepthDirection depthDirection = DepthDirection::Both; ///< which difference of depth counts
  DepthFootprint depthFootprint = DepthFootprint::ReadInMotion; ///< where depth is looked for in history
  Switch flicker = Switch::On; ///< depth of a thin feature at rest that differs is no other surface
  float restLimit = 0.5f;      ///< px a frame of change of motion up to which nothing parts
};

enum class RectifyMethod : std::int32_t {
  None,
  Clamp,
  ClipToCenter,
  ClipToFiltered,
  ShrinkAxes,
  ClampThenClip,
  RayToCurrent,
  ClipToHull,
  ClipToBoth,
  ClampForget,
  Select,
};
struct RectifySettings {
  RectifyMethod method = RectifyMethod::ClipToFiltered;
  float maxSteps = 10.0f;           ///< T of RayToCurrent: hits farther than this along the ray do not count
  Switch relaxAtRest = Switch::Off; ///< only a part of the correction where little moves
  float minStrength = 0.25f;        ///< that part at rest
  float restSpeed = 1.0f;           ///< px a frame from which on all of it is applied
  Switch locks = Switch::Off;       ///< thin features keep their history
  float lockFrames = 16.0f;         ///< frames a lock lasts
  Switch instability = Switch::Off; ///< what comes and goes with the jitter keeps its history
  float flickerStrength = 0.0f;     ///< part of the correction applied to geometric flicker
};

enum class AlphaSource : std::int32_t {
  Constant,
  HistoryLength,
  LumaDifference,
  Contrast,
  Depth,
  LumaDifferenceAsPrinted,
  ContrastPerChannel,
  Confidence,
  LumaDifferenceCompressed,
};
enum class MotionAlpha : std::int32_t { None, Linear, Squared, SquaredAsPrinted, Doubled, Added };
enum class MaskAlpha : std::int32_t { Off, Responsive, Reactive, Exclude };
enum class FlickerScale : std::int32_t { Relative, Compressed };
enum class SampleDistance : std::int32_t { None, Gaussian, Parabola, GaussianMoving };
struct WeightSettings {
  AlphaSource source = AlphaSource::HistoryLength;
  float alpha = 0.1f;               ///< weight of the current frame when constant
  float minimum = 0.1f;             ///< floor of 1/(N+1)
  float sourceMax = 0.12f;          ///< weight of the current frame where its luma differs most from history
  float sourceMin = 0.03f;          ///< and where it is the same
  Switch lumaFlicker = Switch::Off; ///< less where luma differs
  Switch nearClamp = Switch::Off;   ///< less where history is near a wall of the box
  Switch historyContrast = Switch::Off; ///< less where the box is large against history
  MotionAlpha motion = MotionAlpha::None;
  float motionSpeed = 64.0f; ///< px a frame from which on only the current frame counts
  MaskAlpha mask = MaskAlpha::Off;
  float maskAlpha = 0.3f;              ///< least weight of the current frame where the mask is 1
  Switch velocityChange = Switch::Off; ///< more where a surface moves otherwise than a frame ago
  float velocityChangeSpeed = 8.0f;    ///< px a frame of change from which on only the current frame counts
  Switch divergence = Switch::Off;     ///< more where neighbors move apart
  float divergenceSpeed = 12.8f;       ///< px a frame from which on that counts fully
  FlickerScale flickerScale = FlickerScale::Relative;   ///< what a difference of luma is measured against
  SampleDistance sampleDistance = SampleDistance::None; ///< less the farther the sample is from the center
  Switch frameRate = Switch::Off;                       ///< α as if frames took 1/referenceRate
  float referenceRate = 60.0f;                          ///< frames a second that α is meant for
  SpeedUnit motionSpeedIn = SpeedUnit::Pixels;          ///< unit of motionSpeed
  float flickerShare = 0.5f;                            ///< factor on α at geometric flicker
};

enum class ToneWeight : std::int32_t {
  None,
  Luma,
  ReinhardChannel,
  MaxChannel,
  LumaAsPrinted,
  Pq,
  Logarithm,
  WhitePoint,
};
enum class Restart : std::int32_t { Filtered, Blurred };
enum class LengthRule : std::int32_t {
  Variance,
  Count,
  VarianceAsPrinted,
  Confidence,
  Reciprocal,
  CountTo16,
};
struct BlendSettings {
  ToneWeight tone = ToneWeight::Luma;
  float white = 4.0f; ///< scene-linear color that the curve of a white point takes to 1
  Restart restart = Restart::Filtered;
  LengthRule length = LengthRule::Variance;
};

enum class Sharpen : std::int32_t {
  None,
  LumaRatio,
  Laplacian,
  Unsharp,
  Rcas,
  InResolve,
  Logarithm,
  Reconstruct,
  Mitchell,
};
struct OutputSettings {
  Sharpen sharpen = Sharpen::None;
  float amount = 0.5f;             ///< k, 0 to 4
  Switch dering = Switch::Off;     ///< clamp to the nine resolved colors around
  Switch dither = Switch::Off;     ///< noise of a step of 8 bits, for a screen that has no more
  Switch motionBlur = Switch::Off; ///< the current frame blurred along motion, where it is fast
};

/// What is wrong with the jitter that is reported, against the one that the picture is drawn with.
enum class JitterFault : std::int32_t { None, NegatedX, NegatedY, Negated, Swapped, Unreported, Late, Early };
enum class MotionFault : std::int32_t { None, Zero, CameraOnly };
/// The camera that motion is made with in place of the previous one. Twice: its motion is there twice.
enum class CameraFault : std::int32_t { None, OfNow, Turned, Mirrored, SecondView, Identity, Twice };
/// How motion is written that is read as px; from AsUv on: what px are read as.
enum class MotionUnitFault : std::int32_t {
  None,
  Uv,
  Ndc,
  Biased,
  Root,
  Unwritten,
  AsUv,
  AsNdc,
  AsBiased,
  AsRoot
};
/// Jitter that is left in motion; from ThisOff on: that is taken off though there was none.
enum class MotionJitterFault : std::int32_t { None, This, Last, Both, ThisOff, LastOff, BothOff };
enum class DepthFault : std::int32_t { None, Reversed, Linear };
enum class InterfaceFault : std::int32_t { None, Still, Jittered };
enum class FaultRegion : std::int32_t {
  Everywhere,
  Sky,
  Surfaces,
  Still,
  Moving,
  Deforming,
  Object,
  Rectangle
};
/// Faults of an integration, injected between the source of frames and all that uses them. None by default.
struct FaultSettings {
  // Jitter: as it is reported, and as it is drawn
  JitterFault jitter = JitterFault::None;
  float jitterReported = 1.0f;   ///< factor on what is reported
  float jitterApplied = 1.0f;    ///< factor on what is drawn
  std::int32_t jitterPeriod = 0; ///< frames after which both repeat; 0: as the sequence does
  float jitterMeanX = 0.0f;      ///< px, added to both, x right
  float jitterMeanY = 0.0f;      ///< px, y down
  float depthJitter = 1.0f;      ///< factor on what depth is drawn with, 0 to 1
  float skyJitter = 1.0f;        ///< factor on what the sky is drawn with, 0 to 1
  // Motion vectors
  MotionFault motion = MotionFault::None;
  CameraFault previousCamera = CameraFault::None;
  float cameraTurn = 1.0f;      ///< degrees, of CameraFault::Turned
  std::int32_t previousAge = 1; ///< frames from the previous transforms to these
  std::int32_t motionLag = 0;   ///< frames that the plane is old; negative: early
  MotionJitterFault motionJitter = MotionJitterFault::None;
  Switch motionSwapped = Switch::Off; ///< x and y
  float motionX = 1.0f, motionY = 1.0f;
  MotionUnitFault motionUnit = MotionUnitFault::None;
  Switch zeroIsMissing = Switch::Off; ///< motion of 0 has no previous position
  std::int32_t motionShift = 0;  ///< texels up and to the left that it is read at; negative: down and right
  std::int32_t motionCoarse = 1; ///< texels that share one motion, a side
  Switch motionUntested = Switch::Off; ///< objects write motion where they are hidden, too
  // Depth and color
  DepthFault depth = DepthFault::None;
  float nearPlane = 1.0f;       ///< factor on the stated one
  std::int32_t depthCoarse = 1; ///< texels that share one depth, a side
  float exposure = 0.0f;        ///< stops
  InterfaceFault interface = InterfaceFault::None;
  // The resolve
  Switch keepsAtCuts = Switch::Off;   ///< history is not reset
  Switch notSwapped = Switch::Off;    ///< the two textures of the history
  Switch historyJitter = Switch::Off; ///< history is read with the last frame's jitter
  Switch boxCorners = Switch::Off;    ///< two corners are converted instead of all samples
  Switch nan = Switch::Off;           ///< a color that is no number, and that history keeps
  // Where and when planes are faulty
  FaultRegion region = FaultRegion::Everywhere;
  std::int32_t object = 1; ///< number of the object, of FaultRegion::Object
  float left = 0.25f, top = 0.25f, right = 0.75f, bottom = 0.75f; ///< shares of the picture
  std::int32_t firstFrame = 0;
  std::int32_t lastFrame = 1000000;
  bool operator==(const FaultSettings&) const = default;
};

/// One lane's choices. Defaults are the preset "balanced".
struct Settings {
  JitterSettings jitter;
  InputSettings inputs;
  DilateSettings dilate;
  ReprojectSettings reproject;
  HistorySettings history;
  CurrentSettings current;
  SpaceSettings space;
  NeighborhoodSettings neighborhood;
  ValidateSettings validate;
  RectifySettings rectify;
  WeightSettings weight;
  BlendSettings blend;
  OutputSettings output;
  FaultSettings fault;
};

/// Whether anything is accumulated.
inline bool isTaaOn(const Settings& settings) {
  return settings.jitter.taa == Switch::On;
}

/// Whether the scene is drawn smaller than the picture.
inline bool isUpsampled(const Settings& settings) {
  return settings.inputs.renderScale < 1.0f;
}

/// Whether depth that differs at rest is told from another surface (manual 13.9).
inline bool findsFlicker(const Settings& settings) {
  return settings.validate.depth == Switch::On && settings.validate.flicker == Switch::On;
}

/// Whether the depth test needs to know what moves against what.
inline bool tellsRest(const Settings& settings) {
  return findsFlicker(settings) || (settings.validate.depth == Switch::On &&
                                    settings.validate.depthFootprint == DepthFootprint::ReadInMotion);
}

} // namespace taa
