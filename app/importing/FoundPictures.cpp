#include "app/importing/FoundPictures.h"

#include "app/style/Text.h"
#include "app/style/Theme.h"
#include "core/capture/import/StatedPlanes.h"

#include <QHeaderView>
#include <QMimeData>

#include <algorithm>
#include <memory>
#include <string>

namespace taa::app {

namespace {

enum FoundColumn { TakenFor, Files, Channels, FrameCount };

capture::PlaneSource sourceOf(const capture::PictureSequence& sequence, const capture::PictureLayer& layer) {
  capture::PlaneSource source;
  source.file = sequence.pattern;
  source.part = layer.part;
  for (const capture::LayerChannel& channel : layer.channels) source.channels.push_back(channel.name);
  return source;
}

/// Whether a plane is read from this layer, in part at least.
bool holds(const capture::PlaneSource& layer, const capture::PlaneSource& plane) {
  if (plane.file != layer.file || (!plane.part.empty() && plane.part != layer.part)) return false;
  return plane.channels.empty() || std::ranges::any_of(plane.channels, [&](const std::string& channel) {
           return std::ranges::find(layer.channels, channel) != layer.channels.end();
         });
}

QString channelsText(const capture::PictureLayer& layer) {
  QStringList names;
  for (const capture::LayerChannel& channel : layer.channels) names << qtext(channel.name);
  return names.join(QLatin1Char(' '));
}

} // namespace

QString layerText(const capture::PictureSequence& sequence, const capture::PictureLayer& layer) {
  return QString::fromStdString(capture::statedText(sourceOf(sequence, layer)));
}

FoundPictures::FoundPictures(QWidget* parent) : QTreeWidget(parent) {
  setObjectName(QStringLiteral("foundPictures"));
  setAccessibleName(tr("Pictures found"));
  setAccessibleDescription(tr("All sequences of pictures in the folder, layer by layer, and the plane that "
                              "each is taken for. The fields of the planes choose among them."));
  setRootIsDecorated(false);
  setUniformRowHeights(true);
  setHeaderLabels({tr("Plane"), tr("Files"), tr("Channels"), tr("Frames")});
  header()->setStretchLastSection(false);
  header()->setSectionResizeMode(QHeaderView::ResizeToContents); // what has no room is scrolled to
  setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  setDragEnabled(true);
  setDragDropMode(QAbstractItemView::DragOnly);
}

void FoundPictures::setSequences(const std::vector<capture::PictureSequence>& sequences) {
  clear();
  sequences_ = sequences;
  for (const capture::PictureSequence& sequence : sequences_)
    for (const capture::PictureLayer& layer : sequence.layers) {
      auto* item = new QTreeWidgetItem(this);
      item->setText(Files, layer.part.empty()
                               ? qtext(sequence.pattern)
                               : tr("%1, part %2").arg(qtext(sequence.pattern), qtext(layer.part)));
      item->setText(Channels, channelsText(layer));
      item->setText(FrameCount, QString::number(sequence.numbers.size()));
      item->setFont(FrameCount, numberFont());
      item->setTextAlignment(FrameCount, Qt::AlignVCenter | Qt::AlignRight);
      item->setData(Files, Qt::UserRole, layerText(sequence, layer));
    }
  showPlanes({});
}

void FoundPictures::showPlanes(const std::map<capture::PlaneKind, capture::PlaneSource>& planes) {
  int line = 0;
  for (const capture::PictureSequence& sequence : sequences_)
    for (const capture::PictureLayer& layer : sequence.layers) {
      const capture::PlaneSource place = sourceOf(sequence, layer);
      QStringList names;
      for (const auto& [kind, source] : planes)
        if (holds(place, source)) names << qtext(capture::planeName(kind));
      topLevelItem(line++)->setText(TakenFor,
                                    names.isEmpty() ? tr("not used") : names.join(QStringLiteral(", ")));
    }
}

QStringList FoundPictures::mimeTypes() const {
  return {QString::fromLatin1(kPicturesMimeType)};
}

QMimeData* FoundPictures::mimeData(const QList<QTreeWidgetItem*>& items) const {
  auto dragged = std::make_unique<QMimeData>();
  if (!items.isEmpty())
    dragged->setData(mimeTypes().front(), items.front()->data(Files, Qt::UserRole).toString().toUtf8());
  return dragged.release(); // the drag has it
}

} // namespace taa::app
