// Reading and writing whole files, and the files inside the binary.
#include "core/base/Files.h"
#include "core/base/EmbeddedFiles.h"
#include "core/io/CameraTrackJson.h"
#include "core/io/SessionFile.h"
#include "core/settings/Presets.h"
#include "core/sweep/SweepSpec.h"
#include "tests/support/ErrorOf.h"
#include "tests/support/Paths.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <vector>

namespace fs = std::filesystem;
using taa::test::errorOf;

namespace {

std::size_t countFiles(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

fs::path emptyFolder(const std::string& name) {
  const fs::path folder = taa::test::temporaryFolder() / name;
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

/// Sets a variable of the environment for a scope.
class ScopedVariable {
 public:
  ScopedVariable(const char* name, const std::string& value) : name_(name) {
    ::setenv(name, value.c_str(), 1);
  }
  ScopedVariable(const ScopedVariable&) = delete;
  ScopedVariable& operator=(const ScopedVariable&) = delete;
  ~ScopedVariable() { ::unsetenv(name_); }

 private:
  const char* name_;
};

} // namespace

TEST(Files, ReadBackTheBytesThatWereWritten) {
  const fs::path path = emptyFolder("bytes") / "a.bin";
  const std::string bytes("a\0\r\n\xff", 5);
  taa::writeFile(path, bytes);
  EXPECT_EQ(taa::readFile(path), bytes);
}

TEST(Files, SayWhichFileIsMissing) {
  const std::string message = errorOf([] { taa::readFile("/nowhere/at.all"); });
  EXPECT_NE(message.find("/nowhere/at.all"), std::string::npos);
  EXPECT_NE(message.find("No such file"), std::string::npos);
}

TEST(Files, RefuseAFolder) {
  EXPECT_NE(errorOf([] { taa::readFile("/tmp"); }).find("it is a folder"), std::string::npos);
}

TEST(UntrustedFiles, AreRegularAndBelowTheirFolder) {
  const fs::path folder = emptyFolder("below");
  fs::create_directories(folder / "in/deep");
  taa::writeFile(folder / "in/deep/a", "0123456789");
  taa::writeFile(folder / "secret", "x");
  fs::create_symlink("deep/a", folder / "in/inside");
  fs::create_symlink("../secret", folder / "in/outside");
  fs::create_symlink("/dev/zero", folder / "in/zero");
  fs::create_symlink("nowhere", folder / "in/broken");
  fs::create_directories(folder / "inner");
  fs::create_symlink("../inner", folder / "in/inner");
  taa::writeFile(folder / "inner/b", "x");
  ASSERT_EQ(::mkfifo((folder / "in/pipe").c_str(), 0600), 0);
  const auto said = [&](const std::string& file) {
    return errorOf([&] { taa::requireRegularBelow(folder / "in", file); });
  };
  EXPECT_EQ(said("deep/a"), "");
  EXPECT_EQ(said("deep/../deep/a"), "");
  EXPECT_EQ(taa::requireRegularBelow(folder / "in", "inside"), fs::canonical(folder / "in/deep/a"));
  for (const char* out : {"../secret", "outside", "inner/b", "zero", "deep/../../secret"})
    EXPECT_NE(said(out).find("leads out of the folder"), std::string::npos) << out;
  // A folder whose name begins with that of another is not below it.
  EXPECT_NE(said("../inner/b").find("leads out of the folder"), std::string::npos);
  EXPECT_NE(said("/etc/passwd").find("not a path below"), std::string::npos);
  EXPECT_NE(said("").find("not a path below"), std::string::npos);
  EXPECT_NE(said("deep").find("is a folder"), std::string::npos);
  EXPECT_NE(said("pipe").find("not a regular file"), std::string::npos);
  EXPECT_NE(said("broken").find("No such file"), std::string::npos);
  EXPECT_NE(said("missing").find("No such file"), std::string::npos);
}

TEST(UntrustedFiles, ReadWhereTheyAreAsked) {
  const fs::path folder = emptyFolder("untrusted");
  taa::writeFile(folder / "ten", "0123456789");
  const taa::UntrustedFile file = taa::openUntrusted(folder, "ten", 10);
  EXPECT_EQ(file.size(), 10u);
  std::string bytes(4, ' ');
  file.read(3, std::as_writable_bytes(std::span(bytes)));
  EXPECT_EQ(bytes, "3456");
  EXPECT_NE(errorOf([&] { file.read(8, std::as_writable_bytes(std::span(bytes))); }).find("ends after 10"),
            std::string::npos);
  EXPECT_NE(errorOf([&] { taa::openUntrusted(folder, "ten", 9); }).find("ten has 10 bytes"),
            std::string::npos);
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_NE(errorOf([&] { taa::UntrustedFile(folder / "pipe"); }).find("not a regular file"),
            std::string::npos);
}

/// Where a file is expected that somebody gives.
TEST(UntrustedFiles, AreNeverWaitedForNorReadWithoutEnd) {
  const fs::path folder = emptyFolder("given");
  const fs::path pipe = folder / "pipe.json", zero = folder / "zero.json";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  fs::create_symlink("/dev/zero", zero);
  for (const fs::path& file : {pipe, zero}) {
    const std::string reason = file.string() + ": it is not a regular file";
    for (const std::string& said :
         {errorOf([&] { taa::readFile(file); }), errorOf([&] { taa::readSession(file); }),
          errorOf([&] { taa::readCameraTrack(file); }), errorOf([&] { taa::preset(file.string()); }),
          errorOf([&] { taa::readSweepSpec(file); })})
      EXPECT_NE(said.find(reason), std::string::npos) << said;
  }
}

TEST(Files, ReadWhatTellsNoSize) {
  EXPECT_NE(taa::readFile("/proc/self/stat").find(std::to_string(::getpid())), std::string::npos);
  EXPECT_NE(errorOf([] { taa::readFile("/proc/self/stat", 3); }).find("more than the 3 allowed"),
            std::string::npos);
}

TEST(Files, RefuseAFileAboveTheLimit) {
  const fs::path path = emptyFolder("limit") / "ten";
  taa::writeFile(path, "0123456789");
  EXPECT_EQ(taa::readFile(path, 10).size(), 10u);
  EXPECT_NE(errorOf([&] { taa::readFile(path, 9); }).find("10 bytes"), std::string::npos);
}

TEST(Files, ReplaceAFileInOneStep) {
  const fs::path folder = emptyFolder("replace");
  taa::writeFile(folder / "a.txt", "old");
  taa::writeAtomically(folder / "a.txt", [&](const fs::path& temporary) {
    EXPECT_EQ(temporary.parent_path(), folder);
    EXPECT_EQ(temporary.extension(), ".txt");
    std::ofstream(temporary) << "new";
    EXPECT_EQ(taa::readFile(folder / "a.txt"), "old");
  });
  EXPECT_EQ(taa::readFile(folder / "a.txt"), "new");
  EXPECT_EQ(countFiles(folder), 1u);
}

TEST(Files, KeepTheOldFileWhenWritingFails) {
  const fs::path folder = emptyFolder("fails");
  taa::writeFile(folder / "a.txt", "old");
  const std::string message = errorOf([&] {
    taa::writeAtomically(folder / "a.txt", [](const fs::path& temporary) {
      std::ofstream(temporary) << "ha";
      throw taa::Error("the disk is full");
    });
  });
  EXPECT_EQ(message, "the disk is full");
  EXPECT_EQ(taa::readFile(folder / "a.txt"), "old");
  EXPECT_EQ(countFiles(folder), 1u);
}

TEST(Files, AreClearedOfWhatAKilledWriterLeft) {
  const fs::path folder = emptyFolder("killed");
  const ::pid_t ended = ::fork();
  if (ended == 0) ::_exit(0);
  ASSERT_EQ(::waitpid(ended, nullptr, 0), ended);
  const fs::path own = taa::temporaryBeside(emptyFolder("name") / "a.b.txt").filename();
  const std::string name = own.string(), process = "-" + std::to_string(::getpid()) + ".part";
  const std::size_t at = name.find(process);
  ASSERT_NE(at, std::string::npos) << name;
  const std::string dead = name.substr(0, at) + "-" + std::to_string(ended) + ".part.txt";
  const std::string elsewhere = ".a.b.1-" + std::to_string(ended) + ".part.txt"; // of another machine
  for (const std::string& file : {name, dead, elsewhere, std::string("a.part.txt")})
    std::ofstream(folder / file) << "half";
  const std::string sequence = name.substr(0, at) + "-" + std::to_string(ended) + ".part";
  fs::create_directories(folder / sequence / "planes");
  std::ofstream(folder / sequence / "planes" / "a.exr") << "half";
  taa::writeFile(folder / "b.txt", "whole");
  EXPECT_FALSE(fs::exists(folder / dead));
  EXPECT_FALSE(fs::exists(folder / sequence)) << "the folder of a sequence";
  EXPECT_TRUE(fs::exists(folder / name)) << "of a process that runs";
  EXPECT_TRUE(fs::exists(folder / elsewhere));
  EXPECT_EQ(countFiles(folder), 4u);
}

TEST(Files, SayThatTheTargetFolderIsMissing) {
  const fs::path path = emptyFolder("missing") / "no" / "a.txt";
  EXPECT_NE(errorOf([&] { taa::writeFile(path, "x"); }).find(path.string()), std::string::npos);
}

TEST(Files, LeaveNothingBesideATargetThatIsAFolder) {
  const fs::path folder = emptyFolder("target");
  fs::create_directories(folder / "a");
  EXPECT_NE(errorOf([&] { taa::writeFile(folder / "a", "x"); }), "");
  EXPECT_EQ(countFiles(folder), 1u);
}

TEST(EmbeddedFiles, HoldTheSameBytesAsTheSources) {
  const std::vector<std::string> paths = taa::embeddedPaths("shaders/");
  EXPECT_TRUE(std::ranges::is_sorted(paths));
  for (const std::string& path : paths) EXPECT_EQ(taa::embeddedText(path), taa::readFile(path)) << path;
}

TEST(EmbeddedFiles, NameTheFileThatIsNotThere) {
  EXPECT_NE(errorOf([] { taa::embeddedText("shaders/no.glsl"); }).find("shaders/no.glsl"), std::string::npos);
}

TEST(EmbeddedFiles, ComeFromTheShaderFolderWhenThereIsOne) {
  const fs::path folder = emptyFolder("shaders");
  const ScopedVariable variable("TAA_SHADER_DIR", folder.string());
  fs::create_directories(folder / "taa");
  taa::writeFile(folder / "taa" / "new.glsl", "first");
  EXPECT_EQ(taa::embeddedText("shaders/taa/new.glsl"), "first");
  taa::writeFile(folder / "taa" / "new.glsl", "second");
  EXPECT_EQ(taa::embeddedText("shaders/taa/new.glsl"), "second") << "an edit shows at the next read";
  EXPECT_NE(errorOf([] { taa::embeddedText("shaders/taa/no.glsl"); }).find(folder.string()),
            std::string::npos);
}
