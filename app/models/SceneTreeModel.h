// The scene as a tree: each node with whether it is drawn and the motion it is given.
#pragma once

#include "core/requests/Results.h"

#include <QAbstractItemModel>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace taa::app {

class SceneTreeModel : public QAbstractItemModel {
  Q_OBJECT
 public:
  enum Column { Name, Motion, ColumnCount };

  explicit SceneTreeModel(QObject* parent = nullptr);

  void setOutline(std::shared_ptr<const SceneOutline> outline);
  const SceneOutline* outline() const { return outline_.get(); }
  void setState(const ObjectFilter& filter, const std::vector<MotionOverride>& modes,
                const std::vector<ClassOverride>& classes = {});

  /// −1: no node.
  int nodeOf(const QModelIndex& index) const;
  QModelIndex indexOf(int node, int column = Name) const;
  MotionMode motionOf(int node) const;
  /// The class that the node itself is given; nothing: that of what it belongs to, or of what moves it.
  std::optional<ObjectClass> ownClassOf(int node) const;
  /// Whether the filter lets it through.
  bool isDrawn(int node) const { return drawn_.at(static_cast<std::size_t>(node)); }

  QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  QModelIndex parent(const QModelIndex& child) const override;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& = {}) const override { return ColumnCount; }
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

 Q_SIGNALS:
  /// A check mark was changed: the session decides.
  void hiddenAsked(const std::string& object, bool hidden);
  /// The check mark of one that is left out, since others are isolated, was set.
  void isolationAsked(const std::vector<std::string>& objects);

 private:
  QString label(int node) const;
  QString explanation(int node) const;
  bool isLeftOut(int node) const { return !isolated_.at(static_cast<std::size_t>(node)); }

  std::shared_ptr<const SceneOutline> outline_;
  std::vector<std::vector<int>> children_; ///< of each node; the roots last
  std::vector<int> places_;                ///< of each node among its siblings
  std::vector<bool> drawn_, isolated_;     ///< isolated: all where none is
  ObjectFilter filter_;
  std::vector<MotionOverride> modes_;
  std::vector<ClassOverride> classes_;
  std::vector<std::optional<ObjectClass>> given_; ///< by node, inherited ones too
};

} // namespace taa::app
