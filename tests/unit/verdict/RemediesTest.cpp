// Which changes of settings are tried for what is wrong with a pixel, and which of them are told.
#include "core/verdict/pixel/Remedies.h"

#include "core/settings/Parameters.h"
#include "core/verdict/pixel/Cures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace {

using taa::Remedy;
using taa::RemedyCase;
using taa::RemedyMeasure;
using taa::Settings;
using taa::TriedRemedy;
using taa::VerdictKind;

RemedyMeasure measured(double error) {
  RemedyMeasure measure;
  measure.error = measure.latest = error;
  return measure;
}

TriedRemedy triedRemedy(std::vector<std::string> changes, double error) {
  TriedRemedy tried;
  tried.remedy.changes = std::move(changes);
  tried.pixel = measured(error);
  return tried;
}

/// With settings that have the changes.
TriedRemedy triedOn(const Settings& settings, std::vector<std::string> changes, double error) {
  TriedRemedy tried = triedRemedy(std::move(changes), error);
  tried.remedy.settings = settings;
  for (const std::string& change : tried.remedy.changes) applyAssignment(tried.remedy.settings, change);
  return tried;
}

/// A pixel that is off by so much.
RemedyCase offBy(double error) {
  RemedyCase of;
  of.before = measured(error);
  return of;
}

/// Nothing guards history.
RemedyCase trailing(VerdictKind kind) {
  RemedyCase of;
  of.kind = kind;
  of.settings.rectify.method = taa::RectifyMethod::None;
  of.settings.validate.depth = taa::Switch::Off;
  of.before = measured(0.2);
  return of;
}

std::vector<TriedRemedy> inVain(const std::vector<Remedy>& remedies) {
  std::vector<TriedRemedy> tried;
  for (const Remedy& remedy : remedies) tried.push_back({remedy, measured(0.2)});
  return tried;
}

using Changes = std::vector<std::string>;

std::vector<Changes> changesOf(const std::vector<Remedy>& remedies) {
  std::vector<Changes> changes;
  for (const Remedy& remedy : remedies) changes.push_back(remedy.changes);
  return changes;
}

bool holds(const std::vector<Changes>& all, const Changes& changes) {
  return std::ranges::find(all, changes) != all.end();
}

} // namespace

TEST(Remedies, ChangeOneToThreeSettingsThatHaveAnEffect) {
  for (const taa::VerdictKindInfo& info : taa::kVerdictKinds) {
    const RemedyCase of = trailing(info.kind);
    const std::vector<Remedy> remedies = remedyRound(0, of, {});
    EXPECT_EQ(remedies.empty(), info.kind == VerdictKind::None) << info.id;
    for (const Remedy& remedy : remedies) {
      EXPECT_GE(remedy.changes.size(), 1u);
      EXPECT_LE(remedy.changes.size(), 3u);
      EXPECT_EQ(remedy.changes, differences(remedy.settings, of.settings));
      for (const std::string& change : remedy.changes)
        EXPECT_TRUE(isRelevant(taa::parameter(change.substr(0, change.find('='))), remedy.settings))
            << info.id << ": " << change;
    }
  }
}

TEST(Remedies, DrawOtherInputsOnlyWhereThereIsAScene) {
  RemedyCase of = trailing(VerdictKind::MaskSmear);
  const auto drawsOthers = [&](const Remedy& remedy) { return !sameInputs(remedy.settings, of.settings); };
  EXPECT_TRUE(std::ranges::any_of(remedyRound(0, of, {}), drawsOthers)) << "a mask has to be drawn";
  of.drawsInputs = false;
  EXPECT_TRUE(std::ranges::none_of(remedyRound(0, of, {}), drawsOthers)) << "a capture is as it is";
}

// Of a capture's too: they come on its way in.
TEST(Remedies, TakeOutWhatWasInjected) {
  for (const bool drawsInputs : {true, false}) {
    RemedyCase of = trailing(VerdictKind::Ghost);
    of.drawsInputs = drawsInputs;
    for (const char* fault : {"fault.motionX=-1", "fault.motionY=-1", "fault.region=sky"})
      applyAssignment(of.settings, fault);
    const std::vector<Remedy> remedies = remedyRound(0, of, {});
    EXPECT_EQ(remedies.front().settings, trailing(VerdictKind::Ghost).settings) << "without any";
    EXPECT_TRUE(holds(changesOf(remedies), {"fault.motionY=1"})) << "without one";
  }
  for (const Remedy& remedy : remedyRound(0, trailing(VerdictKind::Ghost), {}))
    for (const std::string& change : remedy.changes) EXPECT_FALSE(change.starts_with("fault.")) << change;
}

