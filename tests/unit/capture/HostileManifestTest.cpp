// A capture.json of anybody's: each thing wrong with it gets one sentence that names it, soon.
#include "core/base/Error.h"
#include "core/capture/format/Manifest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace taa::capture {
namespace {

/// Until a refusal: one second on a free machine, with room for sanitized builds on busy ones.
constexpr std::chrono::seconds kBound{20};

/// What follows the file's name.
std::string refusalOf(std::string_view json) {
  const auto begin = std::chrono::steady_clock::now();
  std::string said = "it is taken";
  try {
    parseManifest(json, "it");
  } catch (const Error& error) {
    said = error.what();
  }
  EXPECT_LT(std::chrono::steady_clock::now() - begin, kBound);
  constexpr std::string_view kBegin = "cannot open the capture it: ";
  EXPECT_TRUE(said.starts_with(kBegin)) << said;
  EXPECT_LT(said.size(), 600u);
  EXPECT_EQ(said.find('\n'), std::string::npos);
  return said.substr(std::min(kBegin.size(), said.size()));
}

/// A file that would be taken, with `more` among its keys, `plane` among color's and `frames`.
std::string file(const std::string& more, const std::string& plane = "",
                 const std::string& frames = R"({"number": 0})") {
  return R"({"format": 1, "size": [480, 270], )" + more + R"("planes": {"color": {"file": "c.{frame}.exr")" +
         plane + R"(}}, "frames": [)" + frames + "]}";
}

std::string ofConventions(const std::string& conventions) {
  return refusalOf(file(R"("conventions": )" + conventions + ", "));
}
std::string ofPlane(const std::string& plane) {
  return refusalOf(file("", ", " + plane));
}
std::string ofFrames(const std::string& frames) {
  return refusalOf(file("", "", frames));
}

std::string repeated(std::string_view text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

std::string matrix(const std::string& first = "1") {
  return "[" + first + repeated(",0", 15) + "]";
}

} // namespace

TEST(HostileManifest, WithNothingWrongIsTaken) {
  EXPECT_NO_THROW(parseManifest(file(""), "it"));
}

TEST(HostileManifest, WhatMovesACursorIsTakenOutOfNames) {
  const Manifest read = parseManifest(
      file(R"("name": "a\nb", "engine": "\u001b[2J", "notes": ["x\ny"], "objects": {"1": "c\td"}, )"), "it");
  EXPECT_EQ(read.name, "a?b");
  EXPECT_EQ(read.engine, "?[2J");
  EXPECT_EQ(read.notes, std::vector<std::string>{"x y"});
  EXPECT_EQ(read.objects.at(1), "c?d");
}

TEST(HostileManifest, WhatIsNotJson) {
  EXPECT_EQ(refusalOf(""), "it is empty");
  EXPECT_EQ(refusalOf("{\n \"format\": 1,\n}"), "it is not JSON from line 3, column 1 on");
  EXPECT_EQ(refusalOf(R"({"format": NaN})"), "it is not JSON from line 1, column 12 on");
  EXPECT_EQ(refusalOf("{\"name\": \"\xff\"}"), "it is not JSON from line 1, column 11 on");
  EXPECT_EQ(refusalOf("[1, 2"), "it ends in line 1, column 6, before it is whole");
  EXPECT_EQ(refusalOf(file("") + "x"),
            "it is not JSON from line 1, column " + std::to_string(file("").size() + 1) + " on");
  EXPECT_EQ(refusalOf(R"({"a": 1e999})"), "a number in line 1, column 11 is too large");
  EXPECT_EQ(refusalOf("[]"), "what the file holds is not an object");
  EXPECT_EQ(refusalOf("null"), "what the file holds is not an object");
}

TEST(HostileManifest, WhatIsDeepOrLarge) {
  EXPECT_EQ(refusalOf(repeated("[", 3'000'000)), "it is nested deeper than 32 levels");
  EXPECT_EQ(refusalOf(repeated("{\"a\":", 600'000)), "it is nested deeper than 32 levels");
  EXPECT_EQ(refusalOf(std::string((std::size_t(64) << 20) + 1, ' ')),
            "it has 67108865 bytes, more than the 67108864 allowed");
  EXPECT_EQ(refusalOf("[" + repeated("0,", 1'000'000) + "0]"),
            "what the file holds has more than 1000000 entries");
  const std::string full = "[" + repeated("{},", 900'000) + "0],";
  EXPECT_EQ(refusalOf("[" + repeated(full, 5) + "0]"), "it would take more than 400 MiB of memory");
  EXPECT_EQ(refusalOf("\"" + std::string(3'000'000, 'x')),
            "it ends in line 1, column 3000002, before it is whole");
}

TEST(HostileManifest, KeysThatAreUnknownMissingOrTwice) {
  EXPECT_EQ(refusalOf(file(R"("naem": "", )")), "there is no key \"naem\"; near it is \"name\"");
  EXPECT_EQ(ofPlane(R"("chanels": [])"), "there is no key \"planes.color.chanels\"; near it is \"channels\"");
  EXPECT_EQ(ofFrames(R"({"number": 0}, {"number": 1, "jiter": [0, 0]})"),
            "there is no key \"frames[1].jiter\"; near it is \"jitter\"");
  EXPECT_EQ(refusalOf(file(R"("size": [1, 1], )")), "the key \"size\" comes twice");
  EXPECT_EQ(refusalOf(file("\"" + std::string(3'000'000, 'x') + "\": 1, ")),
            "there is no key \"" + std::string(100, 'x') + "…\"; near it is \"$schema\"");
  EXPECT_EQ(refusalOf(R"({"size": [1, 1], "frames": []})"), "the key \"format\" is missing");
  EXPECT_EQ(refusalOf(R"({"format": 1, "frames": []})"), "the key \"size\" is missing");
  EXPECT_EQ(refusalOf(R"({"format": 1, "size": [1, 1]})"), "the key \"frames\" is missing");
  EXPECT_EQ(refusalOf(R"({"format": 7, "source": "builtin:fan", "frame": 3})"),
            "it is a session, no capture: taa-inspector opens it, and taa-batch takes it with --session");
  EXPECT_EQ(refusalOf(R"({"format": 1, "size": [1, 1], "frames": [{"number": 0}]})"),
            "the key \"planes.color\" is missing");
  EXPECT_EQ(refusalOf(R"({"format": 1, "size": [1, 1], "planes": {"color": {}}, "frames": []})"),
            "the key \"planes.color.file\" is missing");
  EXPECT_EQ(ofFrames(R"({"cut": true})"), "the key \"frames[0].number\" is missing");
  EXPECT_EQ(refusalOf(R"({"format": 2, "size": 1})"), "its format is 2, this program reads 1");
  EXPECT_EQ(refusalOf(R"({"format": "taa"})"), "its format is \"taa\", this program reads 1");
}

TEST(HostileManifest, ValuesOfOtherTypesAndSizes) {
  EXPECT_EQ(refusalOf(file(R"("name": 1, )")), "\"name\" is not text");
  EXPECT_EQ(refusalOf(file(R"("name": ")" + std::string(4097, 'x') + R"(", )")),
            "\"name\" is longer than 4096 bytes");
  EXPECT_EQ(refusalOf(file(R"("outputSize": [1], )")), "\"outputSize\" wants [width, height]");
  EXPECT_EQ(refusalOf(file(R"("outputSize": [1, 16385], )")),
            "\"outputSize\" wants a whole number from 1 to 16384");
  EXPECT_EQ(refusalOf(file(R"("outputSize": [1.5, 1], )")),
            "\"outputSize\" wants a whole number from 1 to 16384");
  EXPECT_EQ(refusalOf(file(R"("framesPerSecond": 0, )")),
            "\"framesPerSecond\" is 0, not from 0.001 to 100000");
  EXPECT_EQ(refusalOf(file(R"("objects": [], )")), "\"objects\" is not an object");
  EXPECT_EQ(refusalOf(file(R"("objects": {"07": "x"}, )")),
            "the key \"objects.07\" is not an id from 1 to 4294967295");
  EXPECT_EQ(refusalOf(file(R"("objects": {"4294967296": "x"}, )")),
            "the key \"objects.4294967296\" is not an id from 1 to 4294967295");
  EXPECT_EQ(refusalOf(file(R"("objects": {"0": "x"}, )")), "\"objects.0\" names nothing: ids begin with 1");
  EXPECT_EQ(refusalOf(file(R"("notes": ["a", 1], )")), "\"notes\" is not text");
  EXPECT_EQ(refusalOf(file(R"("like": "unrael", )")).substr(0, 45),
            "there is no starting point \"unrael\": give one");
}

TEST(HostileManifest, ConventionsThatAreUnknownOrContradictEachOther) {
  EXPECT_EQ(ofConventions("7"), "\"conventions\" is not an object");
  EXPECT_EQ(ofConventions(R"({"motion": 1})"), "\"conventions.motion\" is not an object");
  EXPECT_EQ(ofConventions(R"({"motion": {"unti": "uv"}})").substr(0, 56),
            "there is no convention \"motion.unti\"; near it are motion");
  EXPECT_EQ(ofConventions(R"({"motions": {"unit": "uv"}})").substr(0, 33),
            "there is no convention \"motions\";");
  EXPECT_EQ(ofConventions(R"({"motion": {"unit": "uv"}, "motion.unit": "ndc"})"),
            "there is no key \"conventions.motion.unit\": write \"motion\": {\"unit\": …}");
  EXPECT_EQ(ofConventions(R"({"motion": {"unit": "px"}})"),
            "cannot set motion.unit to \"px\": give one of pixels, uv, ndc");
  EXPECT_EQ(ofConventions(R"({"depth": {"reversed": "on"}})"),
            "\"conventions.depth.reversed\" is not true or false");
  EXPECT_EQ(ofConventions(R"({"motion": {"scaleX": "2"}})"), "\"conventions.motion.scaleX\" is not a number");
  EXPECT_EQ(ofConventions(R"({"motion": {"notWritten": null}})"),
            "\"conventions.motion.notWritten\" is not a number");
  EXPECT_EQ(ofConventions(R"({"motion": {"notWritten": 1e39}})").substr(0, 40),
            "cannot set motion.notWritten to \"1e+39\":");
  EXPECT_EQ(
      ofConventions(R"({"motion": {"offsetX": 0.5}})"),
      "\"conventions.motion.offsetX\" contradicts the rest: it has a meaning with motion.encoding=offset "
      "only");
  EXPECT_EQ(ofConventions(R"({"depth": {"kind": "planar", "nearPlane": 0.1}})"),
            "\"conventions.depth.nearPlane\" contradicts the rest: it has a meaning with depth.kind=window "
            "only");
  EXPECT_EQ(
      ofConventions(R"({"depth": {"scale": 2}})"),
      "\"conventions.depth.scale\" contradicts the rest: it has a meaning with depth.kind=planar|radial "
      "only");
  EXPECT_EQ(ofConventions(R"({"motion": {"fallback": "zero"}})"),
            "\"conventions.motion.fallback\" contradicts the rest: it has a meaning with "
            "motion.notWritten!=none only");
  EXPECT_EQ(ofConventions(R"({"depth": {"nothing": 1}})"),
            "depth.nothing is 1, which with depth.reversed=on is the near plane");
  EXPECT_EQ(
      ofConventions(R"({"matrices": {"jittered": true}})"),
      "\"conventions.matrices.jittered\" says that there is jitter, but \"frames[0].jitter\" is missing");
  EXPECT_EQ(ofConventions(R"({"motion": {"jitter": "both"}})"),
            "\"conventions.motion.jitter\" says that there is jitter, but \"frames[0].jitter\" is missing");
}

TEST(HostileManifest, ConventionsInAListAreHeldLikeOthers) {
  EXPECT_EQ(ofConventions(R"(["motion.unti=uv"])").substr(0, 56),
            "there is no convention \"motion.unti\"; near it are motion");
  EXPECT_EQ(ofConventions(R"(["motion.unit"])"),
            "cannot read \"motion.unit\": write path=value, for example motion.yAxis=up");
  EXPECT_EQ(ofConventions(R"(["motion.unit=px"])"),
            "cannot set motion.unit to \"px\": give one of pixels, uv, ndc");
  EXPECT_EQ(ofConventions(R"(["motion.unit=uv", "rows=topFirst", "motion.unit=uv"])"),
            "\"conventions.motion.unit\" is stated twice");
  EXPECT_EQ(ofConventions("[1]"), "\"conventions\" is not text");
  EXPECT_EQ(ofConventions(R"(["depth.kind=planar", "depth.nearPlane=0.1"])"),
            "\"conventions.depth.nearPlane\" contradicts the rest: it has a meaning with depth.kind=window "
            "only");
  const std::string many = repeated("\"rows=topFirst\", ", 999);
  EXPECT_EQ(ofConventions("[" + many + "0]").substr(0, 30), "\"conventions\" has 1000 entries");
}

// What states again the value that it has anyway is no contradiction: programs write all they know.
TEST(HostileManifest, WhatSaysNothingNewIsTaken) {
  EXPECT_NO_THROW(parseManifest(
      file(R"("conventions": {"depth": {"kind": "planar", "nearPlane": 0, "reversed": true}}, )"), "it"));
}

TEST(HostileManifest, FilesThatAreNotBelowTheFolder) {
  const auto of = [](const std::string& name) {
    return refusalOf(R"({"format": 1, "size": [4, 4], "planes": {"color": {"file": ")" + name +
                     R"("}}, "frames": [{"number": 0}]})");
  };
  for (const char* name : {"", "/etc/passwd", "..", "../a.exr", "a/../../b", "a/..", "C:/a.exr", "a/"})
    EXPECT_EQ(of(name), std::string("\"planes.color.file\" is \"") + name +
                            "\", which is not a file below the capture's folder");
  EXPECT_EQ(of("a\\\\b"), "\"planes.color.file\" is \"a\\b\": write / between folders");
  EXPECT_EQ(of("a\\u0000b"), "\"planes.color.file\" holds what is not a letter");
  EXPECT_EQ(of("a\\nb"), "\"planes.color.file\" holds what is not a letter");
  for (const char* name :
       {"{}", "a}", "{frame", "{frame:}", "{frame:0}", "{frame:10}", "{name}", "{{frame}}"})
    EXPECT_EQ(of(name), std::string("\"planes.color.file\" is \"") + name +
                            "\": braces stand around frame or frame:4 only");
  EXPECT_NO_THROW(parseManifest(R"({"format": 1, "size": [4, 4], "frames": [{"number": 0}],
                                    "planes": {"color": {"file": "...a/..b/.c"}}})",
                                "it"));
}

