// The pages above the timeline, one of them at a time but for those in windows of their own: profiler, plots,
// jitter, weights, lineage, doctor.
#pragma once

#include <QWidget>

#include <array>
#include <cstddef>
#include <optional>

class QStackedWidget;
class QTabBar;

namespace taa::app {

/// In the order of the tabs.
enum class LowerPage { Profiler, Plots, Jitter, Weights, Lineage, Doctor };
inline constexpr int kLowerPageCount = 6;

/// "profiler", "plots" …: for command lines and files; anything else: nothing.
QString lowerPageId(LowerPage page);
std::optional<LowerPage> lowerPageWithId(const QString& id);

/// A page that is not shown is hidden, so that it may stop what costs time.
class LowerArea : public QWidget {
  Q_OBJECT
 public:
  explicit LowerArea(QWidget* parent = nullptr);

  /// The pages come in the order of LowerPage. The area is closed at first.
  void add(QWidget* page, const QString& title);
  /// Opens the area at this page, or closes it.
  void setShown(LowerPage page, bool shown);
  bool shows(LowerPage page) const;
  /// The page in the area, whether the area is open or not.
  LowerPage current() const;
  /// Takes a page out of the area for a window of its own, hidden or shown as it was.
  QWidget* take(LowerPage page);
  /// Puts a page back that was taken.
  void putBack(LowerPage page);
  bool isTaken(LowerPage page) const { return taken_[static_cast<std::size_t>(page)]; }
  QWidget* page(LowerPage page) const { return all_[static_cast<std::size_t>(page)]; }
  QString title(LowerPage page) const;
  /// The row with tabs and buttons, above the pages until somebody places it elsewhere.
  QWidget* head() const { return head_; }
  QTabBar* tabs() const { return tabs_; }
  QSize sizeHint() const override;

 Q_SIGNALS:
  /// Opened, closed or another page.
  void changed();
  /// The button that gives the current page a window of its own was pressed.
  void tearOffRequested(LowerPage page);

 private:
  void makeHead();
  void showPage();

  QWidget* head_ = nullptr;
  QTabBar* tabs_ = nullptr;
  QStackedWidget* pages_ = nullptr;
  std::array<QWidget*, kLowerPageCount> all_{};
  std::array<bool, kLowerPageCount> taken_{};
};

} // namespace taa::app
