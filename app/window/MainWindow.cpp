#include "app/window/MainWindow.h"

#include "app/commands/CameraFiles.h"
#include "app/commands/DoctorCommands.h"
#include "app/commands/EscapeKey.h"
#include "app/commands/Exports.h"
#include "app/commands/Flight.h"
#include "app/commands/GoToPrompts.h"
#include "app/commands/ImportFrames.h"
#include "app/commands/LadderSteps.h"
#include "app/commands/OwnPresets.h"
#include "app/commands/ProbeCommands.h"
#include "app/commands/ThemeSetting.h"
#include "app/commands/ViewChoices.h"
#include "app/docks/LoadingNote.h"
#include "app/docks/PanelCycle.h"
#include "app/docks/PanelDock.h"
#include "app/docks/Workspace.h"
#include "app/doctor/DoctorPanel.h"
#include "app/figures/FigureExport.h"
#include "app/learn/LearnPanel.h"
#include "app/learn/Learning.h"
#include "app/menus/CommandLists.h"
#include "app/menus/EditMenu.h"
#include "app/menus/FaultsMenu.h"
#include "app/menus/FileMenu.h"
#include "app/menus/FrameMenu.h"
#include "app/menus/HelpMenu.h"
#include "app/menus/LayoutMenu.h"
#include "app/menus/PipelineMenu.h"
#include "app/menus/ProbeMenu.h"
#include "app/menus/SceneMenu.h"
#include "app/menus/ViewMenu.h"
#include "app/panels/JitterPanel.h"
#include "app/panels/LeftArea.h"
#include "app/panels/LineagePanel.h"
#include "app/panels/LowerArea.h"
#include "app/panels/MessagesBar.h"
#include "app/panels/PipelinePanel.h"
#include "app/panels/PlotsPanel.h"
#include "app/panels/ProbePanel.h"
#include "app/panels/ProfilerPanel.h"
#include "app/panels/ScenePanel.h"
#include "app/panels/StatusLine.h"
#include "app/panels/TimelinePanel.h"
#include "app/panels/WeightsPanel.h"
#include "app/room/Presenter.h"
#include "app/session/ShaderWatch.h"
#include "app/session/keeping/SessionKeeper.h"
#include "app/style/Icons.h"
#include "app/style/Text.h"
#include "app/style/TextSize.h"
#include "app/views/ViewArea.h"
#include "app/views/ViewHeader.h"
#include "app/views/Viewport.h"
#include "app/views/legend/Legend.h"
#include "app/widgets/Line.h"
#include "app/widgets/Note.h"
#include "app/widgets/areas/FocusOrder.h"
#include "app/widgets/bars/FlightBar.h"
#include "app/widgets/bars/MenuTitle.h"
#include "app/widgets/bars/OfferBar.h"
#include "app/widgets/bars/ProbeBar.h"
#include "app/widgets/bars/WorkBar.h"
#include "app/window/Dialogs.h"
#include "app/window/FlightPresenter.h"
#include "app/window/HoverText.h"
#include "app/window/PlotPresenter.h"
#include "app/window/ProbePresenter.h"
#include "app/window/ScenePresenter.h"
#include "app/window/Screenshot.h"
#include "app/window/ViewPresenter.h"
#include "app/window/WindowFigures.h"
#include "app/window/WindowState.h"
#include "app/window/WindowUndo.h"
#include "app/window/verdict/LineagePresenter.h"
#include "app/window/verdict/VerdictPresenter.h"

#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMenuBar>
#include <QMimeData>
#include <QScreen>
#include <QSettings>
#include <QStringList>
#include <QStyle>
#include <QUrl>
#include <QVBoxLayout>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace taa::app {

