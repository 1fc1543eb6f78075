#include "tests/support/verdicts/VerdictLabels.h"

#include "core/base/Error.h"
#include "tests/support/Paths.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string_view>
#include <utility>

namespace taa::test {

namespace {

constexpr std::string_view kHeading = "scene,preset,frame,x,y,kind,stages,why";
constexpr std::size_t kColumns = 8;

std::vector<std::string> splitAt(const std::string& text, char separator, std::size_t most) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t at = text.find(separator); at != std::string::npos && parts.size() + 1 < most;
       at = text.find(separator, begin)) {
    parts.push_back(text.substr(begin, at - begin));
    begin = at + 1;
  }
  parts.push_back(text.substr(begin));
  return parts;
}

VerdictKind kindNamed(const std::string& id, const std::string& place) {
  for (const VerdictKindInfo& info : kVerdictKinds)
    if (info.id == id) return info.kind;
  throw Error(place + ": there is no kind of verdict \"" + id + "\"");
}

Stage stageNamed(const std::string& id, const std::string& place) {
  for (const StageInfo& info : kStages)
    if (info.id == id) return info.stage;
  throw Error(place + ": there is no stage \"" + id + "\"");
}

int numberIn(const std::string& text, const std::string& place) {
  if (text.empty() || !std::ranges::all_of(text, [](char digit) { return digit >= '0' && digit <= '9'; }))
    throw Error(place + ": \"" + text + "\" is no number");
  return std::stoi(text);
}

VerdictLabel labelOf(const std::string& line, const std::string& place) {
  const std::vector<std::string> parts = splitAt(line, ',', kColumns);
  if (parts.size() != kColumns) throw Error(place + ": " + std::string(kHeading) + " is expected");
  VerdictLabel label;
  label.scene = parts[0];
  label.preset = parts[1];
  label.frame = numberIn(parts[2], place);
  label.pixel = {numberIn(parts[3], place), numberIn(parts[4], place)};
  label.kind = kindNamed(parts[5], place);
  for (const std::string& id : splitAt(parts[6], '|', parts[6].size()))
    label.stages.push_back(stageNamed(id, place));
  label.why = parts[7];
  return label;
}

std::string percent(double share) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%.1f %%", 100.0 * share);
  return text.data();
}

const VerdictKindInfo& infoOf(VerdictKind kind) {
  return kVerdictKinds[static_cast<std::size_t>(kind)];
}

std::ptrdiff_t countOf(const std::vector<JudgedLabel>& judged, VerdictKind said, VerdictKind named) {
  return std::ranges::count_if(
      judged, [&](const JudgedLabel& entry) { return entry.label.kind == said && entry.kind == named; });
}

void addConfusions(std::ostream& out, const std::vector<JudgedLabel>& judged) {
  out << "| said |";
  for (const VerdictKindInfo& info : kVerdictKinds) out << " " << info.id << " |";
  out << " stage |\n|---|";
  for (std::size_t column = 0; column <= kVerdictKinds.size(); ++column) out << "---|";
  out << "\n";
  for (const VerdictKindInfo& said : kVerdictKinds) {
    std::vector<JudgedLabel> ofKind;
    std::ranges::copy_if(judged, std::back_inserter(ofKind),
                         [&](const JudgedLabel& entry) { return entry.label.kind == said.kind; });
    out << "| " << said.label << " |";
    for (const VerdictKindInfo& named : kVerdictKinds) {
      const std::ptrdiff_t count = countOf(ofKind, said.kind, named.kind);
      out << " " << (count > 0 ? std::to_string(count) : "") << " |";
    }
    out << " " << (ofKind.empty() ? "" : percent(sharesRight(ofKind).stage)) << " |\n";
  }
}

std::string stagesText(const std::vector<Stage>& stages) {
  std::string text;
  for (const Stage stage : stages)
    text.append(text.empty() ? "" : " or ").append("`").append(stageInfo(stage).id).append("`");
  return text;
}

void addMistakes(std::ostream& out, const std::vector<JudgedLabel>& judged) {
  out << "| scene | preset | frame | pixel | what is seen | said | verdict "
         "|\n|---|---|---|---|---|---|---|\n";
  for (const JudgedLabel& entry : judged) {
    if (entry.isKindRight() && entry.isStageRight()) continue;
    const VerdictLabel& label = entry.label;
    out << "| " << label.scene << " | " << label.preset << " | " << label.frame << " | " << label.pixel.x
        << ", " << label.pixel.y << " | " << label.why << " | " << infoOf(label.kind).id << ", "
        << stagesText(label.stages) << " | " << infoOf(entry.kind).id << ", " << stagesText({entry.stage})
        << " |\n";
  }
}

} // namespace

bool JudgedLabel::isStageRight() const {
  return std::ranges::find(label.stages, stage) != label.stages.end();
}

std::vector<VerdictLabel> verdictLabelsFrom(const std::string& text, const std::string& place) {
  std::vector<VerdictLabel> labels;
  std::istringstream lines(text);
  std::string line;
  if (!std::getline(lines, line) || line != kHeading)
    throw Error(place + ": the first line must be \"" + std::string(kHeading) + "\"");
  for (int number = 2; std::getline(lines, line); ++number)
    labels.push_back(labelOf(line, place + ":" + std::to_string(number)));
  return labels;
}

std::vector<VerdictLabel> verdictLabels() {
  const std::string path = (rootFolder() / "tests/support/verdicts/labels.csv").string();
  std::ifstream file(path);
  if (!file) throw Error("cannot open " + path);
  return verdictLabelsFrom({std::istreambuf_iterator<char>(file), {}}, path);
}

VerdictShares sharesRight(const std::vector<JudgedLabel>& judged) {
  VerdictShares shares;
  double faults = 0.0;
  for (const JudgedLabel& entry : judged) {
    const bool isFault = entry.label.kind != VerdictKind::None;
    faults += isFault ? 1.0 : 0.0;
    shares.kind += entry.isKindRight() ? 1.0 : 0.0;
    shares.stage += entry.isStageRight() ? 1.0 : 0.0;
    shares.faultsStage += isFault && entry.isStageRight() ? 1.0 : 0.0;
  }
  const auto count = static_cast<double>(judged.size());
  if (count > 0.0) shares.kind /= count, shares.stage /= count;
  if (faults > 0.0) shares.faultsStage /= faults;
  return shares;
}

std::string confusionsPage(const std::vector<JudgedLabel>& judged) {
  const VerdictShares shares = sharesRight(judged);
  std::ostringstream out;
  out << "# Verdicts against what people see\n\n"
      << judged.size() << " pixels of the built-in scenes at " << kLabelledSize.x << " × " << kLabelledSize.y
      << ", each with what is wrong there and which stage let it happen, said by looking at the frames "
         "beside the reference. The verdict names the kind right in "
      << percent(shares.kind) << " of them and the stage in " << percent(shares.stage)
      << " (of those with something wrong in " << percent(shares.faultsStage)
      << "). `TAA_WRITE_VERDICTS=1 build/dev/bin/taa_gl_tests --gtest_filter='VerdictLabels.*'` writes this "
         "page from the table `tests/support/verdicts/labels.csv`; what is changed by hand here is lost.\n\n"
         "Rows are what was said, columns what verdicts name; the last column is the share of right "
         "stages.\n\n";
  addConfusions(out, judged);
  out << "\nWhere the verdict is another:\n\n";
  addMistakes(out, judged);
  return out.str();
}

} // namespace taa::test
