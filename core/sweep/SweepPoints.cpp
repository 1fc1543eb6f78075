#include "core/sweep/SweepPoints.h"

#include "core/base/EmbeddedFiles.h"
#include "core/base/Files.h"
#include "core/capture/format/Manifest.h"
#include "core/scene/builtin/SceneSource.h"
#include "core/settings/Parameters.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cassert>
#include <cstdio>
#include <filesystem>
#include <ranges>
#include <system_error>

namespace taa {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

namespace {

/// Empty where there is nothing to read: opening it will say why.
std::string digestOfSource(const SweepSource& source) {
  if (isBuiltinScene(source.name)) return {};
  std::error_code error;
  const bool isFolder = fs::is_directory(source.path, error);
  const fs::path file = isFolder ? source.path / capture::kManifestName : source.path;
  return fs::is_regular_file(file, error) ? digestOf(readFile(file)) : std::string();
}

} // namespace

std::string digestOf(std::string_view bytes) {
  std::uint64_t digest = 0xcbf29ce484222325;
  for (const char byte : bytes) {
    digest ^= static_cast<unsigned char>(byte);
    digest *= 0x100000001b3;
  }
  std::array<char, 17> text{};
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(digest));
  return text.data();
}

SweepPoint sweepPoint(const SweepSpec& spec, std::size_t index) {
  assert(index < spec.pointCount());
  SweepPoint point;
  point.index = index;
  const auto take = [&index](std::size_t count) {
    const std::size_t place = index % count;
    index /= count;
    return place;
  };
  point.values.resize(spec.ranges.size());
  for (std::size_t range = spec.ranges.size(); range-- > 0;)
    point.values[range] = take(spec.ranges[range].values.size());
  point.settings = take(spec.settings.size());
  point.camera = take(spec.cameras.size());
  point.source = index;
  return point;
}

Settings settingsOfPoint(const SweepSpec& spec, const SweepPoint& point) {
  Settings settings = spec.settings[point.settings].settings;
  for (std::size_t range = 0; range < spec.ranges.size(); ++range)
    spec.ranges[range].row->set(settings, spec.ranges[range].values[point.values[range]]);
  return settings;
}

PointRange pointsOfShard(const SweepShard& shard, std::size_t pointCount) {
  assert(shard.index >= 1 && shard.index <= shard.count);
  return {pointCount * (shard.index - 1) / shard.count, pointCount * shard.index / shard.count};
}

SweepGround::SweepGround(const SweepSpec& spec) {
  std::string all;
  for (const std::string& path : embeddedPaths("shaders/")) all += path + "\n" + embeddedText(path) + "\n";
  shaders_ = digestOf(all);
  for (const SweepSource& source : spec.sources) sources_.push_back(digestOfSource(source));
}

ordered_json SweepGround::inputs(const SweepSpec& spec, const SweepPoint& point) const {
  ordered_json json;
  json["program"] = TAA_VERSION;
  json["shaders"] = shaders_;
  json["source"] = spec.sources[point.source].name;
  json["sourceDigest"] = sources_[point.source];
  json["camera"] = spec.cameras[point.camera];
  json["frames"] = {spec.first, spec.last};
  json["size"] = spec.size ? ordered_json{spec.size->x, spec.size->y} : ordered_json();
  for (const Metric metric : spec.metrics) json["metrics"].push_back(metricInfo(metric).id);
  json["referenceSamples"] = spec.referenceSamples;
  json["flickerFrames"] = spec.flickerFrames;
  json["settings"] = differences(settingsOfPoint(spec, point), Settings{});
  return json;
}

} // namespace taa
