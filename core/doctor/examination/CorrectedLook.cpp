#include "core/doctor/examination/CorrectedLook.h"

#include "core/base/Error.h"
#include "core/base/Say.h"
#include "core/doctor/examination/Doctor.h"
#include "core/measure/Metrics.h"
#include "core/measure/References.h"
#include "core/render/CaptureFacts.h"

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

namespace taa::doctor {

namespace {

/// What the resolve of settings makes of frames, by frame.
using ResolvedFrames = std::map<int, Image>;

/// Where a finding is looked at: where its first region is largest, or at the end.
int frameOf(const Finding& finding, int last) {
  return finding.regions.empty() ? last : finding.regions.front().frame;
}

ResolvedFrames resolvedFrames(DoctorSource& source, const Settings& settings, const std::vector<int>& wanted,
                              const Progress& progress) {
  drawWith(settings, source);
  const auto facts = source.frames->capture();
  OwnOutput resolve(facts ? settingsOn(*facts, settings) : settings);
  const int last = *std::ranges::max_element(wanted);
  ResolvedFrames out;
  FrameInputs drawn;
  for (int frame = 0; frame <= last; ++frame) {
    report(progress, say<"Drawing mended frames">(), frame, last + 1);
    source.frames->draw(source.request, frame, drawn);
    Image resolved = resolve.read(*source.frames, source.request, drawn, frame);
    if (std::ranges::find(wanted, frame) != wanted.end()) out.emplace(frame, std::move(resolved));
  }
  return out;
}

/// Empty: it neither comes with the frames nor can be drawn.
Image referenceOf(const DoctorSource& source, int frame, const Progress& progress) {
  try {
    if (source.frames->capture()) {
      const std::shared_ptr<const Image> own = source.frames->reference(frame);
      return own ? *own : Image();
    }
    References references;
    const ReferenceKey key{referenceRequest(source.request), frame};
    references.refine(*source.frames, key, kCorrectedSamples, progress);
    return references.find(key)->mean();
  } catch (const Cancelled&) {
    throw;
  } catch (const Error&) {
    return {};
  }
}

std::optional<double> psnrOf(const Image& picture, const Image& reference) {
  if (reference.empty() || picture.width != reference.width || picture.height != reference.height) return {};
  return pictureError(picture, reference).psnr;
}

std::vector<int> wantedFrames(const Diagnosis& diagnosis, const Corrected& corrected, int last) {
  std::vector<int> out{last};
  for (const std::size_t finding : corrected.findings)
    out.push_back(frameOf(diagnosis.findings[finding], last));
  return out;
}

} // namespace

CorrectedLook lookAtCorrected(DoctorSource& source, const Diagnosis& diagnosis, const Settings& settings,
                              const Settings& healthy, const Progress& progress, int first) {
  CorrectedLook out;
  out.corrected = corrected(diagnosis.findings, settings, healthy);
  if (out.corrected.findings.empty()) return out;
  out.lastFrame = first + diagnosis.frames - 1;
  const std::vector<int> wanted = wantedFrames(diagnosis, out.corrected, out.lastFrame);
  const ResolvedFrames correctedFrames = resolvedFrames(source, out.corrected.settings, wanted, progress);
  out.left = examine(examinationOf(source, diagnosis.frames, first), progress);
  const ResolvedFrames given = resolvedFrames(source, settings, wanted, progress);
  for (const std::size_t finding : out.corrected.findings) {
    if (out.pictures.size() >= kMaxCorrectedPictures) break;
    const int frame = frameOf(diagnosis.findings[finding], out.lastFrame);
    out.pictures.push_back(
        {finding, frame, shownColors(given.at(frame)), shownColors(correctedFrames.at(frame))});
  }
  const Image reference = referenceOf(source, out.lastFrame, progress);
  out.givenPsnr = psnrOf(given.at(out.lastFrame), reference);
  out.correctedPsnr = psnrOf(correctedFrames.at(out.lastFrame), reference);
  return out;
}

} // namespace taa::doctor
