// The words of choices and settings as the window says them: its tables cite rows of the manual, which nobody
// can open from a list.
#pragma once

#include "core/settings/Parameters.h"

#include <QString>

namespace taa::app {

/// Without "manual 11.3", "D7" of its list of defects, and the like; other sources stay: "(manual 11.3, Karis
/// 2014)" is "(Karis 2014)".
QString withoutManual(const QString& text);

/// What stands beside a choice in a list: the first sentence, without sources, cut between words where it is
/// longer than a line of a list.
QString briefly(const QString& explanation);

/// Whether the choice repeats the defect of a source that shipped or was printed with it, beside its
/// corrected form.
bool isAsShipped(const Choice& choice);

} // namespace taa::app
