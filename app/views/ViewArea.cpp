#include "app/views/ViewArea.h"

#include "app/style/TextSize.h"
#include "app/views/ViewHeader.h"
#include "app/views/Viewport.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QJsonArray>
#include <QJsonObject>
#include <QKeyEvent>
#include <QLineEdit>
#include <QSplitter>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace taa::app {

namespace {

constexpr IntermediateId kFirst[kViewCount] = {IntermediateId::resolved, IntermediateId::alpha,
                                               IntermediateId::color, IntermediateId::rejectReason};

constexpr std::array<const char*, 3> kArrangementKeys = {"automatic", "beside", "stacked"};

QSplitter* splitter(Qt::Orientation orientation) {
  auto* splitter = new QSplitter(orientation);
  splitter->setChildrenCollapsible(false);
  splitter->setHandleWidth(1);
  return splitter;
}

} // namespace

ViewArea::ViewArea(QWidget* parent)
    : QWidget(parent), halves_(splitter(Qt::Vertical)), upper_(splitter(Qt::Horizontal)),
      lower_(splitter(Qt::Horizontal)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(halves_);
  halves_->addWidget(upper_);
  halves_->addWidget(lower_);
  for (int index = 0; index < kViewCount; ++index) {
    ViewPanel* view = new ViewPanel(index, kFirst[index]);
    views_[static_cast<std::size_t>(index)] = view;
    (index < 2 ? upper_ : lower_)->addWidget(view);
    connectView(view);
    view->setVisible(index < count_);
  }
  lower_->hide();
  // The columns of four views stay in line.
  connect(upper_, &QSplitter::splitterMoved, this, [this] {
    if (count_ == kViewCount) lower_->setSizes(upper_->sizes());
  });
  connect(lower_, &QSplitter::splitterMoved, this, [this] { upper_->setSizes(lower_->sizes()); });
  setProperty(kKeepsLimits, true);
  qApp->installEventFilter(this);
  setActive(0);
}

void ViewArea::connectView(ViewPanel* view) {
  const int index = view->index();
  connect(view, &ViewPanel::requestChanged, this, &ViewArea::requestsChanged);
  connect(view, &ViewPanel::contentChanged, this, &ViewArea::shownChanged);
  connect(view, &ViewPanel::activated, this, [this, index] { setActive(index); });
  connect(view, &ViewPanel::intermediateRequested, this,
          [this, index] { Q_EMIT intermediateRequested(index); });
  connect(view, &ViewPanel::comparisonRequested, this, [this, index] { Q_EMIT comparisonRequested(index); });
  connect(view->viewport(), &Viewport::hoverChanged, this, [this, index] { Q_EMIT hoverChanged(index); });
  connect(view->viewport(), &Viewport::probed, this, &ViewArea::probed);
  connect(view->viewport(), &Viewport::otherProbed, this, &ViewArea::otherProbed);
  connect(view->viewport(), &Viewport::doubleClicked, this, [this] { setMaximized(!isMaximized_); });
  connect(view->viewport(), &Viewport::probeMoved, this, &ViewArea::probeMoved);
  connect(view->viewport(), &Viewport::cameraChanged, this, [this, index](const ViewCamera& camera) {
    if (!linked_) return;
    for (ViewPanel* each : views_)
      if (each->index() != index) each->viewport()->setCamera(camera);
  });
}

void ViewArea::setActive(int index) {
  active_ = index < count_ ? index : 0;
  for (ViewPanel* view : views_) view->setActive(view->index() == active_);
  if (isMaximized_) showViews();
  Q_EMIT shownChanged();
}

void ViewArea::showViews() {
  for (ViewPanel* view : views_)
    view->setVisible(isMaximized_ ? view->index() == active_ : view->index() < count_);
  upper_->setVisible(!isMaximized_ || active_ < 2);
  lower_->setVisible(isMaximized_ ? active_ >= 2 : count_ > 2);
  Q_EMIT requestsChanged();
}

void ViewArea::setMaximized(bool maximized) {
  if (maximized == isMaximized_) return;
  isMaximized_ = maximized;
  showViews();
  Q_EMIT shownChanged();
}

void ViewArea::activate(int index) {
  if (index >= count_) setViewCount(index < 2 ? 2 : kViewCount);
  setActive(index);
  active()->viewport()->setFocus();
}

void ViewArea::showIntermediate(IntermediateId id, bool inOtherView) {
  if (inOtherView && viewCount() == 1) setViewCount(2);
  (inOtherView ? other() : active())->setIntermediate(id);
}

void ViewArea::setViewCount(int count) {
  if (count == count_ || (count != 1 && count != 2 && count != kViewCount)) return;
  count_ = count;
  isMaximized_ = false;
  showViews();
  setActive(active_);
  arrange();
  if (count > 2) {
    halves_->setSizes({1000, 1000});
    lower_->setSizes({1000, 1000});
    upper_->setSizes({1000, 1000});
  }
  Q_EMIT requestsChanged();
}

void ViewArea::showNextCount() {
  setViewCount(count_ == kViewCount ? 1 : 2 * count_);
}

void ViewArea::setArrangement(Arrangement arrangement) {
  arrangement_ = arrangement;
  arrange();
  Q_EMIT shownChanged();
}

void ViewArea::setLinked(bool linked) {
  linked_ = linked;
  Q_EMIT shownChanged();
  if (!linked) return;
  for (ViewPanel* view : views_) view->viewport()->setCamera(active()->viewport()->camera());
}

void ViewArea::setPictureSize(glm::ivec2 size) {
  pictureSize_ = size;
  for (ViewPanel* view : views_) view->viewport()->setPictureSize(size);
  arrange();
}

