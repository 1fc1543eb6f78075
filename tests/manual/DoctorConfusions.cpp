#include "tests/manual/DoctorConfusions.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <iterator>
#include <map>
#include <ostream>
#include <set>
#include <sstream>
#include <tuple>
#include <utility>

namespace taa {

namespace {

using Cases = std::vector<JudgedCase>;

bool isCaptured(const JudgedCase& judged) {
  return !judged.tried.source.starts_with("builtin:");
}

Cases casesWhere(const Cases& judged, const std::function<bool(const JudgedCase&)>& isWanted) {
  Cases out;
  std::ranges::copy_if(judged, std::back_inserter(out), isWanted);
  return out;
}

std::string caseShare(std::size_t count, std::size_t of) {
  if (of == 0) return "none";
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%.1f %%",
                100.0 * static_cast<double>(count) / static_cast<double>(of));
  return text.data();
}

std::string caseCount(std::size_t count) {
  return count == 0 ? std::string() : std::to_string(count);
}

/// "a, b, c" in their order, each once, between backticks.
std::string listOf(const Cases& judged, const std::function<std::string(const JudgedCase&)>& word) {
  std::set<std::string> seen;
  std::string text;
  for (const JudgedCase& one : judged)
    if (const std::string name = word(one); seen.insert(name).second)
      text.append(text.empty() ? "`" : ", `").append(name).append("`");
  return text;
}

std::string triedSizeText(const DoctorCase& tried) {
  return std::to_string(tried.sizePx.x) + " × " + std::to_string(tried.sizePx.y);
}

void addTried(std::ostream& out, const Cases& judged) {
  const Cases drawn = casesWhere(judged, [](const JudgedCase& one) { return !isCaptured(one); });
  const Cases captured = casesWhere(judged, isCaptured);
  if (!drawn.empty())
    out << "Scenes: " << listOf(drawn, [](const JudgedCase& one) { return one.tried.source; })
        << ", with cameras " << listOf(drawn, [](const JudgedCase& one) { return one.tried.camera; }) << ", "
        << triedSizeText(drawn.front().tried) << ", " << drawn.front().tried.frames << " frames each. ";
  if (!captured.empty())
    out << "Captures: " << listOf(captured, [](const JudgedCase& one) { return one.tried.source; }) << ". ";
}

OutcomeCounts countsOf(const Cases& judged) {
  OutcomeCounts out;
  for (const JudgedCase& one : judged) out.add(one);
  return out;
}

void addShares(std::ostream& out, const std::string& what, const Cases& judged) {
  if (judged.empty()) return;
  const OutcomeCounts counts = countsOf(judged);
  const auto cell = [&](CaseOutcome outcome) { return caseShare(counts.count(outcome), counts.shown()); };
  out << "| " << what << " | " << counts.cases << " | " << counts.shown() << " | " << cell(CaseOutcome::First)
      << " | " << cell(CaseOutcome::Later) << " | " << cell(CaseOutcome::Undecided) << " | "
      << cell(CaseOutcome::Silent) << " | " << cell(CaseOutcome::Wrong) << " | "
      << caseShare(counts.hiddenNamed, counts.hidden) << " |\n";
}

bool isSingle(const JudgedCase& one) {
  return one.tried.faults.size() == 1 && !one.tried.isHalf;
}

/// Sound frames of other content are the same: a texture that is drawn too sharp is one with more detail, and
/// an interface with jitter, where nothing moves, is a sign that stands in the world. Half of a fault may be
/// no fault of another integration: a wide filter wants jitter of more than half a pixel, and a longer
/// sequence may start with frames of any small mean.
bool showsInSoundFrames(const JudgedCase& one) {
  return std::ranges::any_of(one.tried.faults, [&](Fault fault) {
    return fault == Fault::MipBiasMissing || fault == Fault::MipBiasLeftOn ||
           (fault == Fault::InterfaceJittered && one.tried.camera == "still") ||
           (one.tried.isHalf && (fault == Fault::JitterOutside || fault == Fault::JitterMean));
  });
}

void addAllShares(std::ostream& out, const Cases& judged) {
  out << "| one fault | cases | shown | named first | named later | not decided | nothing said | wrong name "
         "| not "
         "shown, and named |\n|---|---|---|---|---|---|---|---|---|\n";
  for (const FaultPart part :
       {FaultPart::Jitter, FaultPart::Motion, FaultPart::Depth, FaultPart::Color, FaultPart::Resolve})
    addShares(out, std::string(faultPartLabel(part)), casesWhere(judged, [&](const JudgedCase& one) {
                return isSingle(one) && !isCaptured(one) && faultInfo(one.tried.faults.front()).part == part;
              }));
  addShares(out, "All of these, and into captures", casesWhere(judged, isSingle));
  addShares(
      out, "The same, but for what sound frames show as well",
      casesWhere(judged, [](const JudgedCase& one) { return isSingle(one) && !showsInSoundFrames(one); }));
  addShares(out, "At half strength",
            casesWhere(judged, [](const JudgedCase& one) { return one.tried.isHalf; }));
  addShares(
      out, "The same, but for what sound frames show as well",
      casesWhere(judged, [](const JudgedCase& one) { return one.tried.isHalf && !showsInSoundFrames(one); }));
  addShares(out, "Into captures",
            casesWhere(judged, [](const JudgedCase& one) { return isSingle(one) && isCaptured(one); }));
}

void addHealthy(std::ostream& out, const Cases& judged) {
  const Cases healthy = casesWhere(
      judged, [](const JudgedCase& one) { return one.tried.faults.empty() && one.tried.preset.empty(); });
  const Cases named = casesWhere(healthy, [](const JudgedCase& one) { return !one.named.empty(); });
  out << "Of " << healthy.size() << " healthy sequences something is found in " << named.size();
  for (const JudgedCase& one : named)
    out << (&one == named.data() ? ": " : ", ") << "`" << one.named.front() << "` in `" << one.tried.source
        << "`" << (one.tried.camera.empty() ? "" : " with `" + one.tried.camera + "`");
  out << ". ";
}

/// Which of two faults are named.
struct PairCounts {
  std::size_t pairs = 0, both = 0, one = 0;
  std::size_t open = 0; ///< not both, and what is not named is said not to be decided

