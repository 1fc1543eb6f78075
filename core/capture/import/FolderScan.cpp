#include "core/capture/import/FolderScan.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/capture/format/Manifest.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

namespace taa::capture {

namespace fs = std::filesystem;

namespace {

constexpr int kMaxFolders = 3; ///< in each other
constexpr int kMaxFiles = 200000;
constexpr std::size_t kMaxSequences = 256; ///< that are opened
constexpr std::size_t kMaxFailures = 8;

bool isDigit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

std::string extensionOf(const fs::path& path) {
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

bool isPicture(const std::string& extension) {
  static const std::set<std::string> kPictureExtensions = {".exr", ".png", ".hdr", ".tif", ".tiff", ".dds"};
  return kPictureExtensions.contains(extension);
}

/// Names that capture.json could state; see PlaneSource::file.
bool isStatable(const std::string& path) {
  return path.find_first_of("{}\\") == std::string::npos &&
         std::ranges::none_of(path, [](unsigned char c) { return std::iscntrl(c) != 0; });
}

struct Numbered {
  std::string before, after; ///< of the digits
  std::size_t digits = 0;    ///< 0: there are none
  int number = 0;
  bool isPadded = false; ///< begins with a 0 that is not all of it
};

/// Digits within a path; of more than 9 in a row the last ones.
struct DigitRun {
  std::size_t first = 0, count = 0;
};

/// Those of the file's name, else of the last folder's that has any; from the left.
std::vector<DigitRun> runsIn(const std::string& path) {
  constexpr std::size_t kMaxDigits = 9;
  std::vector<DigitRun> runs;
  for (std::size_t end = path.rfind('.'); end != std::string::npos && end > 0 && runs.empty();) {
    const std::size_t slash = path.rfind('/', end - 1);
    const std::size_t begin = slash == std::string::npos ? 0 : slash + 1;
    for (std::size_t last = end; last > begin; --last) {
      if (!isDigit(path[last - 1])) continue;
      std::size_t first = last;
      while (first > begin && isDigit(path[first - 1])) --first;
      const std::size_t count = std::min(last - first, kMaxDigits);
      runs.insert(runs.begin(), {last - count, count});
      last = first + 1;
    }
    end = slash == std::string::npos ? 0 : slash;
  }
  return runs;
}

/// Names that are the same but for their digits, and the digits of each.
struct AlikeNames {
  std::vector<std::string> paths;
  std::vector<std::vector<DigitRun>> runs;

  std::string digits(std::size_t path, std::size_t run) const {
    return paths[path].substr(runs[path][run].first, runs[path][run].count);
  }
  /// The run that counts frames: the one of the most different numbers, the last of those; "0001_v2" and
  /// "0002_v2" differ in the first. Expects that there is one.
  std::size_t counting() const {
    std::size_t best = 0, most = 0;
    for (std::size_t run = 0; run < runs.front().size(); ++run) {
      std::set<std::string> numbers;
      for (std::size_t path = 0; path < paths.size(); ++path) numbers.insert(digits(path, run));
      if (numbers.size() < most) continue;
      most = numbers.size();
      best = run;
    }
    return best;
  }
};

Numbered numberedBy(const std::string& path, const DigitRun& run) {
  const std::string digits = path.substr(run.first, run.count);
  return {path.substr(0, run.first), path.substr(run.first + run.count), run.count, std::stoi(digits),
          run.count > 1 && digits[0] == '0'};
}

std::vector<Numbered> numberedFiles(const std::vector<std::string>& paths) {
  std::vector<Numbered> files;
  std::map<std::string, AlikeNames> alike;
  for (const std::string& path : paths) {
    std::vector<DigitRun> runs = runsIn(path);
    if (runs.empty()) {
      files.push_back({path, "", 0, 0, false});
      continue;
    }
    std::string name = path;
    for (auto run = runs.rbegin(); run != runs.rend(); ++run) name.replace(run->first, run->count, "{}");
    alike[name].paths.push_back(path);
    alike[name].runs.push_back(std::move(runs));
  }
  for (const auto& [name, names] : alike) {
    const std::size_t run = names.counting();
    for (std::size_t i = 0; i < names.paths.size(); ++i)
      files.push_back(numberedBy(names.paths[i], names.runs[i][run]));
  }
  return files;
}

/// Files that differ only in their number.
struct NumberedFiles {
  std::vector<Numbered> files;
};

std::string patternOf(const NumberedFiles& group) {
  const Numbered& first = group.files.front();
  if (first.digits == 0) return first.before;
  std::size_t fewest = first.digits, most = first.digits;
  bool isPadded = false;
  for (const Numbered& file : group.files) {
    fewest = std::min(fewest, file.digits);
    most = std::max(most, file.digits);
    isPadded = isPadded || file.isPadded;
  }
  const bool hasWidth = isPadded || (fewest == most && fewest > 1);
  return first.before + (hasWidth ? "{frame:" + std::to_string(fewest) + "}" : "{frame}") + first.after;
}

std::string folderOfPattern(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? "" : path.substr(0, slash);
}

/// Paths below `folder`, with / between folders.
std::vector<std::string> filesBelow(const fs::path& folder, FolderScan& scan, const Progress& progress) {
  std::vector<std::string> pictures;
  std::error_code failure;
  fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, failure);
  int seen = 0;
  for (; !failure && at != fs::recursive_directory_iterator(); at.increment(failure)) {
    if (++seen > kMaxFiles)
      throw Error(
          say<"%1 holds more than %2 files; give the folder of one capture">(folder.string(), kMaxFiles));
    if (seen % 1024 == 0) report(progress, say<"Looking through the folder">(), seen, kMaxFiles);
    std::error_code ignored;
    if (at->is_directory(ignored) && at.depth() >= kMaxFolders) at.disable_recursion_pending();
    if (!at->is_regular_file(ignored)) continue;
    const std::string path = at->path().lexically_relative(folder).generic_string();
    const std::string extension = extensionOf(at->path());
    if (!isStatable(path)) continue;
    if (isPicture(extension)) pictures.push_back(path);
    if (extension == ".json" && at->path().filename() != kManifestName) scan.sideFiles.push_back(path);
  }
  if (failure) throw Error(say<"cannot read the folder %1: %2">(folder.string(), failure.message()));
  return pictures;
}

std::vector<PictureSequence> sequencesOf(const std::vector<std::string>& pictures) {
  std::map<std::pair<std::string, std::string>, NumberedFiles> groups;
  for (Numbered& file : numberedFiles(pictures)) {
    const auto key = std::pair(file.before, file.after);
    groups[key].files.push_back(std::move(file));
  }
  std::vector<PictureSequence> sequences;
  for (const auto& [key, group] : groups) {
    PictureSequence sequence;
    sequence.pattern = patternOf(group);
    sequence.folder = folderOfPattern(sequence.pattern);
    // "7" and "0007" beside each other are two files of one number; the pattern means one of them.
    for (const Numbered& file : group.files) sequence.numbers.push_back(file.number);
    std::ranges::sort(sequence.numbers);
    const auto twice = std::ranges::unique(sequence.numbers);
    sequence.numbers.erase(twice.begin(), twice.end());
    sequences.push_back(std::move(sequence));
  }
  return sequences;
}

} // namespace

FolderScan scanFolder(const fs::path& folder, const Progress& progress) {
  FolderScan scan;
  std::vector<PictureSequence> sequences = sequencesOf(filesBelow(folder, scan, progress));
  std::ranges::sort(scan.sideFiles, {},
                    [](const std::string& path) { return std::pair(std::ranges::count(path, '/'), path); });
  if (sequences.size() > kMaxSequences)
    throw Error(say<"%1 holds %2 sequences of pictures, more than %3; give the folder of one capture">(
        folder.string(), sequences.size(), kMaxSequences));
  int done = 0;
  for (PictureSequence& sequence : sequences) {
    report(progress, say<"Opening pictures">(), done++, static_cast<int>(sequences.size()));
    PlaneSource source;
    source.file = sequence.pattern;
    const std::string file = planeFile(source, sequence.numbers.front());
    try {
      const std::vector<PicturePart> parts = picturePartsOf(folder, file);
      sequence.layers = layersOf(parts);
      sequence.planes = namedPlanes(parts, sequence.pattern);
      scan.sequences.push_back(std::move(sequence));
    } catch (const Error& error) {
      if (scan.failures.size() < kMaxFailures) scan.failures.emplace_back(error.what());
    }
  }
  return scan;
}

} // namespace taa::capture
