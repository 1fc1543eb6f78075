// Lines that include, in shaders that somebody made: of any length, and files in each other.
#include "core/base/EmbeddedFiles.h"
#include "core/gl/Program.h"
#include "tests/support/ErrorOf.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>

namespace {

using taa::gl::ShaderSource;

/// Shaders in place of all others while this lives.
class ShadersInMemory {
 public:
  explicit ShadersInMemory(taa::ShaderTexts texts)
      : before_(taa::useShaders(std::make_shared<const taa::ShaderTexts>(std::move(texts)))) {}
  ~ShadersInMemory() { taa::useShaders(before_); }
  ShadersInMemory(const ShadersInMemory&) = delete;
  ShadersInMemory& operator=(const ShadersInMemory&) = delete;

 private:
  std::shared_ptr<const taa::ShaderTexts> before_; // also owned by who used it
};

/// "0.glsl" includes "1.glsl", that "2.glsl" … `last` includes nothing.
taa::ShaderTexts chainOf(int last) {
  taa::ShaderTexts texts;
  for (int file = 0; file <= last; ++file)
    texts["shaders/" + std::to_string(file) + ".glsl"] =
        file < last ? "#include \"" + std::to_string(file + 1) + ".glsl\"\n" : "float end;\n";
  return texts;
}

/// Whether the file of a line is included.
bool isIncluded(const std::string& line) {
  const ShadersInMemory shaders({{"shaders/main.glsl", line + "\n"}, {"shaders/a b.glsl", "float found;\n"}});
  return ShaderSource("main.glsl").fullText().find("found") != std::string::npos;
}

} // namespace

TEST(ShaderIncludes, AreReadWithBlanksWhereTheyMayStand) {
  EXPECT_TRUE(isIncluded("#include \"a b.glsl\""));
  EXPECT_TRUE(isIncluded(" \t# \tinclude \t\"a b.glsl\" \t\r"));
  for (const char* const line : {"#include\"a b.glsl\"", "#included \"a b.glsl\"", "include \"a b.glsl\"",
                                 "#include \"a b.glsl\" x", "#include \"a b.glsl", "#include \"\"", "#"})
    EXPECT_FALSE(isIncluded(line)) << line;
}

TEST(ShaderIncludes, AreLookedForInLinesOfAnyLength) {
  const std::string blanks(4'000'000, ' ');
  EXPECT_TRUE(isIncluded(blanks + "#include \"a b.glsl\"" + blanks));
  EXPECT_FALSE(isIncluded("#include \"a b.glsl\"" + blanks + "x"));
}

TEST(ShaderIncludes, GoNoDeeperThanAnybodyWrites) {
  {
    const ShadersInMemory shaders(chainOf(64));
    EXPECT_NE(ShaderSource("0.glsl").text().find("float end"), std::string::npos);
  }
  const ShadersInMemory shaders(chainOf(65));
  EXPECT_EQ(taa::test::errorOf([] { ShaderSource("0.glsl"); }),
            "64.glsl:1: cannot include \"65.glsl\": files include each other more than 64 deep");
}
