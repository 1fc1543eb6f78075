// A flat button that is an icon.
#pragma once

#include "app/style/Theme.h"

#include <QString>
#include <QToolButton>

namespace taa::app {

class IconButton : public QToolButton {
  Q_OBJECT
 public:
  IconButton(const QString& icon, const QString& toolTip, QWidget* parent = nullptr);
  void setIconName(const QString& icon);
  QSize sizeHint() const override { return {scaled(24), rowHeight()}; }
  QSize minimumSizeHint() const override { return sizeHint(); }
};

} // namespace taa::app