TEST(HostileManifest, PlanesThatLieAboutThemselves) {
  EXPECT_EQ(ofPlane(R"("raw": "RGBA16")").substr(0, 61),
            "\"planes.color.raw\" is \"RGBA16\": there is no such raw format, ");
  EXPECT_EQ(ofPlane(R"("raw": "RGBA16F", "channels": ["R", "G", "B"])"),
            "\"planes.color.channels\" contradicts \"planes.color.raw\": a raw plane has neither parts nor "
            "channels with names");
  EXPECT_EQ(ofPlane(R"("raw": "RGBA16F", "part": "x")").substr(0, 32), "\"planes.color.part\" contradicts ");
  EXPECT_EQ(ofPlane(R"("size": [4, 4])"),
            "\"planes.color.size\" is for raw planes: \"planes.color.raw\" is missing");
  EXPECT_EQ(ofPlane(R"("rowPitch": 4)"),
            "\"planes.color.rowPitch\" is for raw planes: \"planes.color.raw\" is missing");
  EXPECT_EQ(ofPlane(R"("raw": "RGBA16F", "rowPitch": 3839)"),
            "\"planes.color.rowPitch\" is 3839 bytes, less than the 3840 of a row");
  EXPECT_EQ(ofPlane(R"("raw": "RGBA16F", "rowPitch": 1e18)"),
            "\"planes.color.rowPitch\" wants a whole number from 0 to 1073741824");
  EXPECT_EQ(ofPlane(R"("raw": "RG16F")"),
            "\"planes.color.raw\" is RG16F with fewer than the 3 channels of color");
  EXPECT_EQ(ofPlane(R"("raw": "R32_UINT")"),
            "\"planes.color.raw\" is R32_UINT, which holds whole numbers: only objectId does");
  EXPECT_EQ(ofPlane(R"("channels": ["R"])"), "\"planes.color.channels\" names 1 channels; color has 3 to 4");
  EXPECT_EQ(ofPlane(R"("channels": ["a", "b", "c", "d", "e"])"),
            "\"planes.color.channels\" has 5 entries, more than the 4 allowed");
  EXPECT_EQ(ofPlane(R"("rows": "up")"), "cannot set rows to \"up\": give one of topFirst, bottomFirst");
  EXPECT_EQ(ofFrames(R"({"number": 0, "planes": {"objectId": {"file": "i", "raw": "R32F"}}})"),
            "\"frames[0].planes.objectId.raw\" is R32F, which does not hold whole numbers: objectId wants "
            "them");
  EXPECT_EQ(ofFrames(R"({"number": 0, "planes": {"colour": {"file": "i"}}})"),
            "there is no key \"frames[0].planes.colour\"; near it is \"color\"");
}

