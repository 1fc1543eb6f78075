// Writes files of one format until somebody ends it: version 0, version 1, version 0 … in the same places, as
// the programs write them. With a third argument that version once. tests/kill runs and ends it.
#include "core/base/Error.h"
#include "core/base/Files.h"
#include "core/capture/format/Manifest.h"
#include "core/capture/planes/Planes.h"
#include "core/inspect/Inspector.h"
#include "core/io/CameraTrackJson.h"
#include "core/io/FrameFile.h"
#include "core/io/PictureFile.h"
#include "core/io/SessionFile.h"
#include "core/report/SequenceExport.h"
#include "core/report/doctor/DoctorPage.h"
#include "core/settings/Presets.h"
#include "core/sweep/SweepTable.h"
#include "core/taa/GlslExport.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace fs = std::filesystem;
using namespace taa;

namespace {

/// Values that do not pack, so that files are large enough for somebody to come in between.
Image noise(int width, int height, int channels, int version) {
  Image image(width, height, channels);
  std::uint32_t state = 0x9e3779b9u + static_cast<std::uint32_t>(version);
  for (float& value : image.pixels) {
    state = state * 1664525u + 1013904223u;
    value = static_cast<float>(state >> 8) / static_cast<float>(1 << 24);
  }
  return image;
}

CameraTrack trackOf(int version) {
  CameraTrack track{"flight", 0, std::vector<CameraPose>(5000)};
  for (std::size_t i = 0; i < track.poses.size(); ++i)
    track.poses[i].yaw = static_cast<float>(version) + static_cast<float>(i) / 7.0f;
  return track;
}

Preset presetOf(int version) {
  Preset made = preset(version == 0 ? "balanced" : "fsr2");
  made.id = "own";
  made.description = std::string(200'000, version == 0 ? 'a' : 'b');
  return made;
}

/// Made once, so that most of the time goes by within the writing.
template <typename Make>
void writeText(const fs::path& path, int version, Make make) {
  static const std::array<std::string, 2> kTexts{make(0), make(1)};
  writeFile(path, kTexts.at(static_cast<std::size_t>(version)));
}

void writeSessionOf(const fs::path& folder, int version) {
  SessionFile session;
  session.source = "builtin:fan";
  session.frame = version;
  session.track = trackOf(version);
  writeSession(folder / "a.taa.json", session);
}

void writePresetOf(const fs::path& folder, int version) {
  writeText(folder / "own.json", version, [](int made) { return presetToText(presetOf(made)); });
}

void writeCameraPath(const fs::path& folder, int version) {
  writeText(folder / "flight.json", version,
            [](int made) { return cameraTrackJson(trackOf(made)).dump(1) + '\n'; });
}

void writeGlsl(const fs::path& folder, int version) {
  writeText(folder / "resolve.frag", version,
            [](int made) { return exportedGlsl(presetOf(made).settings, "own"); });
}

void writePicture(const fs::path& folder, int version) {
  const Image image = noise(320, 180, 4, version);
  std::vector<std::uint8_t> rgba;
  for (const float value : image.pixels) rgba.push_back(static_cast<std::uint8_t>(value * 255.0f));
  writePng(folder / "view.png", image.width, image.height, rgba);
}

void writeValues(const fs::path& folder, int version) {
  FrameFile frame{"builtin:fan", "orbit", "none", {FrameLane{}}, {}};
  frame.parts.push_back({.id = IntermediateId::resolved, .image = noise(320, 180, 3, version)});
  frame.parts.push_back({.id = IntermediateId::alpha, .image = noise(320, 180, 1, version)});
  writeFrameFile(folder / "0007.exr", frame);
}

void writePlane(const fs::path& folder, int version) {
  capture::PlaneData plane;
  plane.image = noise(640, 360, 4, version);
  plane.width = plane.image.width;
  plane.height = plane.image.height;
  capture::writeRawPlane(folder / "color.0007.raw", plane, capture::RawFormat::RGBA16F);
}

std::string manifestOf(int version) {
  capture::Manifest manifest;
  manifest.name = version == 0 ? "one" : "another";
  manifest.sizePx = {64, 36};
  manifest.planes[capture::PlaneKind::Color].file = "color.{frame}.png";
  manifest.frames.resize(5000);
  for (std::size_t i = 0; i < manifest.frames.size(); ++i) manifest.frames[i].number = static_cast<int>(i);
  return capture::manifestText(manifest);
}

void writeManifest(const fs::path& folder, int version) {
  writeText(folder / capture::kManifestName, version, [](int made) { return manifestOf(made); });
}

std::string pageOf(int version) {
  doctor::Diagnosis diagnosis;
  diagnosis.frames = 32;
  diagnosis.notes.assign(2000, version == 0 ? "Nothing moves." : "Something moves.");
  return doctorHtml(diagnosis, "builtin:fan");
}

void writePage(const fs::path& folder, int version) {
  writeText(folder / "doctor.html", version, [](int made) { return pageOf(made); });
}

/// The file of a point, and both tables.
void writeSweep(const fs::path& folder, int version) {
  std::string values;
  for (int i = 1; i <= 500; ++i) values += (i > 1 ? ", " : "") + std::to_string(i / 1000.0);
  static const SweepSpec kSpec = sweepSpecFromText(
      R"({"format": 1, "frames": [0, 1], "sources": ["builtin:fan"], "metrics": ["psnr", "flicker"],
          "parameters": {"weight.alpha": [)" +
          values + "]}}",
      "it", "");
  const SweepFolder into(folder);
  into.keep(PointKey(SweepGround(kSpec).inputs(kSpec, sweepPoint(kSpec, 0))),
            {{"mean", {{"psnr", 30 + version}, {"flicker", 0.25}}}});
  writeSweepTables(kSpec, into);
}

/// Frames of a small shot, one version brighter than the other.
void writeSequence(SequenceKind kind, const fs::path& target, int version) {
  static const std::unique_ptr<Inspector> kInspector = [] {
    auto inspector = std::make_unique<Inspector>();
    inspector->shot().setSize(48, 27);
    inspector->shot().setLanes({Settings{}});
    inspector->shot().open("builtin:fan");
    return inspector;
  }();
  SequenceRequest request;
  request.kind = kind;
  request.target = target;
  request.last = 2;
  request.picture.id = version == 0 ? IntermediateId::resolved : IntermediateId::alpha;
  request.picture.style = defaultStyle(intermediate(request.picture.id));
  request.picture.width = 48;
  request.picture.height = 27;
  request.ids = {request.picture.id};
  if (version == 1) request.capture.conventions = {"rows=bottomFirst"};
  exportSequence(*kInspector, request, {});
}

struct Format {
  std::string_view name;
  std::function<void(const fs::path& folder, int version)> write;
};

const std::vector<Format>& formats() {
  static const auto sequence = [](SequenceKind kind, const char* name) {
    return [=](const fs::path& folder, int version) { writeSequence(kind, folder / name, version); };
  };
  static const std::vector<Format> kFormats{
      {"session", writeSessionOf},
      {"preset", writePresetOf},
      {"camera-path", writeCameraPath},
      {"glsl", writeGlsl},
      {"png", writePicture},
      {"exr", writeValues},
      {"raw", writePlane},
      {"manifest", writeManifest},
      {"html", writePage},
      {"sweep", writeSweep},
      {"png-sequence", sequence(SequenceKind::Png, "shot.png")},
      {"exr-sequence", sequence(SequenceKind::Exr, "shot.exr")},
      {"gif", sequence(SequenceKind::Gif, "shot.gif")},
      {"capture", sequence(SequenceKind::Capture, capture::kManifestName)},
  };
  return kFormats;
}

/// Never ends by itself. A point on standard output for each two versions that are written.
[[noreturn]] void writeForEver(const Format& format, const fs::path& folder) {
  for (;;) {
    for (int version = 0; version < 2; ++version) format.write(folder, version);
    std::fputs(".", stdout);
    std::fflush(stdout);
  }
}

} // namespace

int main(int count, char** words) {
  if (count < 3) {
    for (const Format& format : formats()) std::printf("%s\n", std::string(format.name).c_str());
    return 0;
  }
  try {
    for (const Format& format : formats()) {
      if (format.name != words[1]) continue;
      if (count == 3) writeForEver(format, words[2]);
      format.write(words[2], std::atoi(words[3]));
      return 0;
    }
    throw Error(std::string("there is no format ") + words[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
