#include "tests/manual/CaseJudge.h"

#include "core/base/Error.h"
#include "core/doctor/examination/Doctor.h"
#include "core/doctor/frames/ShownDifference.h"
#include "core/settings/Presets.h"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>

namespace taa {

namespace {

using doctor::Diagnosis;
using doctor::DoctorFrame;
using doctor::ShownDifference;

/// The part of the table that a question is of, by its first word; none: of color or the resolve.
std::optional<FaultPart> partOfQuestion(const std::string& question) {
  if (question.starts_with("Jitter")) return FaultPart::Jitter;
  if (question.starts_with("Motion")) return FaultPart::Motion;
  if (question.starts_with("Depth")) return FaultPart::Depth;
  return {};
}

bool isOfPart(const std::string& question, FaultPart part) {
  const std::optional<FaultPart> asked = partOfQuestion(question);
  return asked ? *asked == part : part == FaultPart::Color || part == FaultPart::Resolve;
}

/// Questions that name faults are open about these alone.
bool leavesOpen(const doctor::Undecided& open, Fault fault) {
  if (open.faults.empty()) return isOfPart(open.question, faultInfo(fault).part);
  return std::ranges::find(open.faults, fault) != open.faults.end();
}

bool isOpenIn(const Diagnosis& diagnosis, Fault fault) {
  return std::ranges::any_of(diagnosis.parts.undecided(),
                             [&](const doctor::Undecided& open) { return leavesOpen(open, fault); });
}

/// Of the fault, or of all of several that are not named.
bool isOpenIn(const Diagnosis& diagnosis, const JudgedCase& judged) {
  std::vector<Fault> asked = judged.tried.faults;
  if (asked.size() > 1) std::erase_if(asked, [&](Fault fault) { return isNamed(fault, judged); });
  return std::ranges::all_of(asked, [&](Fault fault) { return isOpenIn(diagnosis, fault); });
}

bool isFound(const Diagnosis& diagnosis, const std::string& id) {
  return std::ranges::find(diagnosis.findings, id, &doctor::Finding::id) != diagnosis.findings.end();
}

bool isOneOf(const std::vector<Fault>& faults, const std::string& id) {
  return std::ranges::any_of(faults, [&](Fault fault) { return faultInfo(fault).id == id; });
}

/// Of consecutive frames.
ShownDifference shownBetween(const std::vector<DoctorFrame>& faulty, const std::vector<DoctorFrame>& sound) {
  ShownDifference out;
  const auto read = [](const std::vector<DoctorFrame>& frames, std::size_t i) {
    return doctor::ReadFrame{frames[i], i == 0 ? nullptr : &frames[i - 1]};
  };
  for (std::size_t i = 0; i < faulty.size(); ++i) out.add(read(faulty, i), read(sound, i));
  return out;
}

/// Those of the preset, of this program's own none.
Settings presetSettings(const std::string& id) {
  if (id.empty()) return {};
  const auto found = std::ranges::find(builtinPresets(), id, &Preset::id);
  if (found == builtinPresets().end()) throw Error("there is no preset \"" + id + "\"");
  return found->settings;
}

/// Those of the source as healthy as they are, with the faults.
Settings faultySettings(const DoctorCase& tried) {
  Settings out = presetSettings(tried.preset);
  for (const Fault fault : tried.faults)
    if (!tried.isHalf)
      inject(fault, out);
    else if (!injectHalf(fault, out))
      throw Error("there is no half of " + std::string(faultInfo(fault).id));
  return out;
}

/// The fault of the table that has the id; none: it is a name of the doctor's own.
std::optional<Fault> tableFault(const std::string& id) {
  const auto found = std::ranges::find(faultTable(), std::string_view(id), &FaultInfo::id);
  if (found == faultTable().end()) return {};
  return found->fault;
}

} // namespace

void CaseJudge::open(const PlannedCase& planned, const Progress& progress) {
  const DoctorCase& tried = planned.tried;
  DoctorCase healthy = tried;
  healthy.faults.clear();
  healthy.isHalf = false;
  healthy.preset.clear();
  if (opened_ && opened_->path == planned.path && opened_->tried == healthy) return;
  opened_.reset();
  healthy_.clear();
  source_ = doctor::openForDoctor({planned.path, tried.camera, tried.sizePx, {}}, progress);
  healthy_ = framesOf(healthy);
  ofHealthy_ = diagnosisOf(healthy_, progress);
  opened_ = {healthy, planned.path};
}

CaseJudge::Frames CaseJudge::framesOf(const DoctorCase& tried) {
  doctor::drawWith(faultySettings(tried), *source_);
  const doctor::FrameReader read = doctor::readerOf(*source_);
  Frames out;
  for (int frame = 0; frame < std::min(tried.frames, source_->frameCount); ++frame)
    out.push_back(read(frame));
  return out;
}

Diagnosis CaseJudge::diagnosisOf(const Frames& frames, const Progress& progress) const {
  doctor::Examination examination = doctor::examinationOf(*source_, static_cast<int>(frames.size()));
  examination.read = [&frames](int frame) { return frames.at(static_cast<std::size_t>(frame)); };
  return doctor::examine(examination, progress);
}

std::vector<std::string> CaseJudge::sameAs(const Frames& frames, const JudgedCase& judged) {
  const ShownDifference whole = shownBetween(frames, healthy_);
  std::vector<std::string> out;
  for (const std::string& id : judged.named) {
    const std::optional<Fault> fault = tableFault(id);
    if (!fault || isOneOf(judged.tried.faults, id)) continue;
    DoctorCase other = judged.tried;
    other.faults = {*fault};
    other.isHalf = false;
    if (shownBetween(frames, framesOf(other)).isSmallBeside(whole)) out.push_back(id);
  }
  return out;
}

bool CaseJudge::showsBeside(const Frames& frames, const DoctorCase& tried) {
  return std::ranges::all_of(tried.faults, [&](Fault fault) {
    DoctorCase without = tried;
    std::erase(without.faults, fault);
    return shownBetween(frames, without.faults.empty() ? healthy_ : framesOf(without)).shows();
  });
}

JudgedCase CaseJudge::judge(const PlannedCase& planned, const Progress& progress) {
  open(planned, progress);
  JudgedCase out;
  out.tried = planned.tried;
  if (out.tried.faults.empty()) {
    const Diagnosis diagnosis =
        out.tried.preset.empty() ? ofHealthy_ : diagnosisOf(framesOf(out.tried), progress);
    for (const doctor::Finding& finding : diagnosis.findings) out.named.push_back(finding.id);
    return out;
  }
  const Frames frames = framesOf(planned.tried);
  const Diagnosis diagnosis = diagnosisOf(frames, progress);
  out.shows = showsBeside(frames, planned.tried);
  for (const doctor::Finding& finding : diagnosis.findings) {
    if (isFound(ofHealthy_, finding.id) && !isOneOf(planned.tried.faults, finding.id)) continue;
    out.named.push_back(finding.id);
    // What it is not told from stands behind it.
    out.named.insert(out.named.end(), finding.alike.begin(), finding.alike.end());
  }
  out.isOpen = isOpenIn(diagnosis, out);
  if (out.tried.faults.size() == 1 && out.shows) out.same = sameAs(frames, out);
  return out;
}

} // namespace taa
