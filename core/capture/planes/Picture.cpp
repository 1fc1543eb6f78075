// Pictures that hold planes, through OpenImageIO: which part and channels of the file, read as they are
// stored.
#include "core/base/Files.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/capture/planes/PictureParts.h"
#include "core/capture/planes/PlaneFiles.h"
#include "core/capture/planes/PngParts.h"
#include "core/capture/planes/StoredRows.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace taa::capture {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMaxPictureBytes = std::uintmax_t(4) << 30;
constexpr int kMaxParts = 1024;
constexpr int kMaxChannels = 4096;
constexpr int kRowsAtOnce = 256; ///< of the largest blocks that EXR compresses together
constexpr std::size_t kBlockOfRows = std::size_t(64) << 20;    ///< bytes of rows that are read at once
constexpr std::int64_t kMaxTilePixels = std::int64_t(1) << 24; ///< 4096 × 4096: tiles are read whole

/// A kind of file and the bytes that it begins with: no plugin guesses at files that are none of these.
struct FileKind {
  const char* plugin;
  std::string_view magic;
};

constexpr FileKind kFileKinds[] = {
    {"openexr", std::string_view("\x76\x2f\x31\x01", 4)},
    {"png", std::string_view("\x89PNG", 4)},
    {"hdr", "#?RADIANCE"},
    {"hdr", "#?RGBE"},
    {"tiff", std::string_view("II*\0", 4)},
    {"tiff", std::string_view("MM\0*", 4)},
    {"tiff", std::string_view("II+\0", 4)},
    {"tiff", std::string_view("MM\0+", 4)},
    {"dds", "DDS "},
};

const FileKind& kindOf(const UntrustedFile& file, const std::string& name) {
  std::string start(static_cast<std::size_t>(std::min<std::uintmax_t>(file.size(), 16)), '\0');
  file.read(0, std::as_writable_bytes(std::span(start)));
  for (const FileKind& kind : kFileKinds)
    if (start.starts_with(kind.magic)) return kind;
  throw Error(
      say<"%1 is no EXR, PNG, HDR, TIFF or DDS file; a raw plane has to be stated as one (\"raw\")">(name));
}

/// Without the folders of a file in quotes: they may be long, and the reason stands behind them.
std::string withoutQuotedFolders(std::string said) {
  const std::size_t open = said.find("\"/");
  const std::size_t close = open == std::string::npos ? open : said.find('"', open + 1);
  if (close != std::string::npos) said.erase(open + 1, said.rfind('/', close) - open);
  return said;
}

/// Without what a library calls itself and what it was about: the file is named already.
std::string_view withoutLibrary(std::string_view said) {
  constexpr std::string_view kOfFile = "image file \"", kReason = "\". ";
  const std::size_t file = said.find(kOfFile);
  const std::size_t reason = file == said.npos ? file : said.find(kReason, file + kOfFile.size());
  if (reason != said.npos) said.remove_prefix(reason + kReason.size());
  for (const std::string_view name : {"OpenEXR exception: ", "Failed OpenEXR read: "})
    if (said.starts_with(name)) said.remove_prefix(name.size());
  return said;
}

/// What OpenImageIO says in its last error, on one line.
std::string failureOf(const OIIO::ImageInput& input) {
  const std::string said = input.geterror();
  if (said.find("ubsampl") != std::string::npos)
    return say<
        "it stores luminance and chroma (Y, RY, BY) or other channels of reduced size; save it as RGB">();
  if (said.empty()) return say<"it is damaged">();
  return shownText(withoutLibrary(withoutQuotedFolders(said.substr(0, said.find('\n')))));
}

std::unique_ptr<OIIO::ImageInput> openPicture(const UntrustedFile& file, const std::string& name) {
  const FileKind& kind = kindOf(file, name);
  if (std::string_view(kind.plugin) == "png") checkPngParts(file, name);
  std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create(kind.plugin);
  if (!input) throw Error(say<"cannot open %1: OpenImageIO was built without %2">(name, kind.plugin));
  OIIO::ImageSpec asStored, ignored;
  asStored.attribute("oiio:UnassociatedAlpha", 1);
  if (!input->open(file.path().string(), ignored, asStored))
    throw Error(say<"cannot open %1: %2">(name, failureOf(*input)));
  return input;
}

/// A part of the file, the planes in it and where in it the channels of each stand.
struct Selection {
  int part = 0;
  OIIO::ImageSpec spec;
  std::vector<PlaneRequest> requests;
  std::vector<std::vector<int>> channels;
};

