// Which pictures hold which plane of imported frames: a row for each plane, and below all pictures there are,
// to be dragged onto a row.
#pragma once

#include "core/capture/format/Manifest.h"
#include "core/capture/import/FolderScan.h"

#include <QString>
#include <QWidget>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace taa::app {

class FoundPictures;
class PlaneRow;

class PlaneTable : public QWidget {
  Q_OBJECT
 public:
  using Stated = std::map<capture::PlaneKind, std::string>; ///< see ImportState::planes

  explicit PlaneTable(QWidget* parent = nullptr);

  /// All that a folder holds.
  void setSequences(const std::vector<capture::PictureSequence>& sequences);
  /// The planes of a guess, and those that were stated to it: the others were found.
  void setPlanes(const std::map<capture::PlaneKind, capture::PlaneSource>& planes, const Stated& stated);
  void display(const Stated& stated);
  /// Nothing is known any more, and nothing is being typed.
  void clear();
  /// A plane and text of a row in which something was typed and not yet said: it is taken as said then.
  std::optional<std::pair<capture::PlaneKind, QString>> takeTyped();
  /// What is shown next takes its place.
  void dropTyped();
  PlaneRow* row(capture::PlaneKind kind) const { return rows_[static_cast<std::size_t>(kind)]; }
  FoundPictures* pictures() const { return pictures_; }

 Q_SIGNALS:
  /// See PlaneRow.
  void stated(capture::PlaneKind kind, const QString& text);

 private:
  QWidget* makeRows();
  QWidget* makePictures();

  std::vector<PlaneRow*> rows_; // by PlaneKind
  FoundPictures* pictures_;
  std::map<capture::PlaneKind, QString> found_;
};

} // namespace taa::app
