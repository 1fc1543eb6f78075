// capture.json: what a captured sequence of frames consists of, and where in which files it lies.
#pragma once

#include "core/capture/format/Conventions.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace taa::capture {

/// What a frame may consist of. Values are in the capture's conventions.
enum class PlaneKind : std::uint8_t {
  Color,         ///< red, green, blue, before TAA, with jitter
  Motion,        ///< x, y
  Depth,         ///< one value
  ObjectId,      ///< one unsigned integer, 0: nothing
  Normal,        ///< x, y, z, world space; fourth, raw or named: the number of the ObjectClass
  PreviousDepth, ///< distance along the camera's axis that the surface had in the previous frame, m; 0: none
  Mask,          ///< reactive, responsive, 0 to 1; the second may be missing
  Overlay,       ///< red, green, blue, alpha, premultiplied, without jitter: laid over the output
  Fog,           ///< light that fog scatters to the camera; alpha: what it takes of the surface's
  Output,        ///< red, green, blue: what the engine's own TAA made of the frame
  Reference,     ///< red, green, blue: a picture to compare with, supersampled
};
inline constexpr std::size_t kPlaneKinds = 11;

/// "color", "motion", "depth", "objectId", "normal", "previousDepth", "mask", "overlay", "fog", "output",
/// "reference".
std::string_view planeName(PlaneKind kind);
std::optional<PlaneKind> planeOf(std::string_view name);
/// What it holds, in a sentence.
std::string_view planeDescription(PlaneKind kind);
/// Channels that decode/ wants of it, 1 to 4.
int channelsOf(PlaneKind kind);
/// Channels that it needs: of colors the fourth may be missing, of normals the class, of masks the second.
int minChannelsOf(PlaneKind kind);

/// How a value lies in a raw plane, little-endian; the names are those of taa_capture.h without TAA_. D24S8:
/// depth in the lower 24 bits, as Direct3D has it; D24S8_GL: in the upper, as GL_UNSIGNED_INT_24_8. D32F_S8:
/// 8 bytes, the float first. RGBA8_SRGB: decoded to linear when read; no other format is.
enum class RawFormat : std::uint8_t {
  R11G11B10F,
  RGBA16F,
  RGBA32F,
  RG16F,
  RG32F,
  RG16_UNORM,
  RGBA8_UNORM,
  RGBA8_SRGB,
  R16F,
  R32F,
  D32F,
  D24S8,
  D32F_S8,
  R16_UNORM,
  R8_UNORM,
  RG8_UNORM,
  R8_UINT,
  R16_UINT,
  R32_UINT,
  D24S8_GL,
};

inline constexpr std::size_t kRawFormats = 20;

/// "RGBA16F"
std::string_view rawFormatName(RawFormat format);
int rawChannels(RawFormat format);
std::size_t bytesPerPixel(RawFormat format);
std::optional<RawFormat> rawFormatOf(std::string_view name);

/// Where a plane's values lie. `file` is below the capture's folder; "{frame}" stands for the frame's number,
/// "{frame:4}" for it with four digits.
struct PlaneSource {
  std::string file;
  std::string part;                  ///< of a multi-part EXR: its name; empty: whichever holds the channels
  std::vector<std::string> channels; ///< by name, in the order of PlaneKind; empty: as they come
  std::optional<RawFormat> raw;      ///< a raw plane; none: a picture that OpenImageIO reads
  glm::ivec2 sizePx{0};              ///< raw only
  std::size_t rowPitch = 0;          ///< bytes, raw only; 0: rows lie one after another
  std::optional<RowOrder> rows;      ///< none: as the conventions say
  /// Where in the file the picture begins that is the frame's, px from the upper left corner: what lies
  /// around it is not read. None: the file holds that picture alone.
  std::optional<glm::ivec2> atPx = {};
  bool operator==(const PlaneSource&) const = default;
};

/// The file of a frame, "{frame}" filled in: "color.{frame:4}.exr" of frame 7 is "color.0007.exr".
std::string planeFile(const PlaneSource& source, int frameNumber);

