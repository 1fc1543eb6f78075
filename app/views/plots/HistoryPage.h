// What the pages have in common that are drawn from the history of a pixel: they follow it while they are
// shown.
#pragma once

#include "app/models/PixelHistory.h"

#include <QTimer>
#include <QWidget>

class QLabel;

namespace taa::app {

class HistoryPage : public QWidget {
  Q_OBJECT
 public:
  explicit HistoryPage(QWidget* parent = nullptr);

  void setHistory(const PixelHistory& history);
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
  const PixelHistory& history() const { return history_; }
  QLabel* summaryLabel() const { return summary_; } ///< for the layout
  void setSummary(const QStringList& parts, QChar between);
  /// Secondary text that wraps and can be copied.
  static QLabel* makeNote();

 private:
  PixelHistory history_;
  QTimer refresh_; ///< while it plays, a few times a second are enough
  QLabel* summary_ = nullptr;
};

} // namespace taa::app
