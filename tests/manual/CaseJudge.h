// Tries the doctor: injects faults into frames and writes down what it says of them.
#pragma once

#include "core/base/Progress.h"
#include "core/doctor/Diagnosis.h"
#include "core/doctor/frames/DoctorFrame.h"
#include "core/doctor/source/DoctorSource.h"
#include "tests/manual/CasePlan.h"
#include "tests/manual/DoctorCases.h"

#include <optional>
#include <string>
#include <vector>

namespace taa {

/// Keeps the source of the case before open, with its healthy frames. Needs the current context.
class CaseJudge {
 public:
  /// Throws Error, Cancelled.
  JudgedCase judge(const PlannedCase& planned, const Progress& progress = {});

 private:
  using Frames = std::vector<doctor::DoctorFrame>;

  void open(const PlannedCase& planned, const Progress& progress);
  Frames framesOf(const DoctorCase& tried);
  doctor::Diagnosis diagnosisOf(const Frames& frames, const Progress& progress) const;
  /// Whether each fault makes frames differ from those without it.
  bool showsBeside(const Frames& frames, const DoctorCase& tried);
  /// Of what is named, other faults that make the same frames.
  std::vector<std::string> sameAs(const Frames& frames, const JudgedCase& judged);

  std::optional<PlannedCase> opened_; ///< whose frames these are
  std::optional<doctor::DoctorSource> source_;
  Frames healthy_;
  doctor::Diagnosis ofHealthy_;
};

} // namespace taa
