// What is left of a shader whose constants rule parts of it out.
#include "core/gl/ShaderStripper.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace taa::gl {
namespace {

/// What is left, without the blanks.
std::string stripped(const std::string& shader) {
  std::string text = withoutUnused(shader);
  std::erase_if(text, [](char c) { return c == ' ' || c == '\n'; });
  return text;
}

std::string bodyAfter(const std::string& statements) {
  const std::string text = stripped("const bool kOn = true;\nconst bool kOff = false;\nconst int kKind = 2;\n"
                                    "const int kKind_two = 2;\nout float o;\nvoid main() { " +
                                    statements + " }");
  return text.substr(text.find("main(){") + 7);
}

TEST(ShaderStripper, KeepsTheBranchTaken) {
  EXPECT_EQ(bodyAfter("if (kOn) o = 1.0; else o = 2.0;"), "o=1.0;}");
  EXPECT_EQ(bodyAfter("if (kOff) { o = 1.0; } else { o = 2.0; }"), "{o=2.0;}}");
  EXPECT_EQ(bodyAfter("if (kKind == kKind_two && !kOff) o = 1.0;"), "o=1.0;}");
  EXPECT_EQ(bodyAfter("if (kKind != kKind_two) o = 1.0; else if (kOn) o = 2.0; else o = 3.0;"), "o=2.0;}");
  EXPECT_EQ(bodyAfter("if ((kOff || kKind == 3) || o > 1.0) o = 1.0;").find("if("), 0u); // o is not known
}

TEST(ShaderStripper, LeavesAStatementWhereOneIsWanted) {
  EXPECT_EQ(bodyAfter("for (int k = 0; k < 3; ++k) if (kOff) o = 1.0; o = 2.0;"),
            "for(intk=0;k<3;++k);o=2.0;}");
  EXPECT_EQ(bodyAfter("if (o > 0.0) if (kOff) o = 1.0; else o = 2.0;"), "if(o>0.0)o=2.0;}");
}

TEST(ShaderStripper, DecidesChoicesInExpressions) {
  EXPECT_EQ(bodyAfter("o = kOn ? 1.0 : 2.0;"), "o=1.0;}");
  EXPECT_EQ(bodyAfter("o = kOff ? (o > 0.0 ? 3.0 : 4.0) : 2.0;"), "o=2.0;}");
  EXPECT_EQ(bodyAfter("o = kOff ? 1.0 : o > 0.0 ? 3.0 : 4.0;"), "o=o>0.0?3.0:4.0;}");
  EXPECT_EQ(bodyAfter("o = max(kOn ? 1.0 : 2.0, o + (kOff ? 5.0 : 6.0));"), "o=max(1.0,o+(6.0));}");
  EXPECT_EQ(bodyAfter("o = kOn && o > 0.0 ? 1.0 : 2.0;"), "o=kOn&&o>0.0?1.0:2.0;}");
}

TEST(ShaderStripper, DropsWhatStandsBehindAJump) {
  EXPECT_EQ(bodyAfter("if (kOn) return; o = 1.0;"), "return;}");
  EXPECT_EQ(bodyAfter("{ if (o > 0.0) return; o = 1.0; }"), "{if(o>0.0)return;o=1.0;}}");
}

TEST(ShaderStripper, DropsFunctionsAndConstantsThatNothingUses) {
  const std::string shader =
      "const bool kOff = false;\nconst vec2 kFar = vec2(1.0);\n#define shows(value)\n"
      "#define keeps(value) o = deep(value)\nout float o;\n"
      "float deep(float x) { return x; }\nfloat gone(float x) { return deep(x) + kFar.x; }\n"
      "void main() { shows(gone(1.0)); keeps(2.0); if (kOff) o = gone(2.0); }\n";
  const std::string text = stripped(shader);
  EXPECT_EQ(text.find("gone"), std::string::npos);
  EXPECT_EQ(text.find("kFar"), std::string::npos);
  EXPECT_NE(text.find("floatdeep(floatx)"), std::string::npos);
  EXPECT_NE(text.find("keeps(2.0);"), std::string::npos);
}

TEST(ShaderStripper, KeepsLinesAndTheHalfForShaders) {
  const std::string text =
      withoutUnused("#version 450 core\n#ifdef __cplusplus\nstruct A {\n#else\nstruct B {\n"
                    "#endif\n  float x; // a\n};\nvoid main() {\n  B b;\n}\n");
  EXPECT_EQ(text.find("struct A"), std::string::npos);
  const std::size_t at = text.find("B b");
  ASSERT_NE(at, std::string::npos);
  EXPECT_EQ(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'), 9);
}

TEST(ShaderStripper, LeavesAloneWhatItDoesNotUnderstand) {
  for (const std::string text :
       {"#if 1\nvoid main() {}\n#endif\n", "void main() { switch (1) { default: break; } }", "void main() {",
        "const int kA = 1;\nvoid main() { int kA = 2; }"})
    EXPECT_EQ(withoutUnused(text), text);
}

} // namespace
} // namespace taa::gl