int channelIndex(const OIIO::ImageSpec& spec, const std::string& channel) {
  const auto found = std::ranges::find(spec.channelnames, channel);
  return found == spec.channelnames.end() ? -1 : static_cast<int>(found - spec.channelnames.begin());
}

/// The first channel that the part lacks; empty where it has all.
std::string missingIn(const OIIO::ImageSpec& spec, const PlaneRequest& request) {
  for (const std::string& channel : request.source->channels)
    if (channelIndex(spec, channel) < 0) return channel;
  return "";
}

std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t kMaxNames = 16;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMaxNames); ++i)
    text += (i == 0 ? "" : ", ") + shownText(names[i]);
  return names.size() > kMaxNames ? text + " …" : text;
}

std::vector<int> channelsFor(const OIIO::ImageSpec& spec, const PlaneRequest& request) {
  std::vector<int> channels;
  for (const std::string& channel : request.source->channels) channels.push_back(channelIndex(spec, channel));
  // A fourth of normals is their class only where it is named: engines keep other things there.
  const int most = request.kind == PlaneKind::Normal ? 3 : channelsOf(request.kind);
  if (channels.empty())
    for (int i = 0; i < std::min(spec.nchannels, most); ++i) channels.push_back(i);
  if (static_cast<int>(channels.size()) > channelsOf(request.kind))
    channels.resize(static_cast<std::size_t>(channelsOf(request.kind)));
  if (static_cast<int>(channels.size()) < minChannelsOf(request.kind))
    throw Error(say<"%1 gives %2 channels (of %3); %4 are needed">(
        request.file, channels.size(), listed(spec.channelnames), minChannelsOf(request.kind)));
  return channels;
}

struct PartFound {
  int index = 0;
  OIIO::ImageSpec spec;
};

/// The part called so, or the first that holds all channels.
PartFound findPart(OIIO::ImageInput& input, const PlaneRequest& request) {
  const std::string& part = request.source->part;
  std::vector<std::string> parts, channels;
  std::string missing;
  for (int index = 0; index < kMaxParts && input.seek_subimage(index, 0); ++index) {
    OIIO::ImageSpec spec = input.spec();
    if (spec.nchannels > kMaxChannels) throw Error(say<"%1 has %2 channels">(request.file, spec.nchannels));
    const std::string called(spec.get_string_attribute("oiio:subimagename"));
    parts.push_back(called);
    if (!part.empty() && part != called) continue;
    const std::string lacks = missingIn(spec, request);
    if (lacks.empty()) return {index, std::move(spec)};
    if (missing.empty()) missing = lacks;
    channels.insert(channels.end(), spec.channelnames.begin(), spec.channelnames.end());
  }
  if (parts.empty()) throw Error(say<"cannot read %1: %2">(request.file, failureOf(input)));
  // Asking for the part after the last one leaves a message behind.
  (void)input.geterror();
  if (missing.empty() && std::ranges::all_of(parts, &std::string::empty))
    throw Error(say<"%1 has no part \"%2\": its parts have no names">(request.file, shownText(part)));
  if (missing.empty())
    throw Error(say<"%1 has no part \"%2\"; it has %3">(request.file, shownText(part), listed(parts)));
  throw Error(say<"%1 has no channel \"%2\"; it has %3">(request.file, shownText(missing), listed(channels)));
}

void refuseChroma(const OIIO::ImageSpec& spec, const std::string& name) {
  for (const std::string& channel : spec.channelnames)
    if (channel == "RY" || channel == "BY" || channel.ends_with(".RY") || channel.ends_with(".BY"))
      throw Error(say<"%1 stores luminance and chroma (Y, RY, BY); save it as RGB">(name));
}

/// What is read of a part: the display window.
void requireReadable(const Selection& selection, const std::string& name) {
  const OIIO::ImageSpec& spec = selection.spec;
  if (spec.deep) throw Error(say<"%1 is a deep picture, with several samples a pixel; flatten it">(name));
  refuseChroma(spec, name);
  if (spec.depth > 1 || spec.full_depth > 1) throw Error(say<"%1 is a volume, not a picture">(name));
  const auto within = [](int value) { return value >= 1 && value <= kMaxCaptureSide; };
  if (!within(spec.width) || !within(spec.height) || !within(spec.full_width) || !within(spec.full_height) ||
      static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height) > kMaxPlanePixels)
    throw Error(say<"%1 has %2 × %3 px, too many">(name, spec.width, spec.height));
  using Wide = std::int64_t;
  if (Wide(spec.tile_width) * spec.tile_height > kMaxTilePixels)
    throw Error(say<"%1 has tiles of %2 × %3 px, too many">(name, spec.tile_width, spec.tile_height));
  if (spec.x > spec.full_x || spec.y > spec.full_y ||
      Wide(spec.x) + spec.width < Wide(spec.full_x) + spec.full_width ||
      Wide(spec.y) + spec.height < Wide(spec.full_y) + spec.full_height)
    throw Error(
        say<"%1 is a part of a picture: its data window of %2 × %3 px does not cover its display window of "
            "%4 × %5 px; save all of it">(name, spec.width, spec.height, spec.full_width, spec.full_height));
}