namespace {

// Where the fan's blades sweep over the bright wall: history is rejected and clipped there in every turn.
constexpr glm::dvec2 kFirstProbe{0.64, 0.40};

/// "balanced*": the star says that settings were changed since.
QString settingsName(const Session& session) {
  return QString::fromStdString(session.presets().presetId()) +
         (session.presets().isPresetChanged() ? QStringLiteral("*") : QString());
}

/// What the window is called by: source, settings, size.
QString titleText(const Session& session) {
  const Status& status = session.status();
  if (!session.isOpen()) return settingsName(session);
  const QString source = QString::fromStdString(status.source);
  const bool isFile = !status.source.starts_with("builtin:");
  const QStringList parts{isFile ? QFileInfo(source).fileName() : source, settingsName(session),
                          QStringLiteral("%1×%2").arg(status.width).arg(status.height)};
  return parts.join(QStringLiteral(" · "));
}

} // namespace

MainWindow::MainWindow(Session& session, QSettings* settings, QWidget* parent)
    : QMainWindow(parent), session_(session), settings_(settings) {
  setWindowIcon(programIcon());
  setAcceptDrops(true);
  makePanels();
  layOut();
  makeKeeper();
  makeCommands();
  makeRoom();
  makeMenus();
  connectPanels();
  makeFeeds();
  connectProfiler();
  connectSession();
  connectMessages();
  connectMenus();
  watchShaders();
  showSettings();
  commands_->refresh();
  restore();
  orderPanels();
  connect(workspace_, &Workspace::layoutChanged, this, &MainWindow::orderPanels, Qt::QueuedConnection);
}

MainWindow::~MainWindow() {
  // The panels are destroyed after this; what they say on the way is of no interest.
  const QObject* const parts[] = {&session_,         &session_.presets(),  &session_.probes(),
                                  &session_.scene(), &session_.verdicts(), &session_.undoStack()};
  for (const QObject* part : parts) disconnect(part, nullptr, this, nullptr);
  disconnect(views_, nullptr, this, nullptr);
  // A panel that is torn off is a window, which says that it is hidden when it is destroyed: after the views.
  for (PanelDock* dock : findChildren<PanelDock*>())
    if (dock->isFloating()) dock->hide();
}

void MainWindow::makePanels() {
  views_ = new ViewArea;
  pipeline_ = new PipelinePanel;
  scene_ = new ScenePanel;
  left_ = new LeftArea(pipeline_, scene_);
  learn_ = new LearnPanel;
  probe_ = new ProbePanel;
  profiler_ = new ProfilerPanel;
  plots_ = new PlotsPanel;
  jitter_ = new JitterPanel;
  weights_ = new WeightsPanel;
  lineage_ = new LineagePanel;
  doctor_ = new DoctorPanel;
  timeline_ = new TimelinePanel;
  messages_ = new MessagesBar;
  statusLine_ = new StatusLine;
  work_ = new WorkBar(views_, ViewHeader::barHeight());
  flightBar_ = new FlightBar(views_, legendHeight() + 8);
  new LoadingNote(session_, views_);
  lower_ = new LowerArea;
  lower_->add(profiler_, tr("Profiler"));
  lower_->add(plots_, tr("Plots"));
  lower_->add(jitter_, tr("Jitter"));
  lower_->add(weights_, tr("Weights"));
  lower_->add(lineage_, tr("Lineage"));
  lower_->add(doctor_, tr("Doctor"));
  for (QWidget* panel : {static_cast<QWidget*>(pipeline_), static_cast<QWidget*>(probe_)}) {
    panel->setAutoFillBackground(true);
    panel->setBackgroundRole(QPalette::AlternateBase);
  }
}

void MainWindow::layOut() {
  workspace_ = new Workspace({views_, left_, learn_, learn_->head(), probe_, probe_->head(), lower_});
  auto* content = new QWidget;
  auto* rows = new QVBoxLayout(content);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(0);
  rows->addWidget(new Line);
  rows->addWidget(messages_);
  rows->addWidget(workspace_, 1);
  rows->addWidget(new Line);
  rows->addWidget(timeline_);
  rows->addWidget(new Line);
  rows->addWidget(statusLine_);
  setCentralWidget(content);
  menuBar()->setNativeMenuBar(false);
  title_ = new MenuTitle(menuBar());
  setSecondary(*title_);
  title_->setContentsMargins(0, 0, 2 * kUnit, 0);
}

