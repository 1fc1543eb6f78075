// capture.json to Manifest: every key is looked at, none is left over.
#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/base/json/JsonFields.h"
#include "core/base/json/LimitedJson.h"
#include "core/capture/format/ManifestChecks.h"
#include "core/capture/format/ManifestKeys.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace taa::capture {

using nlohmann::json;

namespace {

constexpr int kMaxNumber = std::numeric_limits<int>::max();

// The text that the row reads, of a value of the type that it wants.
std::string assignmentText(const Convention& row, const json& value, const std::string& path) {
  const bool isOptional =
      row.kind == ConventionKind::OptionalNumber || row.kind == ConventionKind::OptionalChoice;
  if (isOptional && value == "none") return "none";
  switch (row.kind) {
  case ConventionKind::Toggle:
    return toggleOf(value, path) ? "on" : "off";
  case ConventionKind::Choice:
  case ConventionKind::OptionalChoice:
    return textOf(value, path);
  case ConventionKind::Integer:
  case ConventionKind::Number:
  case ConventionKind::OptionalNumber:
    break;
  }
  numberOf(value, path); // or it is refused
  return value.dump();
}

/// Assigns what `value` states, and keeps the row.
void readConvention(const std::string& path, const json& value, Conventions& conventions,
                    std::vector<const Convention*>& stated) {
  const Convention& row = convention(path);
  row.assign(conventions, assignmentText(row, value, pathOf("conventions", path)));
  stated.push_back(&row);
}

bool isGroup(std::string_view name) {
  return std::ranges::any_of(conventions(), [&](const Convention& row) {
    return row.path.starts_with(name) && row.path.substr(name.size()).starts_with('.');
  });
}

/// Refuses "motion.unit" beside "motion": each convention has one place, so that none is stated twice.
void requireOwnPlace(const std::string& path) {
  const std::size_t dot = path.find('.');
  if (dot == std::string::npos) return;
  const Convention& row = convention(path);
  throw Error(say<"there is no key \"%1\": write \"%2\": {\"%3\": …}">(
      pathOf("conventions", path), row.path.substr(0, dot), row.path.substr(dot + 1)));
}

/// {"motion": {"unit": "uv"}, "rows": "topFirst"}; the rows that it states.
std::vector<const Convention*> readGroups(const json& groups, Conventions& conventions) {
  requireObject(groups, "conventions");
  std::vector<const Convention*> stated;
  for (const auto& [name, value] : groups.items()) {
    if (!isGroup(name)) {
      requireOwnPlace(name);
      readConvention(name, value, conventions, stated);
      continue;
    }
    requireObject(value, pathOf("conventions", name));
    for (const auto& [key, member] : value.items())
      readConvention(pathOf(name, key), member, conventions, stated);
  }
  return stated;
}

/// The same as ["motion.unit=uv", "rows=topFirst"], which a program writes that knows no convention.
std::vector<const Convention*> readAssignments(const json& list, Conventions& conventions) {
  requireList(list, "conventions", capture::conventions().size());
  std::vector<const Convention*> stated;
  for (const json& entry : list) {
    const std::string assignment = textOf(entry, "conventions");
    applyAssignment(conventions, assignment);
    const Convention& row = convention(assignment.substr(0, assignment.find('=')));
    if (std::ranges::find(stated, &row) != stated.end())
      throw Error(say<"\"%1\" is stated twice">(pathOf("conventions", row.path)));
    stated.push_back(&row);
  }
  return stated;
}

Conventions readConventions(const json& value, const Conventions& base) {
  Conventions result = base;
  const std::vector<const Convention*> stated =
      value.is_array() ? readAssignments(value, result) : readGroups(value, result);
  // What repeats the value that a row without a meaning has anyway contradicts nothing.
  for (const Convention* row : stated)
    if (!isRelevant(*row, result) && row->text(result) != row->text(Conventions{}))
      throw Error(say<"\"%1\" contradicts the rest: it has a meaning with %2 only">(
          pathOf("conventions", row->path), row->when));
  return normalized(result);
}

/// Two whole numbers; `wanted`: what they are, for whoever gives others.
glm::ivec2 readPair(const json& value, const std::string& path, int least, const char* wanted) {
  requireList(value, path, 2);
  if (value.size() != 2) throw Error(say<"\"%1\" wants %2">(path, wanted));
  return {static_cast<int>(integerOf(value[0], path, least, kMaxCaptureSide)),
          static_cast<int>(integerOf(value[1], path, least, kMaxCaptureSide))};
}

glm::ivec2 readSize(const json& value, const std::string& path) {
  return readPair(value, path, 1, "[width, height]");
}

glm::ivec2 readPlace(const json& value, const std::string& path) {
  return readPair(value, path, 0, "[x, y]");
}

template <std::size_t kCount>
std::array<double, kCount> readNumbers(const json& value, const std::string& path) {
  requireList(value, path, kCount);
  if (value.size() != kCount) throw Error(say<"\"%1\" wants %2 numbers">(path, kCount));
  std::array<double, kCount> numbers{};
  for (std::size_t i = 0; i < kCount; ++i) numbers[i] = numberOf(value[i], path);
  return numbers;
}

RowOrder readRows(const json& value, const std::string& path) {
  Conventions read;
  convention("rows").assign(read, textOf(value, path));
  return read.rows;
}

RawFormat readRaw(const json& value, const std::string& path) {
  const std::string name = textOf(value, path);
  if (const std::optional<RawFormat> format = rawFormatOf(name)) return *format;
  throw Error(say<"\"%1\" is \"%2\": there is no such raw format, give one of %3">(path, shownText(name),
                                                                                   rawFormatNames()));
}

PlaneSource readPlaneSource(const json& object, const std::string& path) {
  requireKeys(object, path, kPlaneKeys);
  PlaneSource source;
  source.file = textOf(requireField(object, path, "file"), pathOf(path, "file"));
  if (const json* part = findField(object, "part")) source.part = textOf(*part, pathOf(path, "part"));
  if (const json* channels = findField(object, "channels")) {
    requireList(*channels, pathOf(path, "channels"), 4);
    for (const json& channel : *channels)
      source.channels.push_back(textOf(channel, pathOf(path, "channels")));
  }
  if (const json* raw = findField(object, "raw")) source.raw = readRaw(*raw, pathOf(path, "raw"));
  if (const json* size = findField(object, "size")) source.sizePx = readSize(*size, pathOf(path, "size"));
  if (const json* pitch = findField(object, "rowPitch"))
    source.rowPitch = static_cast<std::size_t>(integerOf(*pitch, pathOf(path, "rowPitch"), 0, 1 << 30));
  if (const json* at = findField(object, "at")) source.atPx = readPlace(*at, pathOf(path, "at"));
  if (const json* rows = findField(object, "rows")) source.rows = readRows(*rows, pathOf(path, "rows"));
  return source;
}

std::map<PlaneKind, PlaneSource> readPlaneSources(const json& object, const std::string& path) {
  std::vector<std::string_view> names;
  for (std::size_t kind = 0; kind < kPlaneKinds; ++kind)
    names.push_back(planeName(static_cast<PlaneKind>(kind)));
  requireKeys(object, path, names);
  std::map<PlaneKind, PlaneSource> planes;
  for (const auto& [name, source] : object.items())
    planes.emplace(planeOf(name).value(), readPlaneSource(source, pathOf(path, name)));
  return planes;
}

void readMatrices(const json& object, const std::string& place, CapturedFrame& frame) {
  const auto read = [&](const char* key, std::optional<StatedMatrix>& matrix) {
    if (const json* value = findField(object, key)) matrix = readNumbers<16>(*value, pathOf(place, key));
  };
  read("view", frame.view);
  read("projection", frame.projection);
  read("previousView", frame.previousView);
  read("previousProjection", frame.previousProjection);
}

CapturedFrame readFrame(const json& object, const std::string& place) {
  requireKeys(object, place, kFrameKeys);
  CapturedFrame frame;
  frame.number = static_cast<int>(
      integerOf(requireField(object, place, "number"), pathOf(place, "number"), 0, kMaxNumber));
  if (const json* jitter = findField(object, "jitter")) {
    const std::array<double, 2> numbers = readNumbers<2>(*jitter, pathOf(place, "jitter"));
    frame.jitter = {numbers[0], numbers[1]};
  }
  readMatrices(object, place, frame);
  if (const json* exposure = findField(object, "preExposure"))
    frame.preExposure = numberOf(*exposure, pathOf(place, "preExposure"));
  if (const json* cut = findField(object, "cut")) frame.cut = toggleOf(*cut, pathOf(place, "cut"));
  if (const json* seconds = findField(object, "seconds"))
    frame.seconds = numberOf(*seconds, pathOf(place, "seconds"));
  if (const json* planes = findField(object, "planes"))
    frame.planes = readPlaneSources(*planes, pathOf(place, "planes"));
  return frame;
}

/// Jitter is stated of all frames or of none; where of none, nothing may be said to hold it.
void requireJitter(const json& list, const Conventions& conventions) {
  const bool isStated = findField(list.front(), "jitter") != nullptr;
  for (std::size_t i = 0; i < list.size(); ++i)
    if ((findField(list[i], "jitter") != nullptr) != isStated)
      throw Error(say<"\"%1\" is missing, but other frames have it">(
          "frames[" + std::to_string(isStated ? i : 0) + "].jitter"));
  if (isStated) return;
  const char* const holder = conventions.matrices.jittered ? "conventions.matrices.jittered"
                             : conventions.motion.jitter != JitterInMotion::Removed
                                 ? "conventions.motion.jitter"
                                 : nullptr;
  if (holder)
    throw Error(say<"\"%1\" says that there is jitter, but \"%2\" is missing">(holder, "frames[0].jitter"));
}

std::vector<CapturedFrame> readFrames(const json& list, const Conventions& conventions) {
  requireList(list, "frames", static_cast<std::size_t>(kMaxCapturedFrames));
  std::vector<CapturedFrame> frames;
  frames.reserve(list.size());
  for (std::size_t i = 0; i < list.size(); ++i)
    frames.push_back(readFrame(list[i], "frames[" + std::to_string(i) + "]"));
  if (!frames.empty()) requireJitter(list, conventions);
  return frames;
}

/// Decimal without leading zeros, so that no id can come twice.
std::uint32_t readId(const std::string& key) {
  std::uint32_t id = 0;
  const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), id);
  if (error != std::errc() || end != key.data() + key.size() || std::to_string(id) != key)
    throw Error(say<"the key \"%1\" is not an id from 1 to %2">(pathOf("objects", shownText(key)),
                                                                std::numeric_limits<std::uint32_t>::max()));
  return id;
}

