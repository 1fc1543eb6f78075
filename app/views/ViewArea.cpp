#include "app/views/ViewArea.h"

#include "app/views/ViewHeader.h"
#include "app/views/Viewport.h"

#include <QSplitter>
#include <QVBoxLayout>

#include <algorithm>

namespace taa::app {

ViewArea::ViewArea(QWidget* parent) : QWidget(parent), splitter_(new QSplitter) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(splitter_);
  splitter_->setChildrenCollapsible(false);
  splitter_->setHandleWidth(1);
  const IntermediateId first[] = {IntermediateId::resolved, IntermediateId::alpha};
  for (int index = 0; index < kViewCount; ++index) {
    ViewPanel* view = new ViewPanel(index, first[index]);
    views_[static_cast<std::size_t>(index)] = view;
    splitter_->addWidget(view);
    connectView(view);
  }
  setActive(0);
}

void ViewArea::connectView(ViewPanel* view) {
  const int index = view->index();
  connect(view, &ViewPanel::requestChanged, this, &ViewArea::requestsChanged);
  connect(view, &ViewPanel::contentChanged, this, &ViewArea::shownChanged);
  connect(view, &ViewPanel::activated, this, [this, index] { setActive(index); });
  connect(view, &ViewPanel::intermediateRequested, this,
          [this, index] { Q_EMIT intermediateRequested(index); });
  connect(view->viewport(), &Viewport::hoverChanged, this, [this, index] { Q_EMIT hoverChanged(index); });
  connect(view->viewport(), &Viewport::picked, this, &ViewArea::picked);
  connect(view->viewport(), &Viewport::pickMoved, this, &ViewArea::pickMoved);
  connect(view->viewport(), &Viewport::cameraChanged, this, [this, index](const ViewCamera& camera) {
    if (linked_) views_[static_cast<std::size_t>(1 - index)]->viewport()->setCamera(camera);
  });
}

void ViewArea::setActive(int index) {
  if (!showsTwo_) index = 0;
  active_ = index;
  for (ViewPanel* view : views_) view->setActive(view->index() == active_);
  Q_EMIT shownChanged();
}

void ViewArea::setTwoViews(bool two) {
  if (two == showsTwo_) return;
  showsTwo_ = two;
  views_[1]->setVisible(two);
  setActive(two ? active_ : 0);
  arrange();
  Q_EMIT requestsChanged();
}

void ViewArea::setArrangement(Arrangement arrangement) {
  arrangement_ = arrangement;
  arrange();
}

void ViewArea::setLinked(bool linked) {
  linked_ = linked;
  if (linked) other()->viewport()->setCamera(active()->viewport()->camera());
}

void ViewArea::setPictureSize(glm::ivec2 size) {
  pictureSize_ = size;
  for (ViewPanel* view : views_) view->viewport()->setPictureSize(size);
  arrange();
}

void ViewArea::setPick(std::optional<glm::ivec2> pixel) {
  for (ViewPanel* view : views_) view->viewport()->setPick(pixel);
}

void ViewArea::arrange() {
  const double aspect = static_cast<double>(std::max(1, pictureSize_.x)) / std::max(1, pictureSize_.y);
  const auto pictureWidth = [&](double width, double height) { return std::min(width, height * aspect); };
  const bool stackedIsLarger = pictureWidth(width(), height() / 2.0 - ViewHeader::kHeight) >
                               pictureWidth(width() / 2.0, height() - ViewHeader::kHeight);
  const bool stacked =
      arrangement_ == Arrangement::Stacked || (arrangement_ == Arrangement::Automatic && stackedIsLarger);
  const Qt::Orientation orientation = stacked ? Qt::Vertical : Qt::Horizontal;
  if (splitter_->orientation() == orientation) return;
  splitter_->setOrientation(orientation);
  splitter_->setSizes({1000, 1000});
}

std::vector<ViewRequest> ViewArea::requests() const {
  std::vector<ViewRequest> requests;
  for (const ViewPanel* view : views_)
    if (view->index() == 0 || showsTwo_) requests.push_back(view->request());
  return requests;
}

std::vector<IntermediateId> ViewArea::shown() const {
  std::vector<IntermediateId> ids{views_[0]->id()};
  if (showsTwo_) ids.push_back(views_[1]->id());
  return ids;
}

void ViewArea::resizeEvent(QResizeEvent*) {
  arrange();
}

void ViewArea::showEvent(QShowEvent*) {
  Q_EMIT requestsChanged();
}

} // namespace taa::app
