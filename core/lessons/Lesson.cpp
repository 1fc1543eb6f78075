// Lessons come from anywhere: nothing in them is believed before it is looked at.
#include "core/lessons/Lesson.h"

#include "core/base/EmbeddedFiles.h"
#include "core/base/Error.h"
#include "core/base/Files.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/lessons/LessonText.h"
#include "core/report/Techniques.h"
#include "core/settings/Presets.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <exception>
#include <functional>
#include <set>
#include <span>
#include <system_error>
#include <utility>

namespace taa {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kLessonFolder = "resources/lessons/", kLessonEnding = ".md";
constexpr std::string_view kHeaderBegin = "```state", kFence = "```";
constexpr std::array<std::string_view, 6> kTeachingKeys{"claim", "rung",     "task",
                                                        "hint",  "solution", "techniques"};
/// The first line of these in a step takes the place of what the step before said.
constexpr std::array<std::string_view, 5> kListKeys{"view", "probe", "plots", "hide", "pose"};
/// And of these in what the pipeline unfolds.
constexpr std::array<std::string_view, 2> kStageKeys{"set", "stage"};

/// Each once: 24 comes several times.
std::span<const std::string_view> techniqueRows() {
  static const std::vector<std::string_view> kTechniqueRows = [] {
    std::vector<std::string_view> rows;
    for (const Technique& technique : techniques()) rows.push_back(technique.row);
    rows.erase(std::ranges::unique(rows).begin(), rows.end());
    return rows;
  }();
  return kTechniqueRows;
}

/// "03-the-box.md" is "the-box": the number is its place in the course.
std::string idOf(const std::string& place) {
  std::string id = fs::path(place).stem().string();
  const std::size_t dash = id.find_first_not_of("0123456789");
  if (dash != 0 && dash != id.npos && id[dash] == '-') id.erase(0, dash + 1);
  return id;
}

/// "source000-3 psnr=21.4 flicker=0.012"
Rung rungFrom(std::string_view text) {
  const std::vector<std::string_view> words = wordsOf(text);
  if (words.size() != 3 || !words[1].starts_with("psnr=") || !words[2].starts_with("flicker="))
    throw Error(say<"expected PRESET psnr=NUMBER flicker=NUMBER">());
  std::vector<std::string_view> ids;
  for (const Preset& known : builtinPresets()) ids.push_back(known.id);
  requireName(words[0], ids, say<"preset">());
  return {.preset = std::string(words[0]),
          .psnr = numberFrom(words[1].substr(5)),
          .flicker = numberFrom(words[2].substr(8))};
}

/// A state being written: what lists were begun anew.
class StateWriter {
 public:
  StateWriter(LessonState& state, const std::string& folder) : state_(state), folder_(folder) {}

  void apply(std::string_view key, std::string_view value) {
    const bool isList = std::ranges::find(kListKeys, key) != kListKeys.end();
    if (isList && begun_.insert(std::string(key)).second) clear(key);
    const bool isOfStages = std::ranges::find(kStageKeys, key) != kStageKeys.end();
    if (isOfStages && begun_.insert("stages").second) state_.stages.clear();
    applyLessonKey(state_, key, value, folder_);
  }

 private:
  void clear(std::string_view key) {
    if (key == "view") state_.views.clear();
    if (key == "probe") state_.probes.clear();
    if (key == "plots") state_.plots.clear();
    if (key == "hide") state_.shot.filter.hidden.clear();
    if (key == "pose") state_.shot.track.reset();
  }

  LessonState& state_;
  const std::string& folder_;
  std::set<std::string> begun_;
};

/// Reads a lesson line by line.
class LessonReader {
 public:
  LessonReader(const std::string& place, const std::string& folder) : folder_(folder) {
    lesson_.id = idOf(place);
    lesson_.place = place;
    const Preset& first = builtinPresets().front();
    state_.shot.settings = {first.id, first.settings, first.settings};
    state_.shot.size = kLessonSizePx;
  }

