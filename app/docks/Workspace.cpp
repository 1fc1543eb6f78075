#include "app/docks/Workspace.h"

#include "app/docks/PanelDock.h"
#include "app/panels/LeftArea.h"
#include "app/style/Theme.h"

#include <QEvent>
#include <QGuiApplication>
#include <QJsonArray>
#include <QLayout>
#include <QMouseEvent>
#include <QScreen>
#include <QTabBar>
#include <QTimer>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace taa::app {

namespace {

constexpr int kStateVersion = 1;
constexpr QSize kLeastViews(320, 150); ///< logical px that no panel takes from the views
constexpr double kViewsShare = 0.4;    ///< of width and height that a layout leaves to the views at least
constexpr double kLeftShare = 0.22, kProbeShare = 0.33; ///< of the width, at most where texts are large
constexpr QSize kReachable(120, 40);    ///< logical px of a window that have to be on a screen
constexpr QSize kFirstWindow(720, 360); ///< of a page that is torn off
constexpr int kLeastProbe = 70;         ///< logical px of texts of 100 %, beside a lesson
constexpr int kPageOfProbe = 300;       ///< likewise, of a page of the probe that is not of its words
constexpr int kTightProbe = 30;         ///< likewise, where there is no room for that
constexpr int kNoProbe = 40;            ///< likewise, while no pixel is probed
constexpr int kHiddenProbe = 2;         ///< likewise, where a lesson would have hardly a line
constexpr double kLessonShare = 0.6;    ///< of a side, that a lesson beside a probe has at most
constexpr int kLessonLines = 20;        ///< of text, that it may have in any case
constexpr int kFewLines = 5;            ///< of text, for which the probe gives what it can

QList<QRect> screenPlaces(const QScreen* first) {
  QList<QRect> places{first->availableGeometry()};
  for (const QScreen* screen : QGuiApplication::screens())
    if (screen != first) places << screen->availableGeometry();
  return places;
}

QRect middleOf(const QRect& screen, const QSize& wanted) {
  QRect place(QPoint(), wanted.boundedTo(screen.size()));
  place.moveCenter(screen.center());
  return place;
}

} // namespace

QRect reachablePlace(const QRect& window, const QList<QRect>& screens) {
  const bool isReachable = std::ranges::any_of(screens, [&](const QRect& screen) {
    const QSize seen = screen.intersected(window).size();
    const QSize needed = kReachable.boundedTo(window.size());
    return seen.width() >= needed.width() && seen.height() >= needed.height();
  });
  return isReachable ? window : middleOf(screens.first(), window.size());
}

Workspace::Workspace(const Panels& panels, QWidget* parent) : QMainWindow(parent), of_(panels) {
  setWindowFlags(Qt::Widget);
  setContextMenuPolicy(Qt::NoContextMenu);
  // Panels lie beside each other: one that hides behind another is not found again.
  setDockOptions(AllowNestedDocks);
  of_.views->setMinimumSize(kLeastViews);
  setCentralWidget(of_.views);
  left_ = addDock(QStringLiteral("left"), tr("Pipeline and scene"), Qt::LeftDockWidgetArea);
  left_->setHead(of_.left->tabs());
  left_->setPanel(of_.left);
  learn_ = addDock(QStringLiteral("learn"), tr("Learn"), Qt::RightDockWidgetArea);
  learn_->setHead(of_.learnHead);
  learn_->setPanel(of_.learn);
  probe_ = addDock(QStringLiteral("probe"), tr("Probe"), Qt::RightDockWidgetArea);
  probe_->setHead(of_.probeHead);
  probe_->setScrolledPanel(of_.probe, kHiddenProbe);
  lower_ = addDock(QStringLiteral("lower"), tr("Pages below the views"), Qt::BottomDockWidgetArea);
  lower_->setWholeHead(of_.lower->head());
  lower_->setPanel(of_.lower);
  addPages();
  connect(learn_, &PanelDock::opened, this, &Workspace::shareSide);
  connect(lower_, &PanelDock::opened, this, &Workspace::shareSide);
  connect(qApp, &QGuiApplication::screenRemoved, this, &Workspace::comeBack, Qt::QueuedConnection);
}

