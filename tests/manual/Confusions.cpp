#include "tests/manual/Confusions.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <iterator>
#include <ostream>
#include <sstream>

namespace taa {

namespace {

std::string confusionPercent(double share) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%.1f %%", 100.0 * share);
  return text.data();
}

const VerdictKindInfo& verdictKindInfo(VerdictKind kind) {
  return kVerdictKinds[static_cast<std::size_t>(kind)];
}

bool isFault(const JudgedLabel& entry) {
  return entry.label.kind != VerdictKind::None;
}

bool isTried(const JudgedLabel& entry) {
  return isFault(entry) && entry.remedy.pixelBefore > 0.0;
}

bool isCorrected(const JudgedLabel& entry) {
  return !entry.remedy.changes.empty() && entry.remedy.pixelAfter < entry.remedy.pixelBefore;
}

template <typename IsRight>
double shareOf(const std::vector<JudgedLabel>& judged, IsRight isRight) {
  if (judged.empty()) return 0.0;
  return static_cast<double>(std::ranges::count_if(judged, isRight)) / static_cast<double>(judged.size());
}

template <typename IsWanted>
std::vector<JudgedLabel> labelsWhere(const std::vector<JudgedLabel>& judged, IsWanted isWanted) {
  std::vector<JudgedLabel> wanted;
  std::ranges::copy_if(judged, std::back_inserter(wanted), isWanted);
  return wanted;
}

void addConfusions(std::ostream& out, const std::vector<JudgedLabel>& judged) {
  out << "| said |";
  for (const VerdictKindInfo& info : kVerdictKinds) out << " " << info.id << " |";
  out << " stage |\n|---|";
  for (std::size_t column = 0; column <= kVerdictKinds.size(); ++column) out << "---|";
  out << "\n";
  for (const VerdictKindInfo& said : kVerdictKinds) {
    const std::vector<JudgedLabel> ofKind =
        labelsWhere(judged, [&](const JudgedLabel& entry) { return entry.label.kind == said.kind; });
    if (ofKind.empty()) continue;
    out << "| " << said.label << " |";
    for (const VerdictKindInfo& named : kVerdictKinds) {
      const auto count =
          std::ranges::count_if(ofKind, [&](const JudgedLabel& entry) { return entry.kind == named.kind; });
      out << " " << (count > 0 ? std::to_string(count) : "") << " |";
    }
    out << " " << confusionPercent(sharesRight(ofKind).stage) << " |\n";
  }
}

std::string labelPlaceCells(const VerdictLabel& label) {
  std::ostringstream out;
  out << "| " << label.scene << " | " << label.preset << " | " << label.frame << " | " << label.pixel.x
      << ", " << label.pixel.y << " | " << label.why << " | ";
  return out.str();
}

std::string labelStagesText(const std::vector<Stage>& stages) {
  std::string text;
  for (const Stage stage : stages)
    text.append(text.empty() ? "" : " or ").append("`").append(stageInfo(stage).id).append("`");
  return text;
}

void addMistakes(std::ostream& out, const std::vector<JudgedLabel>& judged) {
  out << "| scene | preset | frame | pixel | what is seen | said | verdict "
         "|\n|---|---|---|---|---|---|---|\n";
  for (const JudgedLabel& entry : judged)
    if (!entry.isKindRight() || !entry.isStageRight())
      out << labelPlaceCells(entry.label) << verdictKindInfo(entry.label.kind).id << ", "
          << labelStagesText(entry.label.stages) << " | " << verdictKindInfo(entry.kind).id << ", "
          << labelStagesText({entry.stage}) << " |\n";
}

void addCorrected(std::ostream& out, const std::vector<JudgedLabel>& judged) {
  out << "| said | tried | the first lowers the error | it does not | nothing that was tried mends it "
         "|\n|---|---|---|---|---|\n";
  for (const VerdictKindInfo& said : kVerdictKinds) {
    const std::vector<JudgedLabel> tried = labelsWhere(
        judged, [&](const JudgedLabel& entry) { return isTried(entry) && entry.label.kind == said.kind; });
    if (tried.empty()) continue;
    const auto all = static_cast<std::ptrdiff_t>(tried.size());
    const auto corrected = std::ranges::count_if(tried, isCorrected);
    const auto none =
        std::ranges::count_if(tried, [](const JudgedLabel& entry) { return entry.remedy.changes.empty(); });
    out << "| " << said.label << " | " << all << " | " << corrected << " | " << all - corrected - none
        << " | " << none << " |\n";
  }
}

void addUnmended(std::ostream& out, const std::vector<JudgedLabel>& judged) {
  out << "| scene | preset | frame | pixel | what is seen | first remedy |\n|---|---|---|---|---|---|\n";
  for (const JudgedLabel& entry : judged) {
    if (!isTried(entry) || isCorrected(entry)) continue;
    const bool isTold = !entry.remedy.changes.empty();
    out << labelPlaceCells(entry.label) << (isTold ? "`" + entry.remedy.changes + "`" : "none") << " |\n";
  }
}

std::string firstRemediesText(const VerdictShares& shares) {
  if (shares.tried == 0) return "Remedies have not been tried on them.";
  return "Remedies were tried on " + std::to_string(shares.tried) +
         " of these; the first lowers the pixel's error in " + confusionPercent(shares.corrected) + ".";
}

} // namespace

VerdictShares sharesRight(const std::vector<JudgedLabel>& judged) {
  const auto isKindRight = [](const JudgedLabel& entry) { return entry.isKindRight(); };
  const auto isStageRight = [](const JudgedLabel& entry) { return entry.isStageRight(); };
  const std::vector<JudgedLabel> faults = labelsWhere(judged, isFault);
  VerdictShares shares;
  shares.kind = shareOf(judged, isKindRight);
  shares.stage = shareOf(judged, isStageRight);
  shares.faultsKind = shareOf(faults, isKindRight);
  shares.faultsStage = shareOf(faults, isStageRight);
  const std::vector<JudgedLabel> tried = labelsWhere(judged, isTried);
  shares.tried = tried.size();
  shares.corrected = shareOf(tried, isCorrected);
  return shares;
}

std::string confusionsText(const std::vector<JudgedLabel>& judged) {
  const VerdictShares shares = sharesRight(judged);
  std::ostringstream out;
  out << "\nThe verdict names the kind right in " << confusionPercent(shares.kind) << " of " << judged.size()
      << " labelled pixels and the stage in " << confusionPercent(shares.stage)
      << "; of those with something wrong the kind in " << confusionPercent(shares.faultsKind)
      << " and the stage in " << confusionPercent(shares.faultsStage) << ". " << firstRemediesText(shares)
      << " The rules of verdicts were mended by the same labels: of other pixels the shares may be lower.\n\n"
         "Rows are what was said, columns what verdicts name; the last column is the share of right "
         "stages.\n\n";
  addConfusions(out, judged);
  out << "\n## Where the verdict is another\n\n";
  addMistakes(out, judged);
  if (shares.tried == 0) return out.str();
  out << "\n## What the first remedy does\n\nThe error is that of the frame itself, with the shot resolved "
         "from its start with the remedy.\n\n";
  addCorrected(out, judged);
  out << "\n## Where the first remedy does not lower the error\n\n";
  addUnmended(out, judged);
  return out.str();
}

} // namespace taa