TEST(Remedies, AreSingleChangesOfEverySettingWhereLikelyOnesLeaveWhatIsSeen) {
  const RemedyCase of = trailing(VerdictKind::Ghost);
  const std::vector<Remedy> first = remedyRound(0, of, {});
  std::vector<Changes> changes = changesOf(first);
  std::ranges::copy(changesOf(remedyRound(1, of, inVain(first))), std::back_inserter(changes));
  for (const taa::Parameter& row : taa::parameters()) {
    if (row.kind != taa::ParameterKind::Choice || !isRelevant(row, of.settings)) continue;
    if (row.stage < taa::Stage::DilateMotion || row.stage > taa::Stage::Blend) continue;
    for (std::size_t choice = 0; choice < row.choices.size(); ++choice) {
      const bool isTried =
          holds(changes, {std::string(row.path) + "=" + std::string(row.choices[choice].id)});
      const bool isWanted = !row.choices[choice].id.ends_with("AsPrinted") &&
                            row.get(of.settings) != static_cast<double>(choice) &&
                            (row.effect == taa::Effect::Program || row.effect == taa::Effect::Uniform);
      EXPECT_EQ(isTried, isWanted) << row.path << "=" << row.choices[choice].id;
    }
  }
  EXPECT_TRUE(holds(changes, {"weight.minimum=0.05"})) << "half of a number";
  EXPECT_TRUE(holds(changes, {"history.dering=off"})) << "a switch";
}

TEST(Remedies, AgainstOtherKindsAreTriedWhereAllElseIsInVain) {
  const RemedyCase of = trailing(VerdictKind::Ghost);
  std::vector<TriedRemedy> tried = inVain(remedyRound(0, of, {}));
  const std::vector<Changes> others = changesOf(remedyRound(1, of, tried));
  const Changes ofMasks{"inputs.mask=material", "weight.mask=responsive", "weight.maskAlpha=1"};
  EXPECT_TRUE(holds(others, ofMasks)) << "known to help against smears";
  for (const TriedRemedy& one : tried) EXPECT_FALSE(holds(others, one.remedy.changes)) << "it was tried";
  tried.front().pixel = measured(0.1);
  const std::vector<Changes> singles = changesOf(remedyRound(1, of, tried));
  EXPECT_FALSE(holds(singles, ofMasks)) << "one of the first helps";
  EXPECT_TRUE(holds(singles, {"history.dering=off"})) << "and leaves what can be seen";
  tried.front().pixel = measured(0.01);
  EXPECT_TRUE(remedyRound(1, of, tried).empty()) << "nothing is left to see";
}

TEST(Remedies, AverageFramesWhereNothingDoes) {
  RemedyCase of;
  of.kind = VerdictKind::Aliasing;
  of.before = measured(0.2);
  of.settings.jitter.taa = taa::Switch::Off;
  EXPECT_EQ(changesOf(remedyRound(0, of, {})), (std::vector<Changes>{{"taa.enabled=on"}}));
  for (const char* assignment : {"taa.enabled=on", "weight.source=constant", "weight.alpha=1"})
    applyAssignment(of.settings, assignment);
  for (const Remedy& remedy : remedyRound(0, of, {})) {
    EXPECT_FALSE(accumulatesNothing(remedy.settings)) << testing::PrintToString(remedy.changes);
    EXPECT_TRUE(std::ranges::any_of(remedy.changes,
                                    [](const std::string& change) { return change.starts_with("weight."); }));
  }
  const std::vector<TriedRemedy> tried{triedOn(of.settings, {"weight.alpha=0.1"}, 0.1)};
  EXPECT_TRUE(holds(changesOf(remedyRound(1, of, tried)), {"current.filter=center", "weight.alpha=0.1"}))
      << "then each other setting with it";
}

TEST(Remedies, AreTriedTogetherWithTheBest) {
  const RemedyCase of = trailing(VerdictKind::Ghost);
  const std::vector<TriedRemedy> tried{triedOn(of.settings, {"validate.depth=on"}, 0.1),
                                       triedOn(of.settings, {"rectify.method=clamp"}, 0.15),
                                       triedOn(of.settings, {"rectify.method=clipToCenter"}, 0.25)};
  EXPECT_EQ(changesOf(remedyRound(2, of, tried)),
            (std::vector<Changes>{{"validate.depth=on", "rectify.method=clamp"}}))
      << "the third harms by itself";
  EXPECT_TRUE(remedyRound(2, of, {triedOn(of.settings, {"validate.depth=on"}, 0.005), tried[1]}).empty())
      << "nothing that could be seen is left";
  EXPECT_TRUE(remedyRound(2, of, {}).empty());
}

