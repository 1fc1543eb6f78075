// What is wrong with the probed pixel, in one sentence; while it is looked for, how far that has come.
#pragma once

#include <QString>
#include <QWidget>

class QLabel;

namespace taa::app {

enum class VerdictTone { Neutral, Right, Wrong }; ///< Neutral: there is no verdict

class VerdictLine : public QWidget {
  Q_OBJECT
 public:
  explicit VerdictLine(QWidget* parent = nullptr);

  void setSentence(const QString& sentence, VerdictTone tone);
  /// No sentence, for now: its room is kept, so that nothing below jumps.
  void wait();
  QString sentence() const;
  VerdictTone tone() const { return tone_; }
  /// What is under way, and 0 to 1 how much of it is done; empty: nothing is.
  void setWork(const QString& what, double share);
  QString work() const;

 protected:
  void paintEvent(QPaintEvent*) override;

 private:
  QLabel *sentence_, *work_;
  VerdictTone tone_ = VerdictTone::Neutral;
  double share_ = 0.0;
};

} // namespace taa::app
