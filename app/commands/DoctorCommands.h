// Has the frames that are open examined by the doctor, goes to what it finds, and hands its report on.
#pragma once

#include "core/doctor/examination/CorrectedLook.h"
#include "core/inspect/ExaminedShot.h"
#include "core/settings/Settings.h"

#include <QObject>
#include <QString>

#include <string>

namespace taa::app {

class DoctorPanel;
class Session;
class ViewArea;

class DoctorCommands : public QObject {
  Q_OBJECT
 public:
  /// Regions are outlined in `views` while the page is open. Places are asked for over `window`. `folder`:
  /// where settings are kept that make frames right; it is made when there are some.
  DoctorCommands(Session& session, ViewArea& views, DoctorPanel& panel, const QString& folder,
                 QWidget* window);

  /// The frames that the page says, as they are with the present settings.
  void examine();
  /// The frame of what is chosen, with the plane that is wrong in the active view.
  void goToFinding();
  /// Compares the frame of what is chosen, resolved, with what it would be if that were right: the same
  /// settings, but for those that correct it, are a preset of their own.
  void showCorrected();
  /// Why what is chosen cannot be shown corrected; empty: it can.
  QString whyNotCorrected() const;
  /// Why there is no report to save; empty: there is one.
  QString whyNoReport() const;
  void askForReport();
  /// With pictures of what can be made right, given and corrected, which are drawn first: beside the window,
  /// and nothing is written where that is stopped.
  void writeReport(const QString& path);

 Q_SIGNALS:
  void said(const QString& sentence);
  void failed(const QString& sentence);
  void reportChanged();

 private:
  void takeStatus();
  void showOutlines();
  Settings healthySettings() const;
  doctor::Corrected correctedSettings() const;
  void writeReportWith(const doctor::CorrectedLook* corrected);
  void endReport(const QString& error);

  Session& session_;
  ViewArea& views_;
  DoctorPanel& panel_;
  QString folder_;
  QWidget* window_;
  std::string source_;          ///< that the page is about
  int frameCount_ = 0;          ///< of it
  ExaminationRequest examined_; ///< the last
  Settings healthy_;            ///< what settings of faults went back to then
  QString reportPath_;          ///< that waits for its pictures
};

} // namespace taa::app
