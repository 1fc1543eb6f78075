#include "core/lessons/LessonPages.h"

#include "core/base/Error.h"
#include "core/base/Files.h"
#include "core/base/Say.h"
#include "core/inspect/Inspector.h"
#include "core/inspect/ShownPicture.h"
#include "core/io/GifFile.h"
#include "core/io/PictureFile.h"
#include "core/lessons/Ladder.h"
#include "core/lessons/LessonCheck.h"
#include "core/lessons/LessonHtml.h"
#include "core/lessons/LessonNumbers.h"
#include "core/picture/StyleText.h"
#include "core/report/ManualPages.h"
#include "core/settings/Lanes.h"
#include "core/settings/Presets.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace taa {

namespace fs = std::filesystem;

namespace {

constexpr float kPageZoom = 2.0f;  ///< pixels of a page for one of a picture that is not looked into
constexpr int kClipFrames = 16;    ///< after which most jitter repeats, so that a clip goes on where it began
constexpr double kClipRate = 12.5; ///< frames a second: slow enough to see each

/// Pictures of somebody's own lesson may be large: a page shows them as they are.
float zoomOf(const LessonState& state) {
  return state.shot.size.x <= kLessonSizePx.x ? kPageZoom : 1.0f;
}

/// What is measured over the last frames hardly changes from one to the next, and each of them costs
/// references of all: a picture shows it.
bool isClip(const LessonState& state, const LessonView& view) {
  return state.plays && !isOverTime(view.id);
}

std::string figureName(const Lesson& lesson, std::size_t step, std::size_t view) {
  const LessonState& state = lesson.steps[step].state;
  return lesson.id + "-" + std::to_string(step + 1) + static_cast<char>('a' + view) +
         (isClip(state, state.views[view]) ? ".gif" : ".png");
}

/// "Resolved, builtin:fan, frame 40; compared with preset:off"
std::string captionOf(const LessonView& view, const LessonState& state) {
  std::string caption =
      say<"%1, %2, frame %3">(intermediate(view.id).label, state.shot.source, state.shot.frame);
  if (isClip(state, view))
    caption = say<"%1, %2, %3 frames from frame %4 on">(intermediate(view.id).label, state.shot.source,
                                                        kClipFrames, state.shot.frame);
  if (view.comparison) caption = say<"%1; compared with %2">(caption, comparisonText(view.comparison));
  if (state.look)
    caption = say<"%1; %2 times as large, around pixel (%3, %4)">(
        caption, static_cast<int>(std::lround(state.look->zoom)), state.look->pixel.x, state.look->pixel.y);
  else if (!state.probes.empty())
    caption = say<"%1; framed: pixel (%2, %3)">(caption, state.probes.front().x, state.probes.front().y);
  return caption;
}

/// Where the page looks, as the window would.
ViewTransform transformOf(const LessonState& state, int width, int height) {
  ViewTransform transform;
  transform.zoom = zoomOf(state);
  if (!state.look) return transform;
  transform.zoom = static_cast<float>(state.look->zoom);
  transform.origin = glm::vec2(state.look->pixel) + 0.5f - 0.5f * glm::vec2(width, height) / transform.zoom;
  return transform;
}

/// `otherLane`: of the preset that it is compared with.
PictureRequest requestOf(const LessonView& view, const LessonState& state, int otherLane) {
  ViewStyle style = defaultStyle(intermediate(view.id));
  for (const std::string& assignment : view.style) applyStyle(style, assignment);
  const float zoom = zoomOf(state);
  const int width = static_cast<int>(zoom * static_cast<float>(state.shot.size.x));
  const int height = static_cast<int>(zoom * static_cast<float>(state.shot.size.y));
  PictureRequest request{.id = view.id,
                         .style = style,
                         .transform = transformOf(state, width, height),
                         .width = width,
                         .height = height,
                         .showing = view.comparison ? view.showing : Showing::First,
                         .divider = width / 2,
                         .referenceSamples = state.samples};
  if (view.comparison) {
    OtherSide& other = request.other.emplace(otherSideOf(view.comparison, view.id, otherLane));
    other.style = other.id == view.id ? style : defaultStyle(intermediate(other.id));
    if (view.showing == Showing::Difference) request.style = differenceStyle(intermediate(view.id));
  }
  return request;
}

/// A frame around the pixel, black and white, so that it is seen on any color.
void markPixel(Picture& picture, const ViewTransform& transform, glm::ivec2 pixel) {
  const glm::vec2 low = (glm::vec2(pixel) - transform.origin) * transform.zoom;
  for (const auto& [grow, level] : {std::pair(2, std::uint8_t{0}), {1, std::uint8_t{255}}}) {
    const glm::ivec2 first = glm::ivec2(low) - grow - 1, last = glm::ivec2(low + transform.zoom) + grow;
    for (int y = first.y; y <= last.y; ++y)
      for (int x = first.x; x <= last.x; ++x) {
        const bool isSilhouette = x == first.x || x == last.x || y == first.y || y == last.y;
        if (!isSilhouette || x < 0 || y < 0 || x >= picture.width || y >= picture.height) continue;
        std::uint8_t* at = picture.rgba.data() + 4 * (static_cast<std::size_t>(y) * picture.width + x);
        std::fill_n(at, 3, level);
        at[3] = 255;
      }
  }
}

/// Place of these settings among the lanes of a state, of which its own are the first; −1: they are none of
/// them.
int laneWith(const LessonState& state, const Settings& settings) {
  if (state.shot.settings.settings == settings) return 0;
  const auto found = std::ranges::find(state.lanes, settings, &LessonLane::settings);
  return found == state.lanes.end() ? -1 : static_cast<int>(found - state.lanes.begin()) + 1;
}

/// The state with all that its views and numbers compare side by side, as far as there is room: frames are
/// replayed once for all of it. A clip has nothing beside it, because each of its frames would be made with
/// all.
LessonState withComparisons(const LessonStep& step) {
  LessonState state = step.state;
  if (!hasNumbers(step) || state.plays) state.lanes.clear();
  for (const LessonView& view : state.views) {
    if (view.comparison.kind != OtherKind::Preset) continue;
    const Settings other = preset(view.comparison.preset).settings;
    const bool hasRoom = state.lanes.size() + 1 < static_cast<std::size_t>(kMaxLanes);
    if (laneWith(state, other) < 0 && hasRoom) state.lanes.push_back({"", other});
  }
  return state;
}

/// Opens what the view shows; gives the lane of the preset that it is compared with.
int openView(Inspector& inspector, const LessonView& view, const LessonState& step,
             const Progress& progress) {
  LessonState state = step;
  int lane = 0;
  if (view.comparison.kind == OtherKind::Preset) {
    const Settings other = preset(view.comparison.preset).settings;
    lane = laneWith(state, other);
    if (lane < 0) {
      state.lanes.assign(1, {"", other});
      lane = 1;
    }
  }
  openState(inspector, state, progress);
  return lane;
}

Picture drawFigure(Inspector& inspector, const PictureRequest& request, const LessonState& state,
                   const Progress& progress) {
  Picture picture = shownPicture(inspector, request, progress);
  if (!state.probes.empty()) markPixel(picture, request.transform, state.probes.front());
  return picture;
}

/// One that becomes a clip.
struct Clip {
  PictureRequest request;
  std::unique_ptr<GifWriter> file;
};

/// Of all of them frame by frame, which are made once.
void writeClips(Inspector& inspector, const LessonState& state, const std::vector<Clip>& clips,
                const Progress& progress) {
  if (clips.empty()) return;
  const int last = std::min(state.shot.frame + kClipFrames, inspector.shot().frameCount());
  for (int frame = state.shot.frame; frame < last; ++frame) {
    inspector.shot().seek(frame, progress);
    for (const Clip& clip : clips) clip.file->add(drawFigure(inspector, clip.request, state, progress).rgba);
  }
  for (const Clip& clip : clips) clip.file->finish();
}

/// Pictures of its views, and clips.
void writeViews(Inspector& inspector, const LessonState& state, const std::vector<fs::path>& files,
                const Progress& progress) {
  std::vector<Clip> clips;
  for (std::size_t index = 0; index < files.size(); ++index) {
    const LessonView& view = state.views[index];
    const int otherLane = openView(inspector, view, state, progress);
    const PictureRequest request = requestOf(view, state, otherLane);
    if (isClip(state, view)) {
      clips.push_back({request, std::make_unique<GifWriter>(files[index], files[index], request.width,
                                                            request.height, kClipRate)});
      continue;
    }
    const Picture picture = drawFigure(inspector, request, state, progress);
    writePng(files[index], picture.width, picture.height, picture.rgba);
  }
  writeClips(inspector, state, clips, progress);
}

/// What the window drew of a step; empty: nothing.
fs::path windowFigureFile(const Lesson& lesson, std::size_t step, const LessonPages& pages) {
  const std::string figure = windowFigure(lesson.steps[step]);
  if (pages.figures.empty() || figure.empty()) return {};
  const std::string stem = lesson.id + "-" + std::to_string(step + 1) + "-" + figure;
  for (const char* ending : {".svg", ".png"}) {
    std::error_code ignored;
    if (fs::exists(pages.figures / (stem + ending), ignored)) return pages.figures / (stem + ending);
  }
  return {};
}

std::vector<LessonFigure> writeFigures(Inspector& inspector, const Lesson& lesson, std::size_t step,
                                       const LessonPages& pages, const Progress& progress) {
  const LessonState state = withComparisons(lesson.steps[step]);
  const int width = static_cast<int>(zoomOf(state) * static_cast<float>(state.shot.size.x));
  std::vector<LessonFigure> figures;
  std::vector<fs::path> files;
  for (std::size_t view = 0; view < state.views.size(); ++view) {
    const std::string name = figureName(lesson, step, view);
    files.push_back(pages.folder / name);
    figures.push_back({name, captionOf(state.views[view], state), width});
  }
  writeViews(inspector, state, files, progress);
  if (const fs::path file = windowFigureFile(lesson, step, pages); !file.empty()) {
    writeFile(pages.folder / file.filename(), readFile(file));
    figures.push_back({file.filename().string(), say<"What the window shows of it">(), 0});
  }
  return figures;
}

std::vector<LessonNumber> numbersOfStep(Inspector& inspector, const LessonStep& step,
                                        const Progress& progress) {
  if (!hasNumbers(step)) return {};
  return measureNumbers(inspector, step.state, step.claims, progress);
}

std::vector<fs::path> manualFiles(const LessonPages& pages) {
  std::vector<fs::path> files;
  if (pages.manual.empty())
    for (const ManualPage& page : manualPages())
      files.push_back(pages.folder / "manual" / fs::path(page.file).replace_extension(".html"));
  return files;
}

void makeFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw Error(say<"cannot make the folder %1: %2">(folder.string(), error.message()));
}

