#include "core/io/FrameFile.h"

#include "core/base/Files.h"
#include "core/base/Say.h"
#include "core/base/Text.h"
#include "core/settings/Parameters.h"
#include "core/taa/ChannelNames.h"

#include <OpenImageIO/imageio.h>
#include <glm/gtc/type_ptr.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cassert>
#include <memory>

namespace taa {

namespace {

constexpr int kFormatVersion = 1;

// EXR's matrices multiply row vectors and lie row after row: the same 16 floats as GLSL's columns.
void addMatrix(OIIO::ImageSpec& spec, const std::string& name, const glm::mat4& matrix) {
  spec.attribute("taa:" + name, OIIO::TypeMatrix44, glm::value_ptr(matrix));
}

void addLane(OIIO::ImageSpec& spec, const FrameLane& lane) {
  spec.attribute("taa:lane", lane.name);
  spec.attribute("taa:settings", toJson(lane.settings).dump());
  spec.attribute("taa:frame", lane.info.frame);
  spec.attribute("taa:time", static_cast<float>(lane.info.time));
  spec.attribute("taa:jitterIndex", lane.info.jitterIndex);
  spec.attribute("taa:jitterPx", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, OIIO::TypeDesc::VEC2),
                 glm::value_ptr(lane.info.jitterPx));
  spec.attribute("taa:startsHistory", lane.info.startsHistory ? 1 : 0);
  addMatrix(spec, "clipFromWorld", lane.block.clipFromWorld);
  addMatrix(spec, "jitteredClipFromWorld", lane.block.jitteredClipFromWorld);
  addMatrix(spec, "viewFromWorld", lane.block.viewFromWorld);
  addMatrix(spec, "previousClipFromWorld", lane.block.previousClipFromWorld);
  addMatrix(spec, "previousViewFromWorld", lane.block.previousViewFromWorld);
}

void addDifference(OIIO::ImageSpec& spec, const FrameFile& frame, const FrameDifference& difference) {
  spec.attribute("taa:comparedWith", difference.with);
  spec.attribute("taa:otherRow", std::string(intermediate(difference.row).name));
  if (difference.frame) spec.attribute("taa:otherFrame", *difference.frame);
  const FrameLane& other = frame.lanes.at(static_cast<std::size_t>(difference.lane));
  spec.attribute("taa:otherSettings", toJson(other.settings).dump());
}

OIIO::ImageSpec specOf(const FrameFile& frame, const FramePart& part, const glm::ivec2& sizePx) {
  const Intermediate& row = intermediate(part.id);
  const FrameLane& lane = frame.lanes.at(static_cast<std::size_t>(part.lane));
  OIIO::ImageSpec spec(sizePx.x, sizePx.y, row.channels, OIIO::TypeFloat);
  spec.channelnames = channelNames(row, lane.settings.space);
  spec.attribute("oiio:subimagename", partName(lane, part));
  // Lossless; higher levels take longer and save nothing on the noise in the last bits of floats.
  spec.attribute("compression", "zip:1");
  spec.attribute("taa:format", kFormatVersion);
  spec.attribute("taa:source", frame.source);
  spec.attribute("taa:camera", frame.camera);
  spec.attribute("taa:driver", frame.driver);
  if (isOfReference(part.id) && !isOfEngine(part.id))
    spec.attribute("taa:referenceSamples", lane.referenceSamples);
  spec.attribute("taa:label", std::string(row.label));
  spec.attribute("taa:unit", std::string(row.unit));
  spec.attribute("taa:description", std::string(row.description));
  addLane(spec, lane);
  if (part.difference) addDifference(spec, frame, *part.difference);
  return spec;
}

void require(bool done, const OIIO::ImageOutput& output, const std::filesystem::path& path) {
  if (!done) throw Error(say<"cannot write %1: %2">(path.string(), output.geterror()));
}

struct OpenPart {
  std::unique_ptr<OIIO::ImageInput> input;
  int index = 0;
  OIIO::ImageSpec spec;
};

std::unique_ptr<OIIO::ImageInput> openFile(const std::filesystem::path& path) {
  std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path.string());
  if (!input) throw Error(say<"cannot open %1: %2">(path.string(), OIIO::geterror()));
  return input;
}

