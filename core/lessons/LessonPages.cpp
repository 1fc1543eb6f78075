#include "core/lessons/LessonPages.h"

#include "core/base/Error.h"
#include "core/base/Files.h"
#include "core/base/Say.h"
#include "core/inspect/Inspector.h"
#include "core/inspect/ShownPicture.h"
#include "core/io/PictureFile.h"
#include "core/lessons/LessonCheck.h"
#include "core/lessons/LessonHtml.h"
#include "core/picture/StyleText.h"
#include "core/settings/Presets.h"

#include <cstddef>
#include <string>
#include <system_error>
#include <vector>

namespace taa {

namespace fs = std::filesystem;

namespace {

std::string figureName(const Lesson& lesson, std::size_t step, std::size_t view) {
  return lesson.id + "-" + std::to_string(step + 1) + static_cast<char>('a' + view) + ".png";
}

/// "Resolved, frame 40, compared with preset:off"
std::string captionOf(const LessonView& view, const LessonState& state) {
  const std::string what =
      say<"%1, %2, frame %3">(sayLabel(intermediate(view.id).label), state.shot.source, state.shot.frame);
  return view.comparison ? say<"%1; compared with %2">(what, comparisonText(view.comparison)) : what;
}

Picture pictureOf(Inspector& inspector, const LessonView& view, const LessonState& step,
                  const Progress& progress) {
  LessonState state = step;
  state.lanes.clear();
  if (view.comparison.kind == OtherKind::Preset)
    state.lanes.push_back({"other", preset(view.comparison.preset).settings});
  openState(inspector, state, progress);
  ViewStyle style = defaultStyle(intermediate(view.id));
  for (const std::string& assignment : view.style) applyStyle(style, assignment);
  PictureRequest request{.id = view.id,
                         .style = style,
                         .transform = {},
                         .width = inspector.shot().width(),
                         .height = inspector.shot().height(),
                         .showing = view.comparison ? view.showing : Showing::First,
                         .divider = inspector.shot().width() / 2,
                         .referenceSamples = state.samples};
  if (view.comparison) {
    OtherSide& other = request.other.emplace(otherSideOf(view.comparison, view.id, 1));
    other.style = other.id == view.id ? style : defaultStyle(intermediate(other.id));
    if (view.showing == Showing::Difference) request.style = differenceStyle(intermediate(view.id));
  }
  return shownPicture(inspector, request, progress);
}

} // namespace

std::vector<fs::path> lessonPageFiles(const std::vector<Lesson>& lessons, const fs::path& folder) {
  std::vector<fs::path> files{folder / "index.html"};
  for (const Lesson& lesson : lessons) {
    files.push_back(folder / (lesson.id + ".html"));
    for (std::size_t step = 0; step < lesson.steps.size(); ++step)
      for (std::size_t view = 0; view < lesson.steps[step].state.views.size(); ++view)
        files.push_back(folder / figureName(lesson, step, view));
  }
  return files;
}

void writeLessonPages(Inspector& inspector, const std::vector<Lesson>& lessons, const fs::path& folder,
                      const std::string& manual, const Progress& progress) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw Error(say<"cannot make the folder %1: %2">(folder.string(), error.message()));
  for (const Lesson& lesson : lessons) {
    std::vector<std::vector<LessonFigure>> figures(lesson.steps.size());
    for (std::size_t step = 0; step < lesson.steps.size(); ++step) {
      const LessonState& state = lesson.steps[step].state;
      for (std::size_t view = 0; view < state.views.size(); ++view) {
        const std::string file = figureName(lesson, step, view);
        const Picture picture = pictureOf(inspector, state.views[view], state, progress);
        writePng(folder / file, picture.width, picture.height, picture.rgba);
        figures[step].push_back({file, captionOf(state.views[view], state)});
      }
    }
    writeFile(folder / (lesson.id + ".html"), lessonHtml(lesson, figures, manual));
  }
  writeFile(folder / "index.html", contentsHtml(lessons));
}

} // namespace taa
