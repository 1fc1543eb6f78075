// One plane of imported frames as a control: its name, a dot where somebody stated it, and the pictures that
// hold it, to be chosen, typed, or dropped there.
#pragma once

#include "core/capture/format/Manifest.h"
#include "core/capture/import/FolderScan.h"

#include <QString>
#include <QWidget>

#include <optional>
#include <vector>

class QComboBox;
class QMimeData;

namespace taa::app {

class ParameterLabel;

class PlaneRow : public QWidget {
  Q_OBJECT
 public:
  explicit PlaneRow(capture::PlaneKind kind, QWidget* parent = nullptr);

  capture::PlaneKind kind() const { return kind_; }
  QComboBox* box() const { return box_; }
  bool isStated() const { return !stated_.isEmpty(); }
  /// px: of the whole label, and so many of it.
  int labelHint() const;
  void setLabelWidth(int width);
  /// The choices there are.
  void setSequences(const std::vector<capture::PictureSequence>& sequences);
  /// Where the plane lies, as statedText() writes it. `found`: empty: nowhere; `stated`: empty: where it was
  /// found. What is still being typed stays. Emits nothing.
  void display(const QString& found, const QString& stated);
  /// What was typed and not yet said, if it is something else than what is shown; it is taken as said then.
  std::optional<QString> takeTyped();

 Q_SIGNALS:
  /// `text`: empty: as it was found.
  void stated(capture::PlaneKind kind, const QString& text);

 protected:
  bool eventFilter(QObject*, QEvent*) override;
  void dragEnterEvent(QDragEnterEvent*) override;
  void dragLeaveEvent(QDragLeaveEvent*) override;
  void dropEvent(QDropEvent*) override;
  void paintEvent(QPaintEvent*) override;

 private:
  void addChoice(const QString& text, const QString& stated, const QString& layer);
  /// `text` as stated() has it.
  void choose(const QString& text);
  /// Whether it says what the row says already.
  bool isShown(const QString& text) const;
  /// What stands in the field while nothing is typed.
  QString shownText() const;
  /// Of what is dragged, into the choices; -1: it cannot be this plane.
  int choiceOf(const QMimeData& dragged) const;
  void setTarget(bool isTarget);

  capture::PlaneKind kind_;
  ParameterLabel* label_;
  QComboBox* box_;
  QString found_, stated_;
  bool isTarget_ = false; ///< something is dragged over it that it takes
};

} // namespace taa::app
