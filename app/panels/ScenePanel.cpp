#include "app/panels/ScenePanel.h"

#include "app/models/SceneTreeModel.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "app/widgets/Line.h"
#include "app/widgets/Note.h"
#include "app/widgets/SearchField.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QTreeView>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace taa::app {

namespace {

constexpr std::size_t kMaxUnfolded = 200; ///< nodes up to which a tree opens unfolded
constexpr int kMotionWidth = 92;

} // namespace

std::vector<std::optional<ObjectClass>> ScenePanel::classChoices() {
  std::vector<std::optional<ObjectClass>> choices{std::nullopt};
  for (std::size_t i = 1; i < kObjectClasses.size(); ++i) // all but the sky
    choices.emplace_back(static_cast<ObjectClass>(i));
  return choices;
}

QString ScenePanel::classLabel(std::optional<ObjectClass> objectClass) {
  return objectClass ? qtext(kObjectClasses[static_cast<std::size_t>(*objectClass)].label)
                     : tr("By what moves it");
}

ScenePanel::ScenePanel(QWidget* parent)
    : QWidget(parent), model_(new SceneTreeModel(this)), shown_(new QSortFilterProxyModel(this)),
      filter_(new SearchField(tr("Filter objects by name"))), noHits_(new NoHits), tree_(new QTreeView) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 2 * kUnit, 0, 0);
  layout->setSpacing(2 * kUnit);
  filter_->setObjectName(QStringLiteral("objectFilter"));
  auto* top = new QHBoxLayout;
  top->setContentsMargins(2 * kUnit, 0, 2 * kUnit, 0);
  top->addWidget(filter_);
  layout->addLayout(top);
  makeTree();
  layout->addWidget(noHits_);
  layout->addWidget(tree_, 1);
  layout->addWidget(makeBottom());
  connectTree();
  refresh();
}

void ScenePanel::makeTree() {
  shown_->setSourceModel(model_);
  shown_->setRecursiveFilteringEnabled(true);
  shown_->setFilterCaseSensitivity(Qt::CaseInsensitive);
  tree_->setModel(shown_);
  tree_->setObjectName(QStringLiteral("sceneTree"));
  tree_->setAccessibleName(tr("Objects of the scene"));
  tree_->setUniformRowHeights(true);
  tree_->setIndentation(3 * kUnit);
  tree_->setContextMenuPolicy(Qt::CustomContextMenu);
  tree_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  tree_->header()->setStretchLastSection(false);
  tree_->header()->setSectionResizeMode(SceneTreeModel::Name, QHeaderView::Stretch);
  tree_->header()->setSectionResizeMode(SceneTreeModel::Motion, QHeaderView::Fixed);
  tree_->header()->resizeSection(SceneTreeModel::Motion, scaled(kMotionWidth));
}

QWidget* ScenePanel::makeBottom() {
  auto* bottom = new QWidget;
  auto* column = new QVBoxLayout(bottom);
  column->setContentsMargins(0, 0, 0, 2 * kUnit);
  column->setSpacing(kUnit);
  column->addWidget(new Line);
  info_ = newNote();
  info_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  info_->setContentsMargins(2 * kUnit, kUnit, 2 * kUnit, 0);
  info_->setFixedHeight(3 * QFontMetrics(secondaryFont()).lineSpacing() + 2 * kUnit);
  column->addWidget(info_);
  auto* buttons = new QHBoxLayout;
  buttons->setContentsMargins(2 * kUnit, 0, 2 * kUnit, 0);
  buttons->setSpacing(kUnit);
  const auto add = [&](const QString& text, const QString& toolTip, void (ScenePanel::*act)()) {
    auto* button = new QPushButton(text);
    button->setToolTip(toolTip);
    button->setAccessibleName(toolTip);
    button->setAutoDefault(false);
    connect(button, &QPushButton::clicked, this, act);
    buttons->addWidget(button);
    return button;
  };
  isolate_ = add(tr("Isolate"), tr("Draw only the selected object and what is below it, or all again"),
                 &ScenePanel::isolateSelected);
  reveal_ = add(tr("Probe it"), tr("Put the probe on the selected object and show it in the active view"),
                &ScenePanel::revealSelected);
  showAll_ = add(tr("Show all"), tr("Draw all objects again"), &ScenePanel::showAll);
  column->addLayout(buttons);
  return bottom;
}