// As the eye goes; what is torn off has an order of its own.
std::vector<QWidget*> MainWindow::panelsInOrder() const {
  const std::vector<PanelDock*>& docks = workspace_->docks(); // left, learn, probe, then what lies below
  std::vector<QWidget*> panels{messages_, docks.front(), views_};
  panels.insert(panels.end(), docks.begin() + 1, docks.end());
  panels.insert(panels.end(), {timeline_, statusLine_});
  return panels;
}

void MainWindow::orderPanels() {
  orderFocus(*this, panelsInOrder());
}

void MainWindow::makeKeeper() {
  state_ = std::make_unique<WindowState>(WindowState::Holders{
      session_, *views_, *left_, *pipeline_, *scene_, *probe_, *lower_, *plots_, *timeline_, *workspace_});
  const SessionKeeper::StateAccess access{[this] { return state_->capture(); },
                                          [this](const QJsonObject& state) { state_->apply(state); }};
  keeper_ = new SessionKeeper(session_, access, settings_, this);
  connect(keeper_, &SessionKeeper::offerMade, this, &MainWindow::showOffer);
}

void MainWindow::makeCommands() {
  theme_ = new ThemeSetting(settings_, this);
  flight_ = new Flight(session_, views_, this);
  escape_ = new EscapeKey(session_, *views_, *flight_, this);
  exports_ = new Exports(session_, *views_, keeper_->cameraFolder(), this);
  imports_ = new ImportFrames(*keeper_, this);
  cameras_ = new CameraFiles(session_, this);
  presets_ = new OwnPresets(session_, *pipeline_, settings_, this);
  probeCommands_ = new ProbeCommands(session_, *views_, *probe_, this);
  doctorCommands_ =
      new DoctorCommands(session_, *views_, *doctor_, presets_->folder() + QStringLiteral("/mended"), this);
  ladder_ = new LadderSteps(session_, this);
  prompts_ = new GoToPrompts(session_, *views_, *timeline_, this);
  choices_ = new ViewChoices(session_, *views_, presets_->folder(), this);
  learning_ = new Learning(
      {session_, *keeper_, *learn_, settings_, [this](const QString& name) { return partNamed(name); }},
      this);
  panels_ = new PanelCycle(panelsInOrder(), this);
  commands_ = std::make_unique<Commands>();
  lists_ = new CommandLists(*commands_, session_.presets(), this);
}

void MainWindow::makeRoom() {
  presenter_ = new Presenter(
      {*this,
       session_,
       *views_,
       *learning_,
       *theme_,
       {left_, probe_, timeline_, statusLine_, messages_},
       *workspace_,
       [this](int view) { return hoverText(*views_->view(view), session_.status().info.startsHistory); }});
  centralWidget()->layout()->addWidget(presenter_->line());
  const FigurePanels panels{session_, *views_, *probe_, *profiler_, *plots_, *jitter_, *weights_, *lineage_};
  figures_ = new FigureExport(
      {[panels] { return windowFigures(panels); }, [this] { return figureFacts(session_); }}, this);
}

void MainWindow::makeMenus() {
  QMenuBar* bar = menuBar();
  Commands& all = *commands_;
  bar->addMenu(new FileMenu(all, {*keeper_, *imports_, *exports_, *doctorCommands_, *figures_}, bar));
  bar->addMenu(new EditMenu(
      all, {session_, *escape_, *probeCommands_, *exports_, *profiler_, *left_, *pipeline_, *lists_}, bar));
  auto* view = new ViewMenu(all,
                            {session_.presets(), session_.scene(), *views_, *choices_, *left_, *pipeline_,
                             *probe_, *lower_, *plots_, *theme_, *presenter_, *messages_},
                            bar);
  view->addMenu(new LayoutMenu(all, *workspace_, *panels_, view));
  bar->addMenu(view);
  bar->addMenu(new FrameMenu(all, session_, *timeline_, *prompts_, bar));
  bar->addMenu(new SceneMenu(all, {session_.scene(), *flight_, *cameras_, *left_, *scene_}, bar));
  bar->addMenu(
      new PipelineMenu(all, {session_, *pipeline_, *presets_, *views_, *lower_, *exports_, *ladder_}, bar));
  auto* faults = new FaultsMenu(all, session_, *lower_, *doctorCommands_, bar);
  const auto nameFaults = [this, faults] { faults->setFaultsNamed(!learning_->hidesFault()); };
  connect(learning_, &Learning::stepShown, faults, nameFaults);
  connect(learning_, &Learning::changed, faults, nameFaults);
  bar->addMenu(faults);
  bar->addMenu(new ProbeMenu(all,
                             {session_.probes(), session_.verdicts(), *views_, *probe_, *probeCommands_,
                              *prompts_, session_.scene(), session_},
                             bar));
  bar->addMenu(new HelpMenu(all, session_, *lists_, *learning_, bar));
}

