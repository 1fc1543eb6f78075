// Presenting to a room: nothing but pictures and the lesson, in large text; a presenter's keys go through it.
#pragma once

#include <QJsonObject>
#include <QObject>
#include <QRect>
#include <QString>

#include <functional>
#include <optional>
#include <vector>

class QKeyEvent;
class QLabel;
class QMainWindow;
class QWidget;

namespace taa::app {

class Learning;
class PointerLabel;
class Session;
class ThemeSetting;
class ViewArea;
class Workspace;

/// Next and previous (PageDown, PageUp) go a step of the lesson that is open, else a frame; Escape leaves.
class Presenter : public QObject {
  Q_OBJECT
 public:
  struct Holders {
    QMainWindow& window;
    Session& session;
    ViewArea& views;
    Learning& learning;
    ThemeSetting& theme;
    std::vector<QWidget*> chrome;            ///< is away meanwhile, with the menus and the views' headers
    Workspace& workspace;                    ///< has the panels' places
    std::function<QString(int view)> textAt; ///< the value under the mouse
  };
  /// What texts have at least meanwhile, percent of their size.
  static constexpr int kRoomTextPercent = 150;

  explicit Presenter(const Holders& of);

  bool isOn() const { return before_.has_value(); }
  /// Leaving restores panels, their sizes, the text's size and the window's place as they were.
  void setOn(bool on);
  void setFullScreen(bool full);
  bool isFullScreen() const;
  PointerLabel* pointer() const { return pointer_; }
  /// What stands below the pictures meanwhile: where in the lesson, which frame, the keys.
  QLabel* line() const { return line_; }

 Q_SIGNALS:
  void changed();

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  /// What is given back.
  struct Before {
    Qt::WindowStates window;
    QRect geometry;
    int textPercent = 100, menuHeight = 0;
    std::vector<bool> hidden; ///< of the chrome
    QJsonObject layout;
    int workspaceWidth = 0;
  };
  void enter();
  void leave();
  void restoreLayout();
  void step(int by);
  bool takesKey(QEvent& event);
  void point(QObject* object, QPoint place);
  void describe();

  Holders of_;
  PointerLabel* pointer_;
  QLabel* line_;
  std::optional<Before> before_;
  QJsonObject pendingLayout_; ///< for when the panels have the width again that they had
  int pendingWidth_ = 0;
};

} // namespace taa::app
