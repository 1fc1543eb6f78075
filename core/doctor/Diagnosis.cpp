#include "core/doctor/Diagnosis.h"

#include "core/base/Say.h"

#include <cstddef>
#include <string_view>
#include <utility>

namespace taa::doctor {

namespace {

/// One sentence: what is right about a part, and what is not decided.
std::string partlyRight(std::string right, const std::string& undecided) {
  if (right.ends_with('.')) right.pop_back();
  return say<"%1; not decided: %2">(right, undecided);
}

} // namespace

void ExaminedParts::addRight(std::string part, std::string sentence) {
  const auto open = std::ranges::find(undecided_, part, &Undecided::question);
  if (open != undecided_.end()) {
    open->reason = partlyRight(std::move(sentence), open->reason);
    return;
  }
  const auto known = std::ranges::find(right_, part, &RightPart::part);
  if (known == right_.end())
    right_.push_back({std::move(part), std::move(sentence)});
  else
    known->sentence += " " + sentence;
}

void ExaminedParts::takeBack(std::string_view part) {
  std::erase_if(right_, [&](const RightPart& right) { return right.part == part; });
}

void ExaminedParts::keepRight(const ExaminedParts& earlier) {
  std::erase_if(right_, [&](RightPart& right) {
    const auto known = std::ranges::find(earlier.right_, right.part, &RightPart::part);
    if (known == earlier.right_.end()) return true;
    right.sentence = known->sentence;
    return false;
  });
}

void ExaminedParts::leaveOpen(Undecided part) {
  const auto right = std::ranges::find(right_, part.question, &RightPart::part);
  if (right != right_.end()) {
    part.reason = partlyRight(std::move(right->sentence), part.reason);
    right_.erase(right);
  }
  const auto known = std::ranges::find(undecided_, part.question, &Undecided::question);
  if (known == undecided_.end()) {
    undecided_.push_back(std::move(part));
    return;
  }
  known->reason += "; " + part.reason;
  if (known->capture != part.capture) known->capture += (known->capture.empty() ? "" : " ") + part.capture;
  // No faults: all of the part.
  if (known->faults.empty() || part.faults.empty())
    known->faults.clear();
  else
    for (const Fault fault : part.faults)
      if (std::ranges::count(known->faults, fault) == 0) known->faults.push_back(fault);
  known->isMisfit = known->isMisfit || part.isMisfit;
}

bool Diagnosis::isMisfit() const {
  return std::ranges::any_of(parts.undecided(), &Undecided::isMisfit);
}

std::string Diagnosis::lookedText() const {
  const auto firstNumber = frameNames.number(first), lastNumber = frameNames.number(first + frames - 1);
  if (firstNumber && lastNumber)
    return say<"%1 frames (numbers %2 to %3), %4 pairs compared">(frames, *firstNumber, *lastNumber, pairs);
  return say<"%1 frames, %2 pairs compared">(frames, pairs);
}

std::string Diagnosis::healthySentence() const {
  constexpr int kNamed = 4;
  if (!isMisfit()) return say<"Nothing wrong was found.">();
  std::string names;
  int count = 0;
  for (const Undecided& part : parts.undecided())
    if (part.isMisfit && ++count <= kNamed) names += (names.empty() ? "" : ", ") + part.question;
  if (count > kNamed) names = say<"%1 and %2 more">(names, count - kNamed);
  return say<"Nothing is wrong in what could be decided, but not everything fits: %1.">(names);
}

std::optional<FaultPart> partOf(const Finding& finding) {
  const auto row = std::ranges::find(faultTable(), std::string_view(finding.id), &FaultInfo::id);
  if (row != faultTable().end()) return row->part;
  const std::pair<std::string_view, FaultPart> beginnings[] = {
      {"jitter", FaultPart::Jitter}, {"motion", FaultPart::Motion}, {"depth", FaultPart::Depth}};
  for (const auto& [beginning, part] : beginnings)
    if (finding.id.starts_with(beginning)) return part;
  return {};
}

bool isRegionTold(std::string_view name, const Diagnosis& out) {
  return std::ranges::any_of(out.findings, [&](const Finding& finding) {
    return !finding.isWholePicture && std::ranges::count(finding.regions, name, &RegionPlace::name) > 0;
  });
}

bool isMotionTold(std::string_view name, const Diagnosis& out) {
  return isRegionTold(name, out) || std::ranges::any_of(out.findings, [](const Finding& finding) {
           return finding.id == kFrameMissingId ||
                  (finding.isWholePicture && partOf(finding) == FaultPart::Motion);
         });
}

void takeOutOfMotion(const std::vector<std::string>& names, std::vector<Finding>& findings,
                     const std::function<bool(const Finding&)>& mayTake) {
  std::erase_if(findings, [&](Finding& finding) {
    if (partOf(finding) != FaultPart::Motion || finding.isWholePicture || (mayTake && !mayTake(finding)))
      return false;
    const auto taken = std::erase_if(
        finding.regions, [&](const RegionPlace& place) { return std::ranges::count(names, place.name) > 0; });
    return taken > 0 && finding.regions.empty();
  });
}

Finding faultFinding(Fault fault) {
  const FaultInfo& row = faultInfo(fault);
  Finding out;
  out.id = row.id;
  out.name = row.label;
  out.symptom = row.symptom;
  return out;
}

} // namespace taa::doctor
