#include "core/capture/import/PlaneNames.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <span>
#include <utility>

namespace taa::capture {

namespace {

using Words = std::vector<std::string>;

struct NameOfKind {
  std::string_view word;
  PlaneKind kind;
};

/// Words in lower case; several written as one.
constexpr NameOfKind kNames[] = {
    {"color", PlaneKind::Color},
    {"colour", PlaneKind::Color},
    {"combined", PlaneKind::Color},
    {"beauty", PlaneKind::Color},
    {"rgb", PlaneKind::Color},
    {"rgba", PlaneKind::Color},
    {"hdr", PlaneKind::Color},
    {"scenecolor", PlaneKind::Color},
    {"lit", PlaneKind::Color},
    {"motion", PlaneKind::Motion},
    {"motionvector", PlaneKind::Motion},
    {"motionvectors", PlaneKind::Motion},
    {"mv", PlaneKind::Motion},
    {"mvs", PlaneKind::Motion},
    {"mvec", PlaneKind::Motion},
    {"mvecs", PlaneKind::Motion},
    {"vector", PlaneKind::Motion},
    {"vectors", PlaneKind::Motion},
    {"velocity", PlaneKind::Motion},
    {"flow", PlaneKind::Motion},
    {"rsmb", PlaneKind::Motion},
    {"depth", PlaneKind::Depth},
    {"z", PlaneKind::Depth},
    {"zbuffer", PlaneKind::Depth},
    {"viewz", PlaneKind::Depth},
    {"depthbuffer", PlaneKind::Depth},
    {"scenedepth", PlaneKind::Depth},
    {"id", PlaneKind::ObjectId},
    {"ids", PlaneKind::ObjectId},
    {"indexob", PlaneKind::ObjectId},
    {"objectid", PlaneKind::ObjectId},
    {"objectids", PlaneKind::ObjectId},
    {"instanceid", PlaneKind::ObjectId},
    {"entityid", PlaneKind::ObjectId},
    {"normal", PlaneKind::Normal},
    {"normals", PlaneKind::Normal},
    {"worldnormal", PlaneKind::Normal},
    {"previousdepth", PlaneKind::PreviousDepth},
    {"prevdepth", PlaneKind::PreviousDepth},
    {"mask", PlaneKind::Mask},
    {"reactive", PlaneKind::Mask},
    {"responsive", PlaneKind::Mask},
    {"overlay", PlaneKind::Overlay},
    {"ui", PlaneKind::Overlay},
    {"hud", PlaneKind::Overlay},
    {"fog", PlaneKind::Fog},
    {"output", PlaneKind::Output},
    {"resolved", PlaneKind::Output},
    {"taa", PlaneKind::Output},
    {"tsr", PlaneKind::Output},
    {"upscaled", PlaneKind::Output},
    {"result", PlaneKind::Output},
    {"reference", PlaneKind::Reference},
    {"ref", PlaneKind::Reference},
    {"groundtruth", PlaneKind::Reference},
    {"supersampled", PlaneKind::Reference},
};

char lower(char c) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

std::string lowered(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), lower);
  return out;
}

bool isLetter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

bool isUpper(char c) {
  return std::isupper(static_cast<unsigned char>(c)) != 0;
}

/// "ViewLayer.IndexOB" is view, layer, index, ob.
Words wordsOf(std::string_view name) {
  Words words;
  bool wasLetter = false, wasUpper = false;
  for (const char c : name) {
    const bool isNew = isLetter(c) && (!wasLetter || (isUpper(c) && !wasUpper));
    if (isNew) words.emplace_back();
    if (isLetter(c)) words.back() += lower(c);
    wasLetter = isLetter(c);
    wasUpper = isUpper(c);
  }
  return words;
}

std::optional<PlaneKind> kindOfWord(const std::string& word) {
  const auto found = std::ranges::find(kNames, word, &NameOfKind::word);
  if (found == std::end(kNames)) return {};
  return found->kind;
}

/// In lower case, one letter; empty where it is none.
std::string componentOf(std::string_view text) {
  static const std::map<std::string, std::string, std::less<>> kWritten = {
      {"red", "r"}, {"green", "g"}, {"blue", "b"}, {"alpha", "a"}};
  const std::string low = lowered(text);
  if (const auto found = kWritten.find(low); found != kWritten.end()) return found->second;
  return low.size() == 1 && std::string_view("rgbaxyzwuv").find(low[0]) != std::string_view::npos ? low : "";
}

/// A channel, and the name of its layer.
std::pair<LayerChannel, std::string> placeOf(const PictureChannel& channel) {
  const std::string& name = channel.name;
  const std::size_t dot = name.rfind('.');
  const std::string last = componentOf(dot == std::string::npos ? name : name.substr(dot + 1));
  if (!last.empty()) return {{name, last, channel.type}, dot == std::string::npos ? "" : name.substr(0, dot)};
  // "motion_x", "motionX"
  const std::string component = componentOf(name.substr(name.size() - 1));
  std::string layer = name.substr(0, name.size() - 1);
  while (!layer.empty() && !isLetter(layer.back())) layer.pop_back();
  if (!component.empty() && kindOfName(layer) && !kindOfName(name))
    return {{name, component, channel.type}, layer};
  return {{name, "", channel.type}, name};
}

/// The channels called so, in this order; empty where one is missing.
std::vector<std::string> pick(const PictureLayer& layer, std::string_view components) {
  std::vector<std::string> names;
  for (const char component : components) {
    const auto found = std::ranges::find(layer.channels, std::string(1, component), &LayerChannel::component);
    if (found == layer.channels.end()) return {};
    names.push_back(found->name);
  }
  return names;
}