std::map<std::uint32_t, std::string> readObjects(const json& object) {
  requireObject(object, "objects");
  std::map<std::uint32_t, std::string> objects;
  for (const auto& [key, name] : object.items())
    objects.emplace(readId(key), plainText(textOf(name, pathOf("objects", shownText(key)))));
  return objects;
}

std::vector<std::string> readNotes(const json& list) {
  requireList(list, "notes", kMaxNotes);
  std::vector<std::string> notes;
  for (const json& note : list) notes.push_back(shownLine(textOf(note, "notes")));
  return notes;
}

void readAbout(const json& object, Manifest& manifest) {
  if (const json* schema = findField(object, "$schema")) textOf(*schema, "$schema"); // for editors
  if (const json* name = findField(object, "name")) manifest.name = plainText(textOf(*name, "name"));
  if (const json* engine = findField(object, "engine"))
    manifest.engine = plainText(textOf(*engine, "engine"));
  if (const json* like = findField(object, "like")) {
    manifest.like = textOf(*like, "like");
    manifest.conventions = startingPoint(manifest.like).conventions;
  }
  manifest.conventions = normalized(manifest.conventions);
  if (const json* conventions = findField(object, "conventions"))
    manifest.conventions = readConventions(*conventions, manifest.conventions);
}

/// Sessions end in .json as well.
void refuseSession(const json& object) {
  if (findField(object, "source") && !findField(object, "frames"))
    throw Error(
        say<"it is a session, no capture: taa-inspector opens it, and taa-batch takes it with --session">());
}

