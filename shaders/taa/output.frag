// What is shown of one pixel of the resolved picture. Its own program, run only for who looks: history is written
// before and knows nothing of it.

#include "taa/inputs.glsl"
#include "taa/dilate_motion.glsl"
#include "taa/reproject.glsl"
#include "taa/sharpen.glsl"
#include "taa/dither.glsl"
#include "taa/output.glsl"

void main() { showOutput(pixelHere()); }
