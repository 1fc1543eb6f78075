// The pipeline as a column of stages: each with its settings and the intermediates it produces.
#pragma once

#include "core/settings/Parameters.h"
#include "core/taa/Intermediates.h"

#include <QString>
#include <QWidget>

#include <array>
#include <vector>

class QLineEdit;
class QVBoxLayout;

namespace taa::app {

class ChoiceButton;
class IntermediateRow;
class ParameterRow;
class SectionHeader;

class PipelinePanel : public QWidget {
  Q_OBJECT
 public:
  explicit PipelinePanel(QWidget* parent = nullptr);

  void setSettings(const Settings& settings, const Settings& preset);
  void setPreset(const QString& id, bool changed);
  /// What views A and B show (B may be absent), and which of them keys act on.
  void setShown(const std::vector<IntermediateId>& views, int active);
  /// Moves the keyboard to the search field.
  void focusSearch();
  void setAllExpanded(bool expanded);

  const std::vector<ParameterRow*>& parameterRows() const { return parameterRows_; }
  const std::vector<IntermediateRow*>& intermediateRows() const { return intermediateRows_; }
  QLineEdit* searchField() const { return search_; }
  QSize sizeHint() const override { return {300, 600}; }

 Q_SIGNALS:
  void parameterEdited(const QString& path, double value);
  void presetChosen(const QString& id);
  void intermediateChosen(IntermediateId id, bool inOtherView);

 private:
  struct Section {
    SectionHeader* header = nullptr;
    QWidget* body = nullptr;
    std::vector<ParameterRow*> parameters;
    std::vector<IntermediateRow*> intermediates;
  };

  QWidget* makeTop();
  Section makeSection(const StageInfo& stage);
  void layOut(const Section& section);
  void applySearch();

  ChoiceButton* presets_ = nullptr;
  QLineEdit* search_ = nullptr;
  std::vector<Section> sections_;
  std::vector<ParameterRow*> parameterRows_;
  std::vector<IntermediateRow*> intermediateRows_;
};

} // namespace taa::app
