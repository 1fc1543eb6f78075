// What leaves the window: pictures of views, ranges of frames, command lines, GLSL.
#pragma once

#include "core/report/SequenceExport.h"

#include <QImage>
#include <QObject>
#include <QString>

#include <optional>

namespace taa {
struct SessionFile;
struct Settings;
} // namespace taa

namespace taa::app {

class Session;
class ViewArea;

class Exports : public QObject {
  Q_OBJECT
 public:
  /// `cameraFolder`: where cameras lie that copied command lines name. Dialogs open over `window`.
  Exports(Session& session, ViewArea& views, const QString& cameraFolder, QWidget* window);

  /// Asks for a file, then writes the active view.
  void askForView(bool withLegend);
  /// What the active view shows, pixel for pixel of the screen; `withLegend`: and below it what it means.
  void writeView(const QString& path, bool withLegend);
  /// The same into the clipboard.
  void copyView(bool withLegend);
  /// A dialog for a range of frames, which stays open beside the work.
  void askForRange();
  void writeRange(const SequenceRequest& request);
  void askForGlsl();
  void writeGlsl(const QString& path);
  /// The same of settings that were found from the present ones.
  void askForGlslOf(const Settings& settings);
  /// The taa-batch line that draws what the active view shows again, all of its picture. A flown path is in a
  /// file that it names, which copying writes.
  QString commandLine() const;
  void copyCommandLine();

 Q_SIGNALS:
  void said(const QString& sentence);
  void failed(const QString& sentence);

 private:
  void writeGlsl(const QString& path, const Settings& settings);
  QString cameraFile(const SessionFile& session) const; ///< empty: no need for one
  /// Says why when there is none.
  std::optional<QImage> viewImage(bool withLegend);

  Session& session_;
  ViewArea& views_;
  QString cameraFolder_;
  QWidget* window_;
};

} // namespace taa::app
