// Has the samples of the active probe's pixel followed while their page is open, and shows them there and as
// a way in the views.
#pragma once

#include "core/requests/Results.h"

#include <QObject>

#include <optional>

namespace taa::app {

class LineagePanel;
class Session;
class ViewArea;

class LineagePresenter : public QObject {
  Q_OBJECT
 public:
  LineagePresenter(Session& session, LineagePanel& panel, ViewArea& views);

 private:
  void take(const LineageDelivery& delivery);
  void forgetOther();
  void show();

  Session& session_;
  LineagePanel& panel_;
  ViewArea& views_;
  std::optional<LineageDelivery> delivery_; // of the active probe
};

} // namespace taa::app
