// What is done with the probe by a key: its values are copied, another one is set.
#pragma once

#include "core/inspect/WorstOfShot.h"

#include <QObject>
#include <QString>

namespace taa::app {

class ProbePanel;
class Session;
class ViewArea;

/// How a probe is copied; JSON is what taa-batch probe prints.
enum class ProbeFormat { Text, Markdown, Json };

class ProbeCommands : public QObject {
  Q_OBJECT
 public:
  ProbeCommands(Session& session, ViewArea& views, ProbePanel& panel, QObject* parent);

  /// Of the selected row, else of what the active view shows.
  void copyValue();
  void copy(ProbeFormat format);
  /// The verdict as taa-batch prints it; nothing where there is none.
  void copyVerdict();
  /// Sets the probe to the next one of the worst pixels by what the active view shows, once it is found.
  void goToNextWorst(WorstStep step = WorstStep::Pixel);
  /// Where the mouse is, else to the right of the active probe; the next place that no probe has. False:
  /// there is neither.
  bool addAnother();

 Q_SIGNALS:
  /// Which of the worst pixels the probe was set to.
  void foundWorst(const QString& sentence);

 private:
  void showWorst(const FoundWorst& found);
  static QString foundText(const FoundWorst& found);

  Session& session_;
  ViewArea& views_;
  ProbePanel& panel_;
};

} // namespace taa::app