void MainWindow::makeFeeds() {
  probePresenter_ = std::make_unique<ProbePresenter>(session_, *views_, *probe_);
  verdictPresenter_ = std::make_unique<VerdictPresenter>(session_, *views_, *probe_);
  plotPresenter_ = std::make_unique<PlotPresenter>(
      session_, PlotPresenter::Panels{*plots_, *jitter_, *weights_, *timeline_});
  plots_->setFormulas([this](IntermediateId id) { return probe_->formulaOf(id); });
  lineagePresenter_ = std::make_unique<LineagePresenter>(session_, *lineage_, *views_);
  scenePresenter_ = std::make_unique<ScenePresenter>(session_, *views_, *scene_);
  flightPresenter_ = std::make_unique<FlightPresenter>(session_, *flight_, *flightBar_, *messages_);
  viewPresenter_ = std::make_unique<ViewPresenter>(session_, *views_, *pipeline_, *statusLine_);
  undo_ = std::make_unique<WindowUndo>(session_.undoStack(), *views_, *timeline_);
}

// After all else that listens: commands are brought up to date with what has changed by then.
void MainWindow::connectMenus() {
  Commands* all = commands_.get();
  connect(views_, &ViewArea::shownChanged, all, &Commands::refresh);
  connect(left_, &LeftArea::changed, all, &Commands::refresh);
  connect(lower_, &LowerArea::changed, all, &Commands::refresh);
  connect(workspace_, &Workspace::layoutChanged, all, &Commands::refresh);
  connect(scene_, &ScenePanel::selectionChanged, all, &Commands::refresh);
  connect(timeline_, &TimelinePanel::playbackEdited, all, &Commands::refresh);
  connect(timeline_, &TimelinePanel::metricChosen, all, &Commands::refresh);
  connect(flight_, &Flight::changed, all, &Commands::refresh);
  connect(learning_, &Learning::changed, all, &Commands::refresh);
  connect(theme_, &ThemeSetting::changed, all, &Commands::refresh);
  connect(presenter_, &Presenter::changed, all, &Commands::refresh);
  connect(&session_, &Session::statusChanged, all, &Commands::refresh);
  connect(&session_.presets(), &PresetChoices::settingsChanged, all, &Commands::refresh);
  connect(&session_.probes(), &ProbeChoices::changed, all, &Commands::refresh);
  connect(&session_.probes(), &ProbeChoices::changed, workspace_,
          [this] { workspace_->setProbed(session_.probes().pixel().has_value()); });
  connect(probe_, &ProbePanel::whatIfWanted, workspace_, &Workspace::setPageShown);
  connect(learning_, &Learning::stepBegun, workspace_, &Workspace::shareSide);
  connect(learning_, &Learning::answered, workspace_, &Workspace::shareSide);
  connect(&session_.verdicts(), &VerdictChoices::changed, all, &Commands::refresh);
  connect(&session_.undoStack(), &UndoStack::changed, all, &Commands::refresh);
  connect(doctorCommands_, &DoctorCommands::reportChanged, all, &Commands::refresh);
}

