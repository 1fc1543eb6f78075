// Both sides of a view: what has arrived for them, what of it is shown, and who is who. No widget.
#pragma once

#include "app/views/legend/Legend.h"

#include "core/inspect/Comparison.h"
#include "core/picture/ViewRequest.h"

#include <QCoreApplication>
#include <QImage>
#include <QString>

#include <memory>
#include <optional>
#include <vector>

namespace taa::app {

/// What a view of the reference says about it besides its legend: samples so far, and how far the output is
/// from them; empty where the result is of another row.
QString referenceNote(const ViewResult& result);

class ViewSides {
  Q_DECLARE_TR_FUNCTIONS(taa::app::ViewSides)
 public:
  ViewSides();

  /// What legend and overlays speak of.
  const ViewContent& content() const { return content_; }
  void setContent(const ViewContent& content) { content_ = content; }
  /// The other side, when there is one.
  const std::optional<ViewContent>& other() const { return other_; }
  void setOther(const std::optional<ViewContent>& other) { other_ = other; }
  void setShowing(Showing showing) { showing_ = showing; }
  /// Without what is only held for a moment.
  Showing showing() const { return other_ ? showing_ : Showing::First; }
  /// Shows the other side meanwhile.
  void setPeeking(bool peeking) { peeks_ = peeking; }
  bool isPeeking() const { return peeks_; }
  Showing shown() const; ///< peeking included
  /// Whether time goes on: another frame beside it is then not made.
  void setPlaying(bool playing) { playing_ = playing; }
  bool isPlaying() const { return playing_; }

  /// While time goes on, or another pair is on its way, the other side that was there last stays.
  void setResult(std::shared_ptr<const ViewResult> result);
  const std::shared_ptr<const ViewResult>& result() const { return result_; }
  const QImage& image(bool other) const { return other ? otherImage_ : image_; }
  const ViewSide* otherSide() const; ///< that is there; null: none
  const gl::Rect& otherRegion() const { return (kept_ ? kept_ : result_)->region; }
  /// Whether values and picture are of the row or difference that is spoken of.
  bool isResultOfContent() const;
  /// The value at a pixel, when the last result brought it.
  std::optional<std::vector<float>> valueAt(glm::ivec2 pixel) const;
  std::optional<std::vector<float>> otherValueAt(glm::ivec2 pixel) const;
  /// Why there is no value; None where there is one, or nothing is known.
  Absence absenceAt(glm::ivec2 pixel) const;
  Absence otherAbsenceAt(glm::ivec2 pixel) const;

  /// Who is on a side: row, settings, frame; with why it is not there, or not of now, and what helps.
  QString label(bool other) const;
  /// The bytes of the sides, whatever is painted on them, divided at a column; empty while a part of them is
  /// on its way, see-through where there is no picture.
  Picture picture(int dividerColumn) const;
  /// From the top: what lies over the picture, the other side where it is another row, this side. Folded: a
  /// sign for the first.
  LegendFlow legend(Showing showing, LegendFold fold, const ViewTransform& transform,
                    const ThemeColors& colors) const;

 private:
  bool isPictureComplete() const;
  bool isComparedWithAnotherFrame() const;
  bool isAlongMotion() const; ///< whether the other side is the frame before, along the motion
  QString framedLabel(const QString& text, bool other) const;
  QString absenceNote() const;
  LegendSide legendSide(bool other, Showing showing) const;

  ViewContent content_;
  std::optional<ViewContent> other_;
  Showing showing_ = Showing::First;
  bool peeks_ = false, playing_ = false;
  std::shared_ptr<const ViewResult> result_;
  std::shared_ptr<const ViewResult> kept_; ///< an earlier one, whose other side stays meanwhile; else null
  QImage image_, otherImage_;
};

} // namespace taa::app
