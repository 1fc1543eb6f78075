// What somebody has settled about imported frames, and what of it a further guess and the file are told.
#pragma once

#include "core/capture/format/Manifest.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace taa::app {

/// What is undone on the import page.
struct ImportState {
  capture::Conventions conventions;
  std::string like;                                 ///< id of a starting point; empty: none
  std::set<std::string> changed;                    ///< paths of conventions that were set by hand
  std::map<capture::PlaneKind, std::string> planes; ///< that somebody stated: "FILES:CHANNELS", or kNoPlane
  bool operator==(const ImportState&) const = default;
};

/// `state` with assignments made by hand. Throws Error as the table of conventions does.
ImportState withAssignments(ImportState state, const std::vector<std::string>& assignments);

/// `state` with a plane in the pictures that `text` states; empty: where it is found.
ImportState withPlane(ImportState state, capture::PlaneKind kind, const std::string& text);

/// `state` begun like an engine, which takes back conventions set by hand; `id` empty: like none, and all
/// stays.
ImportState startedLike(ImportState state, const std::string& id);

/// What was set by hand and stated, as guessCapture() takes it.
std::vector<std::string> assignmentsOf(const ImportState& state);

/// `manifest` with a note of what is otherwise than it was guessed: its other notes are the guess's.
capture::Manifest withNoteOfChanges(capture::Manifest manifest, const capture::Conventions& guessed);

} // namespace taa::app
