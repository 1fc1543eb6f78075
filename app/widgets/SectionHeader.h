// The heading of a stage that folds: name, and in secondary text what its settings come to.
#pragma once

#include <QAbstractButton>
#include <QImage>

class QPainter;

namespace taa::app {

class SectionHeader : public QAbstractButton {
  Q_OBJECT
 public:
  /// Checked: unfolded.
  explicit SectionHeader(const QString& title, QWidget* parent = nullptr);
  void setSummary(const QString& summary);
  const QString& summary() const { return summary_; }
  /// What the stage did to the frame on show; empty: not known.
  void setNote(const QString& note);
  const QString& note() const { return note_; }
  /// Room for a picture at the right, which is higher than a line of text.
  void setHasThumbnail(bool has);
  void setThumbnail(const QImage& thumbnail);
  const QImage& thumbnail() const { return thumbnail_; }
  /// Where it is; empty without one.
  QRect thumbnailRect() const;
  QSize sizeHint() const override;
  static constexpr QSize kThumbnailSize{80, 45};

 Q_SIGNALS:
  void thumbnailClicked();

 protected:
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent*) override;
  void mouseReleaseEvent(QMouseEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void leaveEvent(QEvent*) override;
  void keyPressEvent(QKeyEvent*) override;

 private:
  void paintThumbnail(QPainter& painter) const;
  void paintLines(QPainter& painter, QRect inside, const QStringList& lines) const;
  void setOverThumbnail(bool over);

  QString summary_, note_;
  QImage thumbnail_;
  bool hasThumbnail_ = false, overThumbnail_ = false, pressedThumbnail_ = false;
};

} // namespace taa::app