TEST(Remedies, ThatHelpAreToldBestFirstAndWithoutWhatAddsNothing) {
  const std::vector<TriedRemedy> tried{triedRemedy({"a"}, 0.19),      triedRemedy({"b"}, 0.05),
                                       triedRemedy({"a", "b"}, 0.05), triedRemedy({"c"}, 0.1),
                                       triedRemedy({"d"}, 0.12),      triedRemedy({"e"}, 0.01)};
  const std::vector<TriedRemedy> best = bestRemedies(tried, offBy(0.2), 3);
  ASSERT_EQ(best.size(), 3u);
  EXPECT_EQ(best[0].remedy.changes, Changes{"e"});
  EXPECT_EQ(best[1].remedy.changes, Changes{"b"});
  EXPECT_EQ(best[2].remedy.changes, Changes{"c"});
  EXPECT_TRUE(bestRemedies({triedRemedy({"a"}, 0.19)}, offBy(0.2), 3).empty()) << "nearer, but not clearly";
}

// By two steps of 255 or a twentieth of the error, whichever is more.
TEST(Remedies, ThatAreSimplerComeFirstWhereTheyLeaveAboutAsLittle) {
  const auto firstOf = [](double one, double two, double before) {
    return bestRemedies({triedRemedy({"a", "b"}, two / 255.0), triedRemedy({"c"}, one / 255.0)},
                        offBy(before / 255.0), 3)
        .front()
        .remedy.changes;
  };
  EXPECT_EQ(firstOf(2.2, 0.242, 20.0), Changes{"c"});
  EXPECT_EQ(firstOf(2.3, 0.242, 20.0), (Changes{"a", "b"})) << "two steps";
  EXPECT_EQ(firstOf(9.9, 0.0, 200.0), Changes{"c"});
  EXPECT_EQ(firstOf(10.1, 0.0, 200.0), (Changes{"a", "b"})) << "a twentieth of the error";
}

RemedyMeasure pictureOf(double error, double flicker) {
  RemedyMeasure measure;
  measure.error = error / 255.0;
  measure.flicker = flicker / 255.0;
  return measure;
}

// By the error of the picture and its flicker together.
TEST(Remedies, ThatArePicturesFriendsComeFirstWhereTheyLeaveAboutAsLittle) {
  TriedRemedy one = triedRemedy({"a"}, 0.2 / 255.0), other = triedRemedy({"b"}, 1.0 / 255.0);
  RemedyCase of = offBy(0.2);
  of.picture = pictureOf(6.0, 3.0);
  const auto firstOf = [&](const RemedyMeasure& ofOne, const RemedyMeasure& ofOther) {
    one.picture = ofOne;
    other.picture = ofOther;
    return bestRemedies({one, other}, of, 3).front().remedy.changes;
  };
  EXPECT_EQ(firstOf(pictureOf(6.0, 1.0), pictureOf(4.0, 1.0)), other.remedy.changes);
  EXPECT_EQ(firstOf(pictureOf(4.0, 3.0), pictureOf(4.0, 1.0)), other.remedy.changes) << "it flickers less";
  EXPECT_EQ(firstOf(pictureOf(4.0, 1.0), pictureOf(6.0, 1.0)), one.remedy.changes);
  other.pixel = measured(10.5 / 255.0);
  EXPECT_EQ(firstOf(pictureOf(6.0, 1.0), pictureOf(4.0, 1.0)), one.remedy.changes) << "the pixel gains more";
}

// 0.1 dB are a factor of 1.0116 of the error.
TEST(Remedies, CostThePictureByPsnrOrFlicker) {
  const RemedyMeasure before = pictureOf(4.0, 1.0);
  EXPECT_FALSE(costsPicture(before, pictureOf(4.04, 1.0)));
  EXPECT_TRUE(costsPicture(before, pictureOf(4.05, 1.0)));
  EXPECT_FALSE(costsPicture(before, pictureOf(3.0, 1.09)));
  EXPECT_TRUE(costsPicture(before, pictureOf(3.0, 1.11)));
  EXPECT_FALSE(costsPicture(pictureOf(4.0, 0.0), pictureOf(4.0, 0.04))) << "nobody sees so little";
  EXPECT_TRUE(costsPicture(pictureOf(4.0, 0.0), pictureOf(4.0, 0.06)));
}

