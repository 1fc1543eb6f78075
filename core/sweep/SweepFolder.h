// Where the results of a sweep lie: a file for each point, whole or not there, under the digest of what it
// was made from.
#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <string>

namespace taa {

/// What a point was made from, and the name of its file.
struct PointKey {
  explicit PointKey(nlohmann::ordered_json pointInputs);

  nlohmann::ordered_json inputs;
  std::string name; ///< digest of `inputs`
};

class SweepFolder {
 public:
  /// Makes the folder where it is missing. Throws Error.
  explicit SweepFolder(std::filesystem::path folder);

  const std::filesystem::path& path() const { return folder_; }
  /// The file of a point; see keep().
  std::filesystem::path pointFile(const PointKey& key) const;

  /// Whether it is there: read, and made from the same.
  bool holds(const PointKey& key) const { return result(key).has_value(); }
  /// What was kept; nothing where there is no such file, it is no JSON, or it was made from something else.
  std::optional<nlohmann::ordered_json> result(const PointKey& key) const;
  /// Writes the point's file: "format", "inputs", and the fields of `result`. Throws Error.
  void keep(const PointKey& key, const nlohmann::ordered_json& result) const;

 private:
  std::filesystem::path folder_;
};

} // namespace taa