void writeManual(const LessonPages& pages) {
  const std::vector<fs::path> files = manualFiles(pages);
  if (files.empty()) return;
  makeFolder(pages.folder / "manual");
  const std::vector<ManualPage> manual = manualPages();
  for (std::size_t page = 0; page < files.size(); ++page) writeFile(files[page], manualHtml(manual[page]));
}

/// Draws steps of lessons on several threads, each with an inspector of its own, whose GL context is its
/// thread's. What one of them throws ends all.
class PageDrawing {
 public:
  PageDrawing(const std::vector<Lesson>& lessons, const LessonPages& pages, const Progress& progress)
      : lessons_(lessons), pages_(pages), progress_(progress), drawn_(lessons.size()) {
    for (const Lesson& lesson : lessons) all_ += static_cast<int>(lesson.steps.size());
  }

  /// Of each lesson its steps. Throws Error, Cancelled.
  std::vector<std::vector<StepOnPage>> draw() {
    const std::size_t most = std::max(1u, std::thread::hardware_concurrency());
    {
      std::vector<std::jthread> threads;
      for (std::size_t i = 0; i < std::min({most, kMostThreads, lessons_.size()}); ++i)
        threads.emplace_back([this] { drawLessons(); });
    }
    if (failure_) std::rethrow_exception(failure_);
    measureLadders();
    return std::move(drawn_);
  }