TEST(HostileManifest, FramesThatContradictEachOther) {
  EXPECT_EQ(ofFrames(""), "\"frames\" is empty");
  EXPECT_EQ(ofFrames(R"({"number": -1})"), "\"frames[0].number\" wants a whole number from 0 to 2147483647");
  EXPECT_EQ(ofFrames(R"({"number": 2}, {"number": 2})"),
            "\"frames[1].number\" is 2 after 2: numbers of frames rise");
  EXPECT_EQ(ofFrames(R"({"number": 0, "jitter": [0, 0]}, {"number": 1})"),
            "\"frames[1].jitter\" is missing, but other frames have it");
  EXPECT_EQ(ofFrames(R"({"number": 0}, {"number": 1, "seconds": 1})"),
            "\"frames[0].seconds\" is missing, but other frames have it");
  EXPECT_EQ(ofFrames(R"({"number": 0, "seconds": 1}, {"number": 1, "seconds": 1})"),
            "\"frames[1].seconds\" does not rise");
  EXPECT_EQ(ofFrames(R"({"number": 0, "jitter": [0, 0, 0]})"),
            "\"frames[0].jitter\" has 3 entries, more than the 2 allowed");
  EXPECT_EQ(ofFrames(R"({"number": 0, "jitter": [0, null]})"), "\"frames[0].jitter\" is not a number");
  EXPECT_EQ(ofFrames(R"({"number": 0, "jitter": [0, 1e7]})"),
            "\"frames[0].jitter\" is 10000000, not from -1000000 to 1000000");
  EXPECT_EQ(ofFrames(R"({"number": 0, "view": [1, 2]})"), "\"frames[0].view\" wants 16 numbers");
  EXPECT_EQ(ofFrames(R"({"number": 0, "view": )" + matrix() + "}"),
            "\"frames[0].view\" is there without \"frames[0].projection\"");
  EXPECT_EQ(ofFrames(R"({"number": 0, "view": )" + matrix("1e31") + R"(, "projection": )" + matrix() + "}"),
            "\"frames[0].view\" is 1e+31, not from -1e+30 to 1e+30");
  EXPECT_EQ(ofFrames(R"({"number": 0, "previousView": )" + matrix() + R"(, "previousProjection": )" +
                     matrix() + "}"),
            "\"frames[0].previousView\" is there without \"frames[0].view\"");
  EXPECT_EQ(ofFrames(R"({"number": 0, "preExposure": 2})"),
            "\"frames[0].preExposure\" is 2, but \"conventions.color.preExposed\" is off");
  EXPECT_EQ(ofFrames(R"({"number": 0, "cut": 1})"), "\"frames[0].cut\" is not true or false");
  EXPECT_EQ(refusalOf(R"({"format": 1, "size": [4, 4], "planes": {"color": {"file": "c.exr"}},
                          "frames": [{"number": 0}, {"number": 1}]})"),
            "\"planes.color.file\" is one file for several frames: write {frame} where their number stands");
}

