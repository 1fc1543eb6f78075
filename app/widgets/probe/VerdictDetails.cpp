#include "app/widgets/probe/VerdictDetails.h"

#include "app/models/verdict/VerdictWords.h"
#include "app/style/Theme.h"
#include "app/widgets/Note.h"
#include "app/widgets/SectionHeader.h"
#include "app/widgets/areas/FittingArea.h"
#include "app/widgets/probe/ErrorBars.h"
#include "app/widgets/probe/EvidenceRow.h"
#include "app/widgets/probe/RemedyButton.h"
#include "core/verdict/pixel/BlindAgreement.h"

#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace taa::app {

VerdictDetails::VerdictDetails(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 2 * kUnit);
  column->setSpacing(0);
  remediesPart_ = makeRemedies();
  evidencePart_ = makeEvidence();
  column->addWidget(remediesPart_);
  column->addWidget(evidencePart_);
  setVerdict(nullptr);
}

QWidget* VerdictDetails::makeRemedies() {
  auto* part = new QWidget;
  auto* column = new QVBoxLayout(part);
  column->setContentsMargins(2 * kUnit, 0, 2 * kUnit, kUnit);
  column->setSpacing(kUnit);
  note_ = newNote();
  column->addWidget(note_);
  for (std::size_t remedy = 0; remedy < kMaxRemedies; ++remedy) {
    auto* button = new RemedyButton;
    connect(button, &RemedyButton::clicked, this,
            [this, remedy] { Q_EMIT remedyChosen(static_cast<int>(remedy)); });
    column->addWidget(button);
    remedies_[remedy] = button;
  }
  remedies_[0]->setToolTip(tr("Changes these settings (Ctrl+T); Ctrl+Z takes it back"));
  remedies_[1]->setToolTip(tr("Changes these settings (Ctrl+Shift+T); Ctrl+Z takes it back"));
  remedies_[2]->setToolTip(tr("Changes these settings (Ctrl+Alt+T); Ctrl+Z takes it back"));
  return part;
}

QWidget* VerdictDetails::makeEvidence() {
  auto* part = new QWidget;
  auto* column = new QVBoxLayout(part);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  header_ = new SectionHeader(tr("Evidence"));
  column->addWidget(header_);
  evidence_ = new QWidget;
  auto* inside = new QVBoxLayout(evidence_);
  inside->setContentsMargins(0, 0, 0, 0);
  inside->setSpacing(0);
  for (EvidenceRow*& row : rows_) {
    row = new EvidenceRow;
    connect(row, &EvidenceRow::clicked, this,
            [this, button = row] { Q_EMIT rowChosen(button->row().id, button->row().frame); });
    inside->addWidget(row);
  }
  bars_ = new ErrorBars;
  inside->addSpacing(kUnit);
  inside->addWidget(bars_);
  agreement_ = newNote();
  agreement_->setContentsMargins(2 * kUnit, kUnit, 2 * kUnit, 0);
  inside->addWidget(agreement_);
  column->addWidget(evidence_);
  connect(header_, &SectionHeader::toggled, evidence_, &QWidget::setVisible);
  evidence_->hide();
  return part;
}

bool VerdictDetails::isUnfolded() const {
  return header_->isChecked();
}

void VerdictDetails::setUnfolded(bool unfolded) {
  header_->setChecked(unfolded);
}

QString VerdictDetails::note() const {
  return note_->text();
}

void VerdictDetails::setVerdict(const VerdictDelivery* verdict) {
  setVisible(verdict && verdict->answer);
  if (!verdict || !verdict->answer) return;
  setMinimumHeight(0);
  showRemedies(*verdict);
  showEvidence(*verdict->answer);
  evidencePart_->show();
}

void VerdictDetails::wait() {
  if (isHidden() || evidencePart_->isHidden()) return;
  setMinimumHeight(heightAt(*this, width()));
  keptRemedies_ = remediesPart_->isHidden() ? 0 : heightAt(*remediesPart_, width());
  remediesPart_->hide();
  evidencePart_->hide();
}

void VerdictDetails::showRemedies(const VerdictDelivery& verdict) {
  const bool isPending =
      !verdict.remedies && verdict.whyNot.empty() && verdict.answer->verdict.kind != VerdictKind::None;
  remediesPart_->setMinimumHeight(isPending ? keptRemedies_ : 0);
  const std::size_t count = verdict.remedies ? std::min(verdict.remedies->best.size(), kMaxRemedies) : 0;
  for (std::size_t remedy = 0; remedy < kMaxRemedies; ++remedy) {
    remedies_[remedy]->setVisible(remedy < count);
    if (remedy >= count) continue;
    const TriedRemedy& tried = verdict.remedies->best[remedy];
    remedies_[remedy]->setTexts(changesText(tried.remedy), remedyEffectsText(*verdict.remedies, tried));
  }
  QString note;
  if (!verdict.whyNot.empty())
    note = tr("What mends it is not known: %1").arg(QString::fromStdString(verdict.whyNot));
  else if (verdict.remedies && count == 0)
    note = tr("None of %n changes that were tried mends it.", nullptr, verdict.remedies->tried);
  note_->setText(note);
  note_->setVisible(!note.isEmpty());
  remediesPart_->setVisible(isPending || count > 0 || !note.isEmpty());
}

void VerdictDetails::showEvidence(const VerdictAnswer& answer) {
  const std::vector<VerdictRow>& decided = answer.verdict.rows;
  for (std::size_t row = 0; row < kMaxEvidence; ++row) {
    rows_[row]->setVisible(row < decided.size());
    if (row < decided.size()) rows_[row]->setRow(decided[row]);
  }
  bars_->setError(answer.error);
  agreement_->setText(QString::fromStdString(agreementText(answer.verdict.kind)));
}

} // namespace taa::app
