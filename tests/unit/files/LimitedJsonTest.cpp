// JSON of somebody else's: what it may cost, and what is said of it.
#include "core/base/json/LimitedJson.h"
#include "core/io/SessionFile.h"
#include "core/scene/builtin/SceneSource.h"
#include "tests/support/ErrorOf.h"
#include "tests/support/frames/GltfSample.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <ctime>
#include <functional>
#include <string>

namespace taa {
namespace {

/// Time that grew with the square of the text was minutes for these files, and is less than one second.
constexpr double kMaxSeconds = 10.0; // under sanitizers, too

double processorSeconds(const std::function<void()>& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

std::string repeated(const std::string& part, int count) {
  std::string text = part;
  for (int i = 1; i < count; ++i) text += "," + part;
  return text;
}

/// {"asset": …, `members`}
std::string gltfOf(const std::string& members) {
  return R"({"asset": {"version": "2.0"}, )" + members + "}";
}

std::string refusalOf(const std::string& text, const JsonLimits& limits = {}) {
  return test::errorOf([&] { parseLimited(text, limits); });
}

TEST(LimitedJson, TakesTimeThatGrowsWithTheTextAlone) {
  constexpr int kMany = 1'000'000;
  EXPECT_LT(processorSeconds([&] {
              EXPECT_EQ(parseLimited("[" + repeated("{}", kMany) + "]").size(), std::size_t(kMany));
            }),
            kMaxSeconds);
}

TEST(LimitedJson, RefusesWhatIsBeyondItsLimits) {
  EXPECT_EQ(refusalOf("[1, 2, 3]", {.entries = 3}), "");
  EXPECT_EQ(refusalOf("[1, 2, 3, 4]", {.entries = 3}), "what the file holds has more than 3 entries");
  EXPECT_EQ(refusalOf(R"({"x": 1, "a": [0, {"b": [1, 2, 3, 4]}]})", {.entries = 3}),
            "\"a[1].b\" has more than 3 entries");
  EXPECT_EQ(refusalOf("[[0]]", {.depth = 2}), "");
  EXPECT_EQ(refusalOf("[[[0]]]", {.depth = 2}), "it is nested deeper than 2 levels");
  EXPECT_EQ(refusalOf("[1]", {.bytes = 2}), "it has 3 bytes, more than the 2 allowed");
  EXPECT_EQ(refusalOf("\"" + std::string(std::size_t(1) << 20, 'x') + "\"", {.memory = std::size_t(1) << 20}),
            "it would take more than 1 MiB of memory");
}

TEST(LimitedJson, SaysWhereItIsNone) {
  EXPECT_EQ(refusalOf(""), "it is empty");
  EXPECT_EQ(refusalOf("{\"a\": 1,\n\"b\": x}"), "it is not JSON from line 2, column 6 on");
  EXPECT_EQ(refusalOf("[1e999]"), "a number in line 1, column 6 is too large");
  EXPECT_EQ(refusalOf("{\"a\\n\": 1, \"a\\n\": 2}"), "the key \"a?\" comes twice");
  EXPECT_EQ(refusalOf(R"({"x": 3, "a": [{"b": {"c": 1, "c": 1}}]})"), "the key \"a[0].b.c\" comes twice");
}

TEST(LimitedJson, SaysWhereItWasCut) {
  EXPECT_EQ(refusalOf("["), "it ends in line 1, column 2, before it is whole");
  EXPECT_EQ(refusalOf("{\"a\":\n"), "it ends in line 2, column 1, before it is whole");
  EXPECT_EQ(refusalOf("{\"a\":\n \"b"), "it ends in line 2, column 4, before it is whole");
  EXPECT_EQ(refusalOf("[\"a\n\"]"),
            "it is not JSON from line 1, column 4 on"); // a line must not end in a text
}

TEST(LimitedJson, OpensScenesOfAnyShapeInTimeOfTheirSize) {
  const std::string channel = R"({"sampler": 0, "target": {"path": "scale"}})";
  const std::string driven = R"({"sampler": 0, "target": {"path": "scale", "node": 0}})";
  std::string unknown = "\"A0\"";
  for (int i = 1; i < 150'000; ++i) unknown += ",\"A" + std::to_string(i) + "\"";
  const std::string shapes[] = {
      gltfOf(R"("scenes": [{"nodes": [0]}], "nodes": [)" + repeated("{}", 400'000) + "]"),
      gltfOf(R"("nodes": [)" + repeated("{}", 200'000) + R"(], "scenes": [)" +
             repeated(R"({"nodes": [0]})", 100'000) + "]"),
      gltfOf(R"("extensionsUsed": [)" + unknown + "]"),
      gltfOf(R"("nodes": [{}], "accessors": [{"componentType": 5126, "count": 1, "type": "VEC3"}],
                "animations": [{"samplers": [{"input": 0, "output": 0}], "channels": [)" +
             repeated(channel + "," + driven, 20'000) + "]}]")};
  for (const std::string& shape : shapes) {
    const std::string file = test::writeTemporary("large.gltf", shape).string();
    const double seconds = processorSeconds([&] { test::errorOf([&] { openScene(file); }); });
    EXPECT_LT(seconds, kMaxSeconds) << shape.substr(0, 60);
  }
}

TEST(LimitedJson, ReadsTheLargestSessionInTimeOfItsSize) {
  const std::string text = R"({"window": {"a": [)" + repeated("{}", 1'300'000) + "]}}";
  std::string said;
  const double seconds =
      processorSeconds([&] { said = test::errorOf([&] { sessionFromText(text, "it"); }); });
  EXPECT_LT(seconds, kMaxSeconds);
  EXPECT_EQ(said, "cannot open the session it: \"window.a\" has more than 1000000 entries");
}

} // namespace
} // namespace taa