void MainWindow::connectPanels() {
  connect(pipeline_, &PipelinePanel::parameterEdited, &session_.presets(), &PresetChoices::setParameter);
  connect(pipeline_, &PipelinePanel::presetChosen, &session_.presets(), &PresetChoices::setPreset);
  connect(pipeline_, &PipelinePanel::parameterConsidered, &session_.presets(),
          &PresetChoices::prepareParameter);
  connect(pipeline_, &PipelinePanel::presetConsidered, &session_.presets(), &PresetChoices::preparePreset);
  session_.onArrival<StageShares>(pipeline_, &PipelinePanel::setShares);
  connect(&session_, &Session::statusChanged, pipeline_, [this] {
    pipeline_->setFrame(session_.status().info.frame, session_.status().playing);
    pipeline_->setCapture(session_.status().capture);
    probe_->bar()->setWhyNoSurfaces(session_.scene().whyNoSurfaces());
  });
  connect(timeline_, &TimelinePanel::seekRequested, &session_, &Session::seek);
  connect(timeline_, &TimelinePanel::stepRequested, this,
          [this](int frames) { session_.post(request::Step{frames}); });
  connect(timeline_, &TimelinePanel::playToggled, &session_, &Session::togglePlaying);
  connect(timeline_, &TimelinePanel::loopToggled, &session_, &Session::setLooping);
  connect(timeline_, &TimelinePanel::playbackEdited, &session_, &Session::setPlayback);
  connect(work_, &WorkBar::stopRequested, this, [this] { session_.post(request::Cancel{}); });
  timeline_->setLooping(session_.isLooping());
}

void MainWindow::connectProfiler() {
  connect(profiler_, &ProfilerPanel::shownChanged, &session_,
          [&session = session_](bool on) { session.post(request::SetProfiling{on}); });
  connect(profiler_, &ProfilerPanel::measureRequested, this,
          [this] { session_.post(request::MeasureStages{}); });
  session_.onArrival<FrameProfile>(profiler_, &ProfilerPanel::addProfile);
  session_.onArrival<StageCosts>(profiler_, &ProfilerPanel::setStageCosts);
  connect(pipeline_, &PipelinePanel::thumbnailsWanted, &session_, [this](const QSize& size) {
    session_.post(request::SetThumbnails{size.width(), size.height()});
  });
  session_.onArrival<Thumbnail>(pipeline_, &PipelinePanel::setThumbnail);
}

void MainWindow::connectSession() {
  connect(&session_, &Session::statusChanged, this, &MainWindow::showStatus);
  connect(&session_.presets(), &PresetChoices::settingsChanged, this, &MainWindow::showSettings);
  connect(&session_, &Session::workChanged, this, [this] {
    const Work& work = session_.work();
    work_->setWork(QString::fromStdString(work.what), work.done, work.total);
    profiler_->setMeasuring(work.kind == WorkKind::Stages);
  });
}

void MainWindow::connectMessages() {
  connect(&session_, &Session::errorOccurred, messages_, &MessagesBar::showError);
  connect(&session_, &Session::offersOpening, messages_, &MessagesBar::offerOpening);
  connect(messages_, &MessagesBar::opensAnyway, &session_, &Session::openAnyway);
  session_.onArrival<ShadersRead>(messages_, [this](const ShadersRead& read) {
    messages_->showShaders(QString::fromStdString(read.error));
  });
  connect(&session_.presets(), &PresetChoices::said, messages_, &MessagesBar::showNote);
  connect(keeper_, &SessionKeeper::said, messages_, &MessagesBar::showNote);
  connect(keeper_, &SessionKeeper::failed, messages_, &MessagesBar::showError);
  connect(probeCommands_, &ProbeCommands::foundWorst, statusLine_, &StatusLine::setHover);
  connect(learning_, &Learning::failed, messages_, &MessagesBar::showError);
  // Lessons say what the hint says, and need its room.
  const auto nameFaults = [this] {
    statusLine_->setFaultsNamed(!learning_->hidesFault());
    probe_->setFaultsNamed(!learning_->hidesFault());
  };
  connect(learning_, &Learning::stepShown, statusLine_, nameFaults);
  connect(learning_, &Learning::changed, statusLine_, nameFaults);
  connect(learning_, &Learning::changed, messages_, [this] {
    if (learning_->isOpen()) messages_->hideHint();
  });
  connect(exports_, &Exports::said, messages_, &MessagesBar::showNote);
  connect(ladder_, &LadderSteps::said, messages_, &MessagesBar::showNote);
  connect(learning_, &Learning::rungChosen, ladder_, &LadderSteps::goTo);
  connect(exports_, &Exports::failed, messages_, &MessagesBar::showError);
  connect(figures_, &FigureExport::said, messages_, &MessagesBar::showNote);
  connect(figures_, &FigureExport::failed, messages_, &MessagesBar::showError);
  connect(cameras_, &CameraFiles::failed, messages_, &MessagesBar::showError);
  connect(doctorCommands_, &DoctorCommands::said, messages_, &MessagesBar::showNote);
  connect(doctorCommands_, &DoctorCommands::failed, messages_, &MessagesBar::showError);
  connect(plots_, &PlotsPanel::failed, messages_, &MessagesBar::showError);
  connect(messages_, &MessagesBar::hintClosed, this, [this] {
    if (settings_) settings_->setValue(QStringLiteral("hintClosed"), true);
  });
}