/// Words of the file's name count before those of its folders; its extension is none.
std::optional<PlaneKind> kindOfFile(const std::string& file) {
  std::string rest = file.substr(0, file.rfind('.'));
  while (!rest.empty()) {
    const std::size_t slash = rest.rfind('/');
    const std::string name = slash == std::string::npos ? rest : rest.substr(slash + 1);
    if (const std::optional<PlaneKind> kind = kindOfName(name)) return kind;
    rest = slash == std::string::npos ? "" : rest.substr(0, slash);
  }
  return {};
}

/// What channels are without a name of their layer or file: one called Z is depth, the rest is color.
std::optional<PlaneKind> kindOfChannels(const PictureLayer& layer) {
  if (layer.channels.size() == 1 && layer.channels[0].component == "z") return PlaneKind::Depth;
  if (!pick(layer, "rgb").empty()) return PlaneKind::Color;
  if (layer.channels.size() == 2 && !pick(layer, "xy").empty()) return PlaneKind::Motion;
  return {};
}

/// A layer without a name that holds both: "R", "G", "B" and "Z" of older files.
std::vector<PictureLayer> splitDepth(std::vector<PictureLayer> layers) {
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (!layers[i].name.empty() || pick(layers[i], "rgbz").empty()) continue;
    PictureLayer depth{layers[i].part, "", layers[i].sizePx, {}};
    const auto isDepth = [](const LayerChannel& channel) { return channel.component == "z"; };
    std::ranges::copy_if(layers[i].channels, std::back_inserter(depth.channels), isDepth);
    std::erase_if(layers[i].channels, isDepth);
    layers.push_back(std::move(depth));
  }
  return layers;
}

} // namespace

std::optional<PlaneKind> kindOfName(std::string_view name) {
  constexpr std::size_t kMaxLetters = 512;
  const Words words = wordsOf(name.substr(0, kMaxLetters));
  std::optional<PlaneKind> found;
  // The last word that is no color says most: "color_depth", "output_color". Several words are one name.
  for (std::size_t first = 0; first < words.size(); ++first) {
    std::string joined;
    for (std::size_t last = first; last < std::min(words.size(), first + 3); ++last) {
      joined += words[last];
      const std::optional<PlaneKind> kind = kindOfWord(joined);
      if (!kind || (found && *kind == PlaneKind::Color)) continue;
      // "previous depth" also ends with depth.
      if (found == PlaneKind::PreviousDepth && *kind == PlaneKind::Depth) continue;
      found = kind;
    }
  }
  return found;
}

std::vector<PictureLayer> layersOf(const std::vector<PicturePart>& parts) {
  std::vector<PictureLayer> layers;
  for (const PicturePart& part : parts)
    for (const PictureChannel& stored : part.channels) {
      if (stored.name.empty()) continue;
      auto [channel, name] = placeOf(stored);
      auto found = layers.begin();
      while (found != layers.end() && (found->part != part.name || found->name != name)) ++found;
      if (found == layers.end()) found = layers.insert(layers.end(), {part.name, name, part.sizePx, {}});
      found->channels.push_back(std::move(channel));
    }
  return splitDepth(std::move(layers));
}

std::vector<std::string> channelsFor(const PictureLayer& layer, PlaneKind kind) {
  static constexpr std::string_view kFour[] = {"rgba", "xyzw", "rgb", "xyz"};
  static constexpr std::string_view kTwo[] = {"xy", "rg", "uv"};
  static constexpr std::string_view kOne[] = {"z", "r", "x", "v", "y"};
  static constexpr std::string_view kThree[] = {"xyz", "rgb"};
  std::span<const std::string_view> sets = kFour;
  // A mask of more channels than two is a gray picture.
  const bool isGray = kind == PlaneKind::Mask && layer.channels.size() != 2;
  if (kind == PlaneKind::Motion || kind == PlaneKind::Mask) sets = kTwo;
  if (kind == PlaneKind::Normal) sets = kThree;
  if (channelsOf(kind) == 1 || isGray) sets = kOne;
  const auto least = static_cast<std::size_t>(minChannelsOf(kind));
  for (const std::string_view set : sets) {
    const std::vector<std::string> names = pick(layer, set);
    if (names.size() >= least) return names;
  }
  // As they come.
  if (layer.channels.size() < least) return {};
  std::vector<std::string> names;
  for (std::size_t i = 0; i < least; ++i) names.push_back(layer.channels[i].name);
  return names;
}

NamedPlanes namedPlanes(const std::vector<PicturePart>& parts, const std::string& file) {
  NamedPlanes out;
  const std::vector<PictureLayer> layers = layersOf(parts);
  for (const PictureLayer& layer : layers) {
    const std::string name = layer.part.empty() || !layer.name.empty() ? layer.name : layer.part;
    std::optional<PlaneKind> kind = kindOfName(name);
    if (!kind && !layer.part.empty()) kind = kindOfName(layer.part);
    bool isNamed = kind.has_value();
    if (!kind && name.empty()) {
      const std::optional<PlaneKind> own = kindOfChannels(layer);
      // A file with other planes beside is not named after one of them.
      if (own == PlaneKind::Depth)
        kind = own;
      else if (layers.size() == 1)
        kind = kindOfFile(file);
      isNamed = kind.has_value();
      if (!kind) kind = own;
    }
    std::vector<std::string> channels;
    if (kind) channels = channelsFor(layer, *kind);
    if (channels.empty() || std::ranges::find(out.planes, *kind, &NamedPlane::kind) != out.planes.end()) {
      if (!name.empty()) out.ignored.push_back(name);
      continue;
    }
    out.planes.push_back(
        {*kind, layer.part, std::move(channels), layer.channels.front().type, layer.sizePx, isNamed});
  }
  return out;
}

} // namespace taa::capture
