#include "app/panels/PipelinePanel.h"

#include "app/style/Numbers.h"
#include "app/style/PictureImage.h"
#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "app/widgets/IconButton.h"
#include "app/widgets/IntermediateRow.h"
#include "app/widgets/ScrollPlace.h"
#include "app/widgets/SearchField.h"
#include "app/widgets/SectionHeader.h"
#include "app/widgets/areas/FocusOrder.h"
#include "app/widgets/parameters/ChoiceButton.h"
#include "app/widgets/parameters/ParameterRow.h"

#include "core/render/CaptureFacts.h"
#include "core/settings/Faults.h"
#include "core/settings/Presets.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QJsonArray>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string_view>
#include <utility>

namespace taa::app {

namespace {

/// Stages that are unfolded at the first start: what one changes and looks at most.
bool startsExpanded(Stage stage) {
  return stage == Stage::Neighborhood || stage == Stage::RectifyHistory || stage == Stage::BlendWeight ||
         stage == Stage::Blend;
}

/// What the settings of a stage come to, for its folded heading: its first relevant choice.
QString summary(Stage stage, const Settings& settings) {
  if (stage == Stage::Jitter && !isTaaOn(settings)) return PipelinePanel::tr("TAA off");
  if (stage == Stage::Faults)
    return isFaulty(settings) ? PipelinePanel::tr("injected") : PipelinePanel::tr("none");
  for (const Parameter& row : parameters())
    if (row.stage == stage && row.kind == ParameterKind::Choice && isRelevant(row, settings)) {
      const auto index = static_cast<std::size_t>(row.get(settings));
      return index < row.choices.size() ? qtext(row.choices[index].label) : QString();
    }
  return {};
}

/// What a stage did to the frame, in a few words.
QString stageShareText(const StageShare& stage, bool startsHistory) {
  const bool isNone = stage.share == 0.0;
  const QString share = percentText(100.0 * stage.share);
  switch (stage.stage) {
  case Stage::DilateMotion:
    return isNone ? PipelinePanel::tr("changed nothing") : PipelinePanel::tr("%1 from neighbors").arg(share);
  case Stage::Reproject:
    return isNone ? PipelinePanel::tr("all on the screen")
                  : PipelinePanel::tr("%1 off the screen").arg(share);
  case Stage::RectifyHistory:
    if (startsHistory) return PipelinePanel::tr("no history yet");
    return isNone ? PipelinePanel::tr("changed nothing") : PipelinePanel::tr("%1 pulled").arg(share);
  case Stage::ValidateHistory:
    if (startsHistory) return PipelinePanel::tr("no history yet");
    return isNone ? PipelinePanel::tr("rejected nothing") : PipelinePanel::tr("%1 rejected").arg(share);
  case Stage::Output:
    return isNone ? PipelinePanel::tr("changed nothing") : PipelinePanel::tr("%1 changed").arg(share);
  default:
    return {};
  }
}

/// Whether it stood elsewhere.
bool putAt(QVBoxLayout* layout, int place, QWidget* widget) {
  if (layout->itemAt(place)->widget() == widget) return false;
  layout->removeWidget(widget);
  layout->insertWidget(place, widget);
  return true;
}

} // namespace

PipelinePanel::PipelinePanel(QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(makeTop());

  auto* content = new QWidget;
  column_ = new QVBoxLayout(content);
  column_->setContentsMargins(0, 0, 0, 2 * kUnit);
  column_->setSpacing(0);
  noHits_ = new NoHits;
  column_->addWidget(noHits_);
  for (const StageInfo& stage : kStages) {
    Section section = makeSection(stage);
    column_->addWidget(section.header);
    column_->addWidget(section.body);
    sections_.push_back(std::move(section));
  }
  column_->addStretch(1);

  scroll_ = new QScrollArea;
  scroll_->setWidgetResizable(true);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
  scroll_->setFocusPolicy(Qt::NoFocus);
  scroll_->setWidget(content);
  layout->addWidget(scroll_, 1);
  setMinimumWidth(260);
}

QWidget* PipelinePanel::makeTop() {
  auto* top = new QWidget;
  auto* layout = new QVBoxLayout(top);
  layout->setContentsMargins(2 * kUnit, 2 * kUnit, 2 * kUnit, 2 * kUnit);
  layout->setSpacing(kUnit);

  auto* line = new QHBoxLayout;
  auto* title = new QLabel(tr("Preset"));
  presets_ = new ChoiceButton;
  presets_->setObjectName(QStringLiteral("presets"));
  presets_->setAccessibleName(tr("Preset"));
  presets_->setToolTip(tr("The preset these settings started from; * when some were changed since."));
  line->addWidget(title);
  line->addStretch(1);
  line->addWidget(presets_);
  auto* compare = new IconButton(QStringLiteral("differences"),
                                 tr("Compare presets, rename and delete your own (Ctrl+D)"));
  connect(compare, &IconButton::clicked, this, &PipelinePanel::comparisonRequested);
  line->addWidget(compare);
  layout->addLayout(line);

  search_ = new SearchField(tr("Search settings and intermediates"));
  search_->setObjectName(QStringLiteral("search"));
  layout->addWidget(search_);

  setUserPresets({});
  connect(presets_, &ChoiceButton::chosen, this, [this](int index) { Q_EMIT presetChosen(presetAt(index)); });
  connect(presets_, &ChoiceButton::considered, this,
          [this](int index) { Q_EMIT presetConsidered(presetAt(index)); });
  connect(search_, &SearchField::textChanged, this, &PipelinePanel::applySearch);
  return top;
}

void PipelinePanel::setUserPresets(const std::vector<UserPreset>& presets) {
  userPresets_ = presets;
  QStringList labels, descriptions;
  std::vector<ChoiceButton::Part> parts;
  for (const Preset& preset : builtinPresets()) {
    if (const PresetGroup* group = startedGroup(preset))
      parts.push_back({static_cast<int>(labels.size()), qtext(group->label)});
    labels << qtext(preset.label);
    descriptions << qtext(preset.description);
  }
  if (!presets.empty()) parts.push_back({static_cast<int>(labels.size()), {}});
  for (const UserPreset& preset : presets) {
    labels << preset.label;
    descriptions << tr("Saved from the window.");
  }
  presets_->setChoices(labels, descriptions);
  presets_->setParts(parts);
}

QString PipelinePanel::presetAt(int index) const {
  const auto& builtin = builtinPresets();
  const auto place = static_cast<std::size_t>(index);
  if (place < builtin.size()) return QString::fromStdString(builtin[place].id);
  return userPresets_.at(place - builtin.size()).path;
}

PipelinePanel::Section PipelinePanel::makeSection(const StageInfo& stage) {
  Section section;
  section.header = new SectionHeader(qtext(stage.label));
  section.header->setToolTip(qtext(stage.description));
  section.header->setObjectName(QStringLiteral("stage.") + qtext(stage.id));
  section.header->setChecked(startsExpanded(stage.stage));
  section.body = new QWidget;
  for (const Parameter& row : parameters())
    if (row.stage == stage.stage) {
      auto* control = new ParameterRow(row);
      connect(control, &ParameterRow::edited, this, &PipelinePanel::parameterEdited);
      connect(control, &ParameterRow::considered, this, &PipelinePanel::parameterConsidered);
      section.parameters.push_back(control);
      parameterRows_.push_back(control);
    }
  for (const Intermediate& row : kIntermediates)
    if (row.stage == stage.stage) {
      auto* item = new IntermediateRow(row);
      connect(item, &IntermediateRow::chosen, this, &PipelinePanel::intermediateChosen);
      section.intermediates.push_back(item);
      intermediateRows_.push_back(item);
    }
  layOut(section);
  section.main = mainRow(stage.stage);
  if (section.main) {
    section.header->setHasThumbnail(showsThumbnails_);
    section.header->setToolTip(tr("%1\nThe picture: %2. Click it to show it in the active view.")
                                   .arg(qtext(stage.description), qtext(intermediate(*section.main).label)));
    connect(section.header, &SectionHeader::thumbnailClicked, this,
            [this, id = *section.main] { Q_EMIT intermediateChosen(id, false); });
  }
  section.body->setVisible(section.header->isChecked());
  connect(section.header, &SectionHeader::toggled, this, &PipelinePanel::applySearch);
  return section;
}

void PipelinePanel::layOut(Section& section) {
  section.bodyRows = new QVBoxLayout(section.body);
  section.bodyRows->setContentsMargins(0, 0, 0, 2 * kUnit);
  section.bodyRows->setSpacing(0);
  section.settingsRows = new QVBoxLayout;
  section.settingsRows->setContentsMargins(2 * kUnit, 0, 2 * kUnit,
                                           section.intermediates.empty() ? 0 : kUnit);
  section.settingsRows->setSpacing(2);
  section.bodyRows->addLayout(section.settingsRows);
  for (ParameterRow* row : section.parameters) section.settingsRows->addWidget(row);
  for (IntermediateRow* row : section.intermediates) section.bodyRows->addWidget(row);
}

void PipelinePanel::setSettings(const Settings& settings, const Settings& preset) {
  for (ParameterRow* row : parameterRows_) row->display(settings, preset);
  settings_ = settings;
  showSummaries();
}

void PipelinePanel::showSummaries() {
  for (std::size_t i = 0; i < sections_.size(); ++i)
    sections_[i].header->setSummary(capture_ && kStages[i].stage == Stage::Jitter
                                        ? tr("The capture's own")
                                        : summary(kStages[i].stage, settings_));
}

void PipelinePanel::setCapture(const std::shared_ptr<const CaptureFacts>& capture) {
  if (capture == capture_) return;
  capture_ = capture;
  for (ParameterRow* row : parameterRows_)
    row->setFixed(capture && isFixedBy(*capture, row->row()) ? sentence(whyFixed(row->row())) : QString());
  showSummaries();
}

void PipelinePanel::setPreset(const QString& id, bool changed) {
  const auto& presets = builtinPresets();
  const auto found = std::ranges::find(presets, id.toStdString(), &Preset::id);
  const bool isBuiltin = found != presets.end();
  const auto own = std::ranges::find(
      userPresets_, id, [](const UserPreset& preset) { return QFileInfo(preset.path).baseName(); });
  const bool isOwn = own != userPresets_.end();
  presets_->setCurrent(isBuiltin ? static_cast<int>(found - presets.begin())
                       : isOwn
                           ? static_cast<int>(presets.size()) + static_cast<int>(own - userPresets_.begin())
                           : -1);
  presets_->setCaption((isBuiltin ? qtext(found->label)
                        : isOwn   ? own->label
                                  : id) +
                       (changed ? QStringLiteral(" *") : QString()));
}

void PipelinePanel::setShown(const std::vector<IntermediateId>& views, int active) {
  for (IntermediateRow* row : intermediateRows_) {
    QString letters;
    for (std::size_t view = 0; view < views.size(); ++view)
      if (views[view] == row->id()) letters += QChar(static_cast<char16_t>('A' + view));
    row->setShownIn(letters, QChar(static_cast<char16_t>('A' + active)));
  }
}

void PipelinePanel::setShares(const StageShares& shares) {
  sharesFrame_ = shares.frame;
  for (const StageShare& stage : shares.stages)
    sections_[static_cast<std::size_t>(stage.stage)].header->setNote(
        stageShareText(stage, shares.startsHistory));
}

// What was said of another frame is not true of this one.
void PipelinePanel::setFrame(int frame, bool playing) {
  if (sharesFrame_ < 0 || (frame == sharesFrame_ && !playing)) return;
  sharesFrame_ = -1;
  for (const Section& section : sections_) section.header->setNote({});
}

void PipelinePanel::setShowsThumbnails(bool shows) {
  showsThumbnails_ = shows;
  for (const Section& section : sections_)
    if (section.main) section.header->setHasThumbnail(shows);
  wantThumbnails(isVisible());
}

void PipelinePanel::setPictureSize(const QSize& size) {
  if (size.isEmpty() || size == pictureSize_) return;
  pictureSize_ = size;
  wantThumbnails(isVisible());
}

void PipelinePanel::wantThumbnails(bool visible) {
  const QSize device = SectionHeader::kThumbnailSize * devicePixelRatioF();
  const QSize size =
      showsThumbnails_ && visible ? pictureSize_.scaled(device, Qt::KeepAspectRatio) : QSize(0, 0);
  if (size == wanted_) return;
  wanted_ = size;
  Q_EMIT thumbnailsWanted(size);
}

void PipelinePanel::setThumbnail(const Thumbnail& thumbnail) {
  const Picture& picture = thumbnail.picture;
  if (!showsThumbnails_ || picture.width <= 0 || thumbnail.shotVersion < firstShotVersion_) return;
  for (Section& section : sections_) {
    if (section.main != thumbnail.id) continue;
    section.frame = thumbnail.frame;
    section.header->setThumbnail(imageOver(picture).copy()); // of its own: the picture ends
  }
}

void PipelinePanel::startAnew(std::uint64_t shotVersion) {
  firstShotVersion_ = shotVersion;
  sharesFrame_ = -1;
  for (Section& section : sections_) {
    section.frame = -1;
    section.header->setThumbnail({});
    section.header->setNote({});
  }
}

bool PipelinePanel::hasThumbnailsOf(int frame) const {
  return std::ranges::all_of(sections_,
                             [&](const Section& section) { return !section.main || section.frame == frame; });
}

void PipelinePanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  wantThumbnails(true);
}

void PipelinePanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  wantThumbnails(false); // also while the window is minimized
}

void PipelinePanel::focusSearch() {
  search_->setFocus(Qt::ShortcutFocusReason);
  search_->selectAll();
}

void PipelinePanel::setAllExpanded(bool expanded) {
  for (const Section& section : sections_) section.header->setChecked(expanded);
}

// What is found by its label comes first, stages and rows alike.
void PipelinePanel::applySearch() {
  const Search search(search_->text().toStdString());
  std::vector<Section*> found;
  std::map<const Section*, FoundBy> best;
  bool moved = false;
  for (Section& section : sections_) {
    // A stage that is found by its name shows everything it has.
    const auto whole = search.find({.label = section.header->text().toStdString()});
    bool any = whole.has_value();
    FoundBy strongest = whole ? whole->by : FoundBy::Synonym;
    const auto filter = [&](auto& rows, QVBoxLayout* layout, int first) {
      std::map<const QWidget*, FoundBy> hits;
      for (auto* row : rows) {
        const auto hit = search.find(row->searched());
        row->setVisible(whole || hit);
        row->setFound(hit ? foundText(*hit) : QString());
        hits[row] = hit ? hit->by : FoundBy::Synonym;
        any = any || hit;
        if (hit) strongest = std::min(strongest, hit->by);
      }
      auto order = rows;
      std::ranges::stable_sort(order, {}, [&](const QWidget* row) { return hits.at(row); });
      for (std::size_t i = 0; i < order.size(); ++i)
        moved = putAt(layout, first + static_cast<int>(i), order[i]) || moved;
    };
    filter(section.parameters, section.settingsRows, 0);
    filter(section.intermediates, section.bodyRows, 1);
    section.header->setVisible(any);
    section.body->setVisible(any && (section.header->isChecked() || !search.isEmpty()));
    best[&section] = strongest;
    found.push_back(&section);
  }
  noHits_->tell(search_->text().trimmed(), std::ranges::any_of(found, [](const Section* section) {
                  return !section->header->isHidden();
                }));
  std::ranges::stable_sort(found, {}, [&](const Section* section) { return best.at(section); });
  moved = placeSections(found) || moved;
  if (moved) orderTabs(found);
}

