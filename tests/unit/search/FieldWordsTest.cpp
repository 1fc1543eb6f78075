// The words that papers and engines have for what is here find the setting or the intermediate that is about
// it.
#include "core/taa/SearchedRows.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <optional>
#include <string>

using namespace taa;

namespace {

struct FieldWord {
  const char* word;
  const char* path; ///< of a setting, or the name of an intermediate
  FoundBy by;
};

// By hand, from papers and engines.
constexpr auto kFieldWords = std::to_array<FieldWord>({
    {"AABB", "neighborhood.box", FoundBy::Synonym},
    {"AABB", "boxMin", FoundBy::Synonym},
    {"bounding box", "boxMax", FoundBy::Synonym},
    {"feedback", "weight.alpha", FoundBy::Synonym},
    {"feedback", "alpha", FoundBy::Synonym},
    {"history weight", "weight.alpha", FoundBy::Text},
    {"variance clip", "neighborhood.box", FoundBy::Synonym},
    {"variance clipping", "neighborhood.gamma", FoundBy::Synonym},
    {"Salvi", "neighborhood.box", FoundBy::Choice},
    {"Karis", "rectify.method", FoundBy::Choice},
    {"Karis", "blend.tone", FoundBy::Choice},
    {"firefly", "blend.tone", FoundBy::Choice},
    {"fireflies", "neighborhood.weights", FoundBy::Choice},
    {"luminance", "neighborhood.weights", FoundBy::Synonym},
    {"luminance", "current.lumaWeighted", FoundBy::Synonym},
    {"bicubic", "history.filter", FoundBy::Synonym},
    {"disocclusion", "validate.depth", FoundBy::Synonym},
    {"disocclusion", "rejectReason", FoundBy::Synonym},
    {"velocity", "validate.velocity", FoundBy::Label},
    {"velocity", "motion", FoundBy::Synonym},
    {"TSAA", "taa.enabled", FoundBy::Synonym},
    {"anti-flicker", "flicker", FoundBy::Synonym},
    {"anti-flicker", "validate.flicker", FoundBy::Synonym},
    {"sharpen", "output.sharpen", FoundBy::Label},
    {"sharpening", "current.sharpen", FoundBy::Label},
    {"RCAS", "output.sharpen", FoundBy::Choice},
    {"Catmull-Rom", "history.filter", FoundBy::Choice},
    {"Lanczos", "history.filter", FoundBy::Choice},
    {"Lanczos", "current.filter", FoundBy::Choice},
    {"Mitchell", "history.filter", FoundBy::Choice},
    {"YCoCg", "space.color", FoundBy::Choice},
    {"Halton", "jitter.sequence", FoundBy::Choice},
    {"R2", "jitter.sequence", FoundBy::Choice},
    {"Hammersley", "jitter.sequence", FoundBy::Choice},
    {"responsive", "weight.mask", FoundBy::Choice},
    {"responsive", "responsive", FoundBy::Label},
    {"reactive", "reactive", FoundBy::Label},
    {"ghosting", "ghost", FoundBy::Label},
    {"ghosting", "rectify.method", FoundBy::Choice},
    {"reprojection", "reproject.method", FoundBy::Synonym},
    {"dithering", "output.dither", FoundBy::Label},
    {"lock", "rectify.locks", FoundBy::Label},
    {"lock", "lock", FoundBy::Label},
    {"clamp", "rectify.method", FoundBy::Choice},
    {"clipping", "clipAmount", FoundBy::Label},
    {"ground truth", "reference", FoundBy::Synonym},
    {"optical flow", "motion", FoundBy::Synonym},
    {"upscaling", "current.upsample", FoundBy::Synonym},
    {"TAAU", "current.upsample", FoundBy::Synonym},
    {"NaN", "fault.nan", FoundBy::Label},
    {"Playdead", "neighborhood.shape", FoundBy::Choice},
    {"FSR2", "current.upsample", FoundBy::Choice},
    {"dilation", "dilate.method", FoundBy::Synonym},
    {"confidence", "weight.source", FoundBy::Choice},
    {"Reinhard", "space.tone", FoundBy::Choice},
});

std::map<std::string, SearchHit> hits(const std::string& wanted) {
  const Search search(wanted);
  std::map<std::string, SearchHit> found;
  const auto add = [&](const SearchedRow& row) {
    if (const std::optional<SearchHit> hit = search.find(row)) found[row.id] = *hit;
  };
  for (const Parameter& row : parameters()) add(searchedRow(row));
  for (const Intermediate& row : kIntermediates) add(searchedRow(row));
  return found;
}

} // namespace

TEST(FieldWords, FindWhatIsAboutThem) {
  for (const FieldWord& of : kFieldWords) {
    const auto found = hits(of.word);
    const auto row = found.find(of.path);
    if (row == found.end())
      ADD_FAILURE() << of.word << " does not find " << of.path;
    else
      EXPECT_EQ(static_cast<int>(row->second.by), static_cast<int>(of.by)) << of.word << ", " << of.path;
  }
}

// What finds half of the tables finds nothing.
TEST(FieldWords, FindLittleElse) {
  const std::size_t rows = parameters().size() + kIntermediateCount;
  for (const FieldWord& of : kFieldWords) EXPECT_LE(hits(of.word).size(), rows / 3) << of.word;
}

TEST(FieldWords, ThatAreNoneFindNothing) {
  for (const char* word : {"qqqq", "tessellation", "spherical harmonics", "AABB tessellation", "clipxyz"})
    EXPECT_TRUE(hits(word).empty()) << word << " finds " << hits(word).begin()->first;
}

// Where a row is in the list because of something that it does not show, the hit says what.
TEST(FieldWords, SayWhyARowIsFound) {
  EXPECT_EQ(hits("Karis").at("rectify.method").why, "Clip to filtered");
  EXPECT_EQ(hits("feedback").at("weight.alpha").why, "alpha");
  EXPECT_EQ(hits("bicubic").at("history.filter").why, "cubic");
  EXPECT_EQ(hits("R2").at("jitter.sequence").why, "R2");
}

TEST(FieldWords, OfOneValueFindTheValuesThatTheyAreOf) {
  const Parameter& method = parameter("rectify.method");
  const SearchedRow filtered = searchedValue(method, static_cast<int>(RectifyMethod::ClipToFiltered));
  EXPECT_EQ(filtered.label, "Method: Clip to filtered");
  EXPECT_EQ(Search("Karis").find(filtered), (SearchHit{FoundBy::Choice, "Clip to filtered"}));
  EXPECT_EQ(Search("rectify.method=clamp").find(filtered), std::nullopt);
  EXPECT_TRUE(Search("rectify.method=clipToF").find(filtered));
  EXPECT_TRUE(Search("taa.enabled=on").find(searchedValue(parameter("taa.enabled"), 1)));
  EXPECT_FALSE(Search("taa.enabled=on").find(searchedValue(parameter("taa.enabled"), 0)));
}