  void read(std::string_view line, int number) {
    line_ = number;
    if (!isPlainText(line.find('\t') == line.npos ? line : withoutBlanks(line)))
      throw Error(say<"the line has bytes that are no text">());
    if (inHeader_)
      readHeader(withoutBlanks(line));
    else
      readText(line);
  }

  Lesson finish() {
    if (inHeader_) throw Error(say<"the header has no end: ``` is missing">());
    if (lesson_.title.empty()) throw Error(say<"the lesson has no title: \"# \" and its name">());
    if (lesson_.steps.empty()) throw Error(say<"the lesson has no step: \"## \" and its name">());
    endStep();
    return std::move(lesson_);
  }

  int line() const { return line_; }

 private:
  using Line = std::pair<int, std::string>;

  void readText(std::string_view line) {
    if (line.starts_with("## ")) {
      beginStep(withoutBlanks(line.substr(3)));
      return;
    }
    if (line.starts_with("# ") && lesson_.title.empty() && lesson_.steps.empty()) {
      lesson_.title = withoutBlanks(line.substr(2));
      return;
    }
    if (withoutBlanks(line) == kHeaderBegin) {
      if (lesson_.steps.empty()) throw Error(say<"a header comes below the title of a step">());
      inHeader_ = true;
      return;
    }
    std::string& text = lesson_.steps.empty() ? lesson_.summary : lesson_.steps.back().text;
    if (text.empty() && withoutBlanks(line).empty()) return;
    text += std::string(line) + "\n";
  }

  void beginStep(std::string_view title) {
    const int line = line_;
    if (!lesson_.steps.empty()) endStep();
    line_ = line; // the end of a step goes back to the lines of its solution
    if (lesson_.steps.size() >= kMaxLessonSteps)
      throw Error(say<"a lesson has at most %1 steps">(kMaxLessonSteps));
    LessonStep& step = lesson_.steps.emplace_back();
    step.title = title;
    step.line = line_;
    state_.lanes.clear();
    state_.highlight.clear();
    state_.values.clear();
    state_.plays = false;
    headerLines_ = 0;
    writer_.emplace(state_, folder_);
  }

  void readHeader(std::string_view line) {
    if (line == kFence) {
      inHeader_ = false;
      return;
    }
    if (line.empty() || line.starts_with("#")) return;
    if (++headerLines_ > kMaxStepLines) throw Error(say<"a step has at most %1 lines">(kMaxStepLines));
    const std::size_t colon = line.find(':');
    if (colon == line.npos)
      throw Error(say<"\"%1\" is no line of a header: expected key: value">(shownText(line)));
    readKey(withoutBlanks(line.substr(0, colon)), withoutBlanks(line.substr(colon + 1)));
  }

  void readKey(std::string_view key, std::string_view value) {
    LessonStep& step = lesson_.steps.back();
    if (key == "claim") {
      step.claims.push_back(conditionOf(value));
    } else if (key == "rung") {
      if (step.ladder.size() >= kMaxRungs) throw Error(say<"a step has at most %1 rungs">(kMaxRungs));
      step.ladder.push_back(rungFrom(value));
      step.ladder.back().line = line_;
    } else if (key == "task") {
      taskOf(step).conditions.push_back(conditionOf(value));
    } else if (key == "hint") {
      taskOf(step).hints.emplace_back(value);
    } else if (key == "solution") {
      taskOf(step);
      solution_.emplace_back(line_, value);
    } else if (key == "techniques") {
      for (const std::string_view row : wordsOf(value)) {
        requireName(row, techniqueRows(), say<"technique">());
        if (std::ranges::find(lesson_.techniques, row) == lesson_.techniques.end())
          lesson_.techniques.emplace_back(row);
      }
    } else {
      requireKnown(key);
      writer_->apply(key, value);
    }
  }

  static Task& taskOf(LessonStep& step) { return step.task ? *step.task : step.task.emplace(); }

