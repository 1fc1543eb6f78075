// All pictures of a folder by sequence and layer, whether they are taken for a plane or not: what the mouse
// drags onto a plane.
#pragma once

#include "core/capture/format/Manifest.h"
#include "core/capture/import/FolderScan.h"

#include <QString>
#include <QTreeWidget>

#include <map>
#include <vector>

namespace taa::app {

/// Of what is dragged: its text is layerText().
inline constexpr const char* kPicturesMimeType = "application/x-taa-pictures";

/// A layer with all of its channels, as statedText() writes it: it stands for that layer alone.
QString layerText(const capture::PictureSequence& sequence, const capture::PictureLayer& layer);

class FoundPictures : public QTreeWidget {
  Q_OBJECT
 public:
  explicit FoundPictures(QWidget* parent = nullptr);

  void setSequences(const std::vector<capture::PictureSequence>& sequences);
  /// Says beside each what it is taken for.
  void showPlanes(const std::map<capture::PlaneKind, capture::PlaneSource>& planes);
  QSize sizeHint() const override { return {400, 160}; }

 protected:
  QStringList mimeTypes() const override;
  QMimeData* mimeData(const QList<QTreeWidgetItem*>& items) const override;

 private:
  std::vector<capture::PictureSequence> sequences_; ///< their layers are the lines, in order
};

} // namespace taa::app