  void add(const JudgedCase& pair) {
    const auto named =
        std::ranges::count_if(pair.tried.faults, [&](Fault fault) { return isNamed(fault, pair); });
    ++pairs;
    if (named == 2) ++both;
    if (named == 1) ++one;
    if (named < 2 && pair.isOpen) ++open;
  }
  std::string text() const {
    const std::string text =
        "both are named in " + caseShare(both, pairs) + ", one of them in " + caseShare(one, pairs);
    if (both == pairs) return text;
    return text + "; where not both are, the rest is said not to be decided in " +
           caseShare(open, pairs - both);
  }
};

/// Source, camera and fault.
using ToldAlone = std::set<std::tuple<std::string, std::string, Fault>>;

/// Faults that are named first where they are the only one.
ToldAlone toldAlone(const Cases& judged) {
  ToldAlone out;
  for (const JudgedCase& one : judged)
    if (isSingle(one) && one.shows && outcomeOf(one) == CaseOutcome::First)
      out.emplace(one.tried.source, one.tried.camera, one.tried.faults.front());
  return out;
}

/// What does not show by itself cannot show beside something else: such pairs are counted apart.
void addPairs(std::ostream& out, const Cases& judged) {
  const ToldAlone alone = toldAlone(judged);
  PairCounts all, showing, told;
  for (const JudgedCase& one : judged) {
    if (one.tried.faults.size() != 2 || !one.shows) continue;
    all.add(one);
    if (!showsInSoundFrames(one)) showing.add(one);
    if (std::ranges::all_of(one.tried.faults, [&](Fault fault) {
          return alone.contains({one.tried.source, one.tried.camera, fault});
        }))
      told.add(one);
  }
  if (all.pairs == 0) return;
  out << "Of " << all.pairs << " pairs of faults of two parts " << all.text() << ". ";
  if (showing.pairs < all.pairs)
    out << "Of the " << showing.pairs << " of them without what sound frames show as well " << showing.text()
        << ". ";
  if (told.pairs > 0)
    out << "Of the " << told.pairs
        << " of them whose faults are each named first by themselves in the same frames " << told.text()
        << ". ";
}

/// "`motionScaled` 3, `jitterLate`": first names of those that are wrong, the most frequent first.
std::string wrongNames(const Cases& judged) {
  std::map<std::string, int> counts;
  for (const JudgedCase& one : judged)
    if (outcomeOf(one) == CaseOutcome::Wrong || outcomeOf(one) == CaseOutcome::Later)
      ++counts[one.named.front()];
  std::vector<std::pair<std::string, int>> names(counts.begin(), counts.end());
  std::ranges::stable_sort(names, std::greater(), [](const auto& name) { return name.second; });
  std::string text;
  for (const auto& [name, count] : names)
    text += (text.empty() ? "`" : ", `") + name + "`" + (count > 1 ? " " + std::to_string(count) : "");
  return text;
}

void addFault(std::ostream& out, const FaultInfo& info, const Cases& judged) {
  const Cases ofFault = casesWhere(
      judged, [&](const JudgedCase& one) { return isSingle(one) && one.tried.faults.front() == info.fault; });
  if (ofFault.empty()) return;
  const OutcomeCounts counts = countsOf(ofFault);
  out << "| `" << info.id << "` | " << counts.cases << " | " << counts.shown();
  for (int outcome = 0; outcome < kCaseOutcomes; ++outcome)
    out << " | " << caseCount(counts.count(static_cast<CaseOutcome>(outcome)));
  out << " | " << wrongNames(ofFault) << " |\n";
}

/// What is found of frames and outputs that presets make.
void addPresets(std::ostream& out, const Cases& judged) {
  const Cases presets = casesWhere(judged, [](const JudgedCase& one) { return !one.tried.preset.empty(); });
  if (presets.empty()) return;
  const auto idOf = [](const JudgedCase& one) { return one.tried.preset; };
  std::map<std::string, std::pair<std::set<std::string>, std::set<std::string>>> found; // names, places
  std::vector<std::string> order;
  for (const JudgedCase& one : presets) {
    if (one.named.empty()) continue;
    if (!found.contains(one.tried.preset)) order.push_back(one.tried.preset);
    auto& [names, places] = found[one.tried.preset];
    for (const std::string& name : one.named) names.insert("`" + name + "`");
    places.insert("`" + one.tried.source + "` with `" + one.tried.camera + "`");
  }
  const Cases sound =
      casesWhere(presets, [&](const JudgedCase& one) { return !found.contains(one.tried.preset); });
  const auto joined = [](const std::set<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text.append(text.empty() ? "" : ", ").append(word);
    return text;
  };
  out << "\nPresets as engines: frames and outputs as each makes them, without a fault. Nothing is found of "
      << listOf(sound, idOf) << ". What is found of the others is what they do:\n\n| preset | found | in |\n"
      << "|---|---|---|\n";
  for (const std::string& preset : order)
    out << "| `" << preset << "` | " << joined(found[preset].first) << " | " << joined(found[preset].second)
        << " |\n";
}

} // namespace

