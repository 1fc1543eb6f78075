// What the doctor gathers while frames go by, once.
#pragma once

#include "core/base/Progress.h"
#include "core/doctor/Diagnosis.h"
#include "core/doctor/color/ColorCheck.h"
#include "core/doctor/depth/DepthCheck.h"
#include "core/doctor/depth/MissingDepth.h"
#include "core/doctor/examination/Examination.h"
#include "core/doctor/flow/FlowCheck.h"
#include "core/doctor/flow/FlowLength.h"
#include "core/doctor/frames/Regions.h"
#include "core/doctor/jitter/JitterCheck.h"
#include "core/doctor/jitter/RegionJitter.h"
#include "core/doctor/motion/MotionEvidence.h"
#include "core/doctor/motion/MotionFindings.h"
#include "core/doctor/motion/MotionPairs.h"
#include "core/doctor/motion/MotionReturns.h"
#include "core/doctor/motion/MotionSilhouettes.h"
#include "core/doctor/resolve/ResolveEvidence.h"
#include "core/doctor/sequence/BadValues.h"
#include "core/doctor/sequence/FrameOrder.h"
#include "core/doctor/sequence/PlaneTimes.h"

#include <functional>
#include <optional>
#include <vector>

namespace taa::doctor {

class Examiner {
 public:
  /// `progress` is reported to while it looks. Expects that all of them outlive it.
  Examiner(const Examination& examination, const CaptureInfo& captureInfo, const Progress& progress,
           bool looksAtOutput)
      : examination_(examination), captureInfo_(captureInfo), progress_(progress),
        looksAtOutput_(looksAtOutput) {}
  /// One of the same frames that has seen none, and does not look at the output.
  Examiner another() const { return {examination_, captureInfo_, progress_, false}; }

  /// `out`: counts frames and pairs. `firstSeen`: called after kFirstLook frames, where more follow.
  void look(const FrameReader& read, Diagnosis& out, const std::function<void()>& firstSeen = {});

  const ColorEvidence& color() const { return color_; }
  /// `brightness`: of the frames as they are.
  void tellColor(const BrightnessEvidence& brightness, Diagnosis& out) const {
    doctor::tellColor(color_, brightness, captureInfo_, examination_.known.maskUsed, out);
  }
  void tellRegionJitter(Diagnosis& out) const {
    doctor::tellRegionJitter(regionJitter_, tracker_.regions(), captureInfo_, out);
  }
  void tellPairs(Diagnosis& out) const { doctor::tellPairs(motion_, tracker_.regions(), captureInfo_, out); }
  void tellOutlier(Diagnosis& out) const {
    doctor::tellOutlier(color_.outlier, tracker_.regions(), captureInfo_, out);
  }
  const JitterEvidence& jitter() const { return jitter_; }
  JitterOutcome tellJitter(bool hasCamera, Diagnosis& out) const;
  const DepthEvidence& depth() const { return depth_; }
  void tellMissingDepth(Diagnosis& out) const { missingDepth_.tell(flow(), captureInfo_, out); }
  bool isDepthDistance() const { return examination_.known.depthDistance; }
  bool isDepthDrawn() const { return !captureInfo_.conventions; }
  const SilhouetteEvidence& silhouettes() const { return silhouettes_; }
  const ResolveEvidence& resolve() const { return resolve_; }
  bool areMatricesFlipped() const;
  bool isMotionBeyondPicture() const { return isBeyondPicture(motion_); }
  std::optional<FittedLength> motionLength() const { return fittedLength(flow_); }
  MotionTold tellMotion(Diagnosis& out) const;
  FlowSeen flow() const { return {flow_, tracker_.regions()}; }
  const OrderEvidence& order() const { return order_; }
  std::vector<PlaneTime> planeTimes() const { return times_.found(); }
  void tellValues(Diagnosis& out) const { tellBadValues(values_, tracker_.regions(), captureInfo_, out); }
  const CaptureInfo& captureInfo() const { return captureInfo_; }

 private:
  DoctorFrame readNext(const FrameReader& read, int frame) const;
  void add(const DoctorFrame* before, const DoctorFrame& now, const DoctorFrame* after, Diagnosis& out);
  /// `out`: says how many frames there are.
  std::optional<RegionPlace> skyPlace(const Diagnosis& out) const;
  /// Whether surfaces are drawn with the jitter that is stated, by depth alone: reads some frames again.
  bool areSurfacesJittered() const;

  const Examination& examination_;
  FrameReader read_; ///< what was looked at
  const CaptureInfo& captureInfo_;
  const Progress& progress_;
  RegionTracker tracker_;
  std::vector<RegionIndex> labels_; ///< of the frame that was added last
  ColorEvidence color_;
  MotionEvidence motion_{captureInfo_.sizePx};
  std::vector<FlowPair> flow_;
  RegionJitter regionJitter_;
  JitterEvidence jitter_;
  DepthEvidence depth_;
  MissingDepth missingDepth_;
  SilhouetteEvidence silhouettes_;
  OrderEvidence order_;
  PlaneTimes times_;
  ValueEvidence values_;
  ReturnEvidence returns_;
  ResolveEvidence resolve_;
  bool looksAtOutput_;
};

} // namespace taa::doctor
