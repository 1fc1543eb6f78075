// How somebody's engine writes its frames: direction, unit and axes of motion, meaning of jitter, kind of
// depth, order of matrices. What is stated here is what decode/ turns into this program's own conventions
// (manual, conventions).
#pragma once

#include <glm/vec2.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace taa::capture {

enum class MotionDirection : std::uint8_t { CurrentMinusPrevious, PreviousMinusCurrent };
/// Uv: 1 is the whole picture; Ndc: 2 is.
enum class ScreenUnit : std::uint8_t { Pixels, Uv, Ndc };
/// Of which picture a pixel of motion is one.
enum class PixelOf : std::uint8_t { Render, Output };
enum class VerticalAxis : std::uint8_t { Down, Up };
/// Unreal: sign · √|v| in 16 bits, 0: not written. Offset: (stored − offset) · scale.
enum class MotionEncoding : std::uint8_t { Plain, Unreal, Offset };
/// The jitter of which frames is left in motion.
enum class JitterInMotion : std::uint8_t { Removed, Both, Current, Previous };
/// What stands where motion was not written: rebuilt from depth and matrices, rest, or no previous position.
enum class MotionFallback : std::uint8_t { Camera, Zero, None };

struct MotionConventions {
  MotionDirection direction = MotionDirection::CurrentMinusPrevious;
  ScreenUnit unit = ScreenUnit::Pixels;
  PixelOf pixelOf = PixelOf::Render;
  VerticalAxis yAxis = VerticalAxis::Down;
  MotionEncoding encoding = MotionEncoding::Plain;
  glm::dvec2 scale{1.0};  ///< what is stored times it is in `unit`; negative mirrors an axis
  glm::dvec2 offset{0.0}; ///< encoding Offset only: taken off before scaling
  JitterInMotion jitter = JitterInMotion::Removed;
  bool includesCamera = true;       ///< false: motion of the camera is added from depth and matrices
  std::optional<double> notWritten; ///< stored value, in both components, of pixels nobody wrote
  MotionFallback fallback = MotionFallback::Camera; ///< what to do there
  /// What to do where depth says that nothing was drawn; none: motion there is as good as elsewhere.
  std::optional<MotionFallback> whereNothing;
  bool operator==(const MotionConventions&) const = default;
};

/// Content: the picture's content moves by +j. Sample: what is seen at a pixel lies at +j of the picture
/// without jitter, so that content moves by −j.
enum class JitterMeaning : std::uint8_t { Content, Sample };

struct JitterConventions {
  ScreenUnit unit = ScreenUnit::Pixels; ///< of the render size
  JitterMeaning meaning = JitterMeaning::Content;
  VerticalAxis yAxis = VerticalAxis::Down;
  int delay = 0; ///< frames, −1 to 1: what is stated with frame n is that of frame n + delay
  bool operator==(const JitterConventions&) const = default;
};

/// Window: what the projection leaves, z / w. Planar: along the camera's axis. Radial: from the eye.
enum class DepthKind : std::uint8_t { Window, Planar, Radial };
enum class ClipRange : std::uint8_t { ZeroToOne, MinusOneToOne };

struct DepthConventions {
  DepthKind kind = DepthKind::Window;
  bool reversed = true;                   ///< Window: near is the larger value
  ClipRange range = ClipRange::ZeroToOne; ///< Window: as stored
  double nearPlane = 0.0,
         farPlane = 0.0; ///< Window, world units; near 0: as the projection matrix says; far 0: infinite
  double scale = 1.0;    ///< Planar, Radial: stored · scale is a distance in world units; negative: view z
  std::optional<double>
      nothing;          ///< stored value where nothing was drawn (sky); Window: the far plane is that, too
  bool jittered = true; ///< drawn with the frame's jitter, as color is
  bool operator==(const DepthConventions&) const = default;
};

enum class MatrixOrder : std::uint8_t { RowMajor, ColumnMajor };
/// Column: clip = projection · view · p. Row: clip = p · view · projection.
enum class VectorSide : std::uint8_t { Column, Row };
enum class ForwardAxis : std::uint8_t { NegativeZ, PositiveZ };

struct MatrixConventions {
  MatrixOrder order = MatrixOrder::RowMajor;
  VectorSide vectors = VectorSide::Column;
  ClipRange clipZ = ClipRange::ZeroToOne;
  VerticalAxis clipY = VerticalAxis::Up;
  ForwardAxis forward = ForwardAxis::NegativeZ; ///< of view space
  bool jittered = false;                        ///< projections that are stated hold the frame's jitter
  double metersPerUnit = 1.0;                   ///< of the world
  bool operator==(const MatrixConventions&) const = default;
};

enum class ColorEncoding : std::uint8_t { Linear, Srgb };

struct ColorConventions {
  ColorEncoding encoding = ColorEncoding::Linear;
  bool preExposed = false; ///< values were multiplied by the frame's preExposure
  bool operator==(const ColorConventions&) const = default;
};

enum class RowOrder : std::uint8_t { TopFirst, BottomFirst };

struct Conventions {
  MotionConventions motion;
  JitterConventions jitter;
  DepthConventions depth;
  MatrixConventions matrices;
  ColorConventions color;
  RowOrder rows = RowOrder::TopFirst; ///< of all planes that do not say otherwise
  bool operator==(const Conventions&) const = default;
};

// The table of all that can be stated: JSON, --set, the import page, the schema and the manual derive from
// it.

enum class ConventionKind : std::uint8_t { Choice, Toggle, Integer, Number, OptionalNumber, OptionalChoice };

struct ConventionChoice {
  std::string_view id, label, explanation;
};

struct Convention {
  std::string_view path; ///< "motion.direction"; components of vectors are rows of their own: "motion.scaleX"
  std::string_view label;
  ConventionKind kind;
  std::span<const ConventionChoice> choices; ///< of choices
  std::string_view unit;                     ///< empty for none
  double minimum, maximum;                   ///< of numbers
  std::string_view tooltip;
  /// "path=choice|choice" or "path!=none": what it has an effect with; empty: always.
  std::string_view when;
  std::string (*text)(const Conventions&);             ///< as JSON and --set write it; "none" where optional
  void (*assign)(Conventions&, std::string_view text); ///< throws Error naming path, text and what is allowed
};

std::span<const Convention> conventions();
/// Throws Error that names the nearest paths when there is none.
const Convention& convention(std::string_view path);
/// Applies "path=value". Throws Error.
void applyAssignment(Conventions& conventions, std::string_view assignment);
/// Whether the row says anything about frames of these conventions; see Convention::when.
bool isRelevant(const Convention& row, const Conventions& conventions);
/// The same conventions with all rows that say nothing as they are in Conventions{}.
Conventions normalized(const Conventions& conventions);
/// What is stated twice and differently, or cannot be true (a scale of 0, far nearer than near); a sentence
/// that names the rows, empty where there is none.
std::string contradiction(const Conventions& conventions);
/// The assignments that turn `base` into `stated`.
std::vector<std::string> differences(const Conventions& stated, const Conventions& base);

/// An engine or library whose conventions are known.
struct StartingPoint {
  std::string_view id;    ///< "unreal"
  std::string_view label; ///< "Unreal Engine 5"
  std::string_view notes; ///< what to look at: what differs between versions or projects
  std::string_view source;
  Conventions conventions;
};

/// taa-inspector (this program's own), unreal, unity, godot, bevy, three, babylon, fsr, xess, streamline,
/// metalfx, blender; in this order.
std::span<const StartingPoint> startingPoints();
/// Throws Error naming those there are.
const StartingPoint& startingPoint(std::string_view id);

} // namespace taa::capture
