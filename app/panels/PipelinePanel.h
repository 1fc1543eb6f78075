// The pipeline as a column of stages: each with its settings and the intermediates it produces.
#pragma once

#include "app/session/UserPresets.h"

#include "core/requests/Results.h"
#include "core/settings/Parameters.h"
#include "core/taa/Intermediates.h"

#include <QJsonObject>
#include <QString>
#include <QWidget>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

class QScrollArea;
class QVBoxLayout;

namespace taa::app {

class ChoiceButton;
class IntermediateRow;
class ParameterRow;
class NoHits;
class SearchField;
class SectionHeader;

class PipelinePanel : public QWidget {
  Q_OBJECT
 public:
  explicit PipelinePanel(QWidget* parent = nullptr);

  void setSettings(const Settings& settings, const Settings& preset);
  /// What of the settings is fixed by the capture that is open; null: a scene is.
  void setCapture(const std::shared_ptr<const CaptureFacts>& capture);
  void setPreset(const QString& id, bool changed);
  /// The user's own, which can be chosen after the built-in ones.
  void setUserPresets(const std::vector<UserPreset>& presets);
  /// What views A and B show (B may be absent), and which of them keys act on.
  void setShown(const std::vector<IntermediateId>& views, int active);
  /// A small picture of each stage in its heading, or none.
  void setShowsThumbnails(bool shows);
  bool showsThumbnails() const { return showsThumbnails_; }
  void setThumbnail(const Thumbnail& thumbnail);
  /// Another scene is open: what is known of shot versions before this one is not shown any more.
  void startAnew(std::uint64_t shotVersion);
  /// What the stages did to a frame; it is said in their headings until another frame is on show.
  void setShares(const StageShares& shares);
  void setFrame(int frame, bool playing);
  /// Of the pictures that thumbnails are of.
  void setPictureSize(const QSize& size);
  /// Whether every stage that can has one of this frame.
  bool hasThumbnailsOf(int frame) const;
  /// Moves the keyboard to the search field.
  void focusSearch();
  void setAllExpanded(bool expanded);

  const std::vector<ParameterRow*>& parameterRows() const { return parameterRows_; }
  const std::vector<IntermediateRow*>& intermediateRows() const { return intermediateRows_; }
  SearchField* searchField() const { return search_; }
  /// Which stages are open, what is searched for, and how far it is scrolled; a state may name the stage that
  /// it is scrolled to, "at", in place of that.
  QJsonObject state() const;
  void setState(const QJsonObject& state);
  QSize sizeHint() const override { return {300, 600}; }

 Q_SIGNALS:
  void parameterEdited(const QString& path, double value);
  void presetChosen(const QString& idOrPath);
  /// To compare presets, and rename and delete those of the user's.
  void comparisonRequested();
  /// Mouse or keys are on it: it may be chosen next.
  void parameterConsidered(const QString& path, double value);
  void presetConsidered(const QString& id);
  void intermediateChosen(IntermediateId id, bool inOtherView);
  /// Device pixels; 0: nobody sees them.
  void thumbnailsWanted(const QSize& size);

 protected:
  void showEvent(QShowEvent*) override;
  void hideEvent(QHideEvent*) override;

 private:
  struct Section {
    std::optional<IntermediateId> main;
    int frame = -1; ///< of the thumbnail
    SectionHeader* header = nullptr;
    QWidget* body = nullptr;
    QVBoxLayout *settingsRows = nullptr, *bodyRows = nullptr; ///< of the body
    std::vector<ParameterRow*> parameters;
    std::vector<IntermediateRow*> intermediates;
  };

  QWidget* makeTop();
  Section makeSection(const StageInfo& stage);
  void layOut(Section& section);
  void showSummaries();
  void applySearch();
  bool placeSections(const std::vector<Section*>& sections);
  void orderTabs(const std::vector<Section*>& sections);
  QString presetAt(int index) const;
  void wantThumbnails(bool visible);

  ChoiceButton* presets_ = nullptr;
  std::vector<UserPreset> userPresets_;
  SearchField* search_ = nullptr;
  NoHits* noHits_ = nullptr;
  QScrollArea* scroll_ = nullptr;
  QVBoxLayout* column_ = nullptr; ///< of what scrolls
  std::vector<Section> sections_;
  int sharesFrame_ = -1; ///< that the headings speak of; −1: none
  std::vector<ParameterRow*> parameterRows_;
  std::vector<IntermediateRow*> intermediateRows_;
  std::shared_ptr<const CaptureFacts> capture_; // shared with the status
  Settings settings_;                           ///< on show
  bool showsThumbnails_ = true;
  std::uint64_t firstShotVersion_ = 0; ///< of thumbnails to show
  QSize pictureSize_{16, 9}, wanted_{0, 0};
};

} // namespace taa::app
