// What is open, at the end of the menu bar: cut, with dots, where menus leave no room.
#pragma once

#include "app/widgets/bars/ElidedLabel.h"

#include <QMenuBar>

namespace taa::app {

class MenuTitle final : public ElidedLabel {
 public:
  explicit MenuTitle(QMenuBar* bar);

  void setTitle(const QString& text);
  /// Places it anew, for other fonts or another width of the bar.
  void place();

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {0, ElidedLabel::minimumSizeHint().height()}; }

 protected:
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QMenuBar* bar_;
  int room_ = 0; ///< logical px that menus leave
  bool isPlacing_ = false;
};

} // namespace taa::app
