// Everything a user can choose about the pipeline, as plain structs; the table in Parameters.h describes each
// field.
#pragma once

#include <cstdint>

namespace taa {

// All fields are 4 bytes wide, so that a test can prove that every one has its row in the table.
// The order of enumerators is the order of the choices in the table.

enum class Switch : std::int32_t { Off, On };

enum class JitterSequence : std::int32_t { None, Halton };
struct JitterSettings {
  JitterSequence sequence = JitterSequence::Halton;
  std::int32_t period = 16;    ///< frames until the pattern repeats, 1 to 1024
  std::int32_t firstIndex = 1; ///< index of the sequence at frame 0; index 0 is the corner (−½, −½)
  float scale = 1.0f;          ///< of the offsets, 0 to 1
};

enum class Precision : std::int32_t { Half, Full };
enum class MotionSource : std::int32_t { Objects, CameraFromDepth };
struct InputSettings {
  Precision precision = Precision::Half; ///< color and motion as 16 or 32-bit floats
  MotionSource motion = MotionSource::Objects;
};

enum class DilateMethod : std::int32_t { None, Closest3x3 };
struct DilateSettings {
  DilateMethod method = DilateMethod::Closest3x3;
};

enum class HistoryFilter : std::int32_t { Bilinear, CatmullRom5 };
struct HistorySettings {
  HistoryFilter filter = HistoryFilter::CatmullRom5;
  Switch dering = Switch::On;            ///< clamp to the filter's own taps; Catmull-Rom only
  Precision precision = Precision::Half; ///< of the stored history
};

enum class CurrentFilter : std::int32_t { Center, Gaussian };
struct CurrentSettings {
  CurrentFilter filter = CurrentFilter::Gaussian;
  float variance = 0.22f; ///< σ² of the Gaussian, px²
};

enum class ColorSpace : std::int32_t { Rgb, YCoCg };
enum class ToneSpace : std::int32_t { Linear, ReinhardLuma };
struct SpaceSettings {
  ColorSpace color = ColorSpace::YCoCg;
  ToneSpace tone = ToneSpace::ReinhardLuma;
};

enum class NeighborhoodShape : std::int32_t { Cross, Square3x3 };
enum class BoxKind : std::int32_t { MinMax, Variance, Intersection };
struct NeighborhoodSettings {
  NeighborhoodShape shape = NeighborhoodShape::Square3x3;
  BoxKind box = BoxKind::Intersection;
  float gamma = 1.0f;                  ///< deviations from the mean to the wall of a variance box
  Switch includeFiltered = Switch::On; ///< grow the box to hold the filtered current color
};

enum class RectifyMethod : std::int32_t { None, Clamp, ClipToCenter, ClipToFiltered };
struct RectifySettings {
  RectifyMethod method = RectifyMethod::ClipToFiltered;
};

struct ValidateSettings {
  Switch offScreen = Switch::On;
  Switch depth = Switch::On;
  float depthTolerance = 0.03f; ///< τ, relative to the expected view depth
  float slopeAllowance = 2.0f;  ///< px along the depth slope of the surface that count as the same depth
};

enum class AlphaSource : std::int32_t { Constant, HistoryLength };
struct WeightSettings {
  AlphaSource source = AlphaSource::HistoryLength;
  float alpha = 0.1f;   ///< weight of the current frame when constant
  float minimum = 0.1f; ///< floor of 1/(N+1)
};

enum class ToneWeight : std::int32_t { None, Luma };
struct BlendSettings {
  ToneWeight tone = ToneWeight::Luma;
};

/// One lane's choices. Defaults are the preset "balanced".
struct Settings {
  JitterSettings jitter;
  InputSettings inputs;
  DilateSettings dilate;
  HistorySettings history;
  CurrentSettings current;
  SpaceSettings space;
  NeighborhoodSettings neighborhood;
  RectifySettings rectify;
  ValidateSettings validate;
  WeightSettings weight;
  BlendSettings blend;
};

} // namespace taa
