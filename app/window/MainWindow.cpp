#include "app/window/MainWindow.h"

#include "app/menus/Menus.h"
#include "app/panels/JitterPanel.h"
#include "app/panels/LowerArea.h"
#include "app/panels/MessagesBar.h"
#include "app/panels/PipelinePanel.h"
#include "app/panels/PlotsPanel.h"
#include "app/panels/ProbePanel.h"
#include "app/panels/ProfilerPanel.h"
#include "app/panels/StatusLine.h"
#include "app/panels/TimelinePanel.h"
#include "app/panels/WeightsPanel.h"
#include "app/session/SessionKeeper.h"
#include "app/style/Icons.h"
#include "app/style/Numbers.h"
#include "app/views/ViewArea.h"
#include "app/views/ViewHeader.h"
#include "app/views/Viewport.h"
#include "app/widgets/Line.h"
#include "app/widgets/bars/WorkBar.h"

#include <QApplication>
#include <QClipboard>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QLabel>
#include <QMenuBar>
#include <QMimeData>
#include <QScreen>
#include <QSettings>
#include <QSplitter>
#include <QTabWidget>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

namespace taa::app {

namespace {

// Where the fan's blades sweep over the bright wall: history is rejected and clipped there in every turn.
constexpr glm::dvec2 kFirstPick{0.64, 0.40};

} // namespace

MainWindow::MainWindow(Session& session, QSettings* settings, QWidget* parent)
    : QMainWindow(parent), session_(session), settings_(settings) {
  setWindowIcon(programIcon());
  setAcceptDrops(true);
  makeParts();
  makeLeft();
  layOut();
  connectFiles();
  menus_ = new Menus(*this);
  connectPanels();
  connectProbe();
  connectProfiler();
  connectLower();
  connectScene();
  connectViews();
  connectSession();
  connectUndo();
  showSettings();
  restore();
  orderFocus();
  showStatus();
}

MainWindow::~MainWindow() {
  // The parts are destroyed after this; what they say on the way is of no interest.
  disconnect(&session_, nullptr, this, nullptr);
  disconnect(&session_.undoStack(), nullptr, this, nullptr);
  disconnect(views_, nullptr, this, nullptr);
}

void MainWindow::makeParts() {
  views_ = new ViewArea;
  pipeline_ = new PipelinePanel;
  probe_ = new ProbePanel;
  profiler_ = new ProfilerPanel;
  plots_ = new PlotsPanel;
  jitter_ = new JitterPanel;
  weights_ = new WeightsPanel;
  timeline_ = new TimelinePanel;
  messages_ = new MessagesBar;
  statusLine_ = new StatusLine;
  work_ = new WorkBar(views_, ViewHeader::kHeight);
  sourceLabel_ = new QLabel;
  sourceLabel_->setFont(secondaryFont());
  sourceLabel_->setForegroundRole(QPalette::PlaceholderText);
  sourceLabel_->setContentsMargins(0, 0, 2 * kUnit, 0);
  lower_ = new LowerArea;
  lower_->add(profiler_, tr("Profiler"));
  lower_->add(plots_, tr("Plots"));
  lower_->add(jitter_, tr("Jitter"));
  lower_->add(weights_, tr("Weights"));
  for (QWidget* panel : {static_cast<QWidget*>(pipeline_), static_cast<QWidget*>(probe_)}) {
    panel->setAutoFillBackground(true);
    panel->setBackgroundRole(QPalette::AlternateBase);
  }
}

void MainWindow::layOut() {
  columns_ = new QSplitter;
  columns_->setHandleWidth(1);
  columns_->setChildrenCollapsible(false);
  columns_->addWidget(left_);
  columns_->addWidget(views_);
  columns_->addWidget(probe_);
  columns_->setStretchFactor(1, 1);
  rows_ = new QSplitter(Qt::Vertical);
  rows_->setHandleWidth(1);
  rows_->setChildrenCollapsible(false);
  rows_->addWidget(columns_);
  rows_->addWidget(lower_);
  rows_->setStretchFactor(0, 1);

  auto* content = new QWidget;
  auto* rows = new QVBoxLayout(content);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(0);
  rows->addWidget(new Line);
  rows->addWidget(messages_);
  rows->addWidget(rows_, 1);
  rows->addWidget(new Line);
  rows->addWidget(timeline_);
  rows->addWidget(new Line);
  rows->addWidget(statusLine_);
  setCentralWidget(content);
  menuBar()->setNativeMenuBar(false);
  menuBar()->setCornerWidget(sourceLabel_);
}

void MainWindow::connectPanels() {
  connect(pipeline_, &PipelinePanel::parameterEdited, &session_, &Session::setParameter);
  connect(pipeline_, &PipelinePanel::presetChosen, &session_, &Session::setPreset);
  connect(pipeline_, &PipelinePanel::parameterConsidered, &session_, &Session::prepareParameter);
  connect(pipeline_, &PipelinePanel::presetConsidered, &session_, &Session::preparePreset);
  connect(pipeline_, &PipelinePanel::intermediateChosen, this, &MainWindow::showIntermediate);
  connect(timeline_, &TimelinePanel::seekRequested, &session_, &Session::seek);
  connect(timeline_, &TimelinePanel::stepRequested, &session_, &Session::step);
  connect(timeline_, &TimelinePanel::playToggled, &session_, &Session::togglePlaying);
  connect(timeline_, &TimelinePanel::loopToggled, &session_, &Session::setLooping);
  connect(work_, &WorkBar::stopRequested, &session_, &Session::cancel);
  connect(messages_, &MessagesBar::hintClosed, this, [this] {
    if (settings_) settings_->setValue(QStringLiteral("hintClosed"), true);
  });
  timeline_->setLooping(session_.isLooping());
}

void MainWindow::connectProfiler() {
  connect(profiler_, &ProfilerPanel::shownChanged, &session_, &Session::setProfiling);
  connect(profiler_, &ProfilerPanel::measureRequested, &session_, &Session::measureStages);
  connect(&session_, &Session::profileArrived, profiler_, &ProfilerPanel::addProfile);
  connect(&session_, &Session::stageCostsArrived, profiler_, &ProfilerPanel::setStageCosts);
  connect(pipeline_, &PipelinePanel::thumbnailsWanted, &session_,
          [this](const QSize& size) { session_.setThumbnails(size.width(), size.height()); });
  connect(&session_, &Session::thumbnailArrived, pipeline_, &PipelinePanel::setThumbnail);
}

void MainWindow::connectViews() {
  connectComparing();
  connect(views_, &ViewArea::shownChanged, this, [this] {
    pipeline_->setShown(views_->shown(), views_->activeIndex());
    menus_->refresh();
  });
  connect(views_, &ViewArea::hoverChanged, this, &MainWindow::showHover);
  connect(views_, &ViewArea::picked, &session_, [this](glm::ivec2 pixel) { session_.setPick(pixel); });
  connect(views_, &ViewArea::pickMoved, &session_, [this](int dx, int dy) {
    session_.movePick(dx, dy);
    if (session_.pick()) views_->active()->viewport()->reveal(*session_.pick());
  });
  connect(views_, &ViewArea::intermediateRequested, this, &MainWindow::chooseIntermediate);
  pipeline_->setShown(views_->shown(), views_->activeIndex());
}

void MainWindow::connectSession() {
  connect(&session_, &Session::statusChanged, this, &MainWindow::showStatus);
  connect(&session_, &Session::settingsChanged, this, &MainWindow::showSettings);
  connect(&session_, &Session::errorOccurred, messages_, &MessagesBar::showError);
  connect(&session_, &Session::pictureArrived, this, [this](int view) {
    const std::shared_ptr<const ViewResult>& picture = session_.picture(view);
    if (!picture) return;
    views_->view(view)->setResult(picture);
    statusLine_->setPicture(picture->subject);
  });
  connect(&session_, &Session::workChanged, this, [this] {
    const Work& work = session_.work();
    work_->setWork(QString::fromStdString(work.what), work.done, work.total);
    profiler_->setMeasuring(work.what == "Measuring stages");
  });
}

void MainWindow::showStatus() {
  const Status& status = session_.status();
  timeline_->setStatus(status);
  statusLine_->setStatus(status);
  showHistory();
  profiler_->setDriver(status.driver);
  if (session_.isOpen()) {
    views_->setPictureSize({status.width, status.height});
    views_->setPlaying(status.playing);
    pipeline_->setPictureSize({status.width, status.height});
  }
  if (session_.isOpen() && status.source != shownSource_) {
    shownSource_ = status.source;
    pipeline_->startAnew(status.subject);
    messages_->clear();
    QStringList warnings;
    for (const std::string& warning : status.warnings) warnings << QString::fromStdString(warning);
    messages_->setWarnings(warnings);
    // Nobody's change, so there is nothing to undo.
    if (status.source == kFirstSource && !session_.pick() && !keeper_->isFromSession())
      session_.setPins({{.pixel = glm::ivec2(kFirstPick * glm::dvec2(status.width, status.height)),
                         .frame = status.info.frame}},
                       0);
  }
  menus_->refresh();
  const bool isFile = !status.source.empty() && !status.source.starts_with("builtin:");
  const QString source = QString::fromStdString(status.source);
  QStringList parts;
  if (session_.isOpen()) parts << (isFile ? QFileInfo(source).fileName() : source);
  parts << QString::fromStdString(session_.presetId()) +
               (session_.isPresetChanged() ? QStringLiteral("*") : QString());
  if (session_.isOpen()) parts << QStringLiteral("%1×%2").arg(status.width).arg(status.height);
  views_->setSettingsName(QString::fromStdString(session_.presetId()) +
                          (session_.isPresetChanged() ? QStringLiteral("*") : QString()));
  const QString text = parts.join(QStringLiteral(" · "));
  if (text == sourceLabel_->text()) return;
  sourceLabel_->setText(text);
  menuBar()->setCornerWidget(sourceLabel_); // places it anew for its new width
  setWindowTitle(tr("%1 - TAA Inspector").arg(text));
}

void MainWindow::showSettings() {
  pipeline_->setSettings(session_.settings(), session_.presetSettings());
  pipeline_->setPreset(QString::fromStdString(session_.presetId()), session_.isPresetChanged());
  views_->setSpaces(session_.settings().space, session_.otherLanes());
  showStatus();
}

void MainWindow::showIntermediate(IntermediateId id, bool inOtherView) {
  if (inOtherView && views_->viewCount() == 1) views_->setViewCount(2);
  (inOtherView ? views_->other() : views_->active())->setIntermediate(id);
}

void MainWindow::setTheme(ThemeChoice choice) {
  theme_ = choice;
  applyTheme(*qApp, choice);
  if (settings_) settings_->setValue(QStringLiteral("theme"), themeName(choice));
  menus_->refresh();
}

void MainWindow::setPanelVisible(QWidget* panel, bool visible) {
  (panel == pipeline_ ? left_ : panel)->setVisible(visible);
  if (menus_) menus_->refresh();
}

void MainWindow::copyProfile(bool asCsv) {
  if (profiler_->isVisible())
    QApplication::clipboard()->setText(asCsv ? profiler_->csv() : profiler_->text());
}

void MainWindow::measureStages() {
  setLowerPage(LowerPage::Profiler, true);
  session_.measureStages();
}

void MainWindow::restore() {
  const bool closed = settings_ && settings_->value(QStringLiteral("hintClosed")).toBool();
  if (!closed)
    messages_->showHint(tr("Step back with the comma key.  Right-click a pixel to see every value at it.  "
                           "Press ? for all keys."));
  resize(QSize(1600, 900).boundedTo(screen()->availableSize()));
  if (settings_) restoreGeometry(settings_->value(QStringLiteral("geometry")).toByteArray());
}

void MainWindow::remember() {
  if (!settings_) return;
  settings_->setValue(QStringLiteral("geometry"), saveGeometry());
  settings_->setValue(QStringLiteral("columns"), columns_->saveState());
}

void MainWindow::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  if (std::exchange(wasShown_, true)) return;
  const bool isKnown =
      settings_ && columns_->restoreState(settings_->value(QStringLiteral("columns")).toByteArray());
  // The probe's last column, what values mean, shows where the window has room for it.
  if (!isKnown) columns_->setSizes({292, width(), width() >= 1500 ? 468 : 388});
  sourceLabel_->setMinimumHeight(menuBar()->height()); // in line with the menus
  menuBar()->setCornerWidget(sourceLabel_);
  views_->active()->viewport()->setFocus();
  keeper_->setFirstState(state());
}

void MainWindow::closeEvent(QCloseEvent* event) {
  remember();
  keeper_->leave();
  QMainWindow::closeEvent(event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  if (urls.isEmpty()) return;
  event->acceptProposedAction();
  if (urls.first().isLocalFile())
    openSource(urls.first().toLocalFile());
  else
    messages_->showError(
        tr("%1 is not a file on this machine; save it first, then open it.").arg(urls.first().toString()));
}

} // namespace taa::app
