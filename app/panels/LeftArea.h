// The area left of the views: the pipeline or the tree of the scene.
#pragma once

#include <QTabWidget>

namespace taa::app {

/// In the order of the tabs.
enum class LeftPage { Pipeline, Scene };

class LeftArea : public QTabWidget {
  Q_OBJECT
 public:
  LeftArea(QWidget* pipeline, QWidget* scene);

  /// Opens the area at this page.
  void openPage(LeftPage page);
  LeftPage page() const { return static_cast<LeftPage>(currentIndex()); }
  bool shows(LeftPage page) const;
  void setShown(bool shown);

 Q_SIGNALS:
  /// Opened, closed or another page.
  void changed();
};

} // namespace taa::app