// Those that come from the program itself do not change.
void MainWindow::watchShaders() {
  const QString folder = ShaderWatch::folder();
  if (folder.isEmpty()) return;
  auto* shaders = new ShaderWatch(folder, this);
  connect(shaders, &ShaderWatch::changed, this, [this] { session_.post(request::ReloadShaders{}); });
}

void MainWindow::showStatus() {
  const Status& status = session_.status();
  timeline_->setStatus(status);
  statusLine_->setStatus(status);
  plotPresenter_->showAlphas();
  profiler_->setDriver(status.driver);
  if (session_.isOpen()) {
    views_->setPictureSize({status.width, status.height});
    views_->setPlaying(status.playing);
    pipeline_->setPictureSize({status.width, status.height});
    if (status.source != shownSource_) startSource(status);
  }
  views_->setSettingsName(settingsName(session_));
  showTitle();
}

void MainWindow::startSource(const Status& status) {
  shownSource_ = status.source;
  pipeline_->startAnew(status.shotVersion);
  messages_->clear();
  QStringList warnings;
  for (const std::string& warning : status.warnings) warnings << sentence(warning);
  messages_->setWarnings(warnings);
  // Nobody's change, so there is nothing to undo.
  if (status.source == kFirstSource && !session_.probes().pixel() && !keeper_->isFromSession())
    session_.probes().set({{.pixel = glm::ivec2(kFirstProbe * glm::dvec2(status.width, status.height)),
                            .frame = status.info.frame}},
                          0);
}

void MainWindow::showTitle() {
  const QString text = titleText(session_);
  if (text == title_->whole()) return;
  title_->setTitle(text);
  setWindowTitle(tr("%1 - TAA Inspector").arg(text));
}

void MainWindow::showSettings() {
  pipeline_->setSettings(session_.presets().settings(), session_.presets().presetSettings());
  pipeline_->setPreset(QString::fromStdString(session_.presets().presetId()),
                       session_.presets().isPresetChanged());
  views_->setSpaces(session_.presets().settings().space, session_.presets().otherLanes());
  showStatus();
}

void MainWindow::setTheme(ThemeChoice choice) {
  theme_->choose(choice);
}

void MainWindow::setTextPercent(int percent) {
  theme_->showTextPercent(percent);
}

void MainWindow::openLesson(const std::string& lesson, int step) {
  learning_->openStep(QString::fromStdString(lesson), step);
}

void MainWindow::openPage(const std::string& name) {
  if (const auto page = lowerPageWithId(QString::fromStdString(name))) lower_->setShown(*page, true);
  if (name == "colorspace") probe_->openTab(ProbeTab::ColorSpace);
  if (name == "whatif") probe_->openTab(ProbeTab::WhatIf);
  if (name == "sensitivity") probe_->openTab(ProbeTab::Sensitivity);
  if (name == "scene") left_->openPage(LeftPage::Scene);
  if (name == "learn") learning_->open();
}

