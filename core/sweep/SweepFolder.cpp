#include "core/sweep/SweepFolder.h"

#include "core/base/Error.h"
#include "core/base/Files.h"
#include "core/base/Say.h"
#include "core/sweep/SweepPoints.h"

#include <cstdint>
#include <system_error>
#include <utility>

namespace taa {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

namespace {

constexpr int kPointFormat = 1;
constexpr std::uintmax_t kMaxPointBytes = std::uintmax_t(64) << 20;
constexpr const char* kPointsFolder = "points";

} // namespace

PointKey::PointKey(ordered_json pointInputs)
    : inputs(std::move(pointInputs)), name(digestOf(inputs.dump())) {}

SweepFolder::SweepFolder(fs::path folder) : folder_(std::move(folder)) {
  const fs::path points = folder_ / kPointsFolder;
  std::error_code error;
  fs::create_directories(points, error);
  if (error) throw Error(say<"cannot make the folder %1: %2">(points.string(), error.message()));
}

fs::path SweepFolder::pointFile(const PointKey& key) const {
  return folder_ / kPointsFolder / (key.name + ".json");
}

std::optional<ordered_json> SweepFolder::result(const PointKey& key) const {
  const fs::path file = pointFile(key);
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return {};
  // Left half done by a full disk, or written by another version: it is made again.
  ordered_json json = ordered_json::parse(readFile(file, kMaxPointBytes), nullptr, false);
  if (!json.is_object() || json.value("format", ordered_json()) != kPointFormat) return {};
  if (json.value("inputs", ordered_json()) != key.inputs) return {};
  return json;
}

void SweepFolder::keep(const PointKey& key, const ordered_json& result) const {
  ordered_json json = {{"format", kPointFormat}, {"inputs", key.inputs}};
  json.update(result);
  writeFile(pointFile(key), json.dump(1) + "\n");
}

} // namespace taa