void Workspace::setProbed(bool isProbed) {
  if (isProbed != std::exchange(isProbed_, isProbed)) shareSide();
}

void Workspace::setPageShown(bool isShown) {
  if (isShown != std::exchange(isPageShown_, isShown)) shareSide();
}

void Workspace::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() == QEvent::FontChange) shareSide();
}

// A step that opens another scene sets its probes and the lower area anew: what is so in the end counts.
void Workspace::shareSide() {
  QTimer::singleShot(0, this, &Workspace::shareSideNow);
}

void Workspace::shareSideNow() {
  if (learn_->isHidden() || probe_->isHidden() || learn_->isFloating() || probe_->isFloating() ||
      dockWidgetArea(learn_) != dockWidgetArea(probe_))
    return;
  layout()->activate();
  const int head = learn_->height() - of_.learn->height();
  const int few = head + of_.learn->minimumSizeHint().height() + kFewLines * fontMetrics().lineSpacing();
  const int least = probe_->titleBarWidget()->height() + scaled(isProbed_ ? kTightProbe : kNoProbe);
  takeFromPages(few + least - learn_->height() - probe_->height());
  const int column = learn_->height() + probe_->height();
  const int most =
      std::max(static_cast<int>(kLessonShare * column), kLessonLines * fontMetrics().lineSpacing());
  const int room = column - probe_->titleBarWidget()->height();
  const int wanted = std::min(head + of_.learn->sizeHint().height(), most);
  const int forProbe = scaled(isPageShown_ ? kPageOfProbe : kLeastProbe);
  const int fair = std::min(room - scaled(kTightProbe), std::max(few, room - forProbe));
  const int needed = std::min(few, room - scaled(kHiddenProbe));
  const int learn =
      isProbed_ ? std::min(wanted, std::max(fair, needed)) : std::max(room - scaled(kNoProbe), needed);
  resizeDocks({learn_, probe_}, {std::max(1, learn), std::max(1, column - learn)}, Qt::Vertical);
}

// Where texts are large, pages below would leave a lesson hardly a line.
void Workspace::takeFromPages(int missing) {
  if (missing <= 0 || lower_->isHidden() || lower_->isFloating() ||
      dockWidgetArea(lower_) != Qt::BottomDockWidgetArea)
    return;
  resizeDocks({lower_}, {std::max(1, lower_->height() - missing)}, Qt::Vertical);
  layout()->activate();
}

PanelDock* Workspace::addDock(const QString& id, const QString& title, Qt::DockWidgetArea area) {
  auto* dock = new PanelDock(id, title, this);
  docks_.push_back(dock);
  addDockWidget(area, dock);
  connect(dock, &PanelDock::headPressed, this, [this, dock] { setTornOff(dock, !isTornOff(dock)); });
  connect(dock, &QDockWidget::topLevelChanged, this, &Workspace::layoutChanged);
  connect(dock, &PanelDock::closed, this, &Workspace::layoutChanged);
  return dock;
}

void Workspace::addPages() {
  for (int index = 0; index < kLowerPageCount; ++index) {
    const auto page = static_cast<LowerPage>(index);
    PanelDock* dock = addDock(QStringLiteral("page.") + lowerPageId(page), of_.lower->title(page),
                              Qt::BottomDockWidgetArea);
    dock->setHead(nullptr);
    dock->addCloseButton();
    dock->hide();
    pages_[static_cast<std::size_t>(index)] = dock;
  }
  connect(of_.lower, &LowerArea::tearOffRequested, this,
          [this](LowerPage page) { setTornOff(dockOf(page), true); });
}

bool Workspace::isPage(const PanelDock* dock, LowerPage& page) const {
  const auto found = std::ranges::find(pages_, dock);
  if (found == pages_.end()) return false;
  page = static_cast<LowerPage>(found - pages_.begin());
  return true;
}