  static void requireKnown(std::string_view key) {
    std::vector<std::string_view> known = lessonKeys();
    known.insert(known.end(), kTeachingKeys.begin(), kTeachingKeys.end());
    requireName(key, known, say<"key">());
  }

  Condition conditionOf(std::string_view text) const {
    Condition condition = conditionFrom(text);
    condition.line = line_;
    return condition;
  }

  /// The state is whole by now; "set rectify.method=clip" is a line of a solution.
  void endStep() {
    LessonStep& step = lesson_.steps.back();
    step.state = state_;
    requireLanes(step.claims, step.state);
    if (step.task) {
      requireLanes(step.task->conditions, step.state);
      step.task->solution = state_;
      StateWriter writer(step.task->solution, folder_);
      for (const auto& [line, text] : std::exchange(solution_, {})) {
        line_ = line;
        const std::size_t blank = std::min(text.find(' '), text.size());
        writer.apply(std::string_view(text).substr(0, blank),
                     withoutBlanks(std::string_view(text).substr(blank)));
      }
      requireTask(*step.task, step.line);
    }
  }

  void requireTask(const Task& task, int line) {
    line_ = line;
    if (task.conditions.empty()) throw Error(say<"the step has a hint or a solution and no task">());
  }

  void requireLanes(const std::vector<Condition>& conditions, const LessonState& state) {
    for (const Condition& condition : conditions)
      for (const Quantity* quantity : {&condition.left, &condition.right})
        if (!quantity->lane.empty() &&
            std::ranges::find(state.lanes, quantity->lane, &LessonLane::name) == state.lanes.end()) {
          line_ = condition.line;
          throw Error(say<"the step has no lane \"%1\"">(shownText(quantity->lane)));
        }
  }

  const std::string& folder_;
  Lesson lesson_;
  LessonState state_;
  std::optional<StateWriter> writer_;
  std::vector<Line> solution_; ///< of the step being read
  bool inHeader_ = false;
  std::size_t headerLines_ = 0;
  int line_ = 0;
};

void forEachLine(const std::string& text, const std::function<void(std::string_view, int)>& take) {
  int number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string_view line(text.data() + begin, end - begin);
    if (line.ends_with('\r')) line.remove_suffix(1);
    take(line, ++number);
    begin = end + 1;
  }
}

} // namespace

Lesson lessonFromText(const std::string& text, const std::string& place, const std::string& folder) {
  if (text.size() > kMaxLessonBytes)
    throw Error(say<"%1: it has more than %2 bytes">(place, kMaxLessonBytes));
  LessonReader reader(place, folder);
  try {
    forEachLine(text, [&](std::string_view line, int number) { reader.read(line, number); });
    return reader.finish();
  } catch (const Error& error) {
    throw Error(place + (reader.line() > 0 ? ":" + std::to_string(reader.line()) : "") + ": " + error.what());
  }
}

const std::vector<Lesson>& builtinLessons() {
  static const std::vector<Lesson> lessons = [] {
    std::vector<Lesson> read;
    for (const std::string& path : embeddedPaths(kLessonFolder))
      if (path.ends_with(kLessonEnding)) read.push_back(lessonFromText(embeddedText(path), path));
    return read;
  }();
  return lessons;
}

Lesson readLesson(const fs::path& path) {
  const std::string text = readFile(path, kMaxLessonBytes);
  return lessonFromText(text, path.string(), fs::absolute(path).parent_path().string());
}

LessonFolder readLessons(const fs::path& folder) {
  LessonFolder read;
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (entry->path().extension() == kLessonEnding && files.size() < static_cast<std::size_t>(kMaxLessons))
      files.push_back(entry->path());
  if (error) read.errors.push_back(say<"cannot read the folder %1: %2">(folder.string(), error.message()));
  std::ranges::sort(files);
  for (const fs::path& file : files) try {
      requireRegularBelow(folder, file.filename());
      read.lessons.push_back(readLesson(file));
    } catch (const std::exception& wrong) {
      read.errors.push_back(shownReason(wrong));
    }
  return read;
}

} // namespace taa
