// The manual's part about how often the doctor is right, made from cases whose outcomes are known.
#include "tests/manual/DoctorConfusions.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace taa {
namespace {

JudgedCase judgedCase(const std::vector<Fault>& faults, const std::vector<std::string>& named,
                      bool shows = true) {
  JudgedCase out;
  out.tried = {"builtin:fan", "pan", {240, 136}, 14, faults, false};
  out.shows = shows;
  out.named = named;
  return out;
}

std::vector<JudgedCase> fiveCases() {
  return {judgedCase({}, {}, false), judgedCase({Fault::JitterLate}, {"jitterLate"}),
          judgedCase({Fault::JitterLate}, {"jitterEarly", "jitterLate"}),
          judgedCase({Fault::JitterLate}, {}, false),
          judgedCase({Fault::JitterLate, Fault::MotionZero}, {"motionZero"})};
}

} // namespace

TEST(DoctorConfusions, CountCasesThatAreShownByTheirOutcome) {
  OutcomeCounts counts;
  for (const JudgedCase& one : fiveCases())
    if (one.tried.faults.size() == 1) counts.add(one);
  EXPECT_EQ(counts.cases, 3u);
  EXPECT_EQ(counts.shown(), 2u);
  EXPECT_EQ(counts.count(CaseOutcome::First), 1u);
  EXPECT_EQ(counts.count(CaseOutcome::Later), 1u);
  EXPECT_EQ(counts.hiddenNamed, 0u);
}

TEST(DoctorConfusions, AreATableWithEveryFault) {
  const std::string text = doctorConfusions(fiveCases());
  for (const char* part : {"Scenes: `builtin:fan`, with cameras `pan`, 240 × 136, 14 frames each.",
                           "Of 1 healthy sequences something is found in 0.",
                           "Of 1 pairs of faults of two parts both are named in 0.0 %, one of them in 100.0 "
                           "%; where not both are, "
                           "the rest is said not to be decided in 0.0 %.",
                           "| Jitter | 3 | 2 | 50.0 % | 50.0 % | 0.0 % | 0.0 % | 0.0 % | 0.0 % |\n",
                           "| `jitterLate` | 3 | 2 | 1 | 1 |  |  |  | `jitterEarly` |\n"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  EXPECT_EQ(text.find("`motionZero` |"), std::string::npos);
}

// No frames tell it; the share of what can be told is beside the share of all.
TEST(DoctorConfusions, CountWhatSoundFramesShowApart) {
  std::vector<JudgedCase> cases = fiveCases();
  const auto add = [&](const std::vector<Fault>& faults, const std::vector<std::string>& named) {
    cases.push_back(judgedCase(faults, named));
    cases.back().isOpen = true;
  };
  add({Fault::MipBiasMissing}, {});
  add({Fault::MipBiasLeftOn}, {});
  add({Fault::JitterLate, Fault::MipBiasLeftOn}, {"jitterLate"});
  add({Fault::InterfaceJittered}, {}); // with a camera that pans
  add({Fault::InterfaceJittered}, {});
  cases.back().tried.camera = "still";
  const auto addHalf = [&](Fault fault, const std::vector<std::string>& named) {
    add({fault}, named);
    cases.back().tried.isHalf = true;
  };
  addHalf(Fault::JitterOutside, {});
  addHalf(Fault::JitterMean, {});
  addHalf(Fault::JitterHalved, {"jitterHalved"});
  const std::string text = doctorConfusions(cases);
  for (const char* part :
       {"| All of these, and into captures | 7 | 6 | 16.7 % | 16.7 % | 66.7 % |",
        "| The same, but for what sound frames show as well | 4 | 3 | 33.3 % | 33.3 % | 33.3 % |",
        "| At half strength | 3 | 3 | 33.3 % |",
        "| The same, but for what sound frames show as well | 1 | 1 | 100.0 % |",
        "Of the 1 of them without what sound frames show as well both are named in 0.0 %, one of them in "
        "100.0 %"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

TEST(DoctorConfusions, SayWhatIsFoundOfPresets) {
  std::vector<JudgedCase> cases = fiveCases();
  for (const char* preset : {"balanced", "godot", "ue4"}) {
    cases.push_back(judgedCase({}, {}, false));
    cases.back().tried.preset = preset;
  }
  cases[6].named = {"dilatesFarthest"};
  const std::string text = doctorConfusions(cases);
  EXPECT_NE(text.find("Nothing is found of `balanced`, `ue4`."), std::string::npos) << text;
  EXPECT_NE(text.find("| `godot` | `dilatesFarthest` | `builtin:fan` with `pan` |"), std::string::npos)
      << text;
  EXPECT_NE(text.find("Of 1 healthy sequences"), std::string::npos) << "they are counted apart";
}

TEST(DoctorConfusions, CountPairsApartThatShowByThemselves) {
  std::vector<JudgedCase> cases = fiveCases();
  EXPECT_EQ(doctorConfusions(cases).find("of them whose faults"), std::string::npos) << "motionZero alone";
  cases.push_back(judgedCase({Fault::MotionZero}, {"motionZero"}));
  cases.push_back(judgedCase({Fault::MotionZero, Fault::JitterLate}, {"motionZero", "jitterLate"}));
  cases.push_back(judgedCase({Fault::MotionZero, Fault::DepthLinear}, {"motionZero"}));
  cases.back().isOpen = true;
  const std::string text = doctorConfusions(cases);
  for (const char* part :
       {"Of 3 pairs of faults of two parts both are named in 33.3 %, one of them in 66.7 %; where not both "
        "are, "
        "the rest is said not to be decided in 50.0 %.",
        "Of the 2 of them whose faults are each named first by themselves in the same frames both are named "
        "in "
        "50.0 %, one of them in 50.0 %; where not both are, the rest is said not to be decided in 0.0 %."})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

TEST(DoctorConfusions, NameHealthyFramesInWhichSomethingIsFound) {
  EXPECT_NE(doctorConfusions({judgedCase({}, {"motionZero"}, false)})
                .find("in 1: `motionZero` in `builtin:fan` with `pan`"),
            std::string::npos);
}

} // namespace taa
