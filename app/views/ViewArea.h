// The views side by side or one above the other, whichever shows the picture larger.
#pragma once

#include "app/Mailbox.h"
#include "app/views/ViewPanel.h"

#include <QWidget>

#include <array>
#include <vector>

class QSplitter;

namespace taa::app {

enum class Arrangement { Automatic, Beside, Stacked };

class ViewArea : public QWidget {
  Q_OBJECT
 public:
  explicit ViewArea(QWidget* parent = nullptr);

  ViewPanel* view(int index) const { return views_.at(static_cast<std::size_t>(index)); }
  ViewPanel* active() const { return view(active_); }
  int activeIndex() const { return active_; }
  void setActive(int index);
  /// The view that is not active.
  ViewPanel* other() const { return view(1 - active_); }

  bool showsTwo() const { return showsTwo_; }
  void setTwoViews(bool two);
  void setArrangement(Arrangement arrangement);
  Arrangement arrangement() const { return arrangement_; }
  bool areLinked() const { return linked_; }
  /// Linked views look at the same place.
  void setLinked(bool linked);

  void setPictureSize(glm::ivec2 size);
  void setPick(std::optional<glm::ivec2> pixel);
  /// What the render thread shall deliver; hidden views have no size.
  std::vector<ViewRequest> requests() const;
  std::vector<IntermediateId> shown() const;

 Q_SIGNALS:
  void requestsChanged();
  void shownChanged(); ///< which intermediates, which view is active
  void hoverChanged(int view);
  void picked(glm::ivec2 pixel);
  void pickMoved(int dx, int dy);
  void intermediateRequested(int view);

 protected:
  void resizeEvent(QResizeEvent*) override;
  void showEvent(QShowEvent*) override;

 private:
  void connectView(ViewPanel* view);
  void arrange();

  std::array<ViewPanel*, kViewCount> views_{};
  QSplitter* splitter_;
  int active_ = 0;
  bool showsTwo_ = true, linked_ = true;
  Arrangement arrangement_ = Arrangement::Automatic;
  glm::ivec2 pictureSize_{16, 9};
};

} // namespace taa::app
