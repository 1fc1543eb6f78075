#include "tests/manual/DoctorCases.h"

#include "core/base/Error.h"
#include "core/base/Files.h"
#include "tests/support/Paths.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <sstream>
#include <utility>

namespace taa {

namespace {

constexpr std::string_view kCasesHeading =
    "source,camera,size,frames,preset,faults,strength,shows,named,same,open";
constexpr std::size_t kCaseColumns = 11;

/// None of an empty text.
std::vector<std::string> caseParts(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream all(text);
  for (std::string part; std::getline(all, part, separator);) parts.push_back(part);
  if (text.ends_with(separator)) parts.emplace_back();
  return parts;
}

std::string caseWords(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text.append(text.empty() ? "" : "|").append(word);
  return text;
}

int caseNumberIn(const std::string& text, const std::string& place) {
  const auto isDigit = [](char letter) { return letter >= '0' && letter <= '9'; };
  if (text.empty() || text.size() > 6 || !std::ranges::all_of(text, isDigit))
    throw Error(place + ": \"" + text + "\" is no number");
  return std::stoi(text);
}

bool caseSwitchIn(const std::string& text, const std::string& place) {
  if (text != "yes" && text != "no") throw Error(place + ": \"" + text + "\" is neither yes nor no");
  return text == "yes";
}

Fault caseFaultIn(const std::string& id, const std::string& place) {
  try {
    return faultInfo(id).fault;
  } catch (const Error& error) {
    throw Error(place + ": " + error.what());
  }
}

DoctorCase caseOf(const std::vector<std::string>& parts, const std::string& place) {
  DoctorCase out{parts[0], parts[1], {}, caseNumberIn(parts[3], place), {}, parts[6] == "half", parts[4]};
  const std::size_t cross = std::min(parts[2].find('x'), parts[2].size());
  out.sizePx = {caseNumberIn(parts[2].substr(0, cross), place),
                caseNumberIn(parts[2].substr(std::min(cross + 1, parts[2].size())), place)};
  for (const std::string& id : caseParts(parts[5], '|')) out.faults.push_back(caseFaultIn(id, place));
  if (!out.isHalf && parts[6] != "full")
    throw Error(place + ": \"" + parts[6] + "\" is neither full nor half");
  return out;
}

/// Half of a wrong factor is another one, and jitter that is half applied is reported twice too large.
bool saysHalf(const std::string& name, Fault fault) {
  if (fault == Fault::JitterNotApplied) return name == faultInfo(Fault::JitterDoubled).id;
  return name == "motionScaled" && (fault == Fault::MotionDoubled || fault == Fault::MotionHalved);
}

bool saysFault(const std::string& name, Fault fault, const JudgedCase& judged) {
  return name == faultInfo(fault).id || (judged.tried.isHalf && saysHalf(name, fault)) ||
         std::ranges::find(judged.same, name) != judged.same.end();
}

} // namespace

bool isNamed(Fault fault, const JudgedCase& judged) {
  return std::ranges::any_of(judged.named,
                             [&](const std::string& name) { return saysFault(name, fault, judged); });
}

CaseOutcome outcomeOf(const JudgedCase& judged) {
  if (judged.named.empty()) return judged.isOpen ? CaseOutcome::Undecided : CaseOutcome::Silent;
  const auto isSaid = [&](const std::string& name) {
    return std::ranges::any_of(judged.tried.faults,
                               [&](Fault fault) { return saysFault(name, fault, judged); });
  };
  if (isSaid(judged.named.front())) return CaseOutcome::First;
  return std::ranges::any_of(judged.named, isSaid) ? CaseOutcome::Later : CaseOutcome::Wrong;
}

std::vector<JudgedCase> judgedCasesFrom(const std::string& text, const std::string& place) {
  std::istringstream lines(text);
  std::string line;
  if (!std::getline(lines, line) || line != kCasesHeading)
    throw Error(place + ": the first line must be \"" + std::string(kCasesHeading) + "\"");
  std::vector<JudgedCase> out;
  for (int number = 2; std::getline(lines, line); ++number) {
    const std::string where = place + ":" + std::to_string(number);
    const std::vector<std::string> parts = caseParts(line, ',');
    if (parts.size() != kCaseColumns) throw Error(where + ": " + std::string(kCasesHeading) + " is expected");
    out.push_back({caseOf(parts, where), caseSwitchIn(parts[7], where), caseParts(parts[8], '|'),
                   caseParts(parts[9], '|'), caseSwitchIn(parts[10], where)});
  }
  return out;
}

std::string judgedCasesHead() {
  return std::string(kCasesHeading) + "\n";
}

std::string judgedCaseText(const JudgedCase& judged) {
  const DoctorCase& tried = judged.tried;
  std::vector<std::string> faults;
  for (const Fault fault : tried.faults) faults.emplace_back(faultInfo(fault).id);
  std::ostringstream out;
  out << tried.source << ',' << tried.camera << ',' << tried.sizePx.x << 'x' << tried.sizePx.y << ','
      << tried.frames << ',' << tried.preset << ',' << caseWords(faults) << ','
      << (tried.isHalf ? "half" : "full") << ',' << (judged.shows ? "yes" : "no") << ','
      << caseWords(judged.named) << ',' << caseWords(judged.same) << ',' << (judged.isOpen ? "yes" : "no")
      << '\n';
  return out.str();
}

std::vector<JudgedCase> judgedCases() {
  const std::filesystem::path file = test::rootFolder() / kDoctorCasesFile;
  return judgedCasesFrom(readFile(file), file.string());
}

} // namespace taa