Manifest manifestFrom(const json& object) {
  requireObject(object, "");
  refuseSession(object);
  requireFormat(object, kManifestFormat);
  requireKeys(object, "", kManifestKeys);
  Manifest manifest;
  readAbout(object, manifest);
  manifest.sizePx = readSize(requireField(object, "", "size"), "size");
  if (const json* output = findField(object, "outputSize"))
    manifest.outputPx = readSize(*output, "outputSize");
  if (const json* rate = findField(object, "framesPerSecond"))
    manifest.framesPerSecond = numberOf(*rate, "framesPerSecond");
  if (const json* objects = findField(object, "objects")) manifest.objects = readObjects(*objects);
  if (const json* planes = findField(object, "planes")) manifest.planes = readPlaneSources(*planes, "planes");
  manifest.frames = readFrames(requireField(object, "", "frames"), manifest.conventions);
  if (const json* notes = findField(object, "notes")) manifest.notes = readNotes(*notes);
  return manifest;
}

} // namespace

Manifest parseManifest(std::string_view text, const std::string& where) {
  try {
    Manifest manifest = manifestFrom(parseLimited(text));
    requireConsistent(manifest);
    return manifest;
  } catch (const Error& error) {
    throw Error(say<"cannot open the capture %1: %2">(where, error.what()));
  }
}

} // namespace taa::capture
