// The doctor's page: has frames examined, and says what is wrong with them and what to change.
#pragma once

#include "app/background/DoctorWork.h"

#include <QWidget>

#include <optional>
#include <vector>

class QLabel;
class QPushButton;
class QSpinBox;
class QStackedWidget;

namespace taa::app {

class BackgroundBar;
class FindingDetails;
class FindingList;

class DoctorPanel : public QWidget {
  Q_OBJECT
 public:
  explicit DoctorPanel(QWidget* parent = nullptr);

  DoctorWork& work() { return work_; }
  /// Another shot: nothing is known of it.
  void setShot(int frameCount);
  /// Has frames examined; what was known before is forgotten.
  void begin(const ExaminationRequest& request);
  /// Has the frames of what is known drawn as they would be, see DoctorWork::corrected().
  void correct(const ExaminationRequest& request, const Settings& healthy);
  /// Whether settings have changed since the frames were examined.
  void setOutdated(bool outdated);
  int first() const;
  int last() const;
  void setFrames(int first, int last);
  /// Nothing: none was made yet, or it has not come to a finding.
  const std::optional<doctor::Diagnosis>& diagnosis() const { return diagnosis_; }
  bool isComplete() const { return isComplete_; }
  /// The chosen finding; null: another line is.
  const doctor::Finding* finding() const;
  /// Its regions, or that which is chosen of them.
  std::vector<doctor::RegionPlace> places() const;
  /// Why it cannot examine; empty: it can.
  QString whyNot() const;

  FindingList* list() const { return list_; }
  FindingDetails* details() const { return details_; }
  QPushButton* saveButton() const { return save_; }
  QString note() const;

 Q_SIGNALS:
  void examineRequested();
  void reportRequested();
  void placeRequested();     ///< the first of places()
  void correctedRequested(); ///< of finding()
  /// What is chosen or known, or whether somebody looks.
  void changed();

 protected:
  void showEvent(QShowEvent*) override;
  void hideEvent(QHideEvent*) override;

 private:
  QWidget* makeTop();
  QWidget* makeResult();
  void take(const doctor::Diagnosis& diagnosis, bool isComplete);
  void finish(const QString& error);
  void showChoice();
  void refresh();
  QString summary() const;
  QString rightSentences() const;

  DoctorWork work_;
  std::optional<doctor::Diagnosis> diagnosis_;
  bool isComplete_ = false, isOutdated_ = false;
  int frameCount_ = 0;
  QSpinBox *first_ = nullptr, *last_ = nullptr;
  BackgroundBar* bar_ = nullptr;
  QPushButton* save_ = nullptr;
  QStackedWidget* pages_ = nullptr;
  QLabel* empty_ = nullptr;
  FindingList* list_ = nullptr;
  FindingDetails* details_ = nullptr;
};

} // namespace taa::app