std::vector<std::string> namesIn(OIIO::ImageInput& input) {
  std::vector<std::string> names;
  for (int index = 0;; ++index) {
    const OIIO::ImageSpec spec = input.spec_dimensions(index);
    if (spec.undefined()) break;
    names.push_back(input.spec(index).get_string_attribute("oiio:subimagename"));
  }
  // Asking for the part after the last one leaves a message behind.
  (void)input.geterror();
  return names;
}

OpenPart openPart(const std::filesystem::path& path, const std::string& part) {
  OpenPart open{openFile(path), 0, {}};
  const std::vector<std::string> names = namesIn(*open.input);
  const auto found = std::ranges::find(names, part);
  if (found == names.end())
    throw Error(say<"%1 has no part \"%2\"; it has %3">(path.string(), part, joined(names)));
  open.index = static_cast<int>(found - names.begin());
  open.spec = open.input->spec(open.index);
  return open;
}

} // namespace

std::string partName(const FrameLane& lane, IntermediateId id) {
  const std::string name(intermediate(id).name);
  return lane.name.empty() ? name : lane.name + "." + name;
}

std::string partName(const FrameLane& lane, const FramePart& part) {
  return partName(lane, part.id) + (part.difference ? ".difference" : "");
}

namespace {

using ImageOf = std::function<const Image&(const FramePart&)>;

void writeParts(const std::filesystem::path& path, const FrameFile& frame, const glm::ivec2& sizePx,
                const ImageOf& imageOf) {
  assert(!frame.parts.empty());
  std::vector<OIIO::ImageSpec> specs;
  for (const FramePart& part : frame.parts) specs.push_back(specOf(frame, part, sizePx));
  writeAtomically(path, [&](const std::filesystem::path& temporary) {
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create("openexr");
    if (!output) throw Error(say<"cannot write %1: OpenImageIO was built without OpenEXR">(path.string()));
    require(output->open(temporary.string(), static_cast<int>(specs.size()), specs.data()), *output, path);
    for (std::size_t index = 0; index < specs.size(); ++index) {
      if (index > 0)
        require(output->open(temporary.string(), specs[index], OIIO::ImageOutput::AppendSubimage), *output,
                path);
      const Image& image = imageOf(frame.parts[index]);
      assert(image.width == sizePx.x && image.height == sizePx.y && image.channels == specs[index].nchannels);
      require(output->write_image(OIIO::TypeFloat, image.pixels.data()), *output, path);
    }
    require(output->close(), *output, path);
  });
}

} // namespace

void writeFrameFile(const std::filesystem::path& path, const FrameFile& frame) {
  const Image& first = frame.parts.front().image;
  writeParts(path, frame, {first.width, first.height},
             [](const FramePart& part) -> const Image& { return part.image; });
}

void writeFrameFile(const std::filesystem::path& path, const FrameFile& frame, const glm::ivec2& sizePx,
                    const std::function<Image(const FramePart&)>& values) {
  Image held;
  writeParts(path, frame, sizePx, [&](const FramePart& part) -> const Image& {
    held = Image(); // before the next one is made
    return held = values(part);
  });
}

std::vector<std::string> partNames(const std::filesystem::path& path) {
  return namesIn(*openFile(path));
}

Image readPart(const std::filesystem::path& path, const std::string& part,
               const std::vector<std::string>& channels) {
  const OpenPart open = openPart(path, part);
  const int inFile = open.spec.nchannels;
  std::vector<float> all(static_cast<std::size_t>(open.spec.width) * open.spec.height * inFile);
  if (!open.input->read_image(open.index, 0, 0, inFile, OIIO::TypeFloat, all.data()))
    throw Error(say<"cannot read part \"%1\" of %2: %3">(part, path.string(), open.input->geterror()));
  Image image(open.spec.width, open.spec.height, static_cast<int>(channels.size()));
  for (std::size_t channel = 0; channel < channels.size(); ++channel) {
    const int from = open.spec.channelindex(channels[channel]);
    if (from < 0)
      throw Error(say<"part \"%1\" of %2 has no channel \"%3\"; it has %4">(
          part, path.string(), channels[channel], joined(open.spec.channelnames)));
    for (std::size_t pixel = 0; pixel < all.size() / inFile; ++pixel)
      image.pixels[pixel * channels.size() + channel] = all[pixel * inFile + from];
  }
  return image;
}

std::string readPartAttribute(const std::filesystem::path& path, const std::string& part,
                              const std::string& name) {
  const OpenPart open = openPart(path, part);
  const OIIO::ParamValue* value = open.spec.find_attribute(name);
  return value ? value->get_string(0) : "";
}

} // namespace taa
