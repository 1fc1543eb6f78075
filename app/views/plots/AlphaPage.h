// What the pages have in common that are drawn from α of a pixel over frames: they follow it while they are
// shown.
#pragma once

#include "app/models/AlphaSeries.h"

#include <QTimer>
#include <QWidget>

class QLabel;

namespace taa::app {

class AlphaPage : public QWidget {
  Q_OBJECT
 public:
  explicit AlphaPage(QWidget* parent = nullptr);

  void setSeries(const AlphaSeries& series);
  /// What it says in words.
  QString summary() const;

 Q_SIGNALS:
  /// Only while it is shown are probes followed for it.
  void shownChanged(bool shown);
  void seekRequested(int frame);

 protected:
  void showEvent(QShowEvent*) override;
  void hideEvent(QHideEvent*) override;

  /// Called while it is shown.
  virtual void refresh() = 0;
  const AlphaSeries& series() const { return series_; }
  QLabel* summaryLabel() const { return summary_; } ///< for the layout
  void setSummary(const QStringList& parts, QChar between);
  /// What α of one pixel over frames does not tell.
  static QString stillNote();
  /// Secondary text that wraps and can be copied.
  static QLabel* makeNote();

 private:
  AlphaSeries series_;
  QTimer refresh_; ///< while it plays, a few times a second are enough
  QLabel* summary_ = nullptr;
};

} // namespace taa::app
