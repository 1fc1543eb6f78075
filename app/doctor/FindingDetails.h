// One line of what the doctor says in full: where, what one sees, what to change, and the evidence.
#pragma once

#include "core/doctor/Diagnosis.h"

#include <QWidget>

#include <utility>
#include <vector>

class QGridLayout;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QScrollArea;

namespace taa::app {

class ResidualBars;

class FindingDetails : public QWidget {
  Q_OBJECT
 public:
  explicit FindingDetails(QWidget* parent = nullptr);

  /// A row: what is said of, and what is said.
  using Row = std::pair<QString, QString>;

  /// `region`: of its regions; −1: all of them.
  void showFinding(const doctor::Finding& finding, int region, const doctor::FrameNames& names);
  void showUndecided(const doctor::Undecided& undecided);
  void showText(const QString& title, const std::vector<Row>& rows);

  const std::vector<Row>& rows() const { return shown_; }
  QString title() const;
  ResidualBars* bars() const { return bars_; }
  QPushButton* goButton() const { return go_; }
  QPushButton* correctedButton() const { return corrected_; }
  /// Why frames cannot be shown with the finding made right; empty: they can.
  void setWhyNotCorrected(const QString& why);

 Q_SIGNALS:
  void placeRequested();
  void correctedRequested();

 private:
  QWidget* makeWords();
  QHBoxLayout* makeButtons();
  QWidget* makeEvidence();
  void setRows(const std::vector<Row>& rows);

  static constexpr std::size_t kMostRows = 6;
  std::vector<Row> shown_;
  QLabel *title_ = nullptr, *measure_ = nullptr;
  std::vector<std::pair<QLabel*, QLabel*>> lines_;
  QPushButton *go_ = nullptr, *corrected_ = nullptr;
  QScrollArea *words_ = nullptr, *evidence_ = nullptr;
  ResidualBars* bars_ = nullptr;
};

} // namespace taa::app