/// Bytes of some rows as OpenImageIO gives them: channels first to end of a pixel, each in its own format.
class RowReader {
 public:
  RowReader(OIIO::ImageInput& input, const Selection& selection, const std::string& name)
      : input_(input), part_(selection.part), spec_(selection.spec), name_(name) {
    first_ = spec_.nchannels;
    for (const std::vector<int>& channels : selection.channels)
      for (const int channel : channels) {
        first_ = std::min(first_, channel);
        end_ = std::max(end_, channel + 1);
      }
    pixelBytes_ = spec_.pixel_bytes(first_, end_, true);
    // Channels between those that are wanted are read, too: of a part with thousands that is much.
    const int step = spec_.tile_width > 0 ? spec_.tile_height : 1;
    const std::size_t stepBytes =
        pixelBytes_ * static_cast<std::size_t>(spec_.width) * static_cast<std::size_t>(step);
    const auto most = static_cast<std::size_t>(std::max(1, kRowsAtOnce / step));
    rowsAtOnce_ = static_cast<int>(std::clamp<std::size_t>(kBlockOfRows / stepBytes, 1, most)) * step;
  }

  int rowsAtOnce() const { return rowsAtOnce_; }
  StoredChannel stored(int channel) const {
    const auto type = static_cast<OIIO::TypeDesc::BASETYPE>(spec_.channelformat(channel).basetype);
    switch (type) {
    case OIIO::TypeDesc::HALF:
    case OIIO::TypeDesc::FLOAT:
    case OIIO::TypeDesc::DOUBLE:
    case OIIO::TypeDesc::UINT8:
    case OIIO::TypeDesc::UINT16:
    case OIIO::TypeDesc::UINT32:
      return {spec_.pixel_bytes(first_, channel, true), type};
    default:
      throw Error(say<"channel \"%2\" of %1 holds %3 values, which no plane does">(
          name_, shownText(spec_.channelnames[static_cast<std::size_t>(channel)]),
          spec_.channelformat(channel).c_str()));
    }
  }
  std::size_t pixelBytes() const { return pixelBytes_; }

  /// Rows of the data window, from one that begins a row of tiles.
  const std::byte* read(int begin, int end) {
    bytes_.resize(pixelBytes_ * static_cast<std::size_t>(spec_.width) *
                  static_cast<std::size_t>(end - begin));
    const bool done = spec_.tile_width > 0
                          ? input_.read_tiles(part_, 0, spec_.x, spec_.x + spec_.width, begin, end, spec_.z,
                                              spec_.z + 1, first_, end_, OIIO::TypeUnknown, bytes_.data())
                          : input_.read_scanlines(part_, 0, begin, end, spec_.z, first_, end_,
                                                  OIIO::TypeUnknown, bytes_.data());
    if (!done) throw Error(say<"cannot read %1: %2">(name_, failureOf(input_)));
    return bytes_.data();
  }

 private:
  OIIO::ImageInput& input_;
  int part_;
  const OIIO::ImageSpec& spec_;
  const std::string& name_;
  int first_ = 0, end_ = 0, rowsAtOnce_ = 1;
  std::size_t pixelBytes_ = 0;
  std::vector<std::byte> bytes_;
};