void OutcomeCounts::add(const JudgedCase& judged) {
  ++cases;
  if (judged.shows) {
    ++byOutcome[static_cast<std::size_t>(outcomeOf(judged))];
    return;
  }
  ++hidden;
  if (!judged.named.empty()) ++hiddenNamed;
}

std::string doctorConfusions(const std::vector<JudgedCase>& judged) {
  std::ostringstream out;
  out << "\n### How often it is right\n\n`build/dev/bin/taa_manual confusions tests/manual/doctor.csv` "
         "injects the "
         "faults of this page and writes down what the doctor says; this part is made from that file. A "
         "fault is "
         "shown where frames differ from those without it by what one sees: in jitter, or in pixels enough "
         "to "
         "be a region in depth, or in light that is not that of the frame before, read by motion and jitter, "
         "where that without the fault is; and in the output, where frames are the same. It is named first, "
         "too, where another name stands first that makes the same frames. Some faults sound frames show as "
         "well: a texture with a bias is one of more or less detail; an interface with jitter, before a "
         "camera that rests, is a sign in the world; half of a jitter beyond half a pixel is that of a wide "
         "filter, and half of a mean that of the first frames of a longer sequence. Shares are given with "
         "them and without. ";
  addTried(out, casesWhere(judged, [](const JudgedCase& one) { return one.tried.preset.empty(); }));
  addHealthy(out, judged);
  addPairs(out, judged);
  out << "Shares are of the cases that are shown, the last of those that are not.\n\n";
  addAllShares(out, judged);
  out << "\nEach fault alone, at full strength:\n\n| fault | cases | shown | named first | named later | not "
         "decided "
         "| nothing said | wrong name | named instead |\n|---|---|---|---|---|---|---|---|---|\n";
  for (const FaultInfo& info : faultTable()) addFault(out, info, judged);
  addPresets(out, judged);
  return out.str();
}

} // namespace taa