/// As lessons call them (kLessonParts).
QWidget* MainWindow::partNamed(const QString& name) const {
  if (name == QLatin1String("views")) return views_;
  if (name == QLatin1String("probe") || name == QLatin1String("verdict")) return probe_;
  if (name == QLatin1String("pipeline")) return left_;
  if (name == QLatin1String("timeline")) return timeline_;
  if (name == QLatin1String("lower")) return lower_;
  if (name == QLatin1String("menus")) return menuBar();
  return nullptr;
}

void MainWindow::offerTour() {
  if (!learning_->shouldOfferTour() || keeper_->offer()) return;
  learning_->rememberOffer();
  auto* bar = new OfferBar(
      tr("New here? Your first ghost: a tour of five minutes. Help, Learn opens it at any time."),
      tr("Start the tour"), tr("Not now"));
  connect(bar, &OfferBar::accepted, learning_, &Learning::openTour);
  showOffer(bar);
}

// One strip at a time: the hint comes when the offer has gone.
void MainWindow::showOffer(QWidget* bar) {
  qobject_cast<QBoxLayout*>(centralWidget()->layout())->insertWidget(0, bar);
  messages_->hideHint();
  if (const auto* offer = qobject_cast<OfferBar*>(bar))
    connect(offer, &OfferBar::refused, this, &MainWindow::showHint);
}

void MainWindow::showHint() {
  if (learning_->isOpen()) return;
  if (settings_ && settings_->value(QStringLiteral("hintClosed")).toBool()) return;
  messages_->showHint(tr("Step back with the comma key.  Right-click a pixel to see every value at it.  "
                         "Press ? for all keys."));
}

void MainWindow::openDialog(const std::string& name) {
  app::openDialog({this, session_, *views_, *exports_, *presets_, *lists_, *imports_}, name);
}

void MainWindow::takeScreenshot(const QString& file, int frame, const std::string& dialog,
                                const std::string& figure,
                                std::function<void(int code, const QString& text)> done) {
  std::function<void()> opens;
  if (!dialog.empty()) opens = [this, dialog] { openDialog(dialog); };
  std::function<void()> writes;
  if (!figure.empty())
    writes = [this, figure, file] { figures_->writeOrThrow(QString::fromStdString(figure), file); };
  new Screenshot({*this, session_, *views_, *pipeline_, *profiler_, *plots_, *jitter_, *weights_, *lineage_,
                  *doctor_, opens, writes},
                 file, frame, std::move(done));
}

void MainWindow::restore() {
  showHint();
  // The frame around it is not known before it is shown: room for a title bar and its borders is left.
  const int title = style()->pixelMetric(QStyle::PM_TitleBarHeight) + 4 * kUnit;
  theme_->restoreTextSize();
  resize(QSize(1600, 900).boundedTo(screen()->availableSize() - QSize(4 * kUnit, title)));
  if (settings_) restoreGeometry(settings_->value(QStringLiteral("geometry")).toByteArray());
}

void MainWindow::remember() {
  if (!settings_) return;
  settings_->setValue(QStringLiteral("geometry"), saveGeometry());
  settings_->setValue(QStringLiteral("docks"), QJsonDocument(workspace_->state()).toJson());
}

void MainWindow::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  if (std::exchange(wasShown_, true)) return;
  fitFonts(textPercent()); // the style sheet has given widgets the fonts back that they were made with
  const QByteArray docks = settings_ ? settings_->value(QStringLiteral("docks")).toByteArray() : QByteArray();
  workspace_->setFirstSizes(width());
  if (!docks.isEmpty()) workspace_->setState(QJsonDocument::fromJson(docks).object());
  title_->setMinimumHeight(menuBar()->height()); // in line with the menus
  title_->place();
  views_->active()->viewport()->setFocus();
  keeper_->setFirstState(state_->capture());
}

void MainWindow::closeEvent(QCloseEvent* event) {
  presenter_->setOn(false); // what is remembered is the layout that it goes back to
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
  const QString path = urls.first().toLocalFile();
  if (urls.first().isLocalFile())
    imports_->openSource(path);
  else
    messages_->showError(
        tr("%1 is not a file on this machine; save it first, then open it.").arg(urls.first().toString()));
}

} // namespace taa::app