void ScenePanel::connectTree() {
  connect(model_, &SceneTreeModel::hiddenAsked, this, &ScenePanel::hiddenAsked);
  connect(model_, &SceneTreeModel::isolationAsked, this, &ScenePanel::isolationAsked);
  connect(filter_, &SearchField::textChanged, this, [this](const QString& text) {
    shown_->setFilterFixedString(text.trimmed());
    if (!text.isEmpty()) tree_->expandAll();
    noHits_->tell(text.trimmed(), shown_->rowCount() > 0 || text.trimmed().isEmpty());
  });
  connect(tree_->selectionModel(), &QItemSelectionModel::currentChanged, this, [this] {
    askForLocation();
    refresh();
    Q_EMIT selectionChanged();
  });
  connect(tree_, &QTreeView::clicked, this, [this](const QModelIndex& index) {
    if (index.column() != SceneTreeModel::Motion || !index.data().isValid()) return;
    openMotionMenu(tree_->viewport()->mapToGlobal(tree_->visualRect(index).bottomLeft()));
  });
  connect(tree_, &QTreeView::activated, this, &ScenePanel::revealSelected);
  connect(tree_, &QTreeView::customContextMenuRequested, this, [this](const QPoint& place) {
    if (const QModelIndex index = tree_->indexAt(place); index.isValid())
      openMenu(tree_->viewport()->mapToGlobal(place));
  });
}

void ScenePanel::setStatus(const Status& status) {
  frame_ = status.info.frame;
  if (status.outline.get() != model_->outline()) {
    model_->setOutline(status.outline);
    area_.reset();
    asked_.clear();
    if (status.outline && status.outline->nodes.size() <= kMaxUnfolded) tree_->expandAll();
  }
  refresh();
}

void ScenePanel::setChoices(const ObjectFilter& filter, const std::vector<MotionOverride>& modes,
                            const std::vector<ClassOverride>& classes) {
  choices_ = filter;
  model_->setState(filter, modes, classes);
  refresh();
}

void ScenePanel::setArea(const ObjectArea& area) {
  if (area.objects != asked_) return; // of another one
  area_ = area;
  refresh();
  Q_EMIT areaChanged();
}

std::optional<ObjectArea> ScenePanel::area() const {
  return area_ && area_->frame == frame_ && area_->pixels > 0 ? area_ : std::nullopt;
}

int ScenePanel::selected() const {
  return model_->nodeOf(shown_->mapToSource(tree_->currentIndex()));
}

const OutlineNode* ScenePanel::selectedNode() const {
  const int node = selected();
  return node < 0 ? nullptr : &model_->outline()->nodes[static_cast<std::size_t>(node)];
}

void ScenePanel::selectObject(int object) {
  if (!model_->outline()) return;
  const int node = model_->outline()->nodeOf(object);
  if (node < 0) {
    tree_->setCurrentIndex({});
    return;
  }
  const QModelIndex source = model_->indexOf(node);
  if (!shown_->mapFromSource(source).isValid()) filter_->clear(); // it was filtered out
  const QModelIndex index = shown_->mapFromSource(source);
  tree_->setCurrentIndex(index);
  tree_->scrollTo(index);
}

void ScenePanel::focusFilter() {
  filter_->setFocus(Qt::ShortcutFocusReason);
  filter_->selectAll();
}

void ScenePanel::askForLocation() {
  const int node = isVisible() ? selected() : -1;
  std::vector<int> objects = node < 0 ? std::vector<int>() : model_->outline()->objectsBelow(node);
  if (objects == asked_) return;
  asked_ = std::move(objects);
  area_.reset();
  Q_EMIT locationAsked(asked_);
  Q_EMIT areaChanged();
}

void ScenePanel::refresh() {
  const OutlineNode* node = selectedNode();
  isolate_->setEnabled(node != nullptr);
  reveal_->setEnabled(area().has_value());
  showAll_->setEnabled(!(choices_ == ObjectFilter{}));
  if (!node) {
    info_->setText(tr("Select an object, or right-click a pixel of it in a view."));
    return;
  }
  QString text = qtext(node->key);
  if (!model_->isDrawn(selected()))
    text += tr(": not drawn");
  else if (asked_.empty())
    text += tr(": draws nothing itself");
  else if (area_ && area_->frame == frame_)
    text += area_->pixels > 0 ? tr(": %1 pixels around (%2, %3), framed in the views")
                                    .arg(QLocale().toString(area_->pixels))
                                    .arg(area_->pixel.x)
                                    .arg(area_->pixel.y)
                              : tr(": not seen on frame %1").arg(frame_);
  info_->setText(text);
}

