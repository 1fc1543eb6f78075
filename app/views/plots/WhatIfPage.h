// The probed pixel under other choices, nearest to the reference first: a click or Enter tries one, and
// beside each stands what it makes of the whole picture.
#pragma once

#include "app/background/SweepWork.h"
#include "app/models/alternatives/WhatIfEntries.h"

#include <QWidget>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

class QLabel;
class QPushButton;

namespace taa::app {

class BackgroundBar;
class ValueTable;

class WhatIfPage : public QWidget {
  Q_OBJECT
 public:
  explicit WhatIfPage(SweepWork::Sweep sweep = sweepShots, QWidget* parent = nullptr);

  void setResult(const std::optional<ProbeResult>& result);
  /// While it plays rows without a reference stay where they are.
  void setPlaying(bool playing);
  /// Measures what each row makes of whole pictures: of `shot` in the frames up to the probed one, but of
  /// settings that have been measured in them. Without samples nothing is measured.
  void measure(const SessionFile& shot, int referenceSamples);
  /// What was measured was of another shot, if it was.
  void setShot(const SessionFile& shot);
  bool hasNumbers() const { return !numbers_.isEmpty(); }
  /// Arrows choose a row of it, Enter tries that one.
  ValueTable* table() const { return table_; }
  /// What the rows are sorted by, in a sentence.
  QString order() const;
  /// The table, to copy.
  QString text() const;

 Q_SIGNALS:
  void measuringRequested();
  void referenceRequested();          ///< there is none to sort by
  void tried(const Variant& variant); ///< to be taken up

 protected:
  void resizeEvent(QResizeEvent*) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  /// What a row is of: group and id.
  using VariantKey = std::pair<WhatIfGroup, std::string>;
  void layOut();
  void show();
  void showOrder(bool hasReference);
  void chooseAgain();
  std::optional<VariantKey> keyOf(int line) const;
  void fitColumns();
  void refresh();
  void tryLine(int line);

  SweepWork work_;
  std::optional<ProbeResult> result_;
  bool isPlaying_ = false;
  std::vector<std::size_t> lines_;   ///< of the table: row of the result
  std::optional<VariantKey> chosen_; ///< it stays the same while others come before it
  PictureNumbers numbers_;
  std::optional<SessionFile> measured_; ///< the shot that the numbers are of
  int first_ = 0, last_ = -1;           ///< frames that they are of
  std::vector<Settings> measuring_;
  ValueTable* table_;
  BackgroundBar* bar_;
  QPushButton* draw_; ///< the reference that is missing
  QLabel *order_, *note_;
};

} // namespace taa::app