bool Workspace::isTornOff(const PanelDock* dock) const {
  LowerPage page{};
  return isPage(dock, page) ? of_.lower->isTaken(page) : dock->isFloating();
}

void Workspace::setTornOff(PanelDock* dock, bool tornOff) {
  if (tornOff == isTornOff(dock)) return;
  if (!tornOff) dock->giveFocusBack();
  LowerPage page{};
  if (!isPage(dock, page)) {
    dock->setFloating(tornOff);
  } else if (tornOff) {
    dock->setPanel(of_.lower->take(page));
    placeFirst(dock);
  } else {
    QWidget* panel = of_.lower->page(page);
    const bool isShown = !panel->isHidden();
    dock->setPanel(nullptr); // hides it
    panel->setVisible(isShown);
    of_.lower->putBack(page);
    dock->setFloating(false);
  }
  if (dock->isFloating() && dock->isVisible()) dock->activateWindow();
  Q_EMIT layoutChanged();
}

// Over the lower part of the window; later it floats where it was.
void Workspace::placeFirst(PanelDock* dock) {
  if (dock->isFloating()) return;
  dock->setFloating(true);
  QRect place(QPoint(), kFirstWindow.boundedTo(size()));
  place.moveCenter(mapToGlobal(rect().center()));
  dock->setGeometry(reachablePlace(place, screenPlaces(screen())));
}

// While an edge is dragged, Qt goes back, move by move, to the layout that was there when it was pressed:
// places that were given meanwhile are gone, and their items with them.
void Workspace::endDrags() {
  for (PanelDock* dock : docks_) dock->endDrag();
  QMouseEvent released(QEvent::MouseButtonRelease, {}, mapToGlobal(QPointF()), Qt::LeftButton, {}, {});
  QMainWindow::event(&released);
}

void Workspace::placeDocks() {
  endDrags();
  for (PanelDock* dock : docks_) setTornOff(dock, false);
  addDockWidget(Qt::LeftDockWidgetArea, left_);
  addDockWidget(Qt::RightDockWidgetArea, learn_);
  splitDockWidget(learn_, probe_, Qt::Vertical);
  addDockWidget(Qt::BottomDockWidgetArea, lower_);
  for (PanelDock* page : pages_) addDockWidget(Qt::BottomDockWidgetArea, page);
  for (PanelDock* dock : docks_) dock->follow();
}

void Workspace::resetLayout() {
  placeDocks();
  of_.left->setShown(true);
  of_.probe->show();
  of_.lower->setShown(of_.lower->current(), false);
  setFirstSizes(width());
  Q_EMIT layoutChanged();
}

// The probe's last column, what values mean, shows where the window has room for it.
void Workspace::setFirstSizes(int windowWidth) {
  layout()->activate();
  // With larger texts wider, as far as the views keep a good part of the window.
  const auto wide = [windowWidth](int px, double share) {
    return std::max(px, std::min(scaled(px), static_cast<int>(share * windowWidth)));
  };
  resizeDocks({left_, probe_}, {wide(292, kLeftShare), wide(windowWidth >= 1500 ? 468 : 388, kProbeShare)},
              Qt::Horizontal);
  resizeDocks({lower_}, {of_.lower->sizeHint().height()}, Qt::Vertical);
}

void Workspace::moveToNextScreen() {
  const QList<QScreen*> screens = QGuiApplication::screens();
  for (PanelDock* dock : docks_) {
    if (!dock->isFloating()) continue;
    const QRect from = dock->screen()->availableGeometry();
    const qsizetype next = (screens.indexOf(dock->screen()) + 1) % screens.size();
    const QRect to = screens[next]->availableGeometry();
    const QRect moved = dock->geometry().translated(to.topLeft() - from.topLeft());
    dock->setGeometry(reachablePlace(moved, {to}));
  }
}

void Workspace::comeBack() {
  for (PanelDock* dock : docks_)
    if (dock->isFloating()) dock->setGeometry(reachablePlace(dock->geometry(), screenPlaces(screen())));
}

