// What the window works on: requests go to the render thread, its answers arrive here as signals.
#pragma once

#include "app/session/LastOpening.h"
#include "app/session/Mailbox.h"
#include "app/session/Outbox.h"
#include "app/session/Pending.h"
#include "app/session/PresetChoices.h"
#include "app/session/ProbeChoices.h"
#include "app/session/Renderer.h"
#include "app/session/SceneChoices.h"
#include "app/session/VerdictChoices.h"
#include "app/undo/UndoStack.h"
#include "core/io/SessionFile.h"

#include <QObject>
#include <QString>

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace taa::app {

/// Owns the parts and delivers to them. Lives on the UI thread and never waits. No exception leaves a member:
/// errors become errorOccurred().
class Session : public QObject {
  Q_OBJECT
 public:
  using MakeRenderer = std::function<std::unique_ptr<Renderer>(Listener)>;
  explicit Session(const MakeRenderer& makeRenderer = makeRenderThread, QObject* parent = nullptr);
  ~Session() override;

  // Parts
  PresetChoices& presets() { return presets_; }
  const PresetChoices& presets() const { return presets_; }
  ProbeChoices& probes() { return probes_; }
  const ProbeChoices& probes() const { return probes_; }
  VerdictChoices& verdicts() { return verdicts_; }
  const VerdictChoices& verdicts() const { return verdicts_; }
  SceneChoices& scene() { return scene_; }
  const SceneChoices& scene() const { return scene_; }
  /// Of all that is open, the window's views and marks included.
  UndoStack& undoStack() { return undo_; }
  void undo() { undo_.undo(); }
  void redo() { undo_.redo(); }

  // State; what has not arrived yet is empty
  const Status& status() const { return status_; }
  const Work& work() const { return work_; }
  const std::shared_ptr<const ViewResult>& picture(int view) const;
  /// What another size takes with these settings and views: "about 155 MiB".
  QString memoryText(const glm::ivec2& sizePx) const;
  bool isLooping() const { return looping_; }
  /// By the requests so far.
  const Playback& playback() const { return playback_; }
  /// Something was opened, and its status has arrived.
  bool isOpen() const { return status_.frameCount > 0; }
  /// Whether what was asked for last has not arrived yet: what is open is of before.
  bool isOpening() const { return status_.opened != opening_; }
  /// Why nothing is drawn any more, as without OpenGL; empty: the render thread runs.
  const QString& whyEnded() const { return whyEnded_; }

  /// What was asked to be opened last; empty: nothing yet.
  QString openingSource() const { return QString::fromStdString(last_.file.source); }

  // Requests
  /// Asks the render thread for what no other member and no part asks it for.
  void post(Request request) { outbox_.post(std::move(request)); }
  /// Plays once it is open, or waits at frame 0.
  void open(const QString& source, bool plays = true, const ShotChoice& choice = {});
  /// Opens what was refused for asking for more than it may, which its source may from then on.
  void openAnyway();
  /// Opens what is open again with another animation or length, which undo takes back; all else stays.
  void choose(const ShotChoice& choice);
  /// By the requests so far.
  const ShotChoice& choice() const { return choice_.value(); }
  void togglePlaying();
  void setLooping(bool looping);
  void setPlayback(const Playback& playback);
  void setTracing(bool tracing);
  void seek(int frame); ///< or to the nearest there is
  void setViews(const std::vector<ViewRequest>& views);
  /// What the picture depends on; `window` is left empty.
  SessionFile file() const;
  /// Opens what the file says, paused at its frame; where that cannot be opened, goes back to what was open.
  void restore(const SessionFile& file);

  /// Calls `act`, a function or a member of `receiver`, with each result of this type that arrives. Of
  /// failures, status, work, pictures, probes and verdicts the session and its parts have signals of their
  /// own.
  template <class T, class Receiver, class Act>
  void onArrival(Receiver* receiver, Act act) {
    static_assert(!(std::is_same_v<T, Failure> || std::is_same_v<T, Status> || std::is_same_v<T, Work> ||
                    std::is_same_v<T, ViewResult> || std::is_same_v<T, ProbeResult> ||
                    std::is_same_v<T, VerdictDelivery>),
                  "its arrival is said by another signal");
    connect(this, &Session::arrived, receiver, [receiver, act](const Result& result) {
      const T* each = std::get_if<T>(&result);
      if (!each) return;
      if constexpr (requires { act(*each); })
        act(*each);
      else
        (receiver->*act)(*each);
    });
  }

 Q_SIGNALS:
  void arrived(const Result& result);
  void statusChanged();
  void playbackChanged();
  void pictureArrived(int view);
  void workChanged();
  void errorOccurred(const QString& sentence);
  void choiceRefused(); ///< the shot has no such camera, object, animation or length; before errorOccurred()
  void offersOpening(bool offers); ///< whether openAnyway() would open something; follows errorOccurred()
  void openingFailed();            ///< of what was opened last; what was open still is
  void ended();                    ///< nothing will arrive any more, and whyEnded() says why

 private:
  void deliver();
  void take(Failure&& failure);
  void take(Status&& status);
  void take(Work&& work);
  void take(ViewResult&& picture);
  void take(VerdictDelivery&& verdict) { verdicts_.arrived(std::move(verdict)); }
  void take(auto other) { Q_EMIT arrived(std::move(other)); }
  void end(const QString& sentence);
  void offer(const std::optional<SceneBudget>& needed);
  void apply(const SessionFile& file);

  Mailbox mailbox_;
  Outbox outbox_;
  UndoStack undo_;
  Status status_;
  PresetChoices presets_{outbox_, undo_};
  ProbeChoices probes_{outbox_, undo_, status_};
  VerdictChoices verdicts_{outbox_, status_, probes_, presets_};
  SceneChoices scene_{outbox_, undo_, status_};
  Work work_;
  std::array<std::shared_ptr<const ViewResult>, kViewCount> pictures_;
  std::vector<ViewRequest> views_;
  bool looping_ = true, playsWhenOpen_ = false;
  RequestId opening_ = 0;                    ///< the last request to open something
  std::optional<SessionFile> beforeOpening_; ///< what a session was opened in place of
  Playback playback_;
  bool tracing_ = false;
  LastOpening last_;
  Pending<ShotChoice> choice_;
  QString whyEnded_;
  RequestId firstChoice_ = 0; ///< since which what was opened last was only opened again; 0: it was not
};

} // namespace taa::app
