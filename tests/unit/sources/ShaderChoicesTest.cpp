// The choices of the table against the shaders: none falls silently into what is written for another.
#include "core/base/Files.h"
#include "core/settings/Parameters.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <string>

namespace taa {
namespace {

/// What is left when all other choices of the row have been asked for, and what is not the shader's to know.
const std::set<std::string>& choicesThatNoShaderNames() {
  static const std::set<std::string> kNames{
      "kDilateMethod_closest3x3",
      "kDilateTies_center",
      "kReprojectMethod_motion",
      "kHistoryFilter_catmullRom16",
      "kHistoryBorder_black",
      "kHistoryLength_reprojected",
      "kHistoryPrecision_full",
      "kCurrentUpsample_lanczos2",
      "kCurrentSharpen_laplacian",
      "kSpaceLuma_rec709",
      "kSpaceTone_linear",
      "kNeighborhoodShape_cross",
      "kNeighborhoodWeights_equal",
      "kNeighborhoodBox_minMax",
      "kNeighborhoodGammaSpeedIn_px",
      "kValidateOffScreen_reject",
      "kValidateDepthDirection_both",
      "kValidateDepthFootprint_square3x3",
      "kValidateVelocity_vector",
      "kValidateAction_restart",
      "kWeightSource_constant",
      "kWeightFlickerScale_relative",
      "kWeightSampleDistance_gaussian",
      "kWeightMotionSpeedIn_px",
      "kBlendTone_maxChannel",
      "kBlendRestart_filtered",
      "kBlendLength_variance",
      // Their nine weights come from core/taa/CurrentWeights.cpp, where the compiler asks for each.
      "kCurrentFilter_gaussian",
      "kCurrentFilter_tent",
      "kCurrentFilter_box",
      "kCurrentFilter_blackmanHarris",
      "kCurrentFilter_distanceAsPrinted",
      "kCurrentFilter_mitchellAsPrinted",
      "kCurrentFilter_blackmanHarrisAsPrinted",
  };
  return kNames;
}

std::set<std::string> found(const std::string& text, const std::regex& pattern) {
  return {std::sregex_token_iterator(text.begin(), text.end(), pattern, 1), std::sregex_token_iterator()};
}

std::string allShaders() {
  std::string text;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::string(TAA_SOURCE_DIR) + "/shaders"))
    if (entry.is_regular_file()) text += readFile(entry.path());
  return text;
}

TEST(ShaderChoices, AreNamedByAShaderOrAreTheOneThatIsLeft) {
  const std::set<std::string> named = found(allShaders(), std::regex(R"(\b(k[A-Z]\w*_\w+)\b)"));
  std::set<std::string> unnamed;
  for (const std::string& choice : found(glslPrelude(Settings{}), std::regex(R"(const int (k\w+_\w+) = )")))
    if (!named.contains(choice)) unnamed.insert(choice);
  EXPECT_EQ(unnamed, choicesThatNoShaderNames());
}

} // namespace
} // namespace taa
