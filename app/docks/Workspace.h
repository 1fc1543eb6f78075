// The views with the panels around them, which can be torn off, moved, and put on another screen.
#pragma once

#include "app/panels/LowerArea.h"

#include <QJsonObject>
#include <QList>
#include <QMainWindow>
#include <QRect>
#include <QSize>

#include <array>
#include <vector>

namespace taa::app {

class LeftArea;
class PanelDock;

/// Where a window of logical px lies so that it can be reached: itself where a good part of it is on a
/// screen, else in the middle of the first screen, no larger than that. Expects a screen.
QRect reachablePlace(const QRect& window, const QList<QRect>& screens);

class Workspace : public QMainWindow {
  Q_OBJECT
 public:
  /// What it places; owns all of them from then on.
  struct Panels {
    QWidget* views;
    LeftArea* left;
    QWidget* learn;
    QWidget* learnHead;
    QWidget* probe;
    QWidget* probeHead;
    LowerArea* lower;
  };
  explicit Workspace(const Panels& panels, QWidget* parent = nullptr);

  /// The sides, the lower area, then pages of the lower area for windows of their own.
  const std::vector<PanelDock*>& docks() const { return docks_; }
  PanelDock* dockOf(LowerPage page) const { return pages_[static_cast<std::size_t>(page)]; }

  /// None: Qt's would hide docks and leave their panels as they are. The menu View has all.
  QMenu* createPopupMenu() override { return nullptr; }

  /// A window of its own, or a place in this one.
  void setTornOff(PanelDock* dock, bool tornOff);
  bool isTornOff(const PanelDock* dock) const;
  /// All panels where they are at a first start, as large as then; the lower area closed.
  void resetLayout();
  /// Every window of a panel goes to the screen after its own. Expects two screens.
  void moveToNextScreen();
  /// At a first start: sides as wide as their texts ask for in a window of this width, logical px.
  void setFirstSizes(int windowWidth);

  /// Whether a pixel is probed: the probe needs no room beside a lesson while none is.
  void setProbed(bool isProbed);
  /// Whether the probe shows a plot or a table of a page of its own, which need more room than its first
  /// words.
  void setPageShown(bool isShown);
  /// A lesson and the probe on one side: the lesson has what its text needs, and the probe the rest.
  void shareSide();

  /// Where the panels are; whether they are shown is for others to say.
  QJsonObject state() const;
  /// Windows on a screen that is gone come back; sides that would leave too little for the views are
  /// narrowed.
  void setState(const QJsonObject& state);

 Q_SIGNALS:
  /// A panel was torn off or put back.
  void layoutChanged();

 protected:
  void changeEvent(QEvent*) override;

 private:
  PanelDock* addDock(const QString& id, const QString& title, Qt::DockWidgetArea area);
  void addPages();
  void shareSideNow();
  void takeFromPages(int missing);
  void endDrags();
  void placeDocks();
  void placeFirst(PanelDock* dock);
  void makeRoomForViews();
  void shrink(Qt::Orientation orientation, int missing);
  void comeBack();
  bool isPage(const PanelDock* dock, LowerPage& page) const;

  Panels of_;
  PanelDock *left_, *learn_, *probe_, *lower_;
  std::array<PanelDock*, kLowerPageCount> pages_{};
  std::vector<PanelDock*> docks_;
  bool isProbed_ = false, isPageShown_ = false;
  QSize savedSize_; ///< of the window whose layout was restored last
};

} // namespace taa::app
