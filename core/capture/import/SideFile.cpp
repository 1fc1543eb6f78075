#include "core/capture/import/SideFile.h"

#include "core/base/Error.h"
#include "core/base/Files.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/base/json/LimitedJson.h"
#include "core/capture/format/ManifestChecks.h"

#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>

namespace taa::capture {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr std::size_t kMaxSideBytes = std::size_t(64) << 20;

/// Letters of a key, small: jitter_px, jitterPx and "Jitter px" are one.
std::string plain(std::string_view key) {
  std::string out;
  for (const char c : key.substr(0, 100))
    if (std::isalpha(static_cast<unsigned char>(c)) != 0)
      out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

/// The values of an object by the letters of their keys. Each key is looked at once, however many there are.
class Fields {
 public:
  explicit Fields(const json& object) {
    for (const auto& [key, value] : object.items()) values_.emplace(plain(key), &value);
  }
  /// The value of the first of `names` that the object has; null where there is none.
  const json* of(std::initializer_list<std::string_view> names) const {
    for (const std::string_view name : names)
      if (const auto found = values_.find(name); found != values_.end()) return found->second;
    return nullptr;
  }

 private:
  std::map<std::string, const json*, std::less<>> values_;
};

std::optional<double> finiteOf(const json* value) {
  if (!value || !value->is_number()) return {};
  const auto number = value->get<double>();
  if (!std::isfinite(number)) return {};
  return number;
}

std::string plainTextOf(const json* value) {
  if (!value || !value->is_string()) return "";
  std::string text = value->get<std::string>();
  return isPlainText(text) && text.size() <= kMaxText ? text : "";
}

/// [x, y] or {"x": …, "y": …}.
std::optional<glm::dvec2> pairOf(const json* value) {
  if (!value) return {};
  const json *x = nullptr, *y = nullptr;
  if (value->is_array() && value->size() >= 2) {
    x = &(*value)[0];
    y = &(*value)[1];
  } else if (value->is_object()) {
    const Fields fields(*value);
    x = fields.of({"x"});
    y = fields.of({"y"});
  }
  const std::optional<double> first = finiteOf(x), second = finiteOf(y);
  if (!first || !second) return {};
  return glm::dvec2(*first, *second);
}

/// 16 numbers, or four rows of four.
std::optional<StatedMatrix> matrixOf(const json* value) {
  if (!value) return {};
  if (value->is_object()) value = Fields(*value).of({"elements", "m", "data"});
  if (!value || !value->is_array()) return {};
  StatedMatrix matrix{};
  const bool isNested = value->size() == 4;
  if (!isNested && value->size() != 16) return {};
  for (std::size_t i = 0; i < 16; ++i) {
    const json* element = nullptr;
    if (!isNested)
      element = &(*value)[i];
    else if ((*value)[i / 4].is_array() && (*value)[i / 4].size() == 4)
      element = &(*value)[i / 4][i % 4];
    const std::optional<double> number = finiteOf(element);
    if (!number) return {};
    matrix[i] = *number;
  }
  return matrix;
}

/// In whichever order: the inverse of what is transposed is transposed.
std::optional<StatedMatrix> inverseOf(const std::optional<StatedMatrix>& matrix) {
  if (!matrix) return {};
  glm::dmat4 m;
  for (std::size_t i = 0; i < 16; ++i) m[static_cast<int>(i / 4)][static_cast<int>(i % 4)] = (*matrix)[i];
  const glm::dmat4 inverse = glm::inverse(m);
  StatedMatrix out{};
  for (std::size_t i = 0; i < 16; ++i) {
    out[i] = inverse[static_cast<int>(i / 4)][static_cast<int>(i % 4)];
    if (!std::isfinite(out[i])) return {};
  }
  return out;
}

void takeJitter(const Fields& fields, CapturedFrame& frame, SideFrames& out) {
  struct Key {
    std::string_view name;
    std::optional<ScreenUnit> unit;
  };
  static constexpr Key kKeys[] = {
      {"jitterpx", ScreenUnit::Pixels},
      {"jitterpixels", ScreenUnit::Pixels},
      {"jitteruv", ScreenUnit::Uv},
      {"jitterndc", ScreenUnit::Ndc},
      {"jitterclip", ScreenUnit::Ndc},
      {"jitter", {}},
      {"jitteroffset", {}},
      {"subpixeljitter", {}},
      {"taajitter", {}},
  };
  for (const Key& key : kKeys) {
    const std::optional<glm::dvec2> jitter = pairOf(fields.of({key.name}));
    if (!jitter) continue;
    frame.jitter = *jitter;
    if (key.unit) out.jitterUnit = key.unit;
    break;
  }
  const std::optional<double> x = finiteOf(fields.of({"jitterx"})), y = finiteOf(fields.of({"jittery"}));
  if (x && y) frame.jitter = {*x, *y};
  out.hasJitter = out.hasJitter || frame.jitter != glm::dvec2(0.0);
}

void takeMatrices(const Fields& fields, CapturedFrame& frame, SideFrames& out) {
  frame.view = matrixOf(fields.of({"view", "viewmatrix", "viewfromworld", "worldtoview", "worldtocamera",
                                   "worldtocameramatrix", "matrixworldinverse", "camerafromworld"}));
  if (!frame.view)
    frame.view = inverseOf(matrixOf(fields.of({"cameratoworld", "cameratoworldmatrix", "worldfromview",
                                               "worldfromcamera", "matrixworld", "cameramatrix"})));
  frame.projection = matrixOf(fields.of(
      {"projectionunjittered", "unjitteredprojection", "projectionwithoutjitter", "projectionnojitter",
       "nonjitteredprojection", "nonjitteredprojectionmatrix", "projectionnoaa", "projection",
       "projectionmatrix", "proj", "clipfromview", "viewtoclip", "cameratoclip"}));
  if (frame.projection) return;
  frame.projection =
      matrixOf(fields.of({"projectionjittered", "jitteredprojection", "projectionwithjitter"}));
  out.isProjectionJittered = out.isProjectionJittered || frame.projection.has_value();
}

CapturedFrame frameOf(const json& object, int index, SideFrames& out) {
  const Fields fields(object);
  CapturedFrame frame;
  frame.number = index;
  const std::optional<double> number =
      finiteOf(fields.of({"frame", "number", "framenumber", "frameindex", "index"}));
  if (number && *number >= 0.0 && *number < 1e9) {
    frame.number = static_cast<int>(*number);
    out.isNumbered = true;
  }
  takeJitter(fields, frame, out);
  takeMatrices(fields, frame, out);
  if (const auto exposure = finiteOf(fields.of({"preexposure"})))
    if (*exposure >= kMinPreExposure && *exposure <= kMaxPreExposure) frame.preExposure = *exposure;
  if (const json* cut = fields.of({"cut", "cameracut", "reset", "resethistory"}); cut && cut->is_boolean())
    frame.cut = cut->get<bool>();
  frame.seconds = finiteOf(fields.of({"seconds", "time", "timeseconds"}));
  return frame;
}

void takeList(const json& list, const std::string& name, SideFile& out) {
  if (!list.is_array() || list.empty() || list.size() > static_cast<std::size_t>(kMaxCapturedFrames)) return;
  SideFrames frames;
  frames.name = name;
  int index = 0;
  for (const json& object : list) {
    if (!object.is_object()) return;
    CapturedFrame frame = frameOf(object, index++, frames);
    frames.frames.insert_or_assign(frame.number, std::move(frame));
  }
  out.lists.push_back(std::move(frames));
}

/// {"1": "door"} or ["nothing", "door"]: 0 is no object.
void takeObjects(const json* value, SideFile& out) {
  if (!value) return;
  if (value->is_array())
    for (std::size_t i = 1; i < value->size(); ++i)
      if (const std::string name = plainTextOf(&(*value)[i]); !name.empty())
        out.objects[static_cast<std::uint32_t>(i)] = name;
  if (!value->is_object()) return;
  for (const auto& [key, name] : value->items()) {
    std::uint32_t id = 0;
    const auto end = key.data() + key.size();
    const auto read = std::from_chars(key.data(), end, id);
    if (read.ec == std::errc() && read.ptr == end && id > 0 && name.is_string())
      out.objects[id] = plainTextOf(&name);
  }
}

void takeRoot(const Fields& fields, SideFile& out) {
  out.name = plainTextOf(fields.of({"name", "scene", "title"}));
  out.engine = plainTextOf(fields.of({"engine", "generator", "renderer"}));
  out.nearPlane = finiteOf(fields.of({"near", "nearplane", "znear", "clipstart"})).value_or(0.0);
  out.farPlane = finiteOf(fields.of({"far", "farplane", "zfar", "clipend"})).value_or(0.0);
  out.framesPerSecond = finiteOf(fields.of({"fps", "framespersecond", "framerate"})).value_or(0.0);
  takeObjects(fields.of({"objects", "objectids", "ids"}), out);
}

bool is0(double value) {
  return std::abs(value) < 1e-12;
}

/// Whether 16 numbers are the columns of column vectors; nothing where a view says it of neither order. Where
/// row 3 is 0 0 0 1 they are rows; the place of the camera stands there otherwise.
std::optional<bool> isTransposedView(const StatedMatrix& view) {
  const bool isRows = is0(view[12]) && is0(view[13]) && is0(view[14]);
  const bool isColumns = is0(view[3]) && is0(view[7]) && is0(view[11]);
  if (isRows == isColumns) return {};
  return isColumns;
}

/// As above, of a projection: w is plus or minus z of a perspective one, and 1 of another.
std::optional<bool> isTransposedProjection(const StatedMatrix& projection) {
  const double rows = projection[14], columns = projection[11];
  if (!is0(projection[15])) return is0(rows) == is0(columns) ? std::nullopt : std::optional(is0(columns));
  const auto is1 = [](double value) { return std::abs(std::abs(value) - 1.0) < 1e-6; };
  const bool isRows = is1(rows), isColumns = is1(columns);
  if (isRows == isColumns) return {};
  return isColumns;
}

std::optional<bool> isTransposed(const SideFrames& frames) {
  for (const auto& [number, frame] : frames.frames)
    if (frame.view)
      if (const std::optional<bool> said = isTransposedView(*frame.view)) return said;
  for (const auto& [number, frame] : frames.frames)
    if (frame.projection)
      if (const std::optional<bool> said = isTransposedProjection(*frame.projection)) return said;
  return {};
}

/// Of a perspective projection of column vectors: between which z/w it puts what it keeps; nothing where none
/// has the near plane at this distance.
std::optional<ClipRange> clipRangeOf(const glm::dmat4& clip, double nearPlane) {
  constexpr double kSameDistance = 0.05; // of its logarithm
  if (!(nearPlane > 0.0)) return {};
  // z/w is a + b/distance.
  const double w = clip[2][3], a = clip[2][2] / w, b = clip[3][2] / std::abs(w);
  const auto isNearAt = [&](double z) {
    const double distance = b / (z - a);
    return distance > 0.0 && std::isfinite(distance) &&
           std::abs(std::log(distance / nearPlane)) < kSameDistance;
  };
  if (isNearAt(-1.0)) return ClipRange::MinusOneToOne;
  if (isNearAt(0.0)) return ClipRange::ZeroToOne;
  // Reversed: the far end says which.
  if (isNearAt(1.0)) return a < -0.5 ? ClipRange::MinusOneToOne : ClipRange::ZeroToOne;
  return {};
}

} // namespace

std::optional<SideFile> readSideFile(const fs::path& folder, const std::string& file) {
  SideFile out;
  out.file = file;
  const UntrustedFile opened = openUntrusted(folder, file, kMaxSideBytes);
  std::string text(static_cast<std::size_t>(opened.size()), '\0');
  opened.read(0, std::as_writable_bytes(std::span(text)));
  json root;
  try {
    root = parseLimited(text);
  } catch (const Error& error) {
    throw Error(say<"%1: %2">(file, error.what()));
  }
  if (root.is_array()) takeList(root, "", out);
  if (root.is_object()) {
    const Fields fields(root);
    takeRoot(fields, out);
    if (const json* frames = fields.of({"frames"})) takeList(*frames, "", out);
    for (const auto& [key, value] : root.items())
      if (value.is_object())
        if (const json* frames = Fields(value).of({"frames"})) takeList(*frames, key, out);
  }
  if (out.lists.empty()) return {};
  return out;
}

SeenMatrices matricesOf(const SideFrames& frames, double nearPlane, const MatrixConventions& start) {
  SeenMatrices out{start};
  const auto found = std::ranges::find_if(
      frames.frames, [](const auto& entry) { return entry.second.view && entry.second.projection; });
  if (found == frames.frames.end()) return out;
  MatrixConventions& seen = out.conventions;
  seen.jittered = frames.isProjectionJittered;
  // Rows of row vectors lie as columns of column vectors do.
  const bool isExpected = (start.order == MatrixOrder::RowMajor) != (start.vectors == VectorSide::Column);
  const std::optional<bool> said = isTransposed(frames);
  out.isOrderSeen = said.has_value();
  const bool isTransposed = said.value_or(isExpected);
  if (isTransposed != isExpected) {
    seen.order = isTransposed ? MatrixOrder::ColumnMajor : MatrixOrder::RowMajor;
    seen.vectors = VectorSide::Column;
  }
  glm::dmat4 clip;
  for (std::size_t i = 0; i < 16; ++i) {
    const int row = static_cast<int>(isTransposed ? i % 4 : i / 4);
    const int column = static_cast<int>(isTransposed ? i / 4 : i % 4);
    clip[column][row] = (*found->second.projection)[i];
  }
  seen.clipY = clip[1][1] < 0.0 ? VerticalAxis::Down : VerticalAxis::Up;
  // Without perspective w is 1 whichever way the camera looks.
  if (is0(clip[2][3])) return out;
  out.isForwardSeen = true;
  seen.forward = clip[2][3] > 0.0 ? ForwardAxis::PositiveZ : ForwardAxis::NegativeZ;
  const std::optional<ClipRange> range = clipRangeOf(clip, nearPlane);
  out.isClipZSeen = range.has_value();
  if (range) seen.clipZ = *range;
  return out;
}

} // namespace taa::capture
