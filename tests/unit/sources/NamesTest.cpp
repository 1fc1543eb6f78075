// GLSL and the twin call the same things by the same names, so that they can be read side by side.
#include "core/base/Files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <initializer_list>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>

namespace taa {
namespace {

using Names = std::set<std::string>;

/// Shaders of the scene's drawing, which the twin takes as given.
const Names kScene{"brdf.glsl",   "fog_cone.glsl", "motion.glsl", "noise.glsl",
                   "shadow.glsl", "sky.glsl",      "storage.glsl"};

/// What has no counterpart, by the reason.
const std::map<std::string, Names>& withoutCounterpart() {
  static const std::map<std::string, Names> kNames{
      {"The twin gets pictures and frames as values, without textures and packed blocks.",
       {"texelAt",     "historyAt",      "historyFlags",   "frameNumber", "firstPixel",  "regionSize",
        "targetSize",  "distanceFactor", "eighthsOfFrame", "pixelHere",   "hasHistory",  "keeps",
        "Samples",     "readInputs",     "readResolved",   "readHistory", "viewDepthAt", "currentWeight",
        "nearestHalf", "lastJitter",     "isNanColor"}},
      {"GLSL has a function for each curve, where the twin's compress() has a switch.",
       {"reinhardChannel", "inverseReinhardChannel", "inverseCompressMax", "pqChannel", "inversePqChannel",
        "logarithmChannel", "inverseLogarithmChannel", "overLuma", "gammaChannel", "inverseGammaChannel"}},
      {"The twin's Taps, std::array or vector does it: weights and colors side by side, in one sum.",
       {"CubicWeights", "historyPair", "historyTexel", "WeightedSum", "sumOfNine", "sumOfSixteen",
        "sampleWeight", "placeConfidence"}},
      {"The twin lists the members of a neighborhood, where GLSL asks of each of nine whether it is one.",
       {"Box",        "Moments",    "isInCross",  "isInX",     "unjittered",    "isLeftOfPair", "isInPair",
        "rounded",    "isInShape",  "allToBox",   "otherAxis", "slabDirection", "measureSlabs", "isCandidate",
        "neighborOf", "firstDepth", "DepthMatch", "isRead",    "Around",        "storedAround", "bestMatch"}},
      {"A step of a function that the twin writes as one.",
       {"isNearer",         "isAsFar",        "wasThin",
        "isThinNow",        "compareObjects", "compareNormals",
        "compareMotion",    "isFrozenBy",     "invalidity",
        "changedShare",     "entry",          "isKept",
        "confidenceWeight", "leastAgreement", "crossDifference",
        "cornerDifference", "rcas",           "blurTrust",
        "detailOf",         "dithered"}},
      {"The twin's Weights and Rectified hold what these do.", {"Damping", "Composed", "RectifiedHistory"}},
  };
  return kNames;
}

/// The first group of each pattern in the lines of a file.
Names found(const std::filesystem::path& file, std::initializer_list<std::regex> patterns) {
  Names names;
  std::istringstream text(readFile(file));
  std::smatch match;
  for (std::string line; std::getline(text, line);)
    for (const std::regex& pattern : patterns)
      if (std::regex_search(line, match, pattern)) names.insert(match[1]);
  return names;
}

Names namesOfShaders() {
  const std::regex type(R"(^struct (\w+))"), function(R"(^\w+(?:\[\d+\])? (\w+)\()");
  Names names;
  for (const char* folder : {"/shaders/taa", "/shaders/include"})
    for (const auto& entry : std::filesystem::directory_iterator(std::string(TAA_SOURCE_DIR) + folder))
      if (entry.path().extension() == ".glsl" && !kScene.contains(entry.path().filename().string()))
        names.merge(found(entry.path(), {type, function}));
  return names;
}

Names namesOfTheTwin() {
  // A template on its number is called …Of: "WeightsOf".
  const std::regex type(R"(^(?:struct|class) (\w+?)(?:Of)?\b)"), function(R"(^[\w:][\w:<>,&* ]*[ &](\w+)\()"),
      lambda(R"(const auto (\w+) = \[)");
  Names names;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::string(TAA_SOURCE_DIR) + "/core/taa/twin"))
    if (entry.is_regular_file()) names.merge(found(entry.path(), {type, function, lambda}));
  return names;
}

TEST(Names, OfTheShaderAreThoseOfTheTwin) {
  Names excused;
  for (const auto& [reason, names] : withoutCounterpart()) excused.insert(names.begin(), names.end());
  const Names shaders = namesOfShaders(), twin = namesOfTheTwin();
  ASSERT_GT(shaders.size(), 200u);
  for (const std::string& name : shaders)
    EXPECT_NE(twin.contains(name), excused.contains(name))
        << name << (twin.contains(name) ? " has a counterpart by now" : " has none in core/taa/twin");
  for (const std::string& name : excused)
    EXPECT_TRUE(shaders.contains(name)) << name << " is in no shader any more";
}

} // namespace
} // namespace taa