 private:
  static constexpr std::size_t kMostThreads = 4; ///< a context holds hundreds of megabytes
  /// Steps look at one shot under many settings: some hundred frames of a lesson's size.
  static constexpr std::size_t kInputsBytes = 256u << 20;

  void drawLessons() try {
    Inspector inspector;
    inspector.shot().setInputsBudget(kInputsBytes);
    for (std::size_t next = next_++; next < lessons_.size() && !ends_; next = next_++)
      for (std::size_t step = 0; step < lessons_[next].steps.size(); ++step)
        drawStep(inspector, lessons_[next], step, drawn_[next]);
  } catch (...) {
    const std::lock_guard lock(mutex_);
    if (!failure_) failure_ = std::current_exception();
    ends_ = true;
  }

  void drawStep(Inspector& inspector, const Lesson& lesson, std::size_t step,
                std::vector<StepOnPage>& drawn) {
    const Progress told = [&](std::string_view, int, int) { return tell(step, lesson); };
    report(told, "", 0, 0);
    drawn.push_back({writeFigures(inspector, lesson, step, pages_, told),
                     numbersOfStep(inspector, lesson.steps[step], told)});
    ++done_;
  }

  /// How far all is, whatever a part of it counts; whether to go on.
  bool tell(std::size_t step, const Lesson& lesson) {
    const std::lock_guard lock(mutex_);
    return !ends_ &&
           (!progress_ || progress_(say<"Steps, now %1 of \"%2\"">(step + 1, lesson.title), done_, all_));
  }