TEST(Remedies, ThatCostThePictureComeLastAndSaySo) {
  RemedyCase of = offBy(0.2);
  of.picture = pictureOf(4.0, 1.0);
  std::vector<TriedRemedy> tried{triedRemedy({"a", "b", "c"}, 0.0), triedRemedy({"d"}, 0.15),
                                 triedRemedy({"e"}, 0.1)};
  tried[0].picture = pictureOf(8.0, 1.5);
  tried[1].picture = tried[2].picture = pictureOf(4.0, 1.0);
  std::vector<TriedRemedy> best = bestRemedies(tried, of, 3);
  ASSERT_EQ(best.size(), 3u);
  EXPECT_EQ(best[0].remedy.changes, Changes{"e"});
  EXPECT_EQ(best[1].remedy.changes, Changes{"d"});
  EXPECT_EQ(best[2].remedy.changes, (Changes{"a", "b", "c"}));
  EXPECT_EQ(remedyNote(best[0], of.before, of.picture), "");
  EXPECT_EQ(remedyNote(best[2], of.before, of.picture),
            "It costs the picture 6 dB of PSNR. The picture flickers more: by 50 %.");
  best = bestRemedies(tried, of, 2);
  EXPECT_EQ(best.back().remedy.changes, Changes{"d"}) << "it makes room for what costs nothing";
}

TEST(Remedies, AreThoseThatTheVerdictNamesInAnyCase) {
  RemedyCase of = offBy(0.2);
  of.named = {"reproject.method"};
  const std::vector<TriedRemedy> tried{
      triedRemedy({"a=1"}, 0.01), triedRemedy({"b=1"}, 0.02), triedRemedy({"c=1"}, 0.03),
      triedRemedy({"reproject.method=motion"}, 0.1), triedRemedy({"reproject.method=inPlace"}, 0.3)};
  std::vector<TriedRemedy> best = bestRemedies(tried, of, 3);
  ASSERT_EQ(best.size(), 3u);
  EXPECT_EQ(best[2].remedy.changes, Changes{"reproject.method=motion"}) << "it helps less, and is told";
  EXPECT_TRUE(best[2].isNamed);
  EXPECT_FALSE(best[0].isNamed);
  EXPECT_EQ(remedyNote(best[2], of.before, {}), "The verdict names this setting.");
  best = bestRemedies({tried[0], tried[4]}, of, 3);
  ASSERT_EQ(best.size(), 2u);
  EXPECT_EQ(best[1].remedy.changes, Changes{"reproject.method=inPlace"});
  EXPECT_EQ(remedyNote(best[1], of.before, {}),
            "The verdict names this setting; changing it does not mend the pixel.");
}

TEST(Remedies, ThatTurnTaaOnComeFirst) {
  RemedyCase of = offBy(0.2);
  of.settings.jitter.taa = taa::Switch::Off;
  const std::vector<TriedRemedy> tried{
      triedOn(of.settings, {"taa.enabled=on", "current.filter=center"}, 0.02),
      triedOn(of.settings, {"taa.enabled=on"}, 0.1)};
  EXPECT_EQ(bestRemedies(tried, of, 3).front().remedy.changes, Changes{"taa.enabled=on"});
}

TEST(Remedies, ThatTakeAFaultOutComeFirst) {
  const std::vector<TriedRemedy> tried{triedRemedy({"rectify.method=clip"}, 0.01),
                                       triedRemedy({"fault.motionY=1"}, 0.05),
                                       triedRemedy({"fault.motionX=1"}, 0.3)};
  const std::vector<TriedRemedy> best = bestRemedies(tried, offBy(0.2), 3);
  ASSERT_EQ(best.size(), 2u) << "one does not help";
  EXPECT_EQ(best[0].remedy.changes, Changes{"fault.motionY=1"});
  EXPECT_EQ(best[1].remedy.changes, Changes{"rectify.method=clip"});
}

TEST(Remedies, AreNotToldWhereTheLastFrameIsWorseOff) {
  TriedRemedy calmer = triedRemedy({"a"}, 0.05);
  calmer.pixel.latest = 0.21;
  EXPECT_TRUE(bestRemedies({calmer}, offBy(0.2), 3).empty());
  calmer.pixel.latest = 0.19;
  EXPECT_EQ(bestRemedies({calmer}, offBy(0.2), 3).size(), 1u);
}

// Of a trail that has just left: what was off in one frame of four and is so no more, comes and goes, too.
TEST(Remedies, AreHeldAgainstTheFrameItselfAsMuchAsAgainstThoseBefore) {
  RemedyCase of;
  of.before = {.error = 0.183, .latest = 0.347, .errorChange = 0.173};
  TriedRemedy tried = triedRemedy({"a"}, 0.0);
  tried.pixel = {.error = 0.161, .latest = 0.257, .errorChange = 0.193};
  EXPECT_EQ(bestRemedies({tried}, of, 3).size(), 1u);
  tried.pixel.latest = 0.34;
  EXPECT_TRUE(bestRemedies({tried}, of, 3).empty()) << "nearer, but not clearly";
}
