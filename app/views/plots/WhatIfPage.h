// The probed pixel under other choices, nearest to the reference first: a click tries one, and beside each
// stands what it makes of the whole picture.
#pragma once

#include "app/background/SweepWork.h"
#include "app/models/alternatives/WhatIfEntries.h"

#include <QWidget>

#include <optional>
#include <vector>

class QLabel;

namespace taa::app {

class BackgroundBar;
class ValueTable;

class WhatIfPage : public QWidget {
  Q_OBJECT
 public:
  explicit WhatIfPage(SweepWork::Sweep sweep = sweepShot, QWidget* parent = nullptr);

  void setResult(const std::optional<ProbeResult>& result);
  /// Measures what each row makes of whole pictures: of `shot` in the frames up to the probed one, but of
  /// settings that have been measured in them. Without samples nothing is measured.
  void measure(const SessionFile& shot, int referenceSamples);
  /// What was measured was of another shot, if it was.
  void setShot(const SessionFile& shot);
  bool hasNumbers() const { return !numbers_.isEmpty(); }
  ValueTable* table() const { return table_; }
  /// The table, to copy.
  QString text() const;

 Q_SIGNALS:
  void measuringRequested();
  void tried(const Variant& variant); ///< a click, to be taken up

 protected:
  void resizeEvent(QResizeEvent*) override;

 private:
  void show();
  void fitColumns();
  void refresh();
  void tryLine(int line);

  SweepWork work_;
  std::optional<ProbeResult> result_;
  std::vector<std::optional<std::size_t>> lines_; ///< of the table: row of the result; nothing: a heading
  PictureNumbers numbers_;
  std::optional<SessionFile> measured_; ///< the shot that the numbers are of
  int first_ = 0, last_ = -1;           ///< frames that they are of
  std::vector<Settings> measuring_;
  ValueTable* table_;
  BackgroundBar* bar_;
  QLabel* note_;
};

} // namespace taa::app
