// The pages above the timeline, one of them at a time: profiler, plots, jitter, weights, lineage,
// doctor.
#pragma once

#include <QWidget>

#include <optional>

class QHBoxLayout;
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
  LowerPage current() const;
  QTabBar* tabs() const { return tabs_; }
  QSize sizeHint() const override { return {1000, 276}; }

 Q_SIGNALS:
  /// Opened, closed or another page.
  void changed();

 private:
  QTabBar* tabs_ = nullptr;
  QStackedWidget* pages_ = nullptr;
};

} // namespace taa::app