QJsonObject Workspace::state() const {
  QJsonArray tornOff;
  for (int index = 0; index < kLowerPageCount; ++index) {
    const auto page = static_cast<LowerPage>(index);
    if (of_.lower->isTaken(page))
      tornOff << QJsonObject{{QStringLiteral("page"), lowerPageId(page)},
                             {QStringLiteral("shown"), of_.lower->shows(page)}};
  }
  return {{QStringLiteral("places"), QString::fromLatin1(saveState(kStateVersion).toBase64())},
          {QStringLiteral("tornOff"), tornOff},
          {QStringLiteral("size"), QJsonArray{width(), height()}}};
}

void Workspace::setState(const QJsonObject& state) {
  std::array<bool, kLowerPageCount> tornOff{};
  for (const QJsonValue& value : state.value(QLatin1String("tornOff")).toArray()) {
    const QJsonObject entry = value.toObject();
    const auto page = lowerPageWithId(entry.value(QLatin1String("page")).toString());
    if (!page) continue;
    tornOff[static_cast<std::size_t>(*page)] = true;
    setTornOff(dockOf(*page), true);
    of_.lower->setShown(*page, entry.value(QLatin1String("shown")).toBool());
  }
  for (std::size_t page = 0; page < tornOff.size(); ++page)
    if (!tornOff[page]) setTornOff(pages_[page], false);
  const QByteArray places =
      QByteArray::fromBase64(state.value(QLatin1String("places")).toString().toLatin1());
  const QJsonArray size = state.value(QLatin1String("size")).toArray();
  savedSize_ = {size.at(0).toInt(), size.at(1).toInt()};
  const auto restorePlaces = [this, places] {
    endDrags();
    restoreState(places, kStateVersion);
    for (PanelDock* dock : docks_) dock->follow();
    comeBack();
    makeRoomForViews();
  };
  restorePlaces();
  // Again when a window that is about to get its size, or its texts theirs, has been laid out: least sizes of
  // before would hold panels wide.
  QTimer::singleShot(0, this, [restorePlaces] {
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    restorePlaces();
  });
  Q_EMIT layoutChanged();
}

// Only where the window is smaller than it was: else it is as somebody wanted it.
void Workspace::makeRoomForViews() {
  layout()->activate();
  const QSize missing = size() * kViewsShare - of_.views->size();
  if (missing.width() > 0 && width() < savedSize_.width()) shrink(Qt::Horizontal, missing.width());
  if (missing.height() > 0 && height() < savedSize_.height()) shrink(Qt::Vertical, missing.height());
}

// Those at opposite sides give in proportion to what they can; those at one side have the same size.
void Workspace::shrink(Qt::Orientation orientation, int missing) {
  const bool isAcross = orientation == Qt::Horizontal;
  const Qt::DockWidgetArea first = isAcross ? Qt::LeftDockWidgetArea : Qt::TopDockWidgetArea;
  const Qt::DockWidgetArea second = isAcross ? Qt::RightDockWidgetArea : Qt::BottomDockWidgetArea;
  const auto along = [isAcross](const QSize& size) { return isAcross ? size.width() : size.height(); };
  QList<QDockWidget*> docks;
  QList<int> sizes, slacks;
  int total = 0;
  for (const Qt::DockWidgetArea area : {first, second})
    for (PanelDock* dock : docks_) {
      if (dock->isHidden() || dock->isFloating() || dockWidgetArea(dock) != area) continue;
      docks << dock;
      sizes << along(dock->size());
      slacks << std::max(0, sizes.last() - along(dock->minimumSizeHint()));
      total += slacks.last();
      break; // the first of its side stands for all of them
    }
  missing = std::min(missing, total);
  for (qsizetype side = 0; side < sizes.size(); ++side)
    sizes[side] -= missing * slacks[side] / std::max(1, total);
  if (!docks.isEmpty()) resizeDocks(docks, sizes, orientation);
}

} // namespace taa::app
