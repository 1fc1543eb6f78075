#include "core/capture/format/ManifestChecks.h"

#include "core/base/Error.h"
#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/base/json/JsonFields.h"
#include "core/capture/format/ConventionText.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace taa::capture {

namespace {

using Frames = std::vector<CapturedFrame>;

std::string framePath(std::size_t index, std::string_view key) {
  return pathOf(elementOf("frames", index), key);
}

void requireText(const std::string& text, const std::string& path) {
  if (text.size() > kMaxText) throw Error(say<"\"%1\" is longer than %2 bytes">(path, kMaxText));
  if (!isPlainText(text)) throw Error(say<"\"%1\" holds what is not a letter">(path));
}

/// Written so that NaN is refused.
void requireWithin(double value, double least, double most, const std::string& path) {
  if (!(value >= least && value <= most))
    throw Error(say<"\"%1\" is %2, not from %3 to %4">(path, decimalText(value), decimalText(least),
                                                       decimalText(most)));
}

/// Whether every "{" begins "{frame}" or "{frame:4}", and every "}" ends one.
bool hasWholePlaceholders(std::string_view file) {
  for (std::size_t at = file.find_first_of("{}"); at != std::string_view::npos;
       at = file.find_first_of("{}")) {
    file.remove_prefix(at);
    std::size_t length = 0;
    if (file.starts_with("{frame}")) length = 7;
    if (file.starts_with("{frame:") && file.size() > 8 && file[7] >= '1' && file[7] <= '9' && file[8] == '}')
      length = 9;
    if (length == 0) return false;
    file.remove_prefix(length);
  }
  return true;
}

bool leadsBelow(std::string_view file) {
  const bool hasDrive = file.size() > 1 && file[1] == ':';
  if (file.empty() || file.starts_with('/') || file.ends_with('/') || hasDrive) return false;
  while (!file.empty()) {
    const std::size_t slash = std::min(file.find('/'), file.size());
    if (file.substr(0, slash) == "..") return false;
    file.remove_prefix(std::min(slash + 1, file.size()));
  }
  return true;
}

void requireFile(const std::string& file, const std::string& path) {
  requireText(file, path);
  const std::string shown = shownText(file);
  if (file.find('\\') != std::string::npos)
    throw Error(say<"\"%1\" is \"%2\": write / between folders">(path, shown));
  if (!leadsBelow(file))
    throw Error(say<"\"%1\" is \"%2\", which is not a file below the capture's folder">(path, shown));
  if (!hasWholePlaceholders(file))
    throw Error(say<"\"%1\" is \"%2\": braces stand around frame or frame:4 only">(path, shown));
}

void requireSide(int side, const std::string& path) {
  if (side < 1 || side > kMaxCaptureSide)
    throw Error(say<"\"%1\" is %2 pixels, not from 1 to %3">(path, side, kMaxCaptureSide));
}

void requireSide(glm::ivec2 sizePx, const std::string& path) {
  requireSide(sizePx.x, path);
  requireSide(sizePx.y, path);
}

bool isWhole(RawFormat format) {
  return rawFormatName(format).ends_with("_UINT");
}

void requireNoPictureKeys(const PlaneSource& source, const std::string& path) {
  const char* const key = !source.part.empty() ? "part" : !source.channels.empty() ? "channels" : nullptr;
  if (key)
    throw Error(say<"\"%1\" contradicts \"%2\": a raw plane has neither parts nor channels with names">(
        pathOf(path, key), pathOf(path, "raw")));
}

void requireRaw(const PlaneSource& source, PlaneKind kind, glm::ivec2 usualPx, const std::string& path) {
  requireNoPictureKeys(source, path);
  const RawFormat format = *source.raw;
  const std::string rawPath = pathOf(path, "raw");
  if (isWhole(format) != (kind == PlaneKind::ObjectId))
    throw Error(isWhole(format) ? say<"\"%1\" is %2, which holds whole numbers: only objectId does">(
                                      rawPath, rawFormatName(format))
                                : say<"\"%1\" is %2, which does not hold whole numbers: objectId wants them">(
                                      rawPath, rawFormatName(format)));
  if (rawChannels(format) < minChannelsOf(kind))
    throw Error(say<"\"%1\" is %2 with fewer than the %3 channels of %4">(
        rawPath, rawFormatName(format), minChannelsOf(kind), planeName(kind)));
  if (source.sizePx != glm::ivec2(0)) requireSide(source.sizePx, pathOf(path, "size"));
  const int width = source.sizePx.x > 0 ? source.sizePx.x : usualPx.x;
  const std::size_t row = static_cast<std::size_t>(width) * bytesPerPixel(format);
  if (source.rowPitch > 0 && source.rowPitch < row)
    throw Error(
        say<"\"%1\" is %2 bytes, less than the %3 of a row">(pathOf(path, "rowPitch"), source.rowPitch, row));
  if (source.rowPitch > std::size_t(1) << 30)
    throw Error(say<"\"%1\" is more than 1 GiB">(pathOf(path, "rowPitch")));
}

void requirePicture(const PlaneSource& source, PlaneKind kind, const std::string& path) {
  const char* const key = source.sizePx != glm::ivec2(0) ? "size"
                          : source.rowPitch > 0          ? "rowPitch"
                                                         : nullptr;
  if (key)
    throw Error(say<"\"%1\" is for raw planes: \"%2\" is missing">(pathOf(path, key), pathOf(path, "raw")));
  const auto channels = static_cast<int>(source.channels.size());
  if (channels > 0 && (channels < minChannelsOf(kind) || channels > channelsOf(kind)))
    throw Error(say<"\"%1\" names %2 channels; %3 has %4 to %5">(
        pathOf(path, "channels"), channels, planeName(kind), minChannelsOf(kind), channelsOf(kind)));
  requireText(source.part, pathOf(path, "part"));
  for (const std::string& channel : source.channels) requireText(channel, pathOf(path, "channels"));
}

void requirePlanes(const std::map<PlaneKind, PlaneSource>& planes, const Manifest& manifest,
                   const std::string& place) {
  for (const auto& [kind, source] : planes) {
    const std::string path = pathOf(place, planeName(kind));
    requireFile(source.file, pathOf(path, "file"));
    if (source.atPx)
      for (const int at : {source.atPx->x, source.atPx->y})
        requireWithin(at, 0.0, kMaxCaptureSide, pathOf(path, "at"));
    if (source.raw)
      requireRaw(source, kind, manifest.sizeOf(kind), path);
    else
      requirePicture(source, kind, path);
  }
}

void requireMatrix(const std::optional<StatedMatrix>& matrix, const std::string& path) {
  if (!matrix) return;
  for (const double number : *matrix) requireWithin(number, -kMaxMatrixElement, kMaxMatrixElement, path);
}

void requirePair(bool hasView, bool hasProjection, const std::string& view, const std::string& projection) {
  if (hasView == hasProjection) return;
  throw Error(
      say<"\"%1\" is there without \"%2\"">(hasView ? view : projection, hasView ? projection : view));
}

void requireMatrices(const CapturedFrame& frame, std::size_t i) {
  requirePair(frame.view.has_value(), frame.projection.has_value(), framePath(i, "view"),
              framePath(i, "projection"));
  requirePair(frame.previousView.has_value(), frame.previousProjection.has_value(),
              framePath(i, "previousView"), framePath(i, "previousProjection"));
  if (frame.previousView && !frame.view)
    throw Error(say<"\"%1\" is there without \"%2\"">(framePath(i, "previousView"), framePath(i, "view")));
  requireMatrix(frame.view, framePath(i, "view"));
  requireMatrix(frame.projection, framePath(i, "projection"));
  requireMatrix(frame.previousView, framePath(i, "previousView"));
  requireMatrix(frame.previousProjection, framePath(i, "previousProjection"));
}

void requireNumbers(const CapturedFrame& frame, const Manifest& manifest, std::size_t i) {
  if (frame.number < 0) throw Error(say<"\"%1\" is below 0">(framePath(i, "number")));
  for (const double jitter : {frame.jitter.x, frame.jitter.y})
    requireWithin(jitter, -kMaxStatedJitter, kMaxStatedJitter, framePath(i, "jitter"));
  requireWithin(frame.preExposure, kMinPreExposure, kMaxPreExposure, framePath(i, "preExposure"));
  if (frame.preExposure != 1.0 && !manifest.conventions.color.preExposed)
    throw Error(say<"\"%1\" is %2, but \"%3\" is off">(
        framePath(i, "preExposure"), decimalText(frame.preExposure), "conventions.color.preExposed"));
  if (frame.seconds) requireWithin(*frame.seconds, -kMaxSeconds, kMaxSeconds, framePath(i, "seconds"));
}

/// What is stated of some frames is stated of all.
void requireSame(bool isThere, bool isThereAtFirst, std::size_t i, std::string_view key) {
  if (isThere == isThereAtFirst) return;
  throw Error(say<"\"%1\" is missing, but other frames have it">(framePath(isThere ? 0 : i, key)));
}

void requireOrder(const Frames& frames, std::size_t i) {
  requireSame(frames[i].seconds.has_value(), frames[0].seconds.has_value(), i, "seconds");
  if (i == 0) return;
  if (frames[i].number <= frames[i - 1].number)
    throw Error(say<"\"%1\" is %2 after %3: numbers of frames rise">(framePath(i, "number"), frames[i].number,
                                                                     frames[i - 1].number));
  if (frames[i].seconds && *frames[i].seconds <= *frames[i - 1].seconds)
    throw Error(say<"\"%1\" does not rise">(framePath(i, "seconds")));
}

void requireColor(const Manifest& manifest) {
  for (std::size_t i = 0; i < manifest.frames.size(); ++i)
    if (!manifest.plane(manifest.frames[i], PlaneKind::Color))
      throw Error(say<"the key \"%1\" is missing">(
          manifest.frames[i].planes.empty() ? "planes.color" : framePath(i, "planes.color")));
  const auto shared = manifest.planes.find(PlaneKind::Color);
  const auto usesShared = [](const CapturedFrame& frame) { return !frame.planes.contains(PlaneKind::Color); };
  if (shared != manifest.planes.end() && shared->second.file.find('{') == std::string::npos &&
      std::ranges::count_if(manifest.frames, usesShared) > 1)
    throw Error(say<"\"%1\" is one file for several frames: write {frame} where their number stands">(
        "planes.color.file"));
}

void requireFrames(const Manifest& manifest) {
  const Frames& frames = manifest.frames;
  if (frames.empty()) throw Error(say<"\"%1\" is empty">("frames"));
  if (frames.size() > static_cast<std::size_t>(kMaxCapturedFrames))
    throw Error(
        say<"\"%1\" has %2 entries, more than the %3 allowed">("frames", frames.size(), kMaxCapturedFrames));
  for (std::size_t i = 0; i < frames.size(); ++i) {
    requireNumbers(frames[i], manifest, i);
    requireMatrices(frames[i], i);
    requireOrder(frames, i);
    if (!frames[i].planes.empty()) requirePlanes(frames[i].planes, manifest, framePath(i, "planes"));
  }
  requireColor(manifest);
}

/// Also numbers that were never text: an assignment of its own text is refused where it could not be read.
void requireConventions(const Conventions& stated) {
  Conventions read = stated;
  for (const Convention& row : conventions()) row.assign(read, row.text(stated));
  if (const std::string wrong = contradiction(stated); !wrong.empty()) throw Error(wrong);
}

void requireTexts(const Manifest& manifest) {
  requireText(manifest.name, "name");
  requireText(manifest.engine, "engine");
  for (const auto& [id, name] : manifest.objects) {
    const std::string path = "objects." + std::to_string(id);
    if (id == 0) throw Error(say<"\"%1\" names nothing: ids begin with 1">(path));
    requireText(name, path);
  }
  if (manifest.notes.size() > kMaxNotes)
    throw Error(
        say<"\"%1\" has %2 entries, more than the %3 allowed">("notes", manifest.notes.size(), kMaxNotes));
  for (std::size_t i = 0; i < manifest.notes.size(); ++i)
    requireText(manifest.notes[i], "notes[" + std::to_string(i) + "]");
}

} // namespace

void requireConsistent(const Manifest& manifest) {
  requireTexts(manifest);
  if (!manifest.like.empty()) startingPoint(manifest.like);
  requireConventions(manifest.conventions);
  requireSide(manifest.sizePx, "size");
  if (manifest.outputPx != glm::ivec2(0)) requireSide(manifest.outputPx, "outputSize");
  requireWithin(manifest.framesPerSecond, 1e-3, 1e5, "framesPerSecond");
  requirePlanes(manifest.planes, manifest, "planes");
  requireFrames(manifest);
}

void checkManifest(const Manifest& manifest, const std::string& where) {
  try {
    requireConsistent(manifest);
  } catch (const Error& error) {
    throw Error(where + ": " + error.what());
  }
}

} // namespace taa::capture
