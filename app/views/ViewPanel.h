// One view: header and viewport, what it shows, and its memory of how each intermediate was last shown.
#pragma once

#include "app/views/ViewportMath.h"

#include "core/RenderThread.h"

#include <QWidget>

#include <map>
#include <optional>

namespace taa::app {

class ViewHeader;
class Viewport;

class ViewPanel : public QWidget {
  Q_OBJECT
 public:
  /// `index` 0 is view A.
  ViewPanel(int index, IntermediateId id, QWidget* parent = nullptr);

  int index() const { return index_; }
  IntermediateId id() const { return id_; }
  const ViewStyle& style() const { return style_; }
  Viewport* viewport() const { return viewport_; }
  ViewHeader* header() const { return header_; }
  /// What the render thread shall deliver.
  ViewRequest request() const;

  void setIntermediate(IntermediateId id);
  void setStyle(const ViewStyle& style);
  void setResult(const ViewResult& result);
  void setActive(bool active);

  // Keys
  void changeExposure(float stops);
  void normalize(); ///< as soon as values are here
  void setAlwaysAuto(bool always);
  bool isAlwaysAuto() const { return alwaysAuto_; }
  void resetStyle();
  void nextColorMap();
  void toggleMarks();
  void toggleChannel(int channel);

 Q_SIGNALS:
  void requestChanged();
  void contentChanged(); ///< intermediate or style
  void activated();
  void intermediateRequested();

 private:
  void connectParts();
  void fitRange(const ViewResult& result);
  void refresh();

  int index_;
  IntermediateId id_;
  ViewStyle style_;
  std::map<IntermediateId, ViewStyle> remembered_;
  bool wantsRange_ = false, alwaysAuto_ = false;
  ViewHeader* header_;
  Viewport* viewport_;
};

} // namespace taa::app