void ViewArea::setPath(const std::vector<PathPlace>& path) {
  for (ViewPanel* view : views_) view->viewport()->setPath(path);
}

void ViewArea::setMarks(const std::vector<ProbeMark>& marks) {
  for (ViewPanel* view : views_) view->viewport()->setMarks(marks);
}

void ViewArea::setPlaying(bool playing) {
  for (ViewPanel* view : views_) view->viewport()->setPlaying(playing);
}

void ViewArea::setSettingsName(const QString& name) {
  for (ViewPanel* view : views_) view->setSettingsName(name);
}

void ViewArea::setSpaces(const SpaceSettings& own, const std::vector<Settings>& others) {
  const QStringList presets = comparedPresets();
  for (ViewPanel* view : views_) {
    const Comparison& comparison = view->comparison();
    const auto lane = static_cast<std::size_t>(presets.indexOf(QString::fromStdString(comparison.preset)));
    const bool isOther = comparison.kind == OtherKind::Preset && lane < others.size();
    view->setSpaces(own, isOther ? others[lane].space : own);
  }
}

// Only two views can be one above the other; four are two by two.
void ViewArea::arrange() {
  const double aspect = static_cast<double>(std::max(1, pictureSize_.x)) / std::max(1, pictureSize_.y);
  const auto pictureWidth = [&](double width, double height) { return std::min(width, height * aspect); };
  const bool stackedIsLarger = pictureWidth(width(), height() / 2.0 - ViewHeader::barHeight()) >
                               pictureWidth(width() / 2.0, height() - ViewHeader::barHeight());
  const bool stacked =
      arrangement_ == Arrangement::Stacked || (arrangement_ == Arrangement::Automatic && stackedIsLarger);
  const Qt::Orientation orientation = stacked && count_ < kViewCount ? Qt::Vertical : Qt::Horizontal;
  if (upper_->orientation() == orientation) return;
  upper_->setOrientation(orientation);
  upper_->setSizes({1000, 1000});
}

QStringList ViewArea::comparedPresets() const {
  QStringList presets;
  for (const ViewPanel* view : views_) {
    const Comparison& comparison = view->comparison();
    if (view->index() >= count_ || comparison.kind != OtherKind::Preset) continue;
    const QString preset = QString::fromStdString(comparison.preset);
    if (!presets.contains(preset) && presets.size() < kMaxOtherPresets) presets << preset;
  }
  return presets;
}

void ViewArea::setFramed(const std::optional<gl::Rect>& box) {
  for (ViewPanel* view : views_) view->viewport()->setFramed(box);
}

void ViewArea::setOutlines(const std::vector<doctor::OutlineEdge>& edges) {
  for (ViewPanel* view : views_) view->viewport()->setOutlines(edges);
}

std::vector<ViewRequest> ViewArea::requests() const {
  const QStringList presets = comparedPresets();
  std::vector<ViewRequest> requests;
  for (int index = 0; index < count_; ++index) requests.push_back(view(index)->request(presets));
  return requests;
}

std::vector<IntermediateId> ViewArea::shown() const {
  std::vector<IntermediateId> ids;
  for (int index = 0; index < count_; ++index) ids.push_back(view(index)->id());
  return ids;
}

void ViewArea::resizeEvent(QResizeEvent*) {
  arrange();
}

void ViewArea::showEvent(QShowEvent*) {
  Q_EMIT requestsChanged();
}

void ViewArea::peek(bool peeking) {
  ViewPanel* looked = active();
  for (ViewPanel* view : views_)
    if (view->isVisible() && view->viewport()->underMouse()) looked = view;
  for (ViewPanel* view : views_) view->setPeeking(peeking && view == looked);
}

// Shift shows the other side as long as it is held, wherever the focus is but in a text.
bool ViewArea::eventFilter(QObject* object, QEvent* event) {
  if (event->type() == QEvent::ApplicationDeactivate) peek(false);
  if (event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease) {
    const auto* key = static_cast<const QKeyEvent*>(event);
    const QWidget* focus = QApplication::focusWidget();
    const bool writes = qobject_cast<const QLineEdit*>(focus) || qobject_cast<const QAbstractSpinBox*>(focus);
    if (key->key() == Qt::Key_Shift && !key->isAutoRepeat())
      peek(event->type() == QEvent::KeyPress && !writes);
  }
  return QWidget::eventFilter(object, event);
}

QJsonObject ViewArea::state() const {
  QJsonArray views;
  for (const ViewPanel* view : views_) views.append(view->state());
  return {{QStringLiteral("count"), count_},
          {QStringLiteral("maximized"), isMaximized_},
          {QStringLiteral("active"), active_},
          {QStringLiteral("linked"), linked_},
          {QStringLiteral("arrangement"),
           QLatin1String(kArrangementKeys[static_cast<std::size_t>(arrangement_)])},
          {QStringLiteral("views"), views}};
}

void ViewArea::setState(const QJsonObject& state) {
  linked_ = state.value(QLatin1String("linked")).toBool(true);
  const QString arrangement = state.value(QLatin1String("arrangement")).toString();
  for (std::size_t index = 0; index < kArrangementKeys.size(); ++index)
    if (arrangement == QLatin1String(kArrangementKeys[index]))
      setArrangement(static_cast<Arrangement>(index));
  const QJsonArray views = state.value(QLatin1String("views")).toArray();
  for (int index = 0; index < kViewCount; ++index)
    if (views.at(index).isObject()) view(index)->setState(views.at(index).toObject());
  setViewCount(state.value(QLatin1String("count")).toInt(count_));
  setActive(std::clamp(state.value(QLatin1String("active")).toInt(), 0, count_ - 1));
  setMaximized(state.value(QLatin1String("maximized")).toBool());
}

} // namespace taa::app
