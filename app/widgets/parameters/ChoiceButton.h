// A choice of many: a button that shows the present one and opens a menu with an explanation for each.
#pragma once

#include <QAbstractButton>
#include <QStringList>

#include <cstddef>
#include <vector>

class QMenu;

namespace taa::app {

class ChoiceButton : public QAbstractButton {
  Q_OBJECT
 public:
  explicit ChoiceButton(QWidget* parent = nullptr);

  /// Labels, and one explanation each (or none).
  void setChoices(const QStringList& labels, const QStringList& explanations = {});
  /// The choices from `first` on are offered in a submenu of this title; without a title below a line.
  struct Part {
    int first = 0;
    QString title;
  };
  void setParts(const std::vector<Part>& ascending) { parts_ = ascending; }
  /// The choices that are set are offered after all others, in a submenu of this title.
  void setLast(const QString& title, const std::vector<bool>& last);
  /// One line for each label that stands beside it in the menu, too; the explanation is its tool tip.
  void setLines(const QStringList& lines) { lines_ = lines; }
  int current() const { return current_; }
  /// Shows a choice; emits nothing. −1: none.
  void setCurrent(int index);
  /// Shown instead of the present choice's label: "balanced*".
  void setCaption(const QString& caption);
  void setFlat(bool flat);
  /// Without the mark of a list.
  void setPlain(bool plain);
  void setDimmed(bool dimmed);
  QSize sizeHint() const override;

 Q_SIGNALS:
  void chosen(int index);
  /// Mouse or keys came to another one than the present in the menu.
  void considered(int index);
  /// Clicked while there are no choices: somebody else offers them.
  void requested();

 protected:
  void paintEvent(QPaintEvent*) override;
  void keyPressEvent(QKeyEvent*) override;

 private:
  void openMenu();
  void addChoice(QMenu* menu, int index);
  bool isLast(int index) const;
  static QMenu* partOf(QMenu* menu, const Part& part);
  void choose(int index);
  QString caption() const;

  QStringList labels_, explanations_, lines_;
  QString caption_;
  std::vector<Part> parts_;
  QString lastTitle_;
  std::vector<bool> last_;
  int current_ = -1;
  bool flat_ = false, plain_ = false, dimmed_ = false;
};

} // namespace taa::app
