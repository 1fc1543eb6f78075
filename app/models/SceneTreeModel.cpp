#include "app/models/SceneTreeModel.h"

#include "app/style/Text.h"
#include "app/style/Theme.h"

#include <QApplication>
#include <QFont>
#include <QLocale>
#include <QPalette>

#include <algorithm>
#include <string>
#include <utility>

namespace taa::app {

namespace {

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

} // namespace

SceneTreeModel::SceneTreeModel(QObject* parent) : QAbstractItemModel(parent) {}

void SceneTreeModel::setOutline(std::shared_ptr<const SceneOutline> outline) {
  if (outline == outline_) return;
  beginResetModel();
  outline_ = std::move(outline);
  const std::size_t count = outline_ ? outline_->nodes.size() : 0;
  children_.assign(count + 1, {});
  places_.assign(count, 0);
  for (std::size_t node = 0; node < count; ++node) {
    const int parent = outline_->nodes[node].parent;
    std::vector<int>& siblings = children_[parent < 0 ? count : static_cast<std::size_t>(parent)];
    places_[node] = static_cast<int>(siblings.size());
    siblings.push_back(static_cast<int>(node));
  }
  filter_ = {};
  modes_.clear();
  classes_.clear();
  given_.assign(count, std::nullopt);
  drawn_.assign(count, true);
  isolated_.assign(count, true);
  endResetModel();
}

void SceneTreeModel::setState(const ObjectFilter& filter, const std::vector<MotionOverride>& modes,
                              const std::vector<ClassOverride>& classes) {
  if (!outline_ || (filter == filter_ && modes == modes_ && classes == classes_)) return;
  filter_ = filter;
  modes_ = modes;
  classes_ = classes;
  given_ = givenClasses(*outline_, classes);
  drawn_ = drawnNodes(*outline_, filter);
  isolated_ = drawnNodes(*outline_, {.hidden = {}, .isolated = filter.isolated});
  const auto tell = [this](const auto& self, const QModelIndex& parent) -> void {
    const int rows = rowCount(parent);
    if (rows == 0) return;
    Q_EMIT dataChanged(index(0, 0, parent), index(rows - 1, ColumnCount - 1, parent));
    for (int row = 0; row < rows; ++row) self(self, index(row, 0, parent));
  };
  tell(tell, {});
}

int SceneTreeModel::nodeOf(const QModelIndex& index) const {
  return index.isValid() ? static_cast<int>(index.internalId()) : -1;
}

QModelIndex SceneTreeModel::indexOf(int node, int column) const {
  if (node < 0 || node >= static_cast<int>(places_.size())) return {};
  return createIndex(places_[static_cast<std::size_t>(node)], column, static_cast<quintptr>(node));
}

MotionMode SceneTreeModel::motionOf(int node) const {
  const OutlineNode& item = outline_->nodes[static_cast<std::size_t>(node)];
  MotionMode mode = item.motion;
  for (const MotionOverride& replaced : modes_)
    if (replaced.node == item.key) mode = replaced.mode;
  return mode;
}

std::optional<ObjectClass> SceneTreeModel::ownClassOf(int node) const {
  const std::string& key = outline_->nodes[static_cast<std::size_t>(node)].key;
  const auto found = std::ranges::find(classes_, key, &ClassOverride::object);
  return found == classes_.end() ? std::nullopt : std::optional(found->objectClass);
}

QModelIndex SceneTreeModel::index(int row, int column, const QModelIndex& parent) const {
  if (!hasIndex(row, column, parent)) return {};
  const std::size_t at = parent.isValid() ? static_cast<std::size_t>(nodeOf(parent)) : children_.size() - 1;
  return createIndex(row, column, static_cast<quintptr>(children_[at][static_cast<std::size_t>(row)]));
}

QModelIndex SceneTreeModel::parent(const QModelIndex& child) const {
  const int node = nodeOf(child);
  return node < 0 ? QModelIndex() : indexOf(outline_->nodes[static_cast<std::size_t>(node)].parent);
}

int SceneTreeModel::rowCount(const QModelIndex& parent) const {
  if (!outline_ || parent.column() > 0) return 0;
  const std::size_t at = parent.isValid() ? static_cast<std::size_t>(nodeOf(parent)) : children_.size() - 1;
  return static_cast<int>(children_[at].size());
}

QString SceneTreeModel::label(int node) const {
  const OutlineNode& item = outline_->nodes[static_cast<std::size_t>(node)];
  QString name = qtext(item.key);
  if (const auto given = given_[static_cast<std::size_t>(node)])
    name = tr("%1: %2").arg(name, qtext(kObjectClasses[static_cast<std::size_t>(*given)].label));
  switch (item.kind) {
  case NodeKind::Light:
    return tr("%1 (light)").arg(name);
  case NodeKind::Camera:
    return tr("%1 (camera)").arg(name);
  case NodeKind::Group:
  case NodeKind::Mesh:
    break;
  }
  return name;
}

QString SceneTreeModel::explanation(int node) const {
  const OutlineNode& item = outline_->nodes[static_cast<std::size_t>(node)];
  QString text = label(node);
  if (item.objectCount > 0)
    text += tr("\nObjects: %1, triangles: %2")
                .arg(QLocale().toString(item.objectCount),
                     QLocale().toString(static_cast<qlonglong>(item.triangles)));
  if (isDrawn(node)) return text;
  if (holds(filter_.hidden, item.key)) return text + tr("\nHidden");
  return text + (filter_.isolated.empty() ? tr("\nHidden with what it belongs to")
                                          : tr("\nNot drawn: others are isolated"));
}

QVariant SceneTreeModel::data(const QModelIndex& index, int role) const {
  const int node = nodeOf(index);
  if (node < 0 || !outline_) return {};
  const OutlineNode& item = outline_->nodes[static_cast<std::size_t>(node)];
  if (role == Qt::DisplayRole) {
    if (index.column() == Name) return label(node);
    if (item.objectCount == 0) return {};
    return qtext(kMotionModes[static_cast<std::size_t>(motionOf(node))].label);
  }
  if (role == Qt::ToolTipRole || role == Qt::AccessibleDescriptionRole) return explanation(node);
  if (role == Qt::CheckStateRole && index.column() == Name)
    return holds(filter_.hidden, item.key) || isLeftOut(node) ? Qt::Unchecked : Qt::Checked;
  if (role == Qt::ForegroundRole && !isDrawn(node)) return themeColors(qApp->palette()).secondary;
  if (role == Qt::FontRole) {
    QFont font = qApp->font();
    font.setItalic(!isDrawn(node));
    font.setBold(index.column() == Name ? holds(filter_.isolated, item.key) : motionOf(node) != item.motion);
    return font;
  }
  return {};
}

QVariant SceneTreeModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::DisplayRole) return section == Name ? tr("Object") : tr("Motion");
  if (role == Qt::ToolTipRole)
    return section == Name ? tr("Unchecked objects are not drawn; isolated ones are bold.")
                           : tr("The motion that an object is given, whatever moves it. Click it to change.");
  return {};
}

Qt::ItemFlags SceneTreeModel::flags(const QModelIndex& index) const {
  if (!index.isValid()) return {};
  const Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
  return index.column() == Name ? flags | Qt::ItemIsUserCheckable : flags;
}

bool SceneTreeModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  const int node = nodeOf(index);
  if (node < 0 || role != Qt::CheckStateRole) return false;
  const std::string& key = outline_->nodes[static_cast<std::size_t>(node)].key;
  if (isLeftOut(node)) {
    std::vector<std::string> isolated = filter_.isolated;
    isolated.push_back(key);
    Q_EMIT isolationAsked(isolated);
    if (!holds(filter_.hidden, key)) return true;
  }
  Q_EMIT hiddenAsked(key, value.toInt() == Qt::Unchecked);
  return true;
}

} // namespace taa::app
