// What a window paints as text, whoever paints it: where each line stands, and how much of it is in sight.
#pragma once

#include <QRectF>
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

/// No text ends in dots that stand for the rest, and none is cut at its side, but where it can be scrolled;
/// nothing that is not scrolled lies beyond the window.
void expectWholeTexts(QWidget& window);

} // namespace taa::app::test
