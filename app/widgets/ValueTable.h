// A small table: a name and values beside it, which can be copied.
#pragma once

#include <QColor>
#include <QStringList>
#include <QTreeWidget>

#include <vector>

namespace taa::app {

class ValueTable : public QTreeWidget {
  Q_OBJECT
 public:
  struct Row {
    QStringList cells;
    QColor swatch{}; ///< before the name; invalid: none
    bool isSum = false;
    QString tip{}; ///< more than the cells have room for; empty: their own texts
    bool operator==(const Row&) const = default;
  };
  explicit ValueTable(const QStringList& header, QWidget* parent = nullptr);

  void setRows(const std::vector<Row>& rows);
  const std::vector<Row>& rows() const { return rows_; }
  /// With its header; fields with commas or quotes are quoted.
  QString csv() const;
  /// With columns as wide as their longest entry.
  QString text() const;
  /// So wide that no name was cut so far, up to a limit.
  QSize sizeHint() const override { return {widest_, 160}; }

 protected:
  void changeEvent(QEvent*) override;

 private:
  static constexpr int kFirstWidth = 220;
  std::vector<QStringList> lines() const;
  void fillRows();
  void fillRow(const Row& row, QTreeWidgetItem& item) const;
  int neededWidth() const;
  QStringList header_;
  std::vector<Row> rows_;
  int widest_ = kFirstWidth; ///< px
};

} // namespace taa::app
