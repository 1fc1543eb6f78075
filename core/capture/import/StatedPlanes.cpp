#include "core/capture/import/StatedPlanes.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/capture/format/Manifest.h"
#include "core/capture/planes/PictureParts.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

namespace taa::capture {

namespace {

struct StatedPlane {
  PlaneKind kind = PlaneKind::Color;
  std::string files;
  std::vector<std::string> channels; ///< empty: as they come
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

/// The colon within "{frame:4}" is none that channels follow.
StatedPlane statedPlane(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals + 1 == text.size())
    throw Error(say<"\"%1\" states no plane: KIND=FILES:CHANNELS, as motion=velocity_{frame:4}.exr:R,G">(
        shownText(text)));
  StatedPlane out{kindCalled(text.substr(0, equals)), text.substr(equals + 1), {}};
  const std::size_t colon = out.files.rfind(':');
  if (colon == std::string::npos || out.files.find('}', colon) != std::string::npos) return out;
  out.channels = partsOf(out.files.substr(colon + 1));
  out.files.resize(colon);
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

} // namespace

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
    const StatedPlane plane = statedPlane(text);
    PictureSequence& sequence = sequenceOf(plane.files, scan);
    PlaneSource source;
    source.file = sequence.pattern;
    const std::string file = planeFile(source, sequence.numbers.front());
    NamedPlane named = namedPlane(plane, picturePartsOf(folder, file), file);
    for (PictureSequence& other : scan.sequences)
      std::erase_if(other.planes.planes, [&](const NamedPlane& one) {
        return one.kind == plane.kind || (&other == &sequence && !one.isNamed);
      });
    sequence.planes.planes.push_back(std::move(named));
  }
}

} // namespace taa::capture
