// Looks for settings that serve a goal better on the shot that is open: the way it went, what it found as
// settings in force, as a preset and as GLSL.
#pragma once

#include "app/background/TuneWork.h"
#include "app/background/WorkDialog.h"
#include "app/session/PresetChoices.h"

#include <QString>

#include <functional>
#include <optional>

class QPushButton;
class QTreeWidget;

namespace taa::app {

class BackgroundBar;
class CurveChart;
class Session;
class TuneChoices;

/// What becomes of settings that were found, besides being taken up.
struct TuneExits {
  std::function<void(const Settings&)> savePreset, exportGlsl;
};

/// There is one of a window: what was typed and found is there again when it is opened again.
class TuneDialog : public WorkDialog {
  Q_OBJECT
 public:
  /// Expects that something is open.
  TuneDialog(Session& session, TuneExits exits, QWidget* parent, TuneWork::Tune tune = tuneShot);

  /// Opens that of `window`, or brings it to the front.
  static void openAt(Session& session, const TuneExits& exits, QWidget* window);

  TuneChoices* choices() const { return choices_; }
  QTreeWidget* numbers() const { return numbers_; }
  QTreeWidget* steps() const { return steps_; }
  CurveChart* chart() const { return chart_; }
  QSize sizeHint() const override { return {1000, 680}; }

  void begin();

 private:
  void makeTables();
  void makeButtons();
  void showWay(const TuneWay& way);
  void showNumbers(const TuneWay& way);
  void refresh();
  void finish(const QString& error);
  /// What was found, with the preset it began with; nothing: it is what it began with.
  std::optional<PresetChoice> found() const;

  Session& session_;
  TuneExits exits_;
  TuneWork work_;
  PresetChoice start_;         ///< of the way
  TuneRequest request_;        ///< the same
  std::optional<TuneWay> way_; ///< the last that was told
  TuneChoices* choices_;
  QTreeWidget *numbers_, *steps_;
  CurveChart* chart_;
  BackgroundBar* bar_;
  QPushButton *apply_ = nullptr, *save_ = nullptr, *export_ = nullptr;
};

} // namespace taa::app
