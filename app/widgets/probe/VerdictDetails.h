// What belongs to a verdict: what corrects the pixel, and, unfolded, the values that decided and the parts of
// the error.
#pragma once

#include "core/requests/Results.h"

#include <QWidget>

#include <array>
#include <cstddef>

class QLabel;

namespace taa::app {

class ErrorBars;
class EvidenceRow;
class RemedyButton;
class SectionHeader;

inline constexpr std::size_t kMaxRemedies = 3;
inline constexpr std::size_t kMaxEvidence = 5;

class VerdictDetails : public QWidget {
  Q_OBJECT
 public:
  explicit VerdictDetails(QWidget* parent = nullptr);

  /// Null: there is none, and nothing to see.
  void setVerdict(const VerdictDelivery* verdict);
  /// Shows nothing, for now: its room is kept, so that nothing below jumps.
  void wait();
  bool isUnfolded() const;
  void setUnfolded(bool unfolded);

  // Those that are shown are not hidden
  const std::array<RemedyButton*, kMaxRemedies>& remedies() const { return remedies_; }
  const std::array<EvidenceRow*, kMaxEvidence>& rows() const { return rows_; }
  ErrorBars* bars() const { return bars_; }
  QLabel* agreement() const { return agreement_; } ///< how often such verdicts were right
  SectionHeader* header() const { return header_; }
  QString note() const; ///< why there are no remedies; empty: there are, or none is needed

 Q_SIGNALS:
  void remedyChosen(int remedy);
  void rowChosen(IntermediateId id, int frame);

 private:
  QWidget* makeRemedies();
  QWidget* makeEvidence();
  void showRemedies(const VerdictDelivery& verdict);
  void showEvidence(const VerdictAnswer& answer);

  int keptRemedies_ = 0; ///< px, the height of the buttons before it waited
  QWidget *remediesPart_ = nullptr, *evidencePart_ = nullptr;
  QLabel *note_ = nullptr, *agreement_ = nullptr;
  std::array<RemedyButton*, kMaxRemedies> remedies_{};
  SectionHeader* header_ = nullptr;
  QWidget* evidence_ = nullptr;
  std::array<EvidenceRow*, kMaxEvidence> rows_{};
  ErrorBars* bars_ = nullptr;
};

} // namespace taa::app
