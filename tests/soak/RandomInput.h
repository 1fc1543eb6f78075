// Keys, clicks, drags, wheels, texts and sizes for a window and what it opens, drawn at random.
#pragma once

#include <QPoint>

#include <functional>
#include <random>
#include <string>

class QMainWindow;
class QWidget;

namespace taa::soak {

class RandomInput {
 public:
  /// `random` alone decides, as far as the window answers in the same time.
  RandomInput(std::mt19937& random, QMainWindow& window) : random_(random), window_(window) {}

  using Tell = std::function<void(const std::string& text)>;
  /// Tells what it does, then does it, and lets the window answer for a moment.
  void step(const Tell& tell);
  /// Popups and dialogs; the window itself stays.
  void closeAll();

 private:
  int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
  bool oneIn(int count) { return below(count) == 0; }
  Qt::KeyboardModifiers modifiers();
  /// Where the next input goes: a popup, a dialog, else any window of the program.
  QWidget* target();
  QPoint pointIn(const QWidget* top);
  void press(const Tell& tell);
  void type(const Tell& tell);
  void click(const Tell& tell);
  void drag(const Tell& tell);
  void turnWheel(const Tell& tell);
  void resize(const Tell& tell);
  void choose(const Tell& tell);

  std::mt19937& random_;
  QMainWindow& window_;
};

} // namespace taa::soak
