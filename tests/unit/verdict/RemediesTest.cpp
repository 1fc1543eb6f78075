// Which changes of settings are tried for what is wrong with a pixel, and which of them are told.
#include "core/verdict/pixel/Remedies.h"

#include "core/settings/Parameters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
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

TEST(Remedies, OfEverySettingAreTriedWhereLikelyOnesAreInVain) {
  const RemedyCase of = trailing(VerdictKind::Ghost);
  const std::vector<Remedy> likely = remedyRound(0, of, {});
  std::vector<TriedRemedy> tried = inVain(likely);
  const std::vector<Changes> others = changesOf(remedyRound(1, of, tried));
  EXPECT_TRUE(holds(others, {"weight.minimum=0.05"})) << "half of a number";
  EXPECT_TRUE(holds(others, {"current.filter=lanczos"})) << "a choice";
  EXPECT_TRUE(holds(others, {"history.dering=off"})) << "a switch";
  for (const Remedy& remedy : likely) EXPECT_FALSE(holds(others, remedy.changes)) << "it was tried";
  tried.front().pixel = measured(0.1);
  EXPECT_TRUE(remedyRound(1, of, tried).empty()) << "one of the likely ones helps";
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
  const std::vector<TriedRemedy> best = bestRemedies(tried, measured(0.2), 3);
  ASSERT_EQ(best.size(), 3u);
  EXPECT_EQ(best[0].remedy.changes, Changes{"e"});
  EXPECT_EQ(best[1].remedy.changes, Changes{"b"});
  EXPECT_EQ(best[2].remedy.changes, Changes{"c"});
  EXPECT_TRUE(bestRemedies({triedRemedy({"a"}, 0.19)}, measured(0.2), 3).empty())
      << "nearer, but not clearly";
}

// By a step of 255 or a tenth of the error, whichever is less.
TEST(Remedies, ThatAreSimplerComeFirstWhereNobodySeesTheDifference) {
  const auto firstOf = [](double one, double two, double before) {
    return bestRemedies({triedRemedy({"a", "b"}, two / 255.0), triedRemedy({"c"}, one / 255.0)},
                        measured(before / 255.0), 3)
        .front()
        .remedy.changes;
  };
  EXPECT_EQ(firstOf(0.34, 0.242, 96.0), Changes{"c"});
  EXPECT_EQ(firstOf(1.2, 0.242, 96.0), Changes{"c"});
  EXPECT_EQ(firstOf(1.3, 0.242, 96.0), (Changes{"a", "b"})) << "a step";
  EXPECT_EQ(firstOf(1.0, 0.9, 5.0), Changes{"c"});
  EXPECT_EQ(firstOf(1.5, 0.9, 5.0), (Changes{"a", "b"})) << "a tenth of the error";
}

// By the error of the picture and its flicker together.
TEST(Remedies, ThatCostThePictureLessComeFirstWhereNobodySeesTheDifference) {
  TriedRemedy dear = triedRemedy({"a"}, 0.2 / 255.0), cheap = triedRemedy({"b", "c"}, 1.0 / 255.0);
  const auto firstOf = [&](const RemedyMeasure& ofDear, const RemedyMeasure& ofCheap) {
    dear.picture = ofDear;
    cheap.picture = ofCheap;
    return bestRemedies({dear, cheap}, measured(0.2), 3).front().remedy.changes;
  };
  const auto picture = [](double error, double flicker) {
    RemedyMeasure measure;
    measure.error = error / 255.0;
    measure.flicker = flicker / 255.0;
    return measure;
  };
  EXPECT_EQ(firstOf(picture(6.0, 1.0), picture(4.0, 1.0)), cheap.remedy.changes);
  EXPECT_EQ(firstOf(picture(4.0, 3.0), picture(4.0, 1.0)), cheap.remedy.changes) << "it flickers less";
  EXPECT_EQ(firstOf(picture(4.0, 1.0), picture(6.0, 1.0)), dear.remedy.changes) << "now that is cheaper";
  EXPECT_EQ(firstOf(picture(4.01, 1.0), picture(4.0, 1.0)), dear.remedy.changes) << "the same: it is simpler";
  cheap.pixel = measured(1.3 / 255.0);
  EXPECT_EQ(firstOf(picture(6.0, 1.0), picture(4.0, 1.0)), dear.remedy.changes) << "the pixel gains a step";
}

TEST(Remedies, ThatTakeAFaultOutComeFirst) {
  const std::vector<TriedRemedy> tried{triedRemedy({"rectify.method=clip"}, 0.01),
                                       triedRemedy({"fault.motionY=1"}, 0.05),
                                       triedRemedy({"fault.motionX=1"}, 0.3)};
  const std::vector<TriedRemedy> best = bestRemedies(tried, measured(0.2), 3);
  ASSERT_EQ(best.size(), 2u) << "one does not help";
  EXPECT_EQ(best[0].remedy.changes, Changes{"fault.motionY=1"});
  EXPECT_EQ(best[1].remedy.changes, Changes{"rectify.method=clip"});
}

TEST(Remedies, AreNotToldWhereTheLastFrameIsWorseOff) {
  TriedRemedy calmer = triedRemedy({"a"}, 0.05);
  calmer.pixel.latest = 0.21;
  EXPECT_TRUE(bestRemedies({calmer}, measured(0.2), 3).empty());
  calmer.pixel.latest = 0.19;
  EXPECT_EQ(bestRemedies({calmer}, measured(0.2), 3).size(), 1u);
}

// Of a trail that has just left: what was off in one frame of four and is so no more, comes and goes, too.
TEST(Remedies, AreHeldAgainstTheFrameItselfAsMuchAsAgainstThoseBefore) {
  const RemedyMeasure before{.error = 0.183, .latest = 0.347, .errorChange = 0.173};
  TriedRemedy tried = triedRemedy({"a"}, 0.0);
  tried.pixel = {.error = 0.161, .latest = 0.257, .errorChange = 0.193};
  EXPECT_EQ(bestRemedies({tried}, before, 3).size(), 1u);
  tried.pixel.latest = 0.34;
  EXPECT_TRUE(bestRemedies({tried}, before, 3).empty()) << "nearer, but not clearly";
}
