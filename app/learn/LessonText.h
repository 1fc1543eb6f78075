// A lesson's text: Markdown of anybody's, which shows nothing but itself.
#pragma once

#include <QTextBrowser>
#include <QUrl>

namespace taa::app {

/// Loads neither pictures nor pages, from wherever they are; links to the web open in the desktop's browser.
/// Lines have room between them and are no longer than the eye follows, at each size of text and in both
/// themes.
class LessonText : public QTextBrowser {
  Q_OBJECT
 public:
  explicit LessonText(QWidget* parent = nullptr);
  /// Another one is shown from its beginning; the same one stays where it was scrolled to.
  void setText(const QString& markdown);
  /// Shows its end rather than its beginning, also when it gets less room, until another text is set.
  void setKeepsEnd(bool keepsEnd);
  /// Where a row of a table leads, that is where the first link in it does; empty: nowhere. `position` in the
  /// viewport.
  QUrl linkOfRow(const QPoint& position) const;
  /// As high as the text is.
  QSize sizeHint() const override;
  /// A line, where the window has room for no more.
  QSize minimumSizeHint() const override;

 Q_SIGNALS:
  /// A link "rung:ID" was followed, or the row of a table that has one.
  void rungChosen(const QString& preset);

 protected:
  void mouseMoveEvent(QMouseEvent*) override;
  void mouseReleaseEvent(QMouseEvent*) override;
  QVariant loadResource(int, const QUrl&) override { return {}; }
  void changeEvent(QEvent*) override;
  void resizeEvent(QResizeEvent*) override;

 private:
  void setType();
  void fitLines();
  void showEnd();

  QString markdown_;
  bool keepsEnd_ = false;
  int heightPx_ = 0; ///< that it would like to have
};

} // namespace taa::app
