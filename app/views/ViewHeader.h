// The line above a view: what it shows and how. Where it is narrow, its lesser
// parts are in a list behind a button.
#pragma once

#include "core/inspect/Comparison.h"
#include "core/picture/Visualizer.h"
#include "core/settings/Settings.h"

#include <QWidget>

#include <vector>

namespace taa::app {

class ChannelButtons;
class ChoiceButton;
class IconButton;
class NumberField;
class OverflowPopup;

class ViewHeader : public QWidget {
  Q_OBJECT
 public:
  static int barHeight();

  explicit ViewHeader(QChar letter, QWidget* parent = nullptr);

  /// `space`: of the settings that make it; it names the channels.
  void setContent(const Intermediate& row, const ViewStyle& style, const SpaceSettings& space);
  void setZoom(double zoom, bool fit);
  void setActive(bool active);
  void setAlwaysAuto(bool always);
  /// Whether there is another side, a difference of both, and how they are shown.
  void setComparing(bool compares, bool hasDifference, Showing showing);
  void setHistogramShown(bool shown);
  /// Below the button that opens the list of overlays, or the one it is behind.
  QPoint overlaysPlace() const;
  QSize sizeHint() const override { return {400, barHeight()}; }
  QSize minimumSizeHint() const override { return {120, barHeight()}; }

 Q_SIGNALS:
  void styleEdited(const ViewStyle& style);
  void intermediateRequested(); ///< a list to choose from is wanted
  void autoRangeRequested();
  void alwaysAutoToggled();
  void resetRequested();
  void zoomClicked();
  void comparisonRequested();
  void showingChosen(Showing showing);
  void overlaysRequested();
  void histogramToggled();
  void pressed();

 protected:
  void paintEvent(QPaintEvent*) override;
  void resizeEvent(QResizeEvent*) override;
  void mousePressEvent(QMouseEvent*) override;

 private:
  void makeControls();
  void nameControls();
  void connectControls();
  /// A control from left to right, and how long it holds out when it gets narrow (0: longest).
  struct Item {
    QWidget* widget;
    QString name; ///< in the list of those without room
    bool isWanted;
    int rank;
    int width = 0;
    bool isShown = false;
  };
  std::vector<Item> items() const;
  /// Shows what there is room for, the most important first.
  void arrange();
  void openOverflow();
  void makeOverflow();
  void editStyle(const ViewStyle& style);

  QChar letter_;
  bool active_ = false;
  Intermediate row_;
  ViewStyle style_;
  SpaceSettings space_;
  bool compares_ = false;
  ChoiceButton* name_ = nullptr;
  ChannelButtons* channels_ = nullptr;
  NumberField *low_ = nullptr, *high_ = nullptr, *exposure_ = nullptr;
  IconButton *auto_ = nullptr, *reset_ = nullptr, *compare_ = nullptr, *overlays_ = nullptr;
  IconButton* histogram_ = nullptr;
  IconButton* more_ = nullptr;
  OverflowPopup* overflow_ = nullptr;
  ChoiceButton *map_ = nullptr, *zoom_ = nullptr, *showing_ = nullptr;
};

} // namespace taa::app
