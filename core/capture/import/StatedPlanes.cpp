#include "core/capture/import/StatedPlanes.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/capture/planes/PictureParts.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

namespace taa::capture {

namespace {

struct StatedPlane {
  PlaneKind kind = PlaneKind::Color;
  std::string files, part;           ///< part: empty: whichever holds the channels
  std::vector<std::string> channels; ///< empty: as they come
};

/// A plane that is stated, in the files that hold it; null: there is none.
struct TakenPlane {
  PictureSequence* sequence = nullptr;
  NamedPlane plane;
};

PlaneKind kindCalled(const std::string& name) {
  if (const std::optional<PlaneKind> kind = planeOf(name)) return *kind;
  std::string known;
  for (std::size_t kind = 0; kind < kPlaneKinds; ++kind)
    known += (known.empty() ? "" : ", ") + std::string(planeName(static_cast<PlaneKind>(kind)));
  throw Error(say<"there is no plane \"%1\"; there are %2">(shownText(name), known));
}

std::vector<std::string> partsOf(const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    if (end > begin) parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

/// What follows the last colon, which is taken off; nothing where there is none. That of "{frame:4}" is none.
std::optional<std::string> takeEnd(std::string& files) {
  const std::size_t colon = files.rfind(':');
  if (colon == std::string::npos || files.find('}', colon) != std::string::npos) return {};
  std::string end = files.substr(colon + 1);
  files.resize(colon);
  return end;
}

StatedPlane statedPlane(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals + 1 == text.size())
    throw Error(say<"\"%1\" states no plane: KIND=FILES:CHANNELS, as motion=velocity_{frame:4}.exr:R,G">(
        shownText(text)));
  StatedPlane out{kindCalled(text.substr(0, equals)), text.substr(equals + 1), {}, {}};
  if (const std::optional<std::string> channels = takeEnd(out.files)) out.channels = partsOf(*channels);
  if (const std::optional<std::string> part = takeEnd(out.files)) out.part = *part;
  return out;
}

PictureSequence& sequenceOf(const std::string& files, FolderScan& scan) {
  const auto found = std::ranges::find(scan.sequences, files, &PictureSequence::pattern);
  if (found != scan.sequences.end()) return *found;
  constexpr std::size_t kMostNamed = 12;
  std::string known;
  for (std::size_t i = 0; i < std::min(scan.sequences.size(), kMostNamed); ++i)
    known += (i == 0 ? "" : ", ") + shownText(scan.sequences[i].pattern);
  throw Error(say<"no pictures here are called \"%1\"; there are %2">(shownText(files), known));
}

/// In a part of a file that has all of these channels.
NamedPlane namedPlane(const StatedPlane& stated, const std::vector<PicturePart>& parts,
                      const std::string& file) {
  std::string known;
  for (const PicturePart& part : parts) {
    if (!stated.part.empty() && part.name != stated.part) continue;
    const auto typeOf = [&](const std::string& name) {
      const auto found = std::ranges::find(part.channels, name, &PictureChannel::name);
      return found == part.channels.end() ? std::nullopt : std::optional(found->type);
    };
    for (const PictureChannel& channel : part.channels) known += (known.empty() ? "" : " ") + channel.name;
    std::vector<std::string> channels = stated.channels;
    if (channels.empty())
      for (const PictureChannel& channel : part.channels)
        if (channels.size() < static_cast<std::size_t>(channelsOf(stated.kind)))
          channels.push_back(channel.name);
    const bool hasAll =
        std::ranges::all_of(channels, [&](const std::string& name) { return typeOf(name).has_value(); });
    if (!hasAll || channels.size() < static_cast<std::size_t>(minChannelsOf(stated.kind))) continue;
    return {stated.kind, part.name, channels, *typeOf(channels.front()), part.sizePx, true};
  }
  throw Error(say<"%1 has no channels for %2 like that; it has %3">(shownText(file), planeName(stated.kind),
                                                                    shownText(known)));
}

TakenPlane takenPlane(const StatedPlane& stated, const std::filesystem::path& folder, FolderScan& scan) {
  TakenPlane taken;
  taken.plane.kind = stated.kind;
  if (stated.files == kNoPlane) return taken;
  taken.sequence = &sequenceOf(stated.files, scan);
  PlaneSource source;
  source.file = taken.sequence->pattern;
  const std::string file = planeFile(source, taken.sequence->numbers.front());
  taken.plane = namedPlane(stated, picturePartsOf(folder, file), file);
  return taken;
}

void requireEachFrame(const PictureSequence& sequence, const Manifest& manifest) {
  for (const CapturedFrame& frame : manifest.frames)
    if (!std::ranges::binary_search(sequence.numbers, frame.number))
      throw Error(say<"%1 has no picture of frame %2">(shownText(sequence.pattern), frame.number));
}

} // namespace

std::string statedText(const PlaneSource& source) {
  std::string text = source.file;
  if (!source.part.empty()) text += ":" + source.part;
  for (std::size_t i = 0; i < source.channels.size(); ++i) text += (i == 0 ? ":" : ",") + source.channels[i];
  return text;
}

std::vector<std::string> takeStatedPlanes(std::vector<std::string>& assignments) {
  std::vector<std::string> planes;
  for (const std::string& assignment : assignments)
    if (assignment.starts_with(kPlanePrefix)) planes.push_back(assignment.substr(kPlanePrefix.size()));
  std::erase_if(assignments,
                [](const std::string& assignment) { return assignment.starts_with(kPlanePrefix); });
  return planes;
}

void statePlanes(const std::vector<std::string>& stated, const std::filesystem::path& folder,
                 FolderScan& scan) {
  for (const std::string& text : stated) {
    TakenPlane taken = takenPlane(statedPlane(text), folder, scan);
    for (PictureSequence& sequence : scan.sequences)
      std::erase_if(sequence.planes.planes, [&](const NamedPlane& one) {
        return one.kind == taken.plane.kind || (&sequence == taken.sequence && !one.isNamed);
      });
    if (taken.sequence) taken.sequence->planes.planes.push_back(std::move(taken.plane));
  }
}

void statePlanes(const std::vector<std::string>& stated, const std::filesystem::path& folder, FolderScan scan,
                 Manifest& manifest) {
  for (const std::string& text : stated) {
    const TakenPlane taken = takenPlane(statedPlane(text), folder, scan);
    const PlaneKind kind = taken.plane.kind;
    manifest.planes.erase(kind);
    for (CapturedFrame& frame : manifest.frames) frame.planes.erase(kind);
    if (!taken.sequence) continue;
    requireEachFrame(*taken.sequence, manifest);
    PlaneSource& source = manifest.planes[kind];
    source.file = taken.sequence->pattern;
    source.part = taken.plane.part;
    source.channels = taken.plane.channels;
    if (kind == PlaneKind::Color) manifest.sizePx = taken.plane.sizePx;
    if (kind == PlaneKind::Output) manifest.outputPx = taken.plane.sizePx;
  }
}

void requireStated(const std::vector<std::string>& stated, const Manifest& manifest) {
  for (const std::string& text : stated) {
    const StatedPlane plane = statedPlane(text);
    if (plane.files != kNoPlane && !manifest.planes.contains(plane.kind))
      throw Error(say<"%1 is not used as %2: it has not the frames of color, %3">(
          shownText(plane.files), planeName(plane.kind),
          shownText(manifest.planes.at(PlaneKind::Color).file)));
  }
}

} // namespace taa::capture
