// The area left of the views: the pipeline or the tree of the scene.
#pragma once

#include <QWidget>

class QStackedWidget;
class QTabBar;

namespace taa::app {

/// In the order of the tabs.
enum class LeftPage { Pipeline, Scene };

class LeftArea : public QWidget {
  Q_OBJECT
 public:
  LeftArea(QWidget* pipeline, QWidget* scene);

  /// Opens the area at this page.
  void openPage(LeftPage page);
  /// Whether the area is open or not.
  void setPage(LeftPage page);
  LeftPage page() const;
  bool shows(LeftPage page) const;
  void setShown(bool shown);
  /// The row of tabs, above the pages until somebody places it elsewhere.
  QTabBar* tabs() const { return tabs_; }

 Q_SIGNALS:
  /// Opened, closed or another page.
  void changed();

 private:
  QTabBar* tabs_;
  QStackedWidget* pages_;
};

} // namespace taa::app