  /// With nothing beside it: times are compared.
  void measureLadders() {
    std::optional<Inspector> inspector; // most lessons have no ladder
    for (std::size_t lesson = 0; lesson < lessons_.size(); ++lesson)
      for (std::size_t step = 0; step < lessons_[lesson].steps.size(); ++step) {
        const LessonStep& measured = lessons_[lesson].steps[step];
        if (measured.ladder.empty()) continue;
        if (!inspector) inspector.emplace();
        const Progress told = [&](std::string_view, int, int) { return tell(step, lessons_[lesson]); };
        drawn_[lesson][step].times = measureTimes(*inspector, measured.state, measured.ladder, told);
      }
  }

  const std::vector<Lesson>& lessons_;
  const LessonPages& pages_;
  const Progress& progress_;
  int all_ = 0;
  std::vector<std::vector<StepOnPage>> drawn_; ///< of each lesson, which one thread draws
  std::atomic<std::size_t> next_ = 0;          ///< lesson
  std::atomic<int> done_ = 0;                  ///< steps
  std::atomic<bool> ends_ = false;
  std::mutex mutex_; ///< of what is told, and of
  std::exception_ptr failure_;
};

} // namespace

std::string windowFigure(const LessonStep& step) {
  if (step.state.tab == "colorSpace") return "color-space";
  for (const char* page : {"plots", "jitter", "weights", "lineage"})
    if (step.state.page == page) return page;
  return {};
}

std::vector<fs::path> lessonPageFiles(const std::vector<Lesson>& lessons, const LessonPages& pages) {
  std::vector<fs::path> files{pages.folder / "index.html"};
  for (const Lesson& lesson : lessons) {
    files.push_back(pages.folder / (lesson.id + ".html"));
    for (std::size_t step = 0; step < lesson.steps.size(); ++step) {
      for (std::size_t view = 0; view < lesson.steps[step].state.views.size(); ++view)
        files.push_back(pages.folder / figureName(lesson, step, view));
      if (const fs::path file = windowFigureFile(lesson, step, pages); !file.empty())
        files.push_back(pages.folder / file.filename());
    }
  }
  for (const fs::path& file : manualFiles(pages)) files.push_back(file);
  return files;
}

void writeLessonPages(const std::vector<Lesson>& lessons, const LessonPages& pages,
                      const Progress& progress) {
  makeFolder(pages.folder);
  LessonLinks links;
  links.manual = pages.manual.empty() ? "manual/" : pages.manual;
  links.manualEnding = pages.manual.empty() ? "html" : "md";
  const std::vector<std::vector<StepOnPage>> drawn = PageDrawing(lessons, pages, progress).draw();
  std::vector<std::string> pictures;
  for (std::size_t index = 0; index < lessons.size(); ++index) {
    const Lesson& lesson = lessons[index];
    const std::vector<StepOnPage>& steps = drawn[index];
    links.before = index > 0 ? &lessons[index - 1] : nullptr;
    links.after = index + 1 < lessons.size() ? &lessons[index + 1] : nullptr;
    writeFile(pages.folder / (lesson.id + ".html"), lessonHtml(lesson, steps, links));
    pictures.push_back(steps.empty() || steps.front().figures.empty() ? std::string()
                                                                      : steps.front().figures.front().file);
  }
  writeFile(pages.folder / "index.html", contentsHtml(lessons, pictures, links));
  writeManual(pages);
}

} // namespace taa
