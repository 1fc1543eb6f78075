// One, two or four views: two side by side or one above the other, whichever shows the picture larger.
#pragma once

#include "app/session/ProbeList.h"
#include "app/session/Renderer.h"
#include "app/views/ViewPanel.h"

#include "core/doctor/Outline.h"

#include <QWidget>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

class QSplitter;

namespace taa::app {

struct PathPlace;
enum class Arrangement { Automatic, Beside, Stacked };

/// Other presets that views can be compared with at a time: a lane each, besides that of the settings. There
/// is one for each view.
inline constexpr int kMaxOtherPresets = kMaxLanes - 1;
static_assert(kMaxOtherPresets >= kViewCount);

class ViewArea : public QWidget {
  Q_OBJECT
 public:
  explicit ViewArea(QWidget* parent = nullptr);

  ViewPanel* view(int index) const { return views_.at(static_cast<std::size_t>(index)); }
  ViewPanel* active() const { return view(active_); }
  int activeIndex() const { return active_; }
  /// Also gives it the keys.
  void activate(int index);
  void setActive(int index);
  /// The view after the active one.
  ViewPanel* other() const { return view((active_ + 1) % std::max(2, count_)); }

  /// Shows it in the active view, or in the one after it.
  void showIntermediate(IntermediateId id, bool inOtherView);

  int viewCount() const { return count_; }
  /// 1, 2 or 4; shows as many.
  void setViewCount(int count);
  void showNextCount(); ///< one, two, four, one …
  /// The active view alone, in the place of all of them.
  void setMaximized(bool maximized);
  bool isMaximized() const { return isMaximized_; }
  void setArrangement(Arrangement arrangement);
  Arrangement arrangement() const { return arrangement_; }
  bool areLinked() const { return linked_; }
  /// Linked views look at the same place.
  void setLinked(bool linked);

  void setPictureSize(glm::ivec2 size);
  void setMarks(const std::vector<ProbeMark>& marks);
  /// The way that a pixel came, in all views; empty: none.
  void setPath(const std::vector<PathPlace>& path);
  void setSettingsName(const QString& name);
  /// What the box is made in by the settings, and by those of comparedPresets().
  void setSpaces(const SpaceSettings& own, const std::vector<Settings>& others);
  void setPlaying(bool playing);
  /// Draws a frame around these pixels in all views.
  void setFramed(const std::optional<gl::Rect>& box);
  /// Draws these outlines in all views.
  void setOutlines(const std::vector<doctor::OutlineEdge>& edges);
  /// What the render thread shall deliver; hidden views have no size.
  std::vector<ViewRequest> requests() const;
  /// The presets that views are compared with, the lanes after the first.
  QStringList comparedPresets() const;
  std::vector<IntermediateId> shown() const;

  QJsonObject state() const;
  void setState(const QJsonObject& state);

 Q_SIGNALS:
  void requestsChanged();
  void shownChanged(); ///< what views show and how, which is active, how they lie
  void hoverChanged(int view);
  void probed(glm::ivec2 pixel);
  void otherProbed(glm::ivec2 pixel);
  void probeMoved(int dx, int dy);
  void intermediateRequested(int view);
  void comparisonRequested(int view);

 protected:
  void resizeEvent(QResizeEvent*) override;
  void showEvent(QShowEvent*) override;
  bool eventFilter(QObject*, QEvent*) override;

 private:
  void connectView(ViewPanel* view);
  void arrange();
  void showViews();
  void peek(bool peeking);

  std::array<ViewPanel*, kViewCount> views_{};
  QSplitter *halves_, *upper_, *lower_;
  int active_ = 0, count_ = 2;
  bool linked_ = true, isMaximized_ = false;
  Arrangement arrangement_ = Arrangement::Automatic;
  glm::ivec2 pictureSize_{16, 9};
};

} // namespace taa::app