QString ScenePanel::infoText() const {
  return info_->text();
}

void ScenePanel::hideSelected() {
  const OutlineNode* node = selectedNode();
  if (!node) return;
  const bool isHidden = std::ranges::find(choices_.hidden, node->key) != choices_.hidden.end();
  Q_EMIT hiddenAsked(node->key, !isHidden);
}

void ScenePanel::isolateSelected() {
  const OutlineNode* node = selectedNode();
  if (!node) return;
  const std::vector<std::string> only{node->key};
  Q_EMIT isolationAsked(choices_.isolated == only ? std::vector<std::string>() : only);
}

void ScenePanel::showAll() {
  Q_EMIT filterAsked({});
}

void ScenePanel::revealSelected() {
  if (const auto seen = area()) Q_EMIT revealAsked(seen->pixel);
}

void ScenePanel::setMotionOfSelected(MotionMode mode) {
  const OutlineNode* node = selectedNode();
  if (node && node->objectCount > 0) Q_EMIT motionAsked(node->key, mode);
}

void ScenePanel::openMotionMenu(const QPoint& globalPos) {
  const OutlineNode* node = selectedNode();
  if (!node || node->objectCount == 0) return;
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  for (std::size_t mode = 0; mode < kMotionModes.size(); ++mode) {
    QAction* action = menu->addAction(qtext(kMotionModes[mode].label), this,
                                      [this, mode] { setMotionOfSelected(static_cast<MotionMode>(mode)); });
    action->setCheckable(true);
    action->setChecked(model_->motionOf(selected()) == static_cast<MotionMode>(mode));
  }
  menu->popup(globalPos);
}

void ScenePanel::setClassOfSelected(std::optional<ObjectClass> objectClass) {
  if (const OutlineNode* node = selectedNode()) Q_EMIT classAsked(node->key, objectClass);
}

void ScenePanel::openClassMenu(const QPoint& globalPos) {
  if (!selectedNode()) return;
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  for (const std::optional<ObjectClass> offered : classChoices()) {
    QAction* action =
        menu->addAction(classLabel(offered), this, [this, offered] { setClassOfSelected(offered); });
    action->setCheckable(true);
    action->setChecked(model_->ownClassOf(selected()) == offered);
  }
  menu->popup(globalPos);
}

void ScenePanel::openMenu(const QPoint& globalPos) {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->addAction(tr("Hide or show"), this, &ScenePanel::hideSelected);
  menu->addAction(tr("Isolate, or show all again"), this, &ScenePanel::isolateSelected);
  menu->addAction(tr("Put the probe on it"), this, &ScenePanel::revealSelected)
      ->setEnabled(area().has_value());
  menu->addAction(tr("Motion…"), this, [this, globalPos] { openMotionMenu(globalPos); });
  menu->addAction(tr("Class…"), this, [this, globalPos] { openClassMenu(globalPos); });
  menu->popup(globalPos);
}

QJsonObject ScenePanel::state() const {
  return {{QStringLiteral("filter"), filter_->text()},
          {QStringLiteral("selected"), selectedNode() ? qtext(selectedNode()->key) : QString()}};
}

void ScenePanel::setState(const QJsonObject& state) {
  filter_->setText(state[QStringLiteral("filter")].toString());
  const QString wanted = state[QStringLiteral("selected")].toString();
  if (wanted.isEmpty() || !model_->outline()) return;
  const auto& nodes = model_->outline()->nodes;
  const auto found = std::ranges::find(nodes, wanted.toStdString(), &OutlineNode::key);
  if (found == nodes.end()) return;
  tree_->setCurrentIndex(shown_->mapFromSource(model_->indexOf(static_cast<int>(found - nodes.begin()))));
}

// Sections of a header do not grow with texts by themselves.
void ScenePanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange)
    tree_->header()->resizeSection(SceneTreeModel::Motion, scaled(kMotionWidth));
}

void ScenePanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  askForLocation();
}

void ScenePanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  askForLocation();
}

} // namespace taa::app
