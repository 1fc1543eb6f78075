// How shader files become one text, and how the driver's messages find the way back to the files.
#include "core/base/EmbeddedFiles.h"
#include "core/gl/Program.h"
#include "tests/support/ErrorOf.h"
#include "tests/support/GlTest.h"
#include "tests/support/ShaderFolder.h"

#include <string>

using taa::gl::ShaderSource;
using taa::test::errorOf;
using taa::test::ShaderFolder;

TEST(ShaderSource, PutsVersionAndPreludeFirst) {
  const ShaderFolder folder;
  folder.write("test.frag", "void main() { gl_FragDepth = float(kOne); }\n");
  const std::string text = ShaderSource("test.frag", "const int kOne = 1;").text();
  EXPECT_EQ(text.find("#version 450 core\n"), 0u);
  EXPECT_LT(text.find("kOne"), text.find("main"));
}

TEST(ShaderSource, LeavesOutWhatConstantsRuleOut) {
  const ShaderFolder folder;
  folder.write("test.frag",
               "float gone() { return 1.0; }\nvoid main() { if (kOff) gl_FragDepth = gone(); }\n");
  const std::string text = ShaderSource("test.frag", "const bool kOff = false;").text();
  EXPECT_EQ(text.find("gone"), std::string::npos) << text;
}

TEST(ShaderSource, ExpandsAnIncludedFileOnce) {
  const ShaderFolder folder;
  folder.write("a.glsl", "float once;\n");
  folder.write("b.glsl", "#include \"a.glsl\"\n");
  folder.write("test.frag", "#include \"a.glsl\"\n#include \"b.glsl\"\nvoid main() {}\n");
  const std::string text = ShaderSource("test.frag").text();
  EXPECT_NE(text.find("once"), std::string::npos);
  EXPECT_EQ(text.find("once"), text.rfind("once"));
  EXPECT_EQ(text.find("#include"), std::string::npos);
}

TEST(ShaderSource, NamesWhoIncludesAMissingFile) {
  const ShaderFolder folder;
  folder.write("test.frag", "\n#include \"taa/nowhere.glsl\"\n");
  const std::string text = errorOf([] { ShaderSource("test.frag"); });
  EXPECT_NE(text.find("test.frag:2"), std::string::npos) << text;
  EXPECT_NE(text.find("taa/nowhere.glsl"), std::string::npos) << text;
}

TEST(ShaderSource, TurnsFileNumbersIntoPaths) {
  const ShaderFolder folder;
  folder.write("a.glsl", "float a;\n");
  folder.write("test.frag", "#include \"a.glsl\"\nvoid main() {}\n");
  const ShaderSource source("test.frag");
  EXPECT_EQ(source.readableLog("2:17(3): error: no"), "a.glsl:17: error: no");
  EXPECT_EQ(source.readableLog("1(4) : error C0000: no"), "test.frag:4: error C0000: no");
  EXPECT_EQ(source.readableLog("note"), "note");
  // Mesa says file 0 of most errors; the line tells which it is.
  EXPECT_EQ(source.readableLog("0:200017(3): error: no"), "a.glsl:17: error: no");
  EXPECT_EQ(source.readableLog("1:100004(3): error: no"), "test.frag:4: error: no");
}

TEST(UsedShaders, AreNotThoseOfTheFilesAnyMore) {
  const ShaderFolder folder;
  folder.write("a.glsl", "float before;\n");
  taa::useShaders(taa::readShaders());
  folder.write("a.glsl", "float after;\n");
  EXPECT_EQ(taa::embeddedText("shaders/a.glsl"), "float before;\n");
  const auto before = taa::useShaders(taa::readShaders());
  EXPECT_EQ(taa::embeddedText("shaders/a.glsl"), "float after;\n");
  taa::useShaders(before);
  EXPECT_EQ(taa::embeddedText("shaders/a.glsl"), "float before;\n");
  taa::useShaders(nullptr);
  EXPECT_EQ(taa::embeddedText("shaders/a.glsl"), "float after;\n");
}

using ProgramTest = taa::test::GlTest;

TEST_F(ProgramTest, NamesFileAndLineOfAnErrorInAnInclude) {
  const ShaderFolder folder;
  folder.write("a.glsl", "float fine() { return 1.0; }\n\nfloat broken() { return missing; }\n");
  folder.write("test.frag",
               "#include \"a.glsl\"\nout vec4 color;\nvoid main() { color = vec4(broken()); }\n");
  const std::string text = errorOf(
      [] { taa::gl::Program(ShaderSource("include/fullscreen.vert"), ShaderSource("test.frag"), "test"); });
  EXPECT_NE(text.find("a.glsl:3:"), std::string::npos) << text;
  EXPECT_NE(text.find("missing"), std::string::npos) << text;
  folder.write("a.glsl", "struct S { float x; };\n\nfloat broken() { S s; return s.y; }\n");
  const std::string field = errorOf(
      [] { taa::gl::Program(ShaderSource("include/fullscreen.vert"), ShaderSource("test.frag"), "test"); });
  EXPECT_NE(field.find("a.glsl:3:"), std::string::npos) << field;
}