TEST(HostileManifest, AsManyFramesAsThereMayBe) {
  std::string frames = R"({"number":0})";
  for (int i = 1; i < kMaxCapturedFrames; ++i) frames += ",{\"number\":" + std::to_string(i) + "}";
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(parseManifest(file("", "", frames), "it").frames.size(), 100000u);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, kBound);
  EXPECT_EQ(ofFrames(frames + R"(,{"number":100000})"),
            "\"frames\" has 100001 entries, more than the 100000 allowed");
}

TEST(HostileManifest, WhatWasMadeWrongIsNotWritten) {
  Manifest manifest = parseManifest(file(""), "it");
  const auto refusal = [&] {
    try {
      manifestText(manifest);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("it is written");
  };
  manifest.frames[0].jitter.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal(), "cannot write the capture: \"frames[0].jitter\" is nan, not from -1000000 to 1000000");
  manifest.frames[0].jitter.x = 0.0;
  manifest.conventions.motion.scale.x = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal(), "cannot write the capture: cannot set motion.scaleX to \"inf\": give a number from "
                       "-1000000000 to 1000000000");
  manifest.conventions = {};
  manifest.name = "\xff";
  EXPECT_EQ(refusal().substr(24), ": \"name\" holds what is not a letter");
  EXPECT_THROW(checkManifest(manifest, "it"), Error);
}

TEST(HostileManifest, FilesThatAreNone) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "hostile-manifest";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder / kManifestName);
  EXPECT_THROW(readManifest(folder), Error);
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  std::filesystem::create_symlink("/dev/zero", folder / kManifestName);
  EXPECT_THROW(readManifest(folder), Error);
  std::filesystem::remove_all(folder);
}

} // namespace taa::capture
