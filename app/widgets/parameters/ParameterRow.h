// One row of the parameter table as a control: label, dot when changed, and the editor its kind asks for.
#pragma once

#include "app/style/Theme.h"
#include "core/taa/SearchedRows.h"

#include <QString>
#include <QWidget>

#include <functional>

class QLabel;

namespace taa::app {

class ParameterLabel;

class ParameterRow : public QWidget {
  Q_OBJECT
 public:
  explicit ParameterRow(const Parameter& row, QWidget* parent = nullptr);

  const Parameter& row() const { return row_; }
  QString path() const;
  /// The control that edits the value.
  QWidget* editor() const { return editor_; }
  double value() const { return value_; }
  /// Shows the row of `settings`; `preset` tells whether it is changed. Emits nothing.
  void display(const Settings& settings, const Settings& preset);
  /// Disables the editor and says why in the tooltips; empty: it can be used.
  void setFixed(const QString& why);
  bool isChanged() const;
  bool isDimmed() const;
  const SearchedRow& searched() const { return searched_; }
  /// Why a search found it, in a line below; empty: nothing to say.
  void setFound(const QString& why);
  QString found() const;

  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {80, rowHeight()}; }

 Q_SIGNALS:
  void edited(const QString& path, double value);
  /// A choice that may be made next: mouse or keys are on it.
  void considered(const QString& path, double value);

 protected:
  void resizeEvent(QResizeEvent*) override;

 private:
  void makeEditor();
  void edit(double value);
  /// Whether label and editor fit side by side.
  bool fitsInOneLine(int width) const;
  int editorWidth() const;
  int foundHeight() const;

  const Parameter& row_;
  SearchedRow searched_;
  ParameterLabel* label_;
  QLabel* found_;
  QWidget* editor_ = nullptr;
  std::function<void(double)> showValue_;
  std::function<void(bool)> dim_;
  double value_ = 0.0, presetValue_ = 0.0;
};

/// What it does, the formula, the source, range and default; rich text.
QString parameterToolTip(const Parameter& row);

} // namespace taa::app
