#include "core/capture/import/FolderPlan.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/base/ShownText.h"
#include "core/capture/import/SideLimits.h"
#include "core/capture/import/StatedPlanes.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

namespace taa::capture {

namespace fs = std::filesystem;

namespace {

const NamedPlane* planeIn(const PictureSequence& sequence, PlaneKind kind) {
  const std::vector<NamedPlane>& planes = sequence.planes.planes;
  const auto found = std::ranges::find(planes, kind, &NamedPlane::kind);
  return found == planes.end() ? nullptr : &*found;
}

std::string lastFolder(const std::string& folder) {
  const std::size_t slash = folder.rfind('/');
  return slash == std::string::npos ? folder : folder.substr(slash + 1);
}

/// Whether a list speaks of all these frames, by number or else by their order.
bool coversAll(const SideFrames& list, const std::vector<int>& numbers) {
  if (!list.isNumbered) return list.frames.size() == numbers.size();
  return std::ranges::all_of(numbers, [&](int number) { return list.frames.contains(number); });
}

/// The list that speaks of a sequence: that of its folder's name, else the only one without a name.
const SideFrames* listFor(const SideFile& file, const PictureSequence& sequence) {
  for (const SideFrames& list : file.lists)
    if (!list.name.empty() && list.name == lastFolder(sequence.folder)) return &list;
  for (const SideFrames& list : file.lists)
    if ((list.name.empty() || file.lists.size() == 1) && coversAll(list, sequence.numbers)) return &list;
  return nullptr;
}

/// How much a sequence looks like the capture: it has color, motion and depth, and a side file knows its
/// jitter.
int scoreOf(const PictureSequence& sequence, const std::vector<SideFile>& sides) {
  if (!planeIn(sequence, PlaneKind::Color)) return -1;
  int score = planeIn(sequence, PlaneKind::Color)->isNamed ? 2 : 1;
  if (planeIn(sequence, PlaneKind::Motion)) score += 8;
  if (planeIn(sequence, PlaneKind::Depth)) score += 4;
  for (const SideFile& side : sides)
    if (const SideFrames* list = listFor(side, sequence); list && coversAll(*list, sequence.numbers)) {
      score += list->hasJitter ? 32 : 16;
      break;
    }
  if (sequence.numbers.size() > 1) score += 2;
  return score;
}

const PictureSequence& mainOf(const fs::path& folder, const FolderScan& scan,
                              const std::vector<SideFile>& sides) {
  const PictureSequence* best = nullptr;
  int most = -1;
  for (const PictureSequence& sequence : scan.sequences) {
    const int score = scoreOf(sequence, sides);
    const bool isBetter =
        score > most || (score == most && best && sequence.numbers.size() > best->numbers.size());
    if (score < 0 || !isBetter) continue;
    best = &sequence;
    most = score;
  }
  if (best) return *best;
  std::string message = say<
      "%1 has no capture.json and holds no pictures of color: EXR, PNG, HDR, TIFF or DDS files were looked "
      "for, with channels R G B or a layer or name like color, Combined, beauty">(folder.string());
  if (!scan.failures.empty()) message += "; " + scan.failures.front();
  throw Error(message);
}

void addPlane(FolderPlan& plan, const PictureSequence& sequence, const NamedPlane& plane) {
  PlaneSource source;
  source.file = sequence.pattern;
  source.part = plane.part;
  source.channels = plane.channels;
  plan.manifest.planes[plane.kind] = std::move(source);
  plan.types[plane.kind] = plane.type;
}

bool hasAll(const std::vector<int>& numbers, const std::vector<int>& wanted) {
  return std::ranges::includes(numbers, wanted);
}

std::string exampleChannels(const PictureSequence& sequence) {
  std::string text;
  for (const NamedPlane& plane : sequence.planes.planes)
    for (std::size_t i = 0; i < std::min<std::size_t>(2, plane.channels.size()) && text.empty(); ++i)
      text = plane.channels.size() > 1 ? plane.channels[0] + "," + plane.channels[1] : plane.channels[0];
  return text.empty() ? std::string("R,G") : shownText(text);
}

/// Planes that other files have, by their names, for the frames there are.
void addOthers(FolderPlan& plan, const FolderScan& scan, const PictureSequence& main,
               std::vector<int>& numbers) {
  std::vector<std::string> unused;
  for (const PictureSequence& sequence : scan.sequences) {
    if (&sequence == &main) continue;
    bool isUsed = false;
    for (const NamedPlane& plane : sequence.planes.planes) {
      if (!plane.isNamed || plan.manifest.planes.contains(plane.kind)) continue;
      std::vector<int> common;
      std::ranges::set_intersection(numbers, sequence.numbers, std::back_inserter(common));
      const bool isInput = plane.kind != PlaneKind::Output && plane.kind != PlaneKind::Reference;
      // The first frame often has no motion; a sequence that fits only here and there is another one.
      const bool fits =
          hasAll(sequence.numbers, numbers) || (isInput && common.size() * 4 >= numbers.size() * 3);
      if (!fits || common.empty()) continue;
      if (common.size() < numbers.size())
        plan.unsure.push_back(say<"%1 of %2 frames are left out: they have no %3 in %4">(
            numbers.size() - common.size(), numbers.size(), planeName(plane.kind),
            shownText(sequence.pattern)));
      numbers = std::move(common);
      addPlane(plan, sequence, plane);
      isUsed = true;
    }
    if (isUsed) continue;
    if (sequence.numbers == main.numbers)
      plan.unsure.push_back(
          say<"%1 is not used: it has the same frames and no name that says what it holds; --plane "
              "motion=%1:%2, or the tab Planes of Import frames, says so of channels">(
              shownText(sequence.pattern), exampleChannels(sequence)));
    else
      unused.push_back(sequence.pattern);
  }
  if (unused.size() == 1)
    plan.unsure.push_back(say<"%1 is not used: it is another sequence">(shownText(unused.front())));
  if (unused.size() > 1)
    plan.unsure.push_back(
        say<"%1 other sequences are not used, among them %2">(unused.size(), shownText(unused.front())));
}

std::vector<SideFile> sidesOf(const fs::path& folder, const FolderScan& scan, FolderPlan& plan,
                              const Progress& progress) {
  constexpr std::size_t kMaxSideFiles = 16;
  std::vector<SideFile> sides;
  const std::size_t count = std::min(scan.sideFiles.size(), kMaxSideFiles);
  for (std::size_t i = 0; i < count; ++i) {
    report(progress, say<"Reading side files">(), static_cast<int>(i), static_cast<int>(count));
    try {
      if (std::optional<SideFile> side = readSideFile(folder, scan.sideFiles[i]))
        sides.push_back(std::move(*side));
    } catch (const Error& error) {
      plan.unsure.emplace_back(error.what());
    }
  }
  return sides;
}

/// What a list states, and of which frames it does not speak.
void sayList(FolderPlan& plan, const std::string& file, const SideFrames& list,
             const std::vector<int>& numbers) {
  const std::string place =
      list.name.empty() ? shownText(file) : say<"\"%2\" in %1">(shownText(file), shownText(list.name));
  const bool hasMatrices = std::ranges::any_of(
      list.frames, [](const auto& entry) { return entry.second.view && entry.second.projection; });
  if (list.hasJitter && hasMatrices)
    plan.found.push_back(say<"jitter and matrices are those of %1">(place));
  else if (list.hasJitter)
    plan.found.push_back(say<"jitter is that of %1, which states no matrices">(place));
  else if (hasMatrices)
    plan.found.push_back(say<"matrices are those of %1, which states no jitter but 0">(place));
  else
    plan.unsure.push_back(say<"%1 states neither jitter nor matrices that are known by their keys">(place));
  const auto covered =
      static_cast<std::size_t>(std::ranges::count_if(numbers, [&, index = 0](int number) mutable {
        return list.frames.contains(list.isNumbered ? number : index++);
      }));
  if (covered < numbers.size())
    plan.unsure.push_back(say<"%1 of %2 frames are not in %3: they have jitter 0 and no matrices">(
        numbers.size() - covered, numbers.size(), place));
}

void takeSide(FolderPlan& plan, const std::vector<SideFile>& sides, const PictureSequence& main) {
  for (const SideFile& side : sides) {
    const SideFrames* list = listFor(side, main);
    if (!list) continue;
    plan.side = *list;
    plan.sideName = shownText(side.file);
    plan.nearPlane = side.nearPlane;
    plan.farPlane = side.farPlane;
    plan.manifest.name = side.name;
    plan.manifest.engine = side.engine;
    plan.manifest.objects = side.objects;
    if (side.framesPerSecond >= 0.01 && side.framesPerSecond <= 1e5)
      plan.manifest.framesPerSecond = side.framesPerSecond;
    sayList(plan, side.file, *list, main.numbers);
    return;
  }
  for (const SideFile& side : sides)
    plan.unsure.push_back(
        say<"%1 is not used: its list \"frames\" does not speak of the %2 pictures of color there are">(
            shownText(side.file), main.numbers.size()));
  if (sides.empty())
    plan.unsure.push_back(
        say<"no side file states jitter and matrices: a .json file with a list \"frames\" was looked for">());
}

/// `all`: those of the main sequence, whose order is that of a side file without numbers.
void addFrames(FolderPlan& plan, const std::vector<int>& numbers, const std::vector<int>& all) {
  if (numbers.size() > static_cast<std::size_t>(kMaxCapturedFrames))
    throw Error(say<"there are %1 frames, more than the %2 allowed">(numbers.size(), kMaxCapturedFrames));
  for (const int number : numbers) {
    CapturedFrame frame;
    const auto index = static_cast<int>(std::ranges::lower_bound(all, number) - all.begin());
    if (plan.side)
      if (const auto found = plan.side->frames.find(plan.side->isNumbered ? number : index);
          found != plan.side->frames.end())
        frame = found->second;
    frame.number = number;
    plan.manifest.frames.push_back(std::move(frame));
  }
  keepWithinLimits(plan.manifest.frames, plan.sideName, plan.unsure);
}

void sayPlanes(FolderPlan& plan, const PictureSequence& main) {
  for (const auto& [kind, source] : plan.manifest.planes) {
    std::string channels;
    for (const std::string& channel : source.channels)
      channels += (channels.empty() ? "" : " ") + shownText(channel);
    plan.found.push_back(say<"%1 is %2 of %3">(planeName(kind), channels, shownText(source.file)));
  }
  for (const std::string& layer : main.planes.ignored)
    plan.unsure.push_back(
        say<"the layer \"%1\" is not used: no plane is known by that name">(shownText(layer)));
}

} // namespace

FolderPlan planFolder(const fs::path& folder, const std::vector<std::string>& planes,
                      const Progress& progress) {
  FolderPlan plan;
  FolderScan scan = scanFolder(folder, progress);
  statePlanes(planes, folder, scan);
  const std::vector<SideFile> sides = sidesOf(folder, scan, plan, progress);
  const PictureSequence& main = mainOf(folder, scan, sides);
  for (const NamedPlane& plane : main.planes.planes) addPlane(plan, main, plane);
  plan.manifest.sizePx = planeIn(main, PlaneKind::Color)->sizePx;
  std::vector<int> numbers = main.numbers;
  addOthers(plan, scan, main, numbers);
  requireStated(planes, plan.manifest);
  for (const PictureSequence& sequence : scan.sequences)
    if (const NamedPlane* output = planeIn(sequence, PlaneKind::Output);
        output && plan.manifest.planes.contains(PlaneKind::Output) &&
        plan.manifest.planes[PlaneKind::Output].file == sequence.pattern &&
        output->sizePx != plan.manifest.sizePx)
      plan.manifest.outputPx = output->sizePx;
  takeSide(plan, sides, main);
  addFrames(plan, numbers, main.numbers);
  sayPlanes(plan, main);
  plan.unsure.insert(plan.unsure.end(), scan.failures.begin(), scan.failures.end());
  plan.sequences = std::move(scan.sequences);
  return plan;
}

} // namespace taa::capture