/// Rows of the data window that are in the display window, too, become rows of the planes.
std::vector<PlaneData> readSelection(OIIO::ImageInput& input, const Selection& selection) {
  const OIIO::ImageSpec& spec = selection.spec;
  const std::vector<PlaneRequest>& requests = selection.requests;
  RowReader reader(input, selection, requests.front().file);
  std::vector<PlaneData> planes;
  std::vector<std::vector<StoredChannel>> stored(requests.size());
  for (std::size_t i = 0; i < requests.size(); ++i) {
    for (const int channel : selection.channels[i]) stored[i].push_back(reader.stored(channel));
    planes.push_back(makePlane(requests[i].kind, {spec.full_width, spec.full_height},
                               static_cast<int>(selection.channels[i].size())));
    planes.back().hasEightBits = stored[i].front().type == OIIO::TypeDesc::UINT8;
  }
  const std::size_t pixelBytes = reader.pixelBytes();
  const std::size_t rowBytes = pixelBytes * static_cast<std::size_t>(spec.width);
  const std::size_t left = pixelBytes * static_cast<std::size_t>(spec.full_x - spec.x);
  for (int begin = spec.y; begin < spec.y + spec.height; begin += reader.rowsAtOnce()) {
    const int end = std::min(begin + reader.rowsAtOnce(), spec.y + spec.height);
    if (end <= spec.full_y || begin >= spec.full_y + spec.full_height) continue;
    const std::byte* bytes = reader.read(begin, end);
    for (int y = std::max(begin, spec.full_y); y < std::min(end, spec.full_y + spec.full_height); ++y)
      for (std::size_t i = 0; i < requests.size(); ++i) {
        const int row = y - spec.full_y;
        unpackRow(planes[i], requests[i].bottomFirst ? spec.full_height - 1 - row : row,
                  bytes + rowBytes * static_cast<std::size_t>(y - begin) + left, pixelBytes, stored[i]);
      }
  }
  return planes;
}

/// The parts that hold `requests`, each once.
std::vector<Selection> select(OIIO::ImageInput& input, const Manifest& manifest,
                              const std::vector<PlaneRequest>& requests) {
  std::vector<Selection> selections;
  for (const PlaneRequest& request : requests) {
    PartFound part = findPart(input, request);
    auto found = std::ranges::find(selections, part.index, &Selection::part);
    if (found == selections.end()) {
      selections.push_back({part.index, std::move(part.spec), {}, {}});
      found = std::prev(selections.end());
      requireReadable(*found, request.file);
    }
    requireSize(manifest, request, {found->spec.full_width, found->spec.full_height});
    found->channels.push_back(channelsFor(found->spec, request));
    found->requests.push_back(request);
  }
  return selections;
}

StoredType storedTypeOf(OIIO::TypeDesc type) {
  if (type == OIIO::TypeDesc::HALF) return StoredType::Half;
  if (type == OIIO::TypeDesc::UINT8) return StoredType::Normalized8;
  if (type == OIIO::TypeDesc::UINT16) return StoredType::Normalized16;
  return type.is_floating_point() ? StoredType::Float : StoredType::Integer;
}

} // namespace

std::vector<PicturePart> picturePartsOf(const fs::path& folder, const std::string& name) {
  const UntrustedFile file = openUntrusted(folder, name, kMaxPictureBytes);
  const std::unique_ptr<OIIO::ImageInput> input = openPicture(file, name);
  std::vector<PicturePart> parts;
  for (int index = 0; index < kMaxParts && input->seek_subimage(index, 0); ++index) {
    const OIIO::ImageSpec spec = input->spec();
    if (spec.nchannels > kMaxChannels) throw Error(say<"%1 has %2 channels">(name, spec.nchannels));
    if (std::max(spec.full_width, spec.full_height) > kMaxCaptureSide)
      throw Error(say<"%1 is %2 × %3 pixels, more than the %4 a side allowed">(
          name, spec.full_width, spec.full_height, kMaxCaptureSide));
    PicturePart part{
        std::string(spec.get_string_attribute("oiio:subimagename")), {spec.full_width, spec.full_height}, {}};
    for (int i = 0; i < spec.nchannels; ++i)
      part.channels.push_back(
          {spec.channelnames[static_cast<std::size_t>(i)], storedTypeOf(spec.channelformat(i))});
    parts.push_back(std::move(part));
  }
  (void)input->geterror();
  return parts;
}

std::vector<PlaneData> readPicture(const fs::path& folder, const Manifest& manifest,
                                   const std::vector<PlaneRequest>& requests) {
  const std::string& name = requests.front().file;
  const UntrustedFile file = openUntrusted(folder, name, kMaxPictureBytes);
  const std::unique_ptr<OIIO::ImageInput> input = openPicture(file, name);
  std::vector<PlaneData> planes(requests.size());
  for (const Selection& selection : select(*input, manifest, requests)) {
    std::vector<PlaneData> read = readSelection(*input, selection);
    for (std::size_t i = 0; i < read.size(); ++i) {
      const auto at = std::ranges::find(requests, selection.requests[i].kind, &PlaneRequest::kind);
      planes[static_cast<std::size_t>(at - requests.begin())] = std::move(read[i]);
    }
  }
  return planes;
}

} // namespace taa::capture
