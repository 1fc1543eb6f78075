// The manual: pages at the left, and a field that finds a word in the one on show, and in the others.
#pragma once

#include "core/report/ManualPages.h"

#include <QDialog>

#include <string>
#include <vector>

class QLabel;
class QLineEdit;
class QListWidget;
class QTextBrowser;
class QUrl;

namespace taa::app {

/// Deletes itself when closed.
class ReferenceDialog : public QDialog {
  Q_OBJECT
 public:
  explicit ReferenceDialog(QWidget* parent);

 private:
  void showPage(int row);
  void follow(const QUrl& link);
  void scrollTo(const std::string& anchor);
  void find(bool fromHere);
  /// Rows of the pages that have a text, those below the one on show first.
  std::vector<int> pagesWith(const QString& text);

  std::vector<ManualPage> pages_; ///< as the list has them
  std::vector<QString> texts_;    ///< of them, as they are read; empty: not needed so far
  QListWidget* list_ = nullptr;
  QLineEdit* search_ = nullptr;
  QLabel* missed_ = nullptr; ///< that nothing was found, and where it is
  QTextBrowser* browser_ = nullptr;
};

} // namespace taa::app
