#include "app/importing/ImportState.h"

#include "core/base/Say.h"
#include "core/capture/format/Conventions.h"
#include "core/capture/import/StatedPlanes.h"

namespace taa::app {

ImportState withAssignments(ImportState state, const std::vector<std::string>& assignments) {
  for (const std::string& assignment : assignments) {
    const capture::Conventions before = state.conventions;
    capture::applyAssignment(state.conventions, assignment);
    if (before == state.conventions) continue;
    state.changed.insert(assignment.substr(0, assignment.find('=')));
  }
  return state;
}

ImportState withPlane(ImportState state, capture::PlaneKind kind, const std::string& text) {
  if (text.empty())
    state.planes.erase(kind);
  else
    state.planes[kind] = text;
  return state;
}

ImportState startedLike(ImportState state, const std::string& id) {
  state.like = id;
  if (id.empty()) return state;
  state.conventions = capture::startingPoint(id).conventions;
  state.changed.clear();
  return state;
}

std::vector<std::string> assignmentsOf(const ImportState& state) {
  std::vector<std::string> assignments;
  for (const std::string& path : state.changed)
    assignments.push_back(path + "=" + capture::convention(path).text(state.conventions));
  for (const auto& [kind, text] : state.planes)
    assignments.push_back(std::string(capture::kPlanePrefix) + std::string(capture::planeName(kind)) + "=" +
                          text);
  return assignments;
}

capture::Manifest withNoteOfChanges(capture::Manifest manifest, const capture::Conventions& guessed) {
  std::string changes;
  for (const std::string& change : capture::differences(manifest.conventions, guessed))
    changes += (changes.empty() ? "" : ", ") + change;
  if (!changes.empty()) manifest.notes.push_back(say<"set by hand after that: %1">(changes));
  return manifest;
}

} // namespace taa::app