/// Matrices are as the file states them, 16 numbers in its order; see MatrixConventions.
using StatedMatrix = std::array<double, 16>;

struct CapturedFrame {
  int number = 0;                               ///< the engine's own, in file names and messages; rising
  glm::dvec2 jitter{0.0};                       ///< as stated; see JitterConventions
  std::optional<StatedMatrix> view, projection; ///< none: not known
  std::optional<StatedMatrix> previousView, previousProjection; ///< none: those of the frame before
  double preExposure = 1.0;
  bool cut = false;                        ///< history starts here
  std::optional<double> seconds;           ///< none: from framesPerSecond
  std::map<PlaneKind, PlaneSource> planes; ///< instead of the manifest's
  bool operator==(const CapturedFrame&) const = default;
};

struct Manifest {
  std::string name, engine;
  Conventions conventions;
  std::string like; ///< the starting point that `conventions` were written as differences of; may be empty
  glm::ivec2 sizePx{0};   ///< of color: the render size
  glm::ivec2 outputPx{0}; ///< of the engine's output; 0: the render size
  double framesPerSecond = 60.0;
  std::map<std::uint32_t, std::string> objects; ///< names of ids
  std::map<PlaneKind, PlaneSource> planes;
  std::vector<CapturedFrame> frames; ///< at least one
  std::vector<std::string> notes;    ///< sentences for the user: what the import guessed, what is missing
  bool operator==(const Manifest&) const = default;

  glm::ivec2 outputSize() const { return outputPx.x > 0 ? outputPx : sizePx; }
  /// That a plane has where it is not coarser.
  glm::ivec2 sizeOf(PlaneKind kind) const {
    return kind == PlaneKind::Output || kind == PlaneKind::Reference ? outputSize() : sizePx;
  }
  /// Null: the frame has no such plane.
  const PlaneSource* plane(const CapturedFrame& frame, PlaneKind kind) const;
  /// How many frames have such a plane.
  std::size_t framesWith(PlaneKind kind) const;
};

inline constexpr const char* kManifestName = "capture.json";
inline constexpr int kMaxCapturedFrames = 100000;
inline constexpr int kMaxCaptureSide = 16384; ///< px

// The keys of capture.json (manual, captures) are the names of the fields above, but for "format": 1,
// which has to be there, "size" and "outputSize" of the manifest, and "size" of a plane:
// {"format": 1, "name": "", "engine": "", "like": "unreal", "conventions": {"motion": {"unit": "uv"}, "rows":
// "topFirst"}, "size": [480, 270], "outputSize": [960, 540], "framesPerSecond": 60, "objects": {"7": "door"},
// "planes": {"color": {"file": "color.{frame:4}.raw", "raw": "RGBA16F", "size": [480, 270], "rowPitch": 3840,
// "rows": "topFirst"}, "motion": {"file": "f.{frame}.exr", "part": "", "channels": ["X", "Y"]}},
// "frames": [{"number": 0, "jitter": [0, 0], "view": [16 numbers], "projection": [16], "previousView": [16],
// "previousProjection": [16], "preExposure": 1, "cut": true, "seconds": 0, "planes": {}}], "notes": [""]}

/// Reads and checks FOLDER/capture.json, strictly: unknown, contradicting or missing keys are an Error that
/// names them, paths lead below the folder. In time and memory that its size bounds.
/// `name`: the file, where it is called otherwise.
Manifest readManifest(const std::filesystem::path& folder, const std::string& name = kManifestName);
/// As above, of text; `where` is named in messages.
Manifest parseManifest(std::string_view json, const std::string& where);
/// What parseManifest refuses whatever text it came from. Throws Error that begins with `where`.
void checkManifest(const Manifest& manifest, const std::string& where);
/// What parseManifest reads back as the same, but that conventions are normalized(). Throws Error where it
/// could not.
std::string manifestText(const Manifest& manifest);

} // namespace taa::capture
