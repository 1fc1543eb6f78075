// What a window paints as text, whoever paints it: where each line stands, and how much of it is in sight.
#pragma once

#include <QRectF>
#include <QSize>
#include <QString>
#include <QWidget>

#include <vector>

namespace taa::app::test {

struct PaintedText {
  QString text;
  QRectF place;   ///< px of the window
  QRectF visible; ///< of its ground, what is not clipped
};

/// Of a window and all that is in it.
std::vector<PaintedText> paintedTexts(QWidget& window);

/// The sizes a window is made for, logical px.
inline constexpr QSize kWindowSizes[] = {{1024, 600}, {1280, 800}, {1920, 1080}};

/// Whether it lies in an area that scrolls.
bool isScrolled(const QWidget* widget);

/// No text ends in dots that stand for the rest, and none is cut at its side, but where it can be scrolled;
/// nothing that is not scrolled lies beyond the window.
void expectWholeTexts(QWidget& window);

} // namespace taa::app::test