bool PipelinePanel::placeSections(const std::vector<Section*>& sections) {
  int place = 1; // behind what says that nothing was found
  bool moved = false;
  for (const Section* section : sections)
    for (QWidget* part : {static_cast<QWidget*>(section->header), section->body})
      moved = putAt(column_, place++, part) || moved;
  return moved;
}

// The Tab key goes as the eye does.
void PipelinePanel::orderTabs(const std::vector<Section*>& sections) {
  std::vector<QWidget*> areas;
  for (const Section* section : sections) {
    areas.push_back(section->header);
    for (const QVBoxLayout* rows : {section->settingsRows, section->bodyRows})
      for (int at = 0; at < rows->count(); ++at)
        if (QWidget* row = rows->itemAt(at)->widget()) areas.push_back(row);
  }
  orderFocus(*window(), areas);
}

QJsonObject PipelinePanel::state() const {
  QJsonArray open;
  for (std::size_t stage = 0; stage < sections_.size(); ++stage)
    if (sections_[stage].header->isChecked()) open << qtext(kStages[stage].id);
  return {{QStringLiteral("open"), open},
          {QStringLiteral("search"), search_->text()},
          {QStringLiteral("thumbnails"), showsThumbnails_},
          {QStringLiteral("scroll"), scroll_->verticalScrollBar()->value()}};
}

void PipelinePanel::setState(const QJsonObject& state) {
  if (const QJsonValue open = state.value(QLatin1String("open")); open.isArray())
    for (std::size_t stage = 0; stage < sections_.size(); ++stage)
      sections_[stage].header->setChecked(open.toArray().contains(qtext(kStages[stage].id)));
  search_->setText(state.value(QLatin1String("search")).toString());
  setShowsThumbnails(state.value(QLatin1String("thumbnails")).toBool(true));
  const QString at = state.value(QLatin1String("at")).toString();
  const auto stage = std::ranges::find(kStages, at.toStdString(), &StageInfo::id);
  if (stage != kStages.end())
    scrollTo(scroll_, sections_[static_cast<std::size_t>(stage - kStages.begin())].header);
  else
    scrollTo(scroll_->verticalScrollBar(), state.value(QLatin1String("scroll")).toInt());
}

} // namespace taa::app
