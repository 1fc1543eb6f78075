// The tree of the scene: what is drawn, with which motion, and where it is seen.
#pragma once

#include "core/requests/Results.h"

#include <QJsonObject>
#include <QWidget>

#include <optional>
#include <string>
#include <vector>

class QLabel;
class QPoint;
class QPushButton;
class QSortFilterProxyModel;
class QTreeView;

namespace taa::app {

class SceneTreeModel;
class NoHits;
class SearchField;

class ScenePanel : public QWidget {
  Q_OBJECT
 public:
  explicit ScenePanel(QWidget* parent = nullptr);

  void setStatus(const Status& status);
  void setChoices(const ObjectFilter& filter, const std::vector<MotionOverride>& modes,
                  const std::vector<ClassOverride>& classes = {});
  void setArea(const ObjectArea& area);
  /// Selects the object of this number; 0 and unknown ones: nothing.
  void selectObject(int object);
  void focusFilter();

  /// The selected node; −1: none.
  int selected() const;
  /// Where it is seen on the frame on show; nothing while that is not known, or it is not seen.
  std::optional<ObjectArea> area() const;

  // What keys and buttons do with the selected node
  void hideSelected();
  void isolateSelected();
  void showAll();
  void revealSelected();
  void setMotionOfSelected(MotionMode mode);
  void setClassOfSelected(std::optional<ObjectClass> objectClass);
  /// Classes that an object can be given; nothing: that of what moves it.
  static std::vector<std::optional<ObjectClass>> classChoices();
  static QString classLabel(std::optional<ObjectClass> objectClass);

  QTreeView* tree() const { return tree_; }
  SearchField* filterField() const { return filter_; }
  SceneTreeModel* model() const { return model_; }
  QString infoText() const;
  QJsonObject state() const;
  void setState(const QJsonObject& state);

 Q_SIGNALS:
  void hiddenAsked(const std::string& object, bool hidden);
  void isolationAsked(const std::vector<std::string>& objects);
  void filterAsked(const ObjectFilter& filter);
  void motionAsked(const std::string& object, MotionMode mode);
  void classAsked(const std::string& object, std::optional<ObjectClass> objectClass);
  /// Where these are seen is of interest; none: no longer.
  void locationAsked(const std::vector<int>& objects);
  void revealAsked(glm::ivec2 pixel);
  void areaChanged();
  void selectionChanged();

 protected:
  void changeEvent(QEvent*) override;
  void showEvent(QShowEvent*) override;
  void hideEvent(QHideEvent*) override;

 private:
  void makeTree();
  QWidget* makeBottom();
  void connectTree();
  void openMotionMenu(const QPoint& globalPos);
  void openClassMenu(const QPoint& globalPos);
  void openMenu(const QPoint& globalPos);
  void askForLocation();
  void refresh();
  const OutlineNode* selectedNode() const;

  SceneTreeModel* model_;
  QSortFilterProxyModel* shown_;
  SearchField* filter_;
  NoHits* noHits_;
  QTreeView* tree_;
  QLabel* info_;
  QPushButton *isolate_, *reveal_, *showAll_;
  ObjectFilter choices_;
  std::optional<ObjectArea> area_;
  std::vector<int> asked_; ///< objects
  int frame_ = 0;
};

} // namespace taa::app
