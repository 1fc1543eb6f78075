// Lists to choose from, over a view: what it shows, and what that is compared with.
#pragma once

#include <QObject>
#include <QString>

class QWidget;

namespace taa::app {

class Session;
class ViewArea;

class ViewChoices : public QObject {
  Q_OBJECT
 public:
  /// `presetFolder` holds the user's own. Numbers are asked for over `window`.
  ViewChoices(Session& session, ViewArea& views, const QString& presetFolder, QWidget* window);

  void chooseIntermediate(int view);
  void chooseComparison(int view);

 private:
  void askForComparedFrame(int view);

  Session& session_;
  ViewArea& views_;
  QString presetFolder_;
  QWidget* window_;
};

} // namespace taa::app
