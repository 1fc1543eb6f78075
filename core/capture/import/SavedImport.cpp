#include "core/capture/import/SavedImport.h"

#include "core/base/Error.h"
#include "core/base/ExistingFiles.h"
#include "core/base/Files.h"
#include "core/base/Say.h"

#include <algorithm>
#include <map>
#include <set>
#include <system_error>
#include <utility>

namespace taa::capture {

namespace fs = std::filesystem;

namespace {

/// Every source of the manifest, its frames' own included.
template <typename Change>
void forSources(Manifest& manifest, const Change& change) {
  for (auto& [kind, source] : manifest.planes) change(source);
  for (CapturedFrame& frame : manifest.frames)
    for (auto& [kind, source] : frame.planes) change(source);
}

/// Files of all planes, below the folder.
std::set<std::string> filesOf(const Manifest& manifest) {
  std::set<std::string> files;
  for (const CapturedFrame& frame : manifest.frames) {
    std::map<PlaneKind, PlaneSource> planes = frame.planes;
    planes.insert(manifest.planes.begin(), manifest.planes.end());
    for (const auto& [kind, source] : planes) files.insert(planeFile(source, frame.number));
  }
  return files;
}

/// From `out` to `folder` where that is `out` or below it; else empty.
fs::path wayBelow(const fs::path& folder, const fs::path& out) {
  std::error_code failure;
  const fs::path way =
      fs::weakly_canonical(folder, failure).lexically_relative(fs::weakly_canonical(out, failure));
  return failure || way.empty() || *way.begin() == ".." ? fs::path() : way;
}

/// Returns whether it is a link.
bool linkOrCopy(const fs::path& from, const fs::path& to) {
  std::error_code failure;
  // Renaming a link over another one of the same file would leave both.
  if (fs::equivalent(from, to, failure)) return true;
  fs::create_directories(to.parent_path(), failure);
  bool isLinked = true;
  writeAtomically(to, [&](const fs::path& temporary) {
    std::error_code linking, copying;
    fs::remove(temporary, linking);
    fs::create_hard_link(from, temporary, linking);
    isLinked = !linking;
    if (isLinked) return;
    fs::copy_file(from, temporary, fs::copy_options::overwrite_existing, copying);
    if (copying) throw Error(say<"cannot copy %1 to %2: %3">(from.string(), to.string(), copying.message()));
  });
  return isLinked;
}

} // namespace

std::vector<fs::path> importedFiles(const fs::path& folder, const Manifest& manifest, const fs::path& out) {
  std::vector<fs::path> targets = {out / kManifestName};
  if (!wayBelow(folder, out).empty()) return targets;
  for (const std::string& file : filesOf(manifest)) targets.push_back(out / file);
  return targets;
}

SavedImport saveImport(const fs::path& folder, const Manifest& manifest, const fs::path& out, bool replace,
                       const Progress& progress) {
  Manifest written = manifest;
  std::set<std::string> files;
  const fs::path way = wayBelow(folder, out);
  if (way.empty())
    files = filesOf(manifest);
  else if (way != ".")
    forSources(written, [&](PlaneSource& source) { source.file = (way / source.file).generic_string(); });
  // A side file may state what color was not multiplied with.
  if (!written.conventions.color.preExposed)
    for (CapturedFrame& frame : written.frames) frame.preExposure = 1.0;
  const std::string text = manifestText(written);
  SavedImport saved{out / kManifestName};
  if (!replace) refuseToReplace(importedFiles(folder, manifest, out));
  std::error_code failure;
  fs::create_directories(out, failure);
  if (failure) throw Error(say<"cannot make the folder %1: %2">(out.string(), failure.message()));
  int done = 0;
  for (const std::string& file : files) {
    report(progress, say<"Copying planes">(), done++, static_cast<int>(files.size()));
    const bool isLinked = linkOrCopy(requireRegularBelow(folder, file), out / file);
    ++(isLinked ? saved.linked : saved.copied);
  }
  // Last: a folder with capture.json is whole.
  writeFile(saved.manifest, text);
  return saved;
}

} // namespace taa::capture
