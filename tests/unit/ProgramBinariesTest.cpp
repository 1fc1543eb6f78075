// Programs kept on disk: found again, refused when they are not whole or of something else, and bounded.
#include "core/gl/ProgramBinaries.h"
#include "core/base/Files.h"
#include "tests/support/Paths.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <string>

namespace fs = std::filesystem;

using taa::gl::ProgramBinaries;
using taa::gl::ProgramBinary;

namespace {

const std::string kSource = "void main() {}\n";
const ProgramBinary kBinary{0x8e21, std::string("bytes\0with zeros", 16)};

class ProgramBinariesTest : public testing::Test {
 protected:
  void SetUp() override { fs::remove_all(folder); }
  void TearDown() override { fs::remove_all(folder); }
  const fs::path folder = taa::test::temporaryFolder() / "programs";
};

} // namespace

TEST_F(ProgramBinariesTest, FindsWhatAnotherKept) {
  ProgramBinaries(folder, "driver 1").keep(kSource, kBinary);
  const auto found = ProgramBinaries(folder, "driver 1").find(kSource);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->format, kBinary.format);
  EXPECT_EQ(found->bytes, kBinary.bytes);
  EXPECT_FALSE(ProgramBinaries(folder, "driver 1").find(kSource + " "));
}

TEST_F(ProgramBinariesTest, RefusesThatOfAnotherDriver) {
  const ProgramBinaries first(folder, "driver 1"), second(folder, "driver 2");
  first.keep(kSource, kBinary);
  EXPECT_FALSE(second.find(kSource));
  fs::copy_file(first.fileOf(kSource), second.fileOf(kSource)); // as if the names had met
  EXPECT_FALSE(second.find(kSource));
  second.keep(kSource, kBinary);
  EXPECT_TRUE(second.find(kSource)) << "replaced";
}

TEST_F(ProgramBinariesTest, RefusesAFlippedByteAndAShortFile) {
  const ProgramBinaries binaries(folder, "driver");
  binaries.keep(kSource, kBinary);
  const std::string whole = taa::readFile(binaries.fileOf(kSource));
  for (std::size_t index = 0; index < whole.size(); ++index) {
    std::string flipped = whole;
    flipped[index] = static_cast<char>(flipped[index] ^ 1);
    taa::writeFile(binaries.fileOf(kSource), flipped);
    EXPECT_FALSE(binaries.find(kSource)) << "byte " << index;
    taa::writeFile(binaries.fileOf(kSource), whole.substr(0, index));
    EXPECT_FALSE(binaries.find(kSource)) << index << " bytes";
  }
  taa::writeFile(binaries.fileOf(kSource), whole);
  EXPECT_TRUE(binaries.find(kSource));
}

TEST_F(ProgramBinariesTest, DropsWhatWasUsedLongestAgo) {
  const std::string large(1000, 'x');
  const ProgramBinaries binaries(folder, "driver", 3500);
  for (const std::string source : {"a", "b", "c"}) {
    binaries.keep(source, {1, large});
    const auto age = std::chrono::hours(source == "a" ? 3 : source == "b" ? 2 : 1);
    fs::last_write_time(binaries.fileOf(source), fs::file_time_type::clock::now() - age);
  }
  EXPECT_TRUE(binaries.find("a")); // used now
  binaries.keep("d", {1, large});
  EXPECT_TRUE(binaries.find("a"));
  EXPECT_FALSE(binaries.find("b"));
  EXPECT_TRUE(binaries.find("c"));
  EXPECT_TRUE(binaries.find("d"));
}

TEST_F(ProgramBinariesTest, GoesOnWithoutAFolder) {
  taa::writeFile(folder, "a file where the folder should be");
  const ProgramBinaries binaries(folder, "driver");
  binaries.keep(kSource, kBinary);
  EXPECT_FALSE(binaries.find(kSource));
}
