// The table of every intermediate at a pixel: rows by stage, those that are off folded away, and columns of
// which names, values and units are not cut.
#pragma once

#include <QTreeView>

namespace taa::app {

class ProbeModel;

class ProbeTable : public QTreeView {
  Q_OBJECT
 public:
  explicit ProbeTable(ProbeModel* model, QWidget* parent = nullptr);

  /// px that names, values and units of texts of 100 % take, and the scroll bar.
  int neededWidth() const;
  /// Shares out the width of the page that it fills.
  void fitColumns(int width);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void showFolds();
  void toggleFold(const QModelIndex& line);

  ProbeModel* model_;
};

} // namespace taa::app
