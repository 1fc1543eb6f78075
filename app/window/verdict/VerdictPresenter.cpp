#include "app/window/verdict/VerdictPresenter.h"

#include "app/models/ProbeModel.h"
#include "app/panels/ProbePanel.h"
#include "app/session/Session.h"
#include "app/views/ViewArea.h"
#include "app/widgets/probe/VerdictDetails.h"
#include "app/widgets/probe/VerdictLine.h"

#include <QEvent>
#include <QTreeView>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace taa::app {

VerdictPresenter::VerdictPresenter(Session& session, ViewArea& views, ProbePanel& panel)
    : session_(session), views_(views), panel_(panel) {
  connect(&session_, &Session::statusChanged, this, &VerdictPresenter::show);
  connect(&session_, &Session::workChanged, this, &VerdictPresenter::showWork);
  connect(&session_.presets(), &PresetChoices::settingsChanged, this, &VerdictPresenter::show);
  connect(&session_.probes(), &ProbeChoices::changed, this, &VerdictPresenter::show);
  connect(&session_.probes(), &ProbeChoices::probeArrived, this, &VerdictPresenter::show);
  connect(&session_.verdicts(), &VerdictChoices::changed, this, &VerdictPresenter::show);
  connect(panel_.verdictDetails(), &VerdictDetails::remedyChosen, this,
          [this](int remedy) { session_.verdicts().apply(static_cast<std::size_t>(remedy)); });
  connect(panel_.verdictDetails(), &VerdictDetails::rowChosen, this, [this](IntermediateId id, int frame) {
    views_.active()->setIntermediate(id);
    if (frame != session_.status().info.frame) session_.seek(frame);
  });
  panel_.table()->installEventFilter(this);
  show();
}

// The values show where a verdict does: there none is wanted while another page or none is open.
bool VerdictPresenter::eventFilter(QObject*, QEvent* event) {
  if (event->type() == QEvent::Show) session_.verdicts().setShown(true);
  if (event->type() == QEvent::Hide) session_.verdicts().setShown(false);
  return false;
}

// One is made of what is probed, or will be once the frame is exact.
bool VerdictPresenter::isExpected() const {
  const ProbeResult* probe = session_.probes().active() < 0 ? nullptr : session_.probes().result();
  return session_.verdicts().areOn() && !session_.status().playing && probe && !probe->around.empty();
}

void VerdictPresenter::show() {
  panel_.verdict()->setVisible(isExpected());
  const VerdictDelivery* verdict = session_.verdicts().verdict();
  if (!verdict && isExpected())
    panel_.verdictDetails()->wait();
  else
    panel_.verdictDetails()->setVerdict(verdict);
  std::vector<IntermediateId> decided;
  if (verdict && verdict->answer)
    for (const VerdictRow& row : verdict->answer->verdict.rows) decided.push_back(row.id);
  panel_.model()->setDecided(decided);
  showSentence();
  showWork();
}

void VerdictPresenter::showSentence() {
  const VerdictDelivery* verdict = session_.verdicts().verdict();
  if (!verdict) {
    panel_.verdict()->wait();
    return;
  }
  if (!verdict->answer) {
    panel_.verdict()->setSentence(tr("No verdict: %1").arg(QString::fromStdString(verdict->whyNot)),
                                  VerdictTone::Neutral);
    return;
  }
  const bool isRight = verdict->answer->verdict.kind == VerdictKind::None;
  panel_.verdict()->setSentence(QString::fromStdString(verdict->answer->sentence),
                                isRight ? VerdictTone::Right : VerdictTone::Wrong);
}

void VerdictPresenter::showWork() {
  const VerdictDelivery* verdict = session_.verdicts().verdict();
  const bool isWrong = verdict && verdict->answer && verdict->answer->verdict.kind != VerdictKind::None;
  QString what;
  if (!session_.whyEnded().isEmpty())
    what.clear(); // nothing is looked for any more
  else if (!verdict)
    what = tr("Looking for the reason…");
  else if (isWrong && !verdict->remedies && verdict->whyNot.empty())
    what = tr("Looking for what mends it…");
  const Work& work = session_.work();
  const bool isUnderWay = work.kind == WorkKind::Verdict && work.total > 0;
  panel_.verdict()->setWork(what, isUnderWay ? std::clamp(double(work.done) / work.total, 0.0, 1.0) : 0.0);
}

} // namespace taa::app
