#include "app/widgets/IconButton.h"

#include "app/style/Icons.h"

namespace taa::app {

IconButton::IconButton(const QString& icon, const QString& toolTip, QWidget* parent) : QToolButton(parent) {
  setIconName(icon);
  setIconSize({scaled(16), scaled(16)});
  setToolTip(toolTip);
  setAccessibleName(toolTip);
  setFocusPolicy(Qt::TabFocus);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void IconButton::setIconName(const QString& icon) {
  setIcon(themedIcon(icon));
}

} // namespace taa::app
