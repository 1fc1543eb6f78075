// Manifest to capture.json: what parseManifest reads back as the same, a line for each frame.
#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/base/json/LimitedJson.h"
#include "core/capture/format/ConventionText.h"
#include "core/capture/format/ManifestChecks.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace taa::capture {

using nlohmann::ordered_json;

namespace {

ordered_json conventionJson(const Convention& row, const Conventions& conventions) {
  const std::string text = row.text(conventions);
  switch (row.kind) {
  case ConventionKind::Toggle:
    return text == "on";
  case ConventionKind::Integer:
  case ConventionKind::Number:
  case ConventionKind::OptionalNumber:
    if (text != "none") return ordered_json::parse(text);
    break;
  case ConventionKind::Choice:
  case ConventionKind::OptionalChoice:
    break;
  }
  return text;
}

/// What differs from the starting point and says something; the rest comes back by itself.
ordered_json conventionsJson(const Manifest& manifest) {
  const Conventions base =
      normalized(manifest.like.empty() ? Conventions{} : startingPoint(manifest.like).conventions);
  ordered_json groups = ordered_json::object();
  for (const Convention& row : conventions()) {
    const bool isSaid = row.text(manifest.conventions) != row.text(base);
    if (!isSaid || !isRelevant(row, manifest.conventions)) continue;
    const std::size_t dot = row.path.find('.');
    ordered_json& group =
        dot == std::string_view::npos ? groups : groups[std::string(row.path.substr(0, dot))];
    const std::string_view key = dot == std::string_view::npos ? row.path : row.path.substr(dot + 1);
    group[std::string(key)] = conventionJson(row, manifest.conventions);
  }
  return groups;
}

ordered_json planeJson(const PlaneSource& source) {
  ordered_json object = {{"file", source.file}};
  if (!source.part.empty()) object["part"] = source.part;
  if (!source.channels.empty()) object["channels"] = source.channels;
  if (source.raw) object["raw"] = rawFormatName(*source.raw);
  if (source.sizePx.x > 0) object["size"] = {source.sizePx.x, source.sizePx.y};
  if (source.rowPitch > 0) object["rowPitch"] = source.rowPitch;
  if (source.atPx) object["at"] = {source.atPx->x, source.atPx->y};
  if (source.rows) object["rows"] = valueText(convention("rows"), *source.rows);
  return object;
}

ordered_json planesJson(const std::map<PlaneKind, PlaneSource>& planes) {
  ordered_json object = ordered_json::object();
  for (const auto& [kind, source] : planes) object[std::string(planeName(kind))] = planeJson(source);
  return object;
}

ordered_json frameJson(const CapturedFrame& frame) {
  ordered_json object = {{"number", frame.number}, {"jitter", {frame.jitter.x, frame.jitter.y}}};
  if (frame.view) object["view"] = *frame.view;
  if (frame.projection) object["projection"] = *frame.projection;
  if (frame.previousView) object["previousView"] = *frame.previousView;
  if (frame.previousProjection) object["previousProjection"] = *frame.previousProjection;
  if (frame.preExposure != 1.0) object["preExposure"] = frame.preExposure;
  if (frame.cut) object["cut"] = true;
  if (frame.seconds) object["seconds"] = *frame.seconds;
  if (!frame.planes.empty()) object["planes"] = planesJson(frame.planes);
  return object;
}

/// All but the frames.
ordered_json headJson(const Manifest& manifest) {
  ordered_json object = {{"format", kManifestFormat}};
  if (!manifest.name.empty()) object["name"] = manifest.name;
  if (!manifest.engine.empty()) object["engine"] = manifest.engine;
  if (!manifest.like.empty()) object["like"] = manifest.like;
  object["conventions"] = conventionsJson(manifest);
  object["size"] = {manifest.sizePx.x, manifest.sizePx.y};
  if (manifest.outputPx.x > 0) object["outputSize"] = {manifest.outputPx.x, manifest.outputPx.y};
  object["framesPerSecond"] = manifest.framesPerSecond;
  for (const auto& [id, name] : manifest.objects) object["objects"][std::to_string(id)] = name;
  if (!manifest.notes.empty()) object["notes"] = manifest.notes;
  object["planes"] = planesJson(manifest.planes);
  return object;
}

std::string jsonText(const Manifest& manifest) {
  std::string text = headJson(manifest).dump(1);
  text.resize(text.size() - 2); // "\n}": the frames follow
  text += ",\n \"frames\": [";
  for (std::size_t i = 0; i < manifest.frames.size(); ++i)
    text += (i > 0 ? ",\n  " : "\n  ") + frameJson(manifest.frames[i]).dump();
  return text + "\n ]\n}\n";
}

} // namespace

std::string manifestText(const Manifest& manifest) {
  try {
    requireConsistent(manifest);
    std::string text = jsonText(manifest);
    if (text.size() > kMaxJsonBytes)
      throw Error(say<"it has %1 bytes, more than the %2 allowed">(text.size(), kMaxJsonBytes));
    return text;
  } catch (const Error& error) {
    throw Error(say<"cannot write the capture: %1">(error.what()));
  }
}

} // namespace taa::capture
