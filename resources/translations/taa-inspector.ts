<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1">
<context>
    <name>QObject</name>
    <message>
        <source>%1 surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the pixel itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt; 0.1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2 · %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing is rejected in this picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>range %1 … %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, difference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>logarithmic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the values: this minus other, the channel that differs most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the values: this minus other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>= %1 %2 or more, shorter in proportion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>= still: less than %1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>arrows point to the neighbor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>arrows point where it moves to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>above the range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>below it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dashes: between objects</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not drawn yet: comes while paused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 samples · RMSE %2 · PSNR %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>restart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not measured yet: comes while paused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing in this frame was seen before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 samples · %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>sentences</name>
    <message>
        <source>&quot;%1&quot; is not NODE=MODE; modes are perObject, cameraOnly and none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a file below the folder of the scene; only such files are opened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a list of at most %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a list of at most %2 names</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an object of at most %2 names</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not x,y,z,yaw,pitch or x,y,z,yaw,pitch,fov, for example 0,1.6,4,0,-10</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is too long</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; wants [width, height]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; wants a whole number from %2 to %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2 is more than the %3 that can be opened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2 is none of 4, 8, … 252</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 are not a finite 4×4 matrix for each joint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 at %2, %3 of a texel from the one before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 bytes from byte %2 on reach past the %3 bytes of its buffer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 current, by %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 current, the rest history</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 does not exist</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 does not hold finite vectors of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 elements of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 elements of %2 bytes need %3 bytes; its %4 has %5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has no part &quot;%2&quot;; it has %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is %2 where there are %3 bytes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is out of range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 lies inside %2 × %3 px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 lies outside %2 × %3 px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of the output is hidden by it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 over %2 samples of what was drawn smaller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 over the nine samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was blended in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2 blurred along its motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, larger by contrast</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, mixed with bounded highlights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, rounded to the %2 bits it is stored with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, the overlay over it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, then sharpened by the four around</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, wide enough for the filtered color</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, wider by the mask</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 taps, their weights are %3 together</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: GL reports error %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: cannot include &quot;%2&quot;: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: one tap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the GL driver is out of memory; use a smaller size or fewer lanes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the nearest sample, %2 px from the center</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; chroma an eighth of the luma range around the pixel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; raised by motion of %2 px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; raised where history was rejected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 at the near plane, 0 in the distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A light of the unknown type &quot;%1&quot; is left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A part of the mesh &quot;%1&quot; has nothing to draw.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A skin whose joints are not in the scene is left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A texture asks for a third set of texture coordinates; the first is used.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A texture has its picture only in a format that is not supported; it is left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An animation of a node that has a matrix is left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Animation keys whose time does not rise are left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Animation of &quot;%1&quot; is not shown yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bilinear, for depth has an edge, at %1, %2 of a texel from the one before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Building meshes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Channels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compiling shaders</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Decoding images</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Default</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawing the frame to compare with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawing the reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each frame goes through these stages from top to bottom. Parameters can be set in the pipeline panel, in presets, and by %1; intermediates can be viewed, probed and exported.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exporting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Going to frame %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Intermediate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>JSON: %1 bytes are more than can be opened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>JSON: nested deeper than %1 levels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>JSON: the file holds no object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Making mip levels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measuring the frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>OpenImageIO was built without GIF</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening the scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Probe: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replaying frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replaying with the new settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file has %1 animations; the first, &quot;%2&quot;, plays.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file has %1 scenes; scenes[%2] is shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file has nothing to draw.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file uses %1, which is not shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uploading meshes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uploading textures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values of %1 that are not numbers are taken for 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What it does</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a camera path is {&quot;name&quot;, &quot;firstFrame&quot;, &quot;poses&quot;: [[x, y, z, yaw, pitch, fov], ...]}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a camera path needs a name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a channel asks for samplers[%1]; there are %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a key is not a finite number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a lane is not an object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a material that changes without motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a neighbor goes only %1 along</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a pose is [x, y, z, yaw, pitch, fov]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a position is not a finite number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a reference cannot have %1 samples: it has %2 to %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a thin feature keeps its history</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a thin feature, mean luma %1, no lock before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a thin feature, mean luma %1, the lock before had a life of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all of the correction is applied</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an edge in depth: read by one bilinear tap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an intermediate (reference is one), preset:NAME, frame:N, or frame:-N for N frames before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an object that deforms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an object that moves rigidly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an object that stands still</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another object than now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as chosen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as it should be: luma of the output less luma of the reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as long as before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as long as the frame it is meant for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as many as α stands for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as many frames&apos; worth of samples were stored around %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as much as was blended in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bounds: the scene reaches to infinity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bright colors count less</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot allocate %1 of %2 bytes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot allocate %1 of %2 texels (%3 MiB)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot compare with &quot;%1&quot;: name %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot compile %1:
%2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot delete %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot draw into %1: GL reports framebuffer status %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot draw the reference of a picture of %1 pixels: it takes about %2 of memory and %3 are free; choose a smaller size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot link %1 with %2:
%3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot link %1:
%2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot make an OpenGL 4.5 core context: the GL driver is too old; update it or set LIBGL_ALWAYS_SOFTWARE=1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot make frame %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot measure the stages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot open %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot open %1: memory: it needs more than there is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot open a GL display: EGL offers neither a device nor a surfaceless platform; install a GL driver (on Debian: libegl-mesa0 and libgl1-mesa-dri)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot open the session %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot open the session %1: its scene %2 is not there any more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot read &quot;%1&quot;: write path=value, for example rectify.method=clamp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot read %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot read %1: it has %2 bytes, more than the %3 allowed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot read %1: it is a folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot read part &quot;%1&quot; of %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot read preset %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot read settings: &quot;%1&quot; is not a group of parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot read settings: expected an object of groups</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot read the camera path %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot read the shaders in %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot read the style &quot;%1&quot;: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot rename the preset: there is one called %1 already</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot run %1 lanes: there are one to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot save the preset: &quot;%1&quot; is a built-in one; give another name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot save the preset: its name needs a letter or a digit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot save the preset: the folder %1 cannot be made</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot set %1 to &quot;%2&quot;: give a number from %3 to %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot set %1 to &quot;%2&quot;: give an integer from %3 to %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot set %1 to &quot;%2&quot;: give on or off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot set %1 to &quot;%2&quot;: give one of %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot use GL without a window: the driver lacks EGL_KHR_surfaceless_context; update it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot use OpenGL: this EGL offers OpenGL ES only; install a desktop GL driver</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot use a picture of %1 pixels: it takes about %2 of memory (inputs %3, histories %4, exposures %5) and %6 are free; choose a smaller size, fewer lanes or fewer views</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot use a picture of %1 pixels: it takes about %2 of memory (inputs %3, histories %4, exposures %5, reference %6) and %7 are free; choose a smaller size, fewer lanes or fewer views</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot use a picture of %1 × %2 pixels: this driver allows 4 to %3 a side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot write %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot write %1: OpenImageIO was built without OpenEXR</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot write %1: OpenImageIO was built without PNG</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>channels are letters of rgb, or none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>chunk %1: its %2 bytes reach past the end of the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>chunk %1: the first chunk, and only that, must be JSON</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>clamped history forgets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>component type %1 cannot be read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>depth of the neighbor at %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>depth of the pixel itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>distance along the view axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drawing the reference of frame %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drawn at full size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>expected a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>expected on or off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>extreme of the samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fast surfaces are blurred along their motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>frames that would be as calm when averaged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>header: it is binary glTF %1; only glTF 2.0 can be opened, export it anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>header: the file ends after %1 bytes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>header: the file has %1 bytes where it says %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>header: there is no chunk with JSON</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history counts less</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history is black</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history is taken as it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history keeps no %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history keeps no motion yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history keeps no normals yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history lies inside the box: kept as it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history starts anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history starts with the mean of the pixel and its diagonals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history was dropped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history was kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history was pulled %1 of the way: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history was rejected: the current frame alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how near the nearest sample lies, %1 px from the pixel&apos;s center, or all of it where it moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in box space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>indices must be scalars</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>indices must be unsigned integers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it cannot be read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has %1 components</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has %1 elements where POSITION has %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has %1 values for %2 times</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has no uri and there is no binary chunk for it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is a child of both nodes[%1] and nodes[%2]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is empty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is glTF %1; only glTF 2.0 can be opened, export it anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is its own ancestor: the nodes form a cycle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is neither PNG nor JPEG</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is nested deeper than %1 levels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is not a finite vector of 3 for each of the %1 vertices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is not a regular file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is not glTF: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it lists nodes[%1] twice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it must have either a uri or a bufferView</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it needs the extension %1, which is not supported; export it without</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its attributes have different counts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its data URI is not base64 of a buffer, PNG or JPEG</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its data URI is not valid base64</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its format is %1, this program reads %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its motion changed by %1 px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its motion is another than a frame ago</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its motion is the same as a frame ago</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its picture is damaged and cannot be decoded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its picture is damaged: it has no size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its picture of %1×%2 pixels is too large</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its times are not single numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its transform is not finite</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its type cannot be used here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its values have %1 components</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>jitter and inputs as now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>jitter and inputs as now; history keeps no %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>joint %1 is out of range; the skin has %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest of the %1 samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest of the %1 samples and of the cross</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>length of the motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>less is applied where little moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>less the farther the sample is from the center</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>less the farther the sample is from the center, unless it moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>less where history is near a wall of the box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>less where luma differs from history</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>less where the box is large against history</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>less where the mask relaxes the box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>luma comes and goes, history is kept: %1 of 255, before %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>luma does not come and go: %1 of 255, before %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>made brighter: luma of the sharpened color less that of the resolved one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>made darker: luma of the sharpened color less that of the resolved one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean luma %1 is another than the %2 it was locked at: no lock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean of the %1 samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean of the %1 samples and of the cross</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>missing or not a text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>missing; it is not a glTF file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mixed in each channel by its own α</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>more than %1 are drawn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>more than is allowed: another surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>motion of %1 px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>motion of %1 px doubles α at most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>motion of %1 px, as fractions of the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>motion of the neighbor at %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>motion of the neighbor at %1, in px of the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>motion of the pixel itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>motion of the pixel itself, in px of the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>neighbors move along, or the pixel rests</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>neither true nor false</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no edge in depth: the filter is used</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no intermediate is called &quot;%1&quot;; there are %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no lock holds history</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no material that changes without motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no more than is allowed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no more than the source&apos;s own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no object is called &quot;%1&quot;; there are %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no object is called &quot;%1&quot;; there are %2 and more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no object is called &quot;%1&quot;; there are none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no object is called &quot;%1&quot;; there are none with a name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no sample is near enough</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no thin feature, mean luma %1, no lock before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no thin feature, mean luma %1, the lock before had a life of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nodes[%1] is the child of nodes[%2], not a root</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not a list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not a list of %1 numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not a list of texts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not a list, or empty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not a text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not a whole number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not all of it could be stored; is the disk full?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not an object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not asked for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not masked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing is laid over the output here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing is rectified</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing was blended in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing was drawn here: the sky</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of each channel&apos;s own contrast, red&apos;s is %1: base %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on, off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one more, by how much the samples say</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>part &quot;%1&quot; of %2 has no channel &quot;%3&quot;; it has %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pixel %1 %2 frame %3 of %4, camera %5, %6x%7, preset %8</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pixel (%1, %2) lies outside the picture of %3 × %4 pixels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>read where the pixel&apos;s center landed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rejected: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rejected: %1, %2 off where %3 is allowed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rejected: %1, %2 px where %3 are allowed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rejected: %1, %2 was here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rejected: %1, at %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rejected: %1, cosine %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rejected: %1, it changed by %2 px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>smaller by motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>smallest of the %1 samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>smallest of the %1 samples and of the cross</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sparse index %1 is out of range; there are %2 elements</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>spread of the %1 samples about their mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ten more where it stands still, else 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the accessor of its indices has no %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the box has no width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the buffers have more than %1 bytes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the camera path &quot;%1&quot; begins at a frame before 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the camera path &quot;%1&quot; has a pose %2 that is out of range: positions within a million units, pitch within 89 degrees, field of view 1 to 160 degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the camera path &quot;%1&quot; has no pose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the current frame alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the field &quot;%1&quot; is missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the images have more than %1 bytes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the largest difference of red, green and blue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the mask leaves history out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the mean of the reference&apos;s samples of this instant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the motion is not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the motion of the neighbor at %1 is used: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the narrower of the samples&apos; extreme and γ deviations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the pixel&apos;s center less the motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the pixel&apos;s own motion is used</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the resolved color</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the resolved color as it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the resolved color sharpened: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the same object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the sample as it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the sample of this frame, taken %1 px from the pixel&apos;s center</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the scene has a camera called &quot;%1&quot; already; give the path another name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the scene has more than %1 indices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the scene has more than %1 morph weights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the scene has more than %1 vertices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the scene has more than %1 vertices and morph deltas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the scene&apos;s skins have more than %1 joints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the session is not an object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the settings that are compared with are no longer there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the sharpened color</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the sky</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the sky against a surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the sky has none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the sky, as before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the sky, or not kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the sky, or nothing before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the surface came from %1 px from here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the surface stayed where it was</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the surface turned by %1 degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the surface was behind the previous camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the tolerance, and more for the surface&apos;s slope</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the variance itself, as printed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the way the surface faces, in the world</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there are gray, viridis, inferno, diverging, cyclic and categorical</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there are more than %1 instances</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there are more than %1 keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there are nine probes already; remove one to pin another</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is a camera called &quot;%1&quot; already; give the path another name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no %1[%2]; there are %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no built-in file &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no built-in scene &quot;%1&quot;; there are %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no camera &quot;%1&quot; in %2; choose one of: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no camera &quot;%1&quot; in this scene; choose one of: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no camera called &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no difference between %1 and %2: one has more channels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no field &quot;%1&quot; in a lane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no field &quot;%1&quot; in the session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no file &quot;%1&quot; beside it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no frame %1: the shot has frames 0 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no history to compare with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no history yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no motion to compare</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no parameter &quot;%1&quot;; near it are %2, %3 or %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no preset &quot;%1&quot;; there are %2, or give a file that ends in .json</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no preset field &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no previous position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no reference of frame %1 while frame %2 is shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no reference of frame %1 yet: it has to be drawn first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no reference yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no way to compare &quot;%1&quot;: it is wipe, first, other or difference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>they have more than %1 vertices together</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too bright: luma of the output less luma of the reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too dark: luma of the output less luma of the reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too large a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>uploading the scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>vertex %1 is out of range; there are %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what the samples weigh together, the nearest %1 px from the pixel&apos;s center</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>where the surface was in the previous frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with it the images have more than %1 pixels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>write low, high, exposure, channels, map, or marks, clipped, rejected, outlines, arrows (on or off), = and a value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α in each, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α with the tone weights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>γ deviations from the mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, and cut off on the way back, as printed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, and noise of a step of 8 bits for the screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, smaller for tall pictures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>R, as the curve has it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as many frames&apos; worth of samples were stored in this pixel, whatever it showed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>compressed as in the box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history is one of the nine samples: kept as it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how near the nearest sample lies, %1 px of the picture from the pixel&apos;s center</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest of four taps on the diagonals, off by %1 px each way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean of four taps on the diagonals, off by %1 px each way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no sample lies in HDRP&apos;s box: the nearest is %1 px from the pixel&apos;s center</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the nine samples that at %1 is nearest to history</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the nine samples the pixel&apos;s own is nearest to history</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>read on the other side of where the pixel&apos;s center landed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>smallest of four taps on the diagonals, off by %1 px each way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>spread of four taps about their mean, off by %1 px each way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the nearest sample lies in HDRP&apos;s box: %1 px from the pixel&apos;s center</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the sample of this frame, which the resolve believes %1 px from the pixel&apos;s center</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the surface was behind the previous camera, or its motion as printed is beyond all numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not OBJECT=CLASS; classes are still, moving, deforming and character</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 and %2 as rejected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 and %2 by divergence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 and %2 by its change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 and %2 by motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 by the frame&apos;s time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 hidden</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 hidden by the overlay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is there already; --force replaces it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 masked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 motion blur</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, although it is a ghost, %2 of the result: %3, and in a color that is none of those around</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, although it is of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, although it lies off the screen, where it is black</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, although it lies off the screen, where the border is read instead</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, although its color is none of those around</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, at least %2 when rejected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, but follows the neighbor at %2, which did not move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, but follows the neighbor at %2, which has no previous position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, but follows the neighbor at %2, which moved %3 px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, but history is read in place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, for its luma comes and goes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, for single frames miss a thin feature here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, locked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, mixed as the curve has them: %2; then taken back from it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, of a depth test that does not run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, of channels %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, rounded to a half float</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, rounded up or down at random to a half float</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, rounded up or down at random to the %2 bits it is stored with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 of the correction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 of the correction, of which %3 are taken back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the correction, of which %2 are taken back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; %2 of that, for single frames may miss a thin feature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; its depth differs as of a thin feature at rest, which single frames miss</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; its depth is off by %2, and %3 are allowed where the surface recedes so</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; no depth test runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; no less than the floor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; raised where the mask asks for it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1/(%1 + 1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flicker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames of samples now: N = %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measuring the flicker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N = %1 counts samples of the other surface, too</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N = %1 from now on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N = %1 → α = %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replaying after several changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replaying at the new size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replaying the new scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replaying up to this frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replaying with the new camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replaying with the new classes of objects</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replaying with the new motion of objects</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replaying with the new shaders</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replaying with the new starts of history</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replaying with the objects that are drawn now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replaying with the settings to compare with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shown %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TAA is off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TAA is off: 1 in each</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TAA is off: the current frame alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TAA is off: the nearest sample is all there is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TAA is off: the sample as it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a character</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a neighbor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a single frame may miss a thin feature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a thin feature at rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all of the change over %1 frames is flicker: the reference did not change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all samples count alike where nothing moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an object that was given the class of characters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another surface by its depth (%1, expected %2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another surface, not tested</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as chosen: nothing moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as it should be</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as many frames&apos; worth of samples were stored around %1, by bilinear interpolation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>below 0: the compiler leaves out of the longer program what the shorter one has to keep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot draw with the driver zink of this Mesa (%1), which crashes: unset GALLIUM_DRIVER and MESA_LOADER_DRIVER_OVERRIDE, or update Mesa to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot record a flight at frame %1, which is the last one: go to another frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot restart the history at frame %1: the shot has frames 0 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>changes nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>comes and goes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>counts less</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>deforms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>did not move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>farther than expected: it hid nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>files that are there already: %1 of %2, the first is %3; --force replaces them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>for a frame that counts as %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>frames in which the surface was seen, one after the other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history alone: nothing of the current frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history counts less: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history failed a test (%1), which changes nothing: it counted no more before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history is far from the walls of the box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history is outside, but not pulled: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history kept as it was</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history kept whole, as printed: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history kept, pulled %1 of the way to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history lies within the slabs around the samples: kept as it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history outside is kept whole, as printed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history rejected: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history replaced by the sample that is most like it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>inside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it counted no more before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it decays by what is rejected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is not measured yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it moves: less the farther the sample is from the center</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its depth is that of history</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>keeps history</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kept: all tests passed (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kept: depth differs at rest, of a thin feature that single frames miss</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kept: no test runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>larger by motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>luma is that of history</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>luma of the sharpened color is that of the resolved one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>max(%1, %2 by mask)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>max(%1, %2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>more than a depth test would allow, but none runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>more than is allowed, of a thin feature at rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>moved %1 px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>moves rigidly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no flicker: what is shown of the surface changed by %1, and the reference at least as much</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no fog lies before it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no geometric flicker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no history yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no more than a depth test would allow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no previous</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no previous position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no reference drawn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no wall of the box is hit on the way to the current color: kept as it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not above the noise, ± %1 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not asked for: whatever time the frame takes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not blurred: it is no faster than 2 px a frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not clipped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not locked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not rejected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not tested</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing over it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing parts by more than %1 px, and what is nearer is thin: single frames miss it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing to compare with: what is seen here was not seen in the frame before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the depths stored around, the one that fits best</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one bilinear tap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one more, and no more than 16</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>outside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>outside of the box, but nothing of the correction is applied</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pulled %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pulled %1 of the way to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rejected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>same surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sharpened: %1 brighter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sharpened: %1 darker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>single frames miss a thin feature at rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sky</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sky, or not kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>something moves against it, or what is nearer is not thin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>steady</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>still</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>takes back %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the change over %1 frames, %2, without that of the reference, %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the current color</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the first frame is not counted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the fog before it takes %1 of the surface&apos;s light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the mask asks for that much</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the middle of the box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the pixel itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the pixel&apos;s own center: history is read in place, whatever moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the resolved color filtered: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the sample lies at the center</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the sample lies at the center, or it moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the sample of this frame, at the pixel&apos;s center</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no flicker of frame %1 yet: it has to be measured first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no preset &quot;%1&quot; to go on from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too bright</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what is seen here was not seen in the frame before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what is shown of the surface changed over %1 frames, on the screen&apos;s scale from 0 to 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what is shown of the surface did not change in %1 frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>where the surface would have been a frame before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α = %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α = 0: history alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α = 1: the current frame alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>κ %1 × (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tracing the probes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Settings and intermediates</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::CameraFiles</name>
    <message>
        <source>Save the flown camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera paths (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a recorded camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the flown camera</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::ChannelButtons</name>
    <message>
        <source>Channels: a click shows or hides one, a right click shows it alone.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::ColorSpacePage</name>
    <message>
        <source>RGB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>YCoCg</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axes of the color space plot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag to turn, double-click to turn back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>highlights bounded, as the box has them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scene-linear</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::ColorSpaceView</name>
    <message>
        <source>Color space plot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>resolved %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 right, %2 up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are no values to plot in this frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>min-max box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>variance box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>final box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hull</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what if</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>clip ray</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rectified</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>resolved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>taps</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::CommandLists</name>
    <message>
        <source>on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search commands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In a view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom at the cursor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag the divider</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show more of one side; a double click puts it in the middle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold Shift</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the other side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right click, drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Probe a pixel; it stays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arrows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the probe by 1 px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift+arrows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the probe by 10 px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag, Up, Down, wheel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change it (Shift: finer)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double-click its label</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to the preset&apos;s value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the pipeline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+click</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show an intermediate in the other view</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::CompareMenu</name>
    <message>
        <source>&amp;Compare</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Compare with…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With the frame &amp;before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With the &amp;preset as it was chosen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With &amp;nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This side, the &amp;other, their difference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Divider between both</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Divider to the left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Divider to the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Divider to the middle</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::CurveChart</name>
    <message>
        <source>Click to go there; drag or turn the wheel to zoom, double-click to see all.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::EditMenu</name>
    <message>
        <source>&amp;Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End what is under wa&amp;y, or remove the probe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Search settings and intermediates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Find a command…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy probed value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy &amp;all probed values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the probe as &amp;Markdown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the probe as &amp;JSON</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the &amp;picture of the view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy it with its le&amp;gend</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy as &amp;command line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy profile as text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy profile as CSV</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::Exports</name>
    <message>
        <source>The export ended early; none of its files were left.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A part of this view is on its way: pause, or try again when it is there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the view with its legend</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PNG (*.png)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>GLSL (*.frag *.glsl)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copied the picture of view %1, %2×%3 pixels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copied: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export resolve and output as GLSL</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exported. Frames: %1, the first into %2.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::FigureTable</name>
    <message>
        <source>Table: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::FiguresMenu</name>
    <message>
        <source>F&amp;igure under the timeline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::FileMenu</name>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start &amp;anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The first scene, settings and layout. What is open is kept, and can be opened again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save session &amp;as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Forget these</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View as PNG…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View with its &amp;legend as PNG…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Range of frames…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::FlightBar</name>
    <message>
        <source>Flying the camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to the camera that was left (Backspace)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End the flight and stay here (Esc)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flying</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1  W A S D Q E: move   drag: look   wheel: %2 a second   Shift: faster   Ctrl: slower</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play, and keep where the camera is in each frame as a camera (Ctrl+Shift+R)</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>● Recording: %n frames, %1 s</source>
        <translation type="unfinished">
            <numerusform></numerusform>
        </translation>
    </message>
</context>
<context>
    <name>taa::app::FlightFeed</name>
    <message numerus="yes">
        <source>%1 has %n frames from frame %2 on, %3 s.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
        </translation>
    </message>
</context>
<context>
    <name>taa::app::FrameMenu</name>
    <message>
        <source>F&amp;rame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Stop what is under way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step &amp;back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step &amp;forward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ten back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ten forward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Go to frame…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start again at the end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Restart the history here, or no longer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take all restarts awa&amp;y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Render si&amp;ze</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Memory for &amp;kept frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 MiB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 GiB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Motion of objects</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::GlslWindow</name>
    <message>
        <source>GLSL</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program of these settings, as it is compiled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file that Export GLSL writes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find; Enter goes on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find in the text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It follows the settings.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Built in. Start with --shaders FOLDER to edit a copy of it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 - it is read anew when it is saved.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::GoToPrompts</name>
    <message>
        <source>Go to pixel (x, y)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to frame (0 to %1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Render size (width × height, px)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>width and height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>takes %1 of memory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the mark at frame %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::HelpMenu</name>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Manual, settings and intermediates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;About TAA Inspector</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About TAA Inspector</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TAA Inspector %1

Steps temporal anti-aliasing frame by frame and shows everything it computes.

Driver: %2
Qt %3</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::HoverText</name>
    <message>
        <source>no history yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>  difference </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>  other </source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::JitterPanel</name>
    <message>
        <source>Index</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weight, %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disks: samples, with areas as their weights; ringed: this frame&apos;s. + middle of the samples, × with their weights: where the picture&apos;s content lies. The grid has as many cells as there are samples, or a few less. Click a sample to go to the frame that took it last.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, index %2 of %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Effective samples: %1 of frames, %2 of the %3 places.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Covers %1 % of %2×%2 cells.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Middle %1 px, with weights %2 px.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weights as measured at %1. Frames: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weights by the settings, where nothing moves or changes. Frames: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The samples lie across the way the camera moves in this frame.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The samples are shown as for a camera that moves to the right.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::JitterView</name>
    <message>
        <source>Samples of the jitter pattern in a pixel</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::KeysDialog</name>
    <message>
        <source>Keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::LeftArea</name>
    <message>
        <source>Pipeline or scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pipeline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scene</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::LowerArea</name>
    <message>
        <source>Pages of the lower area</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close the lower area</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::MainWindow</name>
    <message>
        <source>Profiler</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jitter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 - TAA Inspector</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step back with the comma key.  Right-click a pixel to see every value at it.  Press ? for all keys.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not a file on this machine; save it first, then open it.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::MarksMenu</name>
    <message>
        <source>&amp;Marks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Mark this frame, or take its mark away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Name the mark…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Previous mark, cut or restart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ne&amp;xt mark, cut or restart</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::MessagesBar</name>
    <message>
        <source>
and %1 more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>
The shaders from before stay in use.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shaders compile again and are in use.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shaders were read anew.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::OverflowPopup</name>
    <message>
        <source>More about this view</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::OverlayMenu</name>
    <message>
        <source>O&amp;verlays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mark NaN red, infinite green, negative blue</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::OwnPresets</name>
    <message>
        <source>Save these settings as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Presets (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::ParameterRow</name>
    <message>
        <source>range %1 to %2%3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>default %1%2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::PinBar</name>
    <message>
        <source>Probe %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Probe %1 (J: the next one); Shift+right click pins another</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the probe follows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stays on this pixel of the screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stays on the point of the surface that is here now, wherever it goes</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::PinnedProbes</name>
    <message>
        <source>move of probe %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pinning of probe %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>removal of probe %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>removal of all probes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change of what probe %1 follows</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::PipelineMenu</name>
    <message>
        <source>&amp;Pipeline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;TAA, or the frames as they are drawn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Back to the preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Unfold all stages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Fold all stages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;My presets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None saved yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save as preset…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Compare, rename, delete presets…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a preset &amp;file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Measure what each stage costs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reload &amp;shaders</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read &amp;GLSL of the stage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export GLSL…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Show the reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the &amp;error against it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the &amp;absolute error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 samples in a pixel</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::PipelinePanel</name>
    <message>
        <source>changed nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all on the screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 off the screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no history yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 pulled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rejected nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 rejected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The preset these settings started from; * when some were changed since.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare presets, rename and delete your own (Ctrl+D)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search settings and intermediates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved from the window.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1
The picture: %2. Click it to show it in the active view.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TAA off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 take another motion</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::PlaybackMenu</name>
    <message>
        <source>Speed and &amp;range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Slower</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Faster</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repeat from &amp;here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repeat &amp;up to here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repeat the &amp;whole shot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;peed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1×</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F&amp;rames per second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 fps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shot&apos;s own</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::PlotsMenu</name>
    <message>
        <source>P&amp;lots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Add a plot…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Fill in the frames that were not shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Show all frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy values as CSV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sa&amp;ve values as CSV…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::PlotsPanel</name>
    <message>
        <source>Right-click a pixel: its values over frames are drawn here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plots of the probes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a plot…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plot another intermediate (Shift+F6)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fill in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Makes the frames that were not shown yet, in the background while nothing plays (Ctrl+F6). The stop button ends it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show all frames (Ctrl+0)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy or save the values as CSV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy as CSV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as CSV…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plot of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove this plot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plot an intermediate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save values as CSV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CSV files (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot write %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames known at probe %3: %1 of %2 · × history rejected there</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::PresetChoices</name>
    <message>
        <source>change of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>choice of preset %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>return to the preset</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::PresetsDialog</name>
    <message>
        <source>Presets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Settings that differ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Setting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the present settings as a preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename this preset of yours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete this preset of yours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply this value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change only the selected setting to the preset&apos;s value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change all settings to the preset&apos;s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (mine)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is what is set now.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the present settings as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New name of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete a preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the preset %1? Its file goes, too: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 differs from the present settings. Values: %2.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::ProbeMenu</name>
    <message>
        <source>Pr&amp;obe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Go to pixel…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to the probe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Remove the probe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove &amp;all probes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Pin another under the mouse or beside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ne&amp;xt probe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Previo&amp;us probe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow the &amp;surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Color space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;What if</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Color space p&amp;lot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;RGB or YCoCg</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn &amp;left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn &amp;right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn &amp;up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn &amp;down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn &amp;back</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::ProbeModel</name>
    <message>
        <source>Intermediate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::ProbePanel</name>
    <message>
        <source>Right-click a pixel to see every value at it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pages of the probe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Color space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What if</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Probe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy every value, exact (Ctrl+Shift+C)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>resolved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pixel and its neighbors: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every intermediate at the pixel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>(%1, %2)  frame %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The surface is behind something here: these are the values of what hides it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The surface is not drawn in this frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The surface is off screen in this frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a row to read what happened there; Enter shows it in the active view.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the probe (Del)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::ProfileChart</name>
    <message>
        <source>Times of the passes over the last frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>frames before the last</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ms</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::ProfilerPanel</name>
    <message>
        <source>Pass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>median</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resource</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MiB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>objects</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Passes, from the next frame on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stages of the resolve, when measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Over time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Memory on the GPU</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure stages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resolves the frame on show again and again with programs that end after each stage (Shift+F11). The stop button ends it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy all figures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As CSV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Passes of frame %1, median of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of it kept histories</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw and stores</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>±</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in the noise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stages at frame %1, %2×%3, ± of %4 rounds</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::RangeDialog</name>
    <message>
        <source>Export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export a range of frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PNG pictures, one for each frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Animated GIF</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>EXR values, one file for each frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kind of files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The whole picture, pixel for pixel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the active view shows, as large as it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part of the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames a second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Into</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Intermediates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The last frame is before the first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No values are chosen.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no picture yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The name of a file is missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder %1 is not there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing can be written into %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Files: %1, the first %2. They appear when all of them are made.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of frame %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 They show both sides, with the divider where it is: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 They show the difference of %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 They show the other side: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export into</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, frames: %2, of %3×%4 pixels, each shown for %5 ms (GIF counts in steps of 10 ms).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, frames before: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::RangeHistogram</name>
    <message>
        <source>Histogram of the visible values and the range they are drawn in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Visible values, counted on a logarithmic scale. Drag an end of the range; Left and Right move the low end, with Shift the high end.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The visible values are being counted</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::ReferenceDialog</name>
    <message>
        <source>Find in this page; Enter goes on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find in this page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Manual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pages of the manual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Settings and intermediates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Page of the manual</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::ReplaceTexts</name>
    <message>
        <source>Replace files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is there already. Replace it?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Files that are there already: %1 of %2, the first is %3. Replace them?</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::SceneChoices</name>
    <message>
        <source>change of how objects move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change of what is drawn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change of what class objects are of</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change of where history restarts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>choice of camera %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>flight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>recording of a flight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>opening of camera %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>removal of camera %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>new name of camera %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::SceneMenu</name>
    <message>
        <source>&amp;Scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show &amp;all objects</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Fly the camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Record a flight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Back to the scene&apos;s camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End the &amp;recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sa&amp;ve the flown camera…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a recorded &amp;camera…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Re&amp;name the flown camera…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Delete the flown camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Objects in place of the pipeline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Search objects</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Hide or show the selected object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Isolate the selected object, or show all again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Probe the selected object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Motion of the selected object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Class of the selected object</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::ScenePanel</name>
    <message>
        <source>Filter objects by name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Objects of the scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Isolate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw only the selected object and what is below it, or all again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Probe it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the probe on the selected object and show it in the active view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw all objects again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select an object, or right-click a pixel of it in a view.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>: not drawn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>: draws nothing itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>: %1 pixels around (%2, %3), framed in the views</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>: not seen on frame %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide or show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Isolate, or show all again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the probe on it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By what moves it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Class…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::SceneTreeModel</name>
    <message>
        <source>%1 (light)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (camera)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>
Hidden</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>
Hidden with what it belongs to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>
Not drawn: others are isolated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unchecked objects are not drawn; isolated ones are bold.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The motion that an object is given, whatever moves it. Click it to change.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>
Objects: %1, triangles: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::Screenshot</name>
    <message>
        <source>The picture did not get ready within %1 s. %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot write %1: check that its folder exists and can be written</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::Session</name>
    <message>
        <source>about %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::SessionKeeper</name>
    <message>
        <source>Save the session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sessions (*.taa.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TAA Inspector ended without being closed. What was open on %1 has been kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open it again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Throw it away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was open last is not open again: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It has been kept as %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was open has been kept: File, Open recent, %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a scene or a session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scenes and sessions (*.gltf *.glb *.taa.json);;glTF 2.0 scenes (*.gltf *.glb);;Sessions (*.taa.json);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::SourceText</name>
    <message>
        <source>Text of the shader</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::StateWatch</name>
    <message>
        <source>change of what view %1 shows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change of what view %1 is compared with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change of the side that view %1 shows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>move of the divider of view %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change of what lies over view %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change of the look of view %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change of how the views lie</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mark of a frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>removal of a mark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>name of a mark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change of the repeated part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change of what comes after the end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change of the figure under the timeline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change of the speed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::StatusLine</name>
    <message>
        <source>rendered at %1 × %2 · </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>frame %1 until %2 is there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history from old settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time of the last frame: drawing the scene, and the resolve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the picture is exactly what these settings give from frame 0 on. After a change the old history is used until it has been made anew, and on the way to a frame the nearest one that was kept is shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>software renderer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scene %1 ms · resolve %2 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history from these settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history not exact yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no history of this camera yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no history of this size yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history with the old motion of objects</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history with the objects drawn before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history with the old classes of objects</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history with the old starts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history from old shaders</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history from before several changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no picture yet</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::Strip</name>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::Swatches</name>
    <message>
        <source>Neighborhood: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no color</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::Timeline</name>
    <message>
        <source>Timeline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mark “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cut: history starts anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 not known yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, 0 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click or drag to go to a frame; the wheel steps. Drag the brackets to repeat a part.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>history is restarted</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::TimelinePanel</name>
    <message>
        <source>First frame (Home)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One frame back (,)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play or pause (Space)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One frame on (.)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last frame (End)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start again at the end (Ctrl+L)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How fast it plays (Ctrl+[ slower, Ctrl+] faster)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1×</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames per second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames shown a second at speed 1; the shot&apos;s own time stays as it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 fps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shot: %1 fps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shot&apos;s fps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to a frame (G)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place in the jitter pattern, and the displacement of the picture in px (x right, y down)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>jitter %1 of %2 (%3, %4)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no jitter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>t = %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No figure under the ruler</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::ViewChoices</name>
    <message>
        <source>Search intermediates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same with another preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same in another frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The frame before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This frame, kept while others are shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another frame…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare with frame (0 to %1)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::ViewCountMenu</name>
    <message>
        <source>&amp;Views</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two views</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Four views</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys act on view %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::ViewHeader</name>
    <message>
        <source>Value drawn as the low end of the range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value drawn as the high end of the range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>EV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exposure in stops, before the range (E, Shift+E)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit the range to the visible values (N); right click: always</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show it as it opened (R)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Color map (M)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare with another intermediate, preset or frame (C)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Histogram of the visible values (H)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What lies over the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which of both sides is shown (O; Shift+O: divider; hold Shift: the other one)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which of both sides is shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Difference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Divider</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Screen pixels for each pixel; a click changes between fit (F) and one to one (1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Intermediate on show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Low end of the range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>High end of the range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exposure in stops</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Color map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fit · %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which of both sides is shown (O); they have no difference: one has more channels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Channels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Range from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit the range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Histogram</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As it opened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare with…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shown side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Overlays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More about this view, which has no room here</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::ViewMenu</name>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Intermediate…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Next number of views: one, two, four</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Look at the same place in all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;One to one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pipeline panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Probe panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures in the headings of stages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Profiler</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plots of the probes over frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jitter pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weights and effective samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Arrangement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whichever is larger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One above the other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brighter by half a stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Darker by half a stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Normalize: fit the range to the visible values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normalize always</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Histogram of the visible values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next color &amp;map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First channel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Second channel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Third channel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>T&amp;heme</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the system</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::ViewPanel</name>
    <message>
        <source>View %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hatch what lies outside the range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tint by the reason of rejection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outline objects</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arrows over vectors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grid between large pixels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mark NaN red, infinite green, negative blue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whole legend also where the picture is low</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::ViewSides</name>
    <message>
        <source>%1 · only the frame on show has a reference: go to that frame to see its own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · comes when it is paused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · on its way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · frame %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · stays until it is paused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · not exact yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>⋯ overlays</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::Viewport</name>
    <message>
        <source>%1  −  %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::WeightsPanel</name>
    <message>
        <source>Weight in the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>frames back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Effective samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>by the settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame %1, %2 after history started. By the settings, where nothing moves or changes: α = %3, %4 effective samples now, %5 at last.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>measured at %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A probe adds what its pixel measured in the frames that were shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured at %1: α = %2, %3 effective samples of frames: %4. Where the surface moves, its history came from other pixels.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::WhatIfPage</name>
    <message>
        <source>%1: resolved %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Instead</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resolved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pixel under other choices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This frame again on the history it had, one choice replaced. ▸ is in force. * uses jitter and inputs as they are now, or misses what this history does not keep.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>taa::app::WorkBar</name>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 of %3</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tables</name>
    <message>
        <source>Jitter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves the picture by a part of a pixel, a different one each frame.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the renderer draws for this frame: color, depth, motion, normal, object id.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dilate motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chooses the neighbor whose motion this pixel follows, so that silhouettes move with what is in front.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reproject</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finds where this pixel&apos;s surface was in the previous frame.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sample history</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reads the accumulated picture at that place.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rebuilds the color at the pixel&apos;s center from the jittered samples around it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Neighborhood</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measures the colors around the pixel and bounds them by a box.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rectify history</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pulls history that lies outside the box back to it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Validate history</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rejects history that belongs to something else: off the screen, or behind what is now in front.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blend weight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Decides α, how much the current frame counts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blend</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mixes current and history into the resolved picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Output</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is shown of the resolved picture: sharpened, or blurred where it moves fast. Never goes into history.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sequence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pattern of sub-pixel offsets the picture is drawn with.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>j = (Φ₂(i) − ½, Φ₃(i) − ½)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Still</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uniform 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uniform 4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Helix 4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double helix 8</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skew butterfly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotated grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Poisson 10</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pentagram</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Halton</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>R2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hammersley</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gradient noise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MSAA 8</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blue noise 16</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>White noise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Period</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames until the pattern repeats. Longer covers the pixel better and converges slower.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>i = first + n mod P</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First index</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Index of the sequence at frame 0. Index 0 is the corner (−½, −½).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size of the offsets. 0 turns anti-aliasing off, less than 1 flickers less and aliases more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>j·s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Precision</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Storage of color and motion.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>16-bit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Half floats, as engines store it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>32-bit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Full floats, for reference runs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whose motion the motion vectors hold.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>v = π(Xₜ) − π(Xₜ₋₁)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Objects</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera from depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera, raw position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera, jitter subtracted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera, one matrix</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera, jitter subtracted, as printed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mip bias</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>levels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Added to the level of detail of textures. Below 0 they are sharper: accumulated samples carry more detail. Drawn at a render scale r, textures want log₂ r besides; FSR2 takes log₂ r − 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>λ + b, b ≥ −½ log₂ N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unjitter textures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reads textures at the pixel&apos;s center instead of at the jittered sample: they stand still, and are not anti-aliased.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>uv + ∂uv/∂x·jx + ∂uv/∂y·jy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Transparency</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How materials with alpha blending are drawn: as surfaces, or blended over them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>c = a·cs + (1 − a)·c</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mask</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solid where alpha is at least ½.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dithered</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blended before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before, with motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blended after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the scene marks what has no motion of its own or was blended in, for the resolve to treat otherwise.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reactive = min(0.9, 5·max|c − c opaque|)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No mask is drawn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Difference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Render scale r</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draws fewer pixels than the picture has, ⌈r·W⌉ × ⌈r·H⌉; accumulation fills the rest. Wants a jitter period near 8/r² and a mip bias of log₂ r, less 1 in FSR2: both stay yours to choose.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>xᵢ = r·xₒ, P ≈ 8/r²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Noise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is added to the shaded color, against banding where history has few bits.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>c + (u − ½)·A/255</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colors as they were shaded.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blue noise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Amount A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1/255</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steps of 8 bits that the noise is wide; twice as many when triangular. What falls below 0 is 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Triangular</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The sum of two noises less 1, from −1 to 1: its variance, 1/6, is the same for every color.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>u₀ + u₁ − 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whose motion vector a pixel follows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>v(argmin z over 3×3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closest 3×3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closest +</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closest ×</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closest × at 2 px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longest 3×3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longest +</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closest 3×3, as printed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closest ×, as printed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How history is read between its pixels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bilinear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Catmull-Rom 5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Catmull-Rom 9</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Catmull-Rom 16</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cubic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mitchell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lanczos 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Catmull-Rom 5, as printed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Catmull-Rom 5, corners</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cubic 5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cubic 5, as printed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sharpness c</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sharpness of the cubic: 0.5 is Catmull-Rom, HDRP uses 0.35; only 0.5 keeps ramps straight.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>w₀ = −cf³ + 2cf² − cf</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deringing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps the filtered value within the values it was made from: no dark or bright halos.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>clamp(h, min taps, max taps)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bilinear at edges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One bilinear tap where depth has an edge: no ringing of one surface into the other.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>max z − min z &gt; e·max z over 3×3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edge e</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Range of view depth over 3×3 that is an edge, relative to the farthest. Intel has 0.002 of its far plane, which depends on where that is; the sky is infinitely far.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>e</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Storage of the accumulated color. 16 bits are rounded to nearest; small differences stop counting.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>8-bit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>10-bit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dither</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rounds up or down at random before the store, by a hash of pixel, frame and channel that has nothing to do with the jitter: the mean no longer stops short of its goal.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>⌊x/LSB + u⌋·LSB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the color at the pixel&apos;s center is made from the jittered samples. Below a render scale of 1 the upsampling kernel does.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Σ w(‖o − j‖) c / Σ w</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Center</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gaussian</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unjitter tap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>4-2-1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Catmull-Rom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blackman-Harris</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None, as printed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mitchell, as printed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blackman-Harris, as printed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Variance σ²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>px²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the Gaussian. 0.22 is close to Blackman-Harris 3.3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>w = exp(−d²/2σ²)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jitter-aware</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measures distances to where the jittered samples lie; off: to the pixels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>d = ‖o − j‖</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Luma weights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bright samples count less, so that a highlight does not flicker with its sample.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>w/(1 + L)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps the filtered color within the nine samples.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>clamp(s, min c, max c)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sharpen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sharpens this frame&apos;s color before it is blended: what is added goes into history and is added again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>f + s(f − mean₄)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As filtered.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Laplacian</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Laplacian, as printed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Amount</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much of the difference to the four around is added. 0 adds nothing; as printed 0 is black.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>s; as printed max(0, 5s f − s Σ₄)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Upsampling</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the color at a pixel&apos;s center is made from the fewer samples of a render scale below 1, and what they say of it: the confidence κ, a factor on α.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>d = k + ½ − j − r·xₒ, α·κ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nearest sample</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HDRP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FSR2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Color space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axes of the box that history must lie in.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Y = R/4 + G/2 + B/4, Co = R/2 − B/2, Cg = −R/4 + G/2 − B/4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RGB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>YCoCg</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>YCoCg lifting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>YCbCr</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tone space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether highlights are compressed before the box is measured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>c / (1 + L)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Linear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Box of scene-linear colors; a highlight opens it wide.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reinhard luma</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reinhard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest channel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Samples around the pixel that the box is made from.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cross</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3×3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>×</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rounded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alternating</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unjitter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes the samples where the pixels&apos; centers landed, each by a bilinear tap: the box stands still while the jitter moves, and is smaller.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>c(p + o + j)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moment weights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What each sample counts for mean and deviation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>μ = Σwc/Σw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Equal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every sample counts alike.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Luma</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the box is made from the samples.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>μ ± γσ ∩ [min, max]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Min-max</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Variance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Both</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>γ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>σ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Half the width of the variance box, in deviations. Less ghosts less, more flickers less.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>μ ± γσ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>γ by motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tightens the box where things move.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>γ = lerp(γ moving, γ, (1 − ‖v‖/v₀)²)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>γ moving</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>γ at full speed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Full speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion a frame from which on γ is that of motion.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>v₀</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>γ by contrast</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Widens the box where current and history differ in luma, so that what flickers settles.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>γ + A·smoothstep(0.05, 0.55, |Ls − Lh|/max)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Growth A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Most that contrast adds to γ.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relax by mask</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Widens the box and takes less of the current frame where the mask is set, so that what would be clamped away accumulates.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>γ·(1 + 1.5m), α/(1 + 0.5m)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chroma shrink</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chroma may differ from the pixel by an eighth of the luma range: no colored ghosts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>extent = (Ymax − Ymin)/8</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Include filtered</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grows the box to hold the filtered current color, the target of clip to filtered.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lo = min(lo, s), hi = max(hi, s)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How history outside the box is pulled back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>h + t·(target − h)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clamp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To center</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To filtered</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shrink axes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clamp, then clip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ray to current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To filtered, hull</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clamp and forget</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Farthest hit T</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hits farther along the ray than this many times the way to the current color do not count.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>t ≤ T</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relax at rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Applies only a part of the correction where little moves, against flicker.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lerp(h, rectified, κ)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strength at rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part of the correction that is applied where nothing moves. 0 freezes changes of light.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>κ min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rest ends at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion a frame from which on all of the correction is applied.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>κ = κ min + (1 − κ min)·min(1, (‖v‖/θ)²)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Locks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thin features keep their history: a pixel brighter or darker than all neighbors that are unlike it, and part of no even 2×2, is locked. A lock is made by a second such frame, and dies when history is rejected, when the mean luma of 3×3 changes to less than 0.531 of what it was, or before it leaves the picture. FSR2 compares sixth roots of luma with 1.05 and 0.9: the same as luma with 1.34 and 0.531, which is exact; its mean is that of a coarse mip. Locked ghosts stay.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>max/min &lt; 1.05⁶; h + max(lock, instability)·(h₀ − h)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lock lasts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames until a lock that is not made anew is gone. FSR2 takes w/(P·0.74/12) off in each frame, w being the weight of its samples, whose mean is 0.74/12: 1/P.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>life − 1/P</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Luma instability</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pixels whose luma comes and goes keep their history: where one of four past lumas is nearer to this one than the last is, not across it, and the box is not small. Luma is the mean of 3×3 as L/(1 + L) in 255 steps. An exact return counts too, which FSR2&apos;s comparison of signs misses.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>least |L − L′ᵢ| &lt; |L − L′₁| and min(1, σ/0.1)⁶ &gt; 1/255</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Off screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What happens where the previous position lies outside the picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>q ∉ [0, W] × [0, H] ⇒ α = 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reject</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With margin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One-sided, as printed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rejects history that belongs to a surface at another depth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>|z − z′| &gt; τ·z ⇒ α = 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth tolerance τ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Difference that still counts as the same surface, relative to the expected depth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>|z − z′| / z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slope allowance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>τ + px·(|∂z/∂x| + |∂z/∂y|) / z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rejects the history of what moves faster than a limit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>‖v‖ &gt; v max ⇒ α = 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fastest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion a frame that still keeps its history.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>v max</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Class</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>n·n′ &lt; cos θ ⇒ reject</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least cos θ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least cosine between the normals of now and then.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cos θ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Velocity change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α ≥ min(1, (‖v − v′‖ − θ)·k)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion may change as it likes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vector</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change allowed θ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change of motion a frame that rejects nothing. Godot: 2.5 px; too little turns accumulation off wherever something moves. HDRP: 0.0159 of the picture, 20 px of 1280.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>θ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rejected for each px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1/px</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of history that is lost for each px of change beyond θ. Godot multiplies velocities by the size of the picture first, so that its 0.01 is for each px: all is lost at 102.5 px.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>k</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rejected history</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What becomes of history that depth, speed, object, class, normal or velocity reject.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Raise α</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Raised α</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least weight of the current frame where history is rejected and stays. HDRP: 0.97.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α soft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the weight of the current frame comes from.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Constant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>History length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Luma difference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contrast</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Luma difference, as printed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contrast, by channel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Confidence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weight of the current frame. 0.1 averages about 19 frames.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N∞ = (2 − α)/α</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least α</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least that calming and 1/(N+1) leave of α; a source that is smaller by itself stays. 0 never forgets.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α = max(α base · calm, α min)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Most α</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α where current and history differ most in luma; the most α that confidence leaves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α = most + u²·(least − most)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fewest α</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α where they are the same; the least that confidence leaves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>u = 1 − |Ls − Lh|/max(Ls, Lh, 0.2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calm luma</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Less of the current frame where luma differs, against flicker. Can hold on to old history.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α·(1 − |Ls − Lh|/(0.001 + max))²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Luma measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the difference of luma is measured against.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relative</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compressed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calm near clamp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Less of the current frame where history is near a wall of the box, against flicker.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α·d/(d + hi − lo)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calm contrast</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Less of the current frame where the box is large against history.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α/(1 + (hi − lo)/Lh)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sample distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Less of the current frame the farther the jitter took its sample from the pixel&apos;s center.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α·w(‖j‖)/w(0)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parabola, at rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α by motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More of the current frame where things move.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 − (1 − α)(1 − α motion)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion does not matter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Squared</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Squared, as printed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Doubled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Added</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Full α at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion a frame from which on only the current frame counts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α by mask</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More of the current frame where the mask is set.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>max(α, α mask)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mask does not matter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Responsive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reactive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exclude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mask α</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least weight of the current frame where the mask is 1. UE4 and HDRP take 0.2 to 0.5.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α mask = α·max(reactive, responsive)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α by velocity change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More of the current frame where a surface moves otherwise than what history shows did a frame ago. Steady motion keeps its history, which α by motion does not. Measured as validate.velocity says, as a vector when that is off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 − (1 − α)(1 − min(1, ‖v − v′‖/v₁))</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Full α at change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change of motion a frame from which on only the current frame counts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>v₁</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α by divergence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More of the current frame where the pixel and one of its eight neighbors move apart: there something is uncovered. Needs nothing of the past. FSR2 divides by the square of the fastest so far; here by that of the faster of the two.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>(1 − min v·v₀/max(‖v‖, ‖v₀‖)²)·min(1, fastest/v₂)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Full divergence at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion a frame from which on divergence counts fully. FSR2: 1 % of the picture, 12.8 px of 1280.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>v₂</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By frame rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Makes α that of the time a frame takes, so that a ghost fades alike at any frame rate. The exponent is rounded to eighths, 1/8 to 8: whole powers and square roots have the same bits everywhere.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α′ = 1 − (1 − α)^(Δt/Δt₀)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Meant for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame rate at which α is taken as it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Δt₀ = 1/rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tone weighting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether bright colors count less, so that single highlights do not flicker.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>w = 1/(1 + L)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Luma, as printed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What a pixel shows whose history was rejected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filtered</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blurred</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How N grows from frame to frame.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N = 1/(α² + (1 − α)²/N)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Count</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Variance, as printed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1/α</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>c + k(c − mean)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is resolved is shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Luma ratio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsharp mask</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RCAS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the resolve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Logarithm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reconstruct</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How strongly. 0 changes nothing; constants stay what they are whatever it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps the sharpened color within the nine it stands among: no halos, and no peak above its neighbors.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>clamp(s, min₉ c, max₉ c)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion blur</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows this frame blurred along its motion where that is fast, because the resolved color is not to be trusted there: none of it to 2 px a frame, all from 15 px.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean of 7 taps along ½v; trust = 1 − sat((‖v‖ − 2)/13)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Color</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This frame&apos;s jittered samples, scene-linear.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Device depth: reversed, 0 is the sky.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance along the view axis; 0 stands for the sky.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the surface came from, render px: current minus previous position, jitter removed; 65504 where there is no previous.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shading normal in world space.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Object id</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of the drawn object; 0 is the sky.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mask of what was blended into the color; 0 where none is drawn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mask of materials that change without motion: screens, flip-books, particles; 0 where none is drawn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is laid over the output, without jitter, times its opacity; 0 where nothing is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Overlay opacity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much of the output the overlay hides.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Object class</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dilated offset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step to the neighbor whose motion is used, render px.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dilated depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Device depth of that neighbor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dilated motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion of that neighbor, from here on in px of the picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>History position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where this pixel was in the previous frame: pixel center minus dilated motion.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 where the history position lies inside the picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of the dilated motion.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>History</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The accumulated color at the history position.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>History length before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N at the history position: how many frames&apos; worth of samples it holds.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 where history was read by one bilinear tap because of an edge in depth; 0 when off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Current filtered</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This frame&apos;s color at the pixel&apos;s center.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>κ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much this frame&apos;s samples say about the pixel, a factor on α; 1 when drawn at full size.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean of the neighborhood, box space.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard deviation of the neighborhood, box space.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smallest of each channel, box space.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest of each channel, box space.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>γ used</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deviations from the mean to the wall of the box, after motion and contrast.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Box minimum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lower corner of the box history must lie in.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Box maximum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Upper corner of the box history must lie in.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>History rectified</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>History after it was pulled into the box.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clip amount</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far history was pulled towards its target: 0 kept, 1 all the way.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rectify strength</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part of the correction that is applied.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much of the correction a lock takes back; 0 when off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lock life</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>2: locked in this frame; less than 1 does nothing, 0: no lock.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 where luma comes and goes, which takes back all of the correction; 0 when off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>History length kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N after rectification: less than before only where that forgets.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth expected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View depth this surface had in the previous frame.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>History depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth mismatch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth allowed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest mismatch that still counts as the same surface: the tolerance, and more where it recedes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>History object id</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normal agreement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reject reason</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why history was rejected: 0 kept, 1 no history, 2 no previous position, 3 off screen, 4 depth, 5 too fast, 6 another object, 7 another class, 8 another normal, 9 another velocity.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α of the chosen source.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α floor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The least α may be.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α calm luma</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Factor on α where luma differs from history; 1 when off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α calm near clamp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Factor on α by the distance of history to the box&apos;s walls; 1 when off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α calm contrast</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Factor on α by the size of the box; 1 when off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α relax</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Factor on α where the mask is set; 1 when off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α sample distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Factor on α by how far the sample is from the pixel&apos;s center; 1 when off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What motion adds to α; 0 when off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α velocity change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What a change of motion adds to α; 0 when off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α divergence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What motion that parts adds to α; 0 when off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α by frame rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α after motion, for the time this frame took; unchanged when off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α mask</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The least that the mask asks of α; 0 when off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α invalid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least α where history was rejected: 1 where it is dropped, 0 where it was kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weight of the current frame: base times the calming factors, at least the floor, what motion adds joined, for the frame&apos;s time, times κ, at least α mask and α invalid.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α of channels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weight of the current frame in red, green and blue: α in each, unless its source has three.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tone weight current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1/(1+luma) of the current color, 1 without tone weighting.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tone weight history</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1/(1+luma) of the rectified history, 1 without tone weighting.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blend factor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the current color after tone weighting.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N after this frame: samples&apos; worth of averaging in this pixel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resolved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The output of TAA, which is the next frame&apos;s history.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sharpening</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Luma that sharpening adds to the resolved color; 0 when off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blur trust</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the resolved color in what is shown; the rest is this frame blurred along its motion.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is shown: the resolved color sharpened, or blurred where it moves fast, and the overlay over it; the same as resolved when all are off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same instant drawn many times over the pixel&apos;s square, without mip bias and noise, at full size: the mean, scene-linear.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Luma of the output less luma of the reference, scene-linear: above 0 the output is too bright.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Absolute error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest difference of output and reference in red, green or blue, scene-linear.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no history</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no previous position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>off screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too fast</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another class</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another velocity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean α</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean weight of the current frame.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rejected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of pixels whose history was rejected; all of them where history starts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clipped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of pixels whose history was pulled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean clip amount</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far history was pulled towards its target, the mean over all pixels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean history length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean number of samples that a pixel holds after the frame.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RMSE</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Root of the mean squared difference of output and reference as they are shown: clamped to 0…1, sRGB, over red, green and blue.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PSNR</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Peak signal to noise of output against reference as they are shown, −20 log₁₀ RMSE: the peak is 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RMSE, scene-linear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As RMSE, but scene-linear and not clamped: bright highlights count for what they are.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Per object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gray</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Viridis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inferno</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diverging</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cyclic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Categorical</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rectification</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>History filter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>timed by timer queries of the GPU</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>timed by the wall clock with glFinish around each pass, because this driver&apos;s timer queries lie</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Balanced</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Minimal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The least that can be called TAA: jitter, motion, bilinear history, a min-max clamp in RGB and a constant α of 0.1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sharp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps detail first: sixteen-texel Catmull-Rom history, the bare center sample and a tight box; highlights flicker more than with Balanced.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flickers least: a wide luma-weighted Gaussian, a box that grows where luma flickers, half of the correction at rest and a floor of 0.05 for α; ghosts stay a little longer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unrectified</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>History is believed as it is: nothing is clamped or rejected but what is off the screen. Every ghost shows; a place to start teaching.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The exact mean of all frames since the start in 32-bit floats: on a still camera and scene it converges to the supersampled picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bevy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DiligentFX</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Falcor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filament</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Godot 4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HDRP Low</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HDRP Medium</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HDRP High</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Intel TAA</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MiniEngine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>NVIDIA Donut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Playdead INSIDE</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Raptor, chapter 11</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UE4, Karis 2014</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The talk&apos;s choices: depth-closest × at 2 px, a Blackman-Harris 3.3 (the Gaussian of variance 0.22 next to it), a rounded box in YCoCg that holds the filtered color, clip to it, α 0.04 less near the box, luma weights. What is blended comes before the resolve without motion; responsive materials keep α of 0.25 or more. Known from the slides and from peers that cite them; Epic&apos;s source was not consulted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>URP Very Low</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>URP Low</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>URP Medium</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>URP High</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>URP Very High</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FSR 2 at 1:1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AMD&apos;s FidelityFX Super Resolution 2 where it does not enlarge: Lanczos for history and samples, variance inside min-max in YCoCg, a clamp that forgets, taken back by locks and luma instability where the mask is not reactive, α by the mask it makes itself and by divergence. It accumulates a weight of 1, about 16 frames; below a render scale of 1 its own kernel enlarges. There the history that fast pixels keep shrinks, divergence feeds the mask, shading changes are seen in a coarse mip and the samples of the box are weighted; exposure and sharpening are left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A fan spins in its wire guard before bricks and small bright lights: ghosting, thin wires, HDR</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The camera passes pickets, wires and a net, far to near: sub-pixel detail and disocclusion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disocclusion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Boards slide before a detailed wall and uncover it: ghosts, and pixels that have no history</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The camera cuts every second, and a ball is teleported without a cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lines one pixel and half a pixel wide at every slope, some nearly level, of known coverage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fine print, checkers, a zone plate and a ticker: what the history filter blurs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fireflies</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sparks smaller than a pixel, a thousand times as bright as white: tone weights and boxes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lamps switch on and off: the history&apos;s geometry is right and its shading wrong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Foliage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grass and leaves sway in the vertex shader: motion of vertex animation, alpha masks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gallery</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One labelled object for each source of motion: camera, rigid, skin, morph, wind, cache</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Glass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Panes of glass, particles, a flip-book and a ticker: what no motion vector tells the history</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crowd</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Six hundred things, a million triangles: small, thin and far ones that spin, walk and run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exposing for views</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Views</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Probe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thumbnails</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Between the passes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>G-buffer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sky</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blended surfaces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reactive mask</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resolve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Across the motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Projection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the offset gets into the projection. The resolve always believes it is the translation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P̃ = T(2jx/W, −2jy/H)·P</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Translation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Third column, sign as printed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Third column always, as printed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Objects, as printed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the resolve runs before tone mapping or after it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>min(c, 1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HDR</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LDR</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Border</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What a filter reads outside of the picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The nearest pixel of the picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Black</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the history length is read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N(q)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Own pixel, as printed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unjitter tap, as printed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HDRP, Gaussian</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>YCoCg, as printed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PQ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Four taps that vary</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seven, by pairs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>γ by resolution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tightens the box of tall pictures, whose pixels hold less each.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>γ·clamp(1.1·1080/H, ¾, 1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To filtered, both boxes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>White point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>White W</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scene-linear color that the curve takes to 1; brighter ones go on beyond.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>W</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Triangular noise of one step of 8 bits on what is shown, against banding on a screen that has no more. In square roots, which is near to what screens are sent; never into history.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>(√c + (u₀ + u₁ − 1)/255)²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unity&apos;s High Definition pipeline, quality High: as Medium, its slips included, with nine samples and a jitter-aware Gaussian. There what contrast adds to γ is scaled by speed as well, 2.25 times at rest and 0.8 from ½ px on, which is left out. Sharpened by 0.5: there the current color before the blend, against the mean of the eight around, here what is shown, against that of nine. What is blended comes before the resolve without motion; flagged materials are excluded from it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HDRP TAAU</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unity&apos;s High Definition pipeline, temporal upsampling: as High, drawn at 0.67 of the size with 18 samples of Halton, HDRP&apos;s kernel and a mip bias of log₂ 0.67. γ and what contrast adds to it lie nearer to 0.9 the smaller the drawing; here their values for this scale. The rest differs as with High.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unity&apos;s Universal pipeline, quality Very Low: bilinear history, a clamp to five samples in RGB, no dilation and no test at the border, luma weights where colors are blended. Low-precision targets are left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unity&apos;s Universal pipeline, quality Low: as Very Low, with the closest of five depths and history rejected outside the picture. Low-precision targets are left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unity&apos;s Universal pipeline, quality High, its default: as Medium, with five-tap Catmull-Rom history. There the luma that weighs the blend is Y of YCoCg.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unity&apos;s Universal pipeline, quality Very High: as High, with a jitter-aware Gaussian and clip to the center. There the box is of the filtered center and the eight samples around, here of nine samples; there the luma that weighs the blend is Y of YCoCg.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the right, as printed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Objects, projection as printed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Noise and range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dynamic range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same instant, supersampled: what the output should be, how far it is from it, and how much more it flickers. Drawn while somebody looks at it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TAA</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Off: each frame is shown as it is drawn. The jitter rests at the pixels&apos; centers, the filter of the current frame takes the nearest sample alone, α is 1 everywhere, and the output is neither sharpened nor blurred nor dithered. History holds the frame before, and all other values are what TAA would make of it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>j = 0, f = c, α = 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fog steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steps of the march through the fog of scenes that have some, from where it begins to where it ends. 0: the integral itself, which the reference has.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>T = Π exp(−σ Δ), L = Σ T (1 − exp(−σ Δ)) c</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>source 001, improving banding</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fog density</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Times the density that the scene gives its fog. 0: there is none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>source 001</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fog noise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where in its step each sample of a ray lies: noise u instead of bands, for TAA to average.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tᵢ = t₀ + (i + u)Δ; none: u = ½</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All rays stop at the same distances: the fog has as many levels as steps, in bands.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Animated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another noise in each frame, whose mean over frames is the integral. Off: that of frame 0, which no average over frames takes away.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>u(p, n)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fog history</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A temporal filter of the fog&apos;s own, before the resolve. The fog of earlier frames is marched again along the rays of this one, so that no frame depends on how one came to it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>f = (s + (M − 1)·clamp(h, min, max))/M</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The fog of this frame alone: its noise is left to the resolve.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clamped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest, as printed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fog frames M</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames that are averaged, this one included; each is marched.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>M</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Farthest 3×3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of equals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which of equally near ones is chosen: what faces the camera and the sky are nothing but equals.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pixel itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The last</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read up-left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reads motion one texel up and to the left of the one that was chosen: Godot leaves out the border of its tile.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>v(p* − (1, 1))</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>History at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the history of a pixel is read: where its surface was, or at the pixel itself, whatever moves. Speed is that of the motion either way.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>q = p − v, or q = p</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where it was</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Luma of the box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Full speed in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What full speed is counted in.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pixels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the picture, however many it has.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pixels of 1080 lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>‖v‖·1080/H: the same for a picture of any size (DiligentFX).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1080ths of the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>‖(vx/W, vy/H)‖·1080, as of a motion in texture coordinates: across it counts less than down (Godot, source 002).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strength at flicker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part of the correction that is applied to geometric flicker. 0: history there is not rectified.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steps along a receding surface whose change of depth is allowed on top of τ: jitter and dilation move samples so far. The slope is that of the dilated sample, by the smaller step along each axis, and none where both neighbors are nearer or both farther, as around a wire. With 0 grazing ground never accumulates.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth differs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which difference of depth rejects history.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>z′ &lt; z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nearer and farther</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nearer alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth looked for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of which texels of history the one whose depth fits best counts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>min |z − z′| / z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The texel at the history position and those around it: as wide as the jitter, and alike on all sides.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3×3 at rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where something parts, only the texels that a bilinear tap reads, one to four; where nothing does, 3×3. Keeps less of what hid the surface, at the price of the history&apos;s motion.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Geometric flicker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps history whose depth differs where nothing moves against anything and what is nearer is thin: a line that single frames miss by their jitter, and no other surface. Thin is what is seen past on two opposite sides, up to four texels apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>|z − z′| &gt; τ·z and ‖v − v′‖ ≤ θ ⇒ kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Difference of the pixel&apos;s motion to that of what history shows there, up to which nothing parts: what hid its surface then hides it still. Jitter moves samples by half a pixel, so that less cannot be told from it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rejects history that belongs to another object: none of the nine texels around the history position has its number. History keeps the number of each pixel&apos;s dilated sample. Blind to what hides a part of itself: use it with depth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>id ≠ id′ of all nine ⇒ reject</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rejects history that belongs to another class of objects, as an engine&apos;s stencil marks them: sky, still, moving as a whole, deforming, or the class that an object is given in the tree of the scene.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>class ≠ class′ of all nine ⇒ reject</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rejects history of a surface that faced another way, by the best of nine. World space: what turns by itself is rejected too; normal maps need a low limit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rejects history, the more the faster, that moved otherwise a frame ago: what was hidden then was hidden by something that moves otherwise. The best of nine counts; points without a previous position change nothing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α = 1, N = 1, or α ≥ α soft, or N(1 − r), α + r</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Decay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Luma difference, compressed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gaussian, in motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α at flicker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Factor on α at geometric flicker, after its floor: a single frame says little of what it may miss.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α·share</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Full α in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What that motion is counted in.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Count to 16</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sharpens what is shown against the blur of averaging, or filters it. History is written before, so nothing adds up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mitchell, B = C = ⅓</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fog</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light that fog adds to the color; 0 where there is none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fog opacity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much of the surface&apos;s light the fog takes: 1 − transmittance.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the object is: 0 the sky, 1 still, 2 moves rigidly, 3 deforms, 4 a character.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth stored with the history, the best match of the texels around that are asked; 0: the sky.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relative difference of expected and stored depth, 0 for what is farther where that does not count; the depth test rejects what is above the allowed one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 where depth differs at rest because single frames miss a thin feature: history is kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Object stored with the history: that of this pixel when it is one of the nine texels around, else the nearest one; 0: the sky, or not kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cosine between the normals of now and then, the best of nine; 1 when off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change of motion since the previous frame, the smallest of nine; 0 when off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Factor on α, after its floor, at geometric flicker; 1 elsewhere and when off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flicker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard deviation over the last frames of what is shown (sRGB, 0 to 1), followed along the motion, without what the reference has of it: the root of the difference of variances.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deviation over time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same with what really changes: the reference is not taken off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames followed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames that flicker is taken over: fewer where the surface was hidden, off screen or cut off before.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard deviation of what is shown over the last frames, followed along the motion: the mean over all pixels that were seen before. It has in it what really changes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard deviation of what is shown over the last frames, followed along the motion, without what the reference has of it: the mean over all pixels that were seen before.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves rigidly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deforms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Character</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fog march</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recommended, and what to compare with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Engines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Source 003: notes on URP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recommended set: sharp history, a tight box in compressed YCoCg, clip to filtered, depth rejection that spares thin features at rest, α by history length.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TAA off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No TAA: each frame as it is drawn, at the pixels&apos; centers, nothing jittered, filtered or accumulated. All other settings are those of Balanced, so that every intermediate says what it would make of the frame before.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closest × at 2 px, five-tap Catmull-Rom, colors over their largest channel, mean ± σ in YCoCg, clip to the center, α of 1 over a confidence that grows by 10 a still frame, from 0.1 to 0.015, mip bias −1. As shipped, the taps are not divided by their weights, the confidence is read at the pixel itself, YCoCg comes back cut to 0…1, and jitter shears orthographic pictures (D7, D15). There the jitter table starts at the center, here Halton at 1; there history is kept compressed, here scene-linear. Where the engine resets, the first frame counts there as a confidence of 67 and stays long; here as 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion of the closest of nine, of equals of the first, five-tap Catmull-Rom, moments in RGB after c/(1 + c), γ from 2.5 at rest to 0.75 at 1/256 of the picture&apos;s height, the ray to the current color unless it is hit beyond 10, depth test, N to 15 and less up to that speed. There the left of the five taps is weighted by the sum across twice instead of across and down, and the weight of history is filtered like its color; here the tap is right and N is read bilinearly. Where all nine are sky there the pixel&apos;s own motion is taken. Its depth test takes the best of nine stored depths, nearer and farther alike, as here, where slopes are allowed for.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fastest motion of nine, nine-tap Catmull-Rom, mean ± σ in YCoCg, clamp, α 0.1 that falls to 0 near the walls of the box. Nothing is tested at the border: there history is read from the opposite side, here from the edge, and samples of the box are black, here those of the edge. There history keeps what falls below 0, here it ends at 0. Its samples are those of whoever calls it; here Halton 16.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Google Filament&apos;s defaults: camera motion by one matrix from the center depth, deringed five-tap Catmull-Rom history and Lanczos input, a rounded box in RGB compressed by the largest channel, clip to the filtered color kept within that box, α 0.12, no test at the border, mip bias −1. Objects have no motion of their own, and until December 2025 the jitter was computed and not applied (D18); here it is. What is shown is dithered, which its color grading does there. There samples are compressed before they are filtered, here after.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nine-tap Catmull-Rom, Reinhard, moments weighted by the luma of the compressed samples, γ that falls with speed, to 0.4 at 128/1080 of the picture, and beyond 1188 lines, the box shrunk axis by axis, N read bilinearly and counted to 16 without the first frame, α of 1/(N + 1) lowered where luma differs, to 0 where nothing else raises it. The least of nine depths is chosen, the first of equals, which since depth was reversed in 4.3 is the farthest; before, it was the closest. Motion is read one texel up and left of it, because the border of a tile is left out. A change of velocity beyond 2.5 px takes from N and adds to α: there against the motion at one texel, the one that holds the history position, as it was drawn a frame ago; here against the dilated motion that agrees best of those around.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unity&apos;s High Definition pipeline, quality Low: bilinear history clamped to five samples in RGB, α 0.125. Its closest of five pairs depths with the wrong offsets (D13), so that the lower left wins wherever one of the four is no farther than the pixel, as here. With orthographic cameras the pixel&apos;s own motion is used there. Sharpened by 0.5: there the current color before the blend, against the mean of the four around, here what is shown, against that of nine. What is blended comes before the resolve without motion; flagged materials are excluded from it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unity&apos;s High Definition pipeline, quality Medium, its default: a five-tap cubic history of sharpness 0.35 whose right tap is read a row too high, a closest of five that pairs depths with the wrong offsets (D13) and so is the lower left wherever one of the four is no farther than the pixel, a variance box in YCoCg, whose Y is the luma there, clip to the center, α 0.125 that doubles at 50 px. γ grows with contrast and shrinks to 0.75 at 50 px: there evenly and all of it, here by the square and without what contrast adds. Sharpened by 0.5: there the current color before the blend, against the mean of the four around, here what is shown, against that of nine. What is blended comes before the resolve without motion; flagged materials are excluded from it. Outside the picture history is the filtered color there, which the box may still pull; here the filtered color is shown. With orthographic cameras the pixel&apos;s own motion is used there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shader&apos;s defaults: fastest motion of nine, a five-tap Catmull-Rom that guesses the corners, γ from 2 at rest to 0.75 at 128 px, history that counts less with speed and not at all beyond 128 px, a blurred restart. Sharpened in logarithms, 0.5. There this frame&apos;s colors are kept in 11, 11 and 10 bits, the upper right corner of the history filter is guessed from the tap on the left, its weight is filtered like its color, the restart is a mean of compressed colors, and a variance that rounding puts below 0 is NaN (D14); here N is read bilinearly, and the rest is as it is meant. There the YCoCg box becomes an RGB box before the clamp, here the clamp is in YCoCg; there history is kept compressed, here scene-linear. There as here only history that is nearer is rejected, there by 0.001 than the farthest of four depths, here by a relative tolerance than the best of nine.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Microsoft&apos;s sample: camera motion by one matrix, closest of five, of equals the one above, a min-max box of seven samples in RGB, shared by pairs of pixels, clip to the center, a depth test that rejects what is nearer alone, history that counts less with speed and not at all beyond 64 px. Sharpened in logarithms, 0.5. The depth tolerance is relative, and the best of nine stored depths counts in place of the farthest of four. There each side of the box lies 0.001 farther out. Its history taps weighted before they are filtered and its box that widens up to four times where little moves are left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The 8×MSAA pattern, the fastest motion of nine, nine-tap Catmull-Rom that reads black beyond the border, a clamp to mean ± σ, α 0.1, box and blend in PQ of 10000; its relax mask, which the user draws there, is that of the materials. α falls with the distance of the sample where little moves, and below a render scale of 1 its trust in the nearest sample is the confidence. Of motions that are equally fast there the first at the upper left is taken, here the pixel&apos;s own. There history is also kept and filtered in PQ, the camera&apos;s motion comes from one matrix, and the mask is blurred.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Component defaults of Playdead&apos;s Temporal Reprojection: motion by the projection of this frame (D16), of equal depths that of the first at the upper left, rounded min-max box in RGB, clip to the center, α from the luma difference within 0.03 to 0.12. Colors end at 1 before anything is averaged, and history has 8 bits, as there, with its noise of ±1/510. There colors are tone-mapped before, here they stay linear, so shadows have few steps. There only tagged objects have motion of their own. Pixels faster than 2 px are shown with motion blur, from 15 px alone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Raptor, chapter 11, corrected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unity&apos;s Universal pipeline, quality Medium: bilinear history, clamped to a variance box of γ 0.9 inside min-max in YCoCg, the closest of nine depths. There the luma that weighs the blend is Y of YCoCg, and what falls below 0 is kept; here it ends at 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two lamps in a hazy hall, their beams marched in few steps: banding, and noise that TAA averages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual J0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual §2.2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No jitter: the picture stays aliased (manual J0).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Always (½, ½): a shift, no pattern (manual J0, Playdead).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two points on the diagonal (manual J1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The centers of four quarters, in raster order (manual J2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same four, each step across the center (manual J3).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same four in an order of eight (manual J4).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two far points and two near ones (manual J5).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RGSS: four points, each alone in its row and column (manual J6).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ten points of a disc of radius ¼ px, none near another (manual J7).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Five points of a star, each step across it (manual J8).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Halton(2, 3): low discrepancy, the usual choice (manual J9).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two points ¼ px to either side of the way the camera moves, whose direction follows by a fifth in each frame (manual J10, Playdead&apos;s experiment).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roberts&apos; plastic number sequence: evenly spread at any length (manual J11).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exact in x, radical inverse in y; wants its period known (manual J12).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Interleaved gradient noise along time: x and y hang together, so it covers badly (manual J13).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The standard pattern of 8×MSAA; its mean is exactly 0 (manual J14).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sixteen points, each alone in its row and column (manual J15).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hashed random points: what the others are measured against (manual J16).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual J9</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual §2.1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>T(δ)·P: the same shift at every depth, with any projection (manual §2.1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As printed in sources 000 to 002: added to the third column, which with OpenGL&apos;s w = −z moves the picture the other way than every filter believes (manual §2.1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As in Bevy: the third column also for orthographic cameras, where it shears by depth instead of shifting; the same as Translation with perspective (manual §26, D15).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P·T(δ), which source 001 warns of: it moves the world before it is projected, near things far and far things hardly (manual §2.1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual §3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each object&apos;s own motion, the camera&apos;s included (manual 3.2 to 3.7).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera motion only, reprojected from depth (manual 3.1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the pixel&apos;s center instead of where its sample lies: the jitter leaks into the motion, so that it is j instead of 0 where nothing moves (manual 3.1a, Playdead).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Both frames with their jitter, whose difference is subtracted again in the same unit (manual 3.1b).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One matrix from picture to picture, as if samples lay in the pixels&apos; centers: off by the jitter times the slope of the parallax (manual 3.1c, FSR, Filament).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As printed in Raptor&apos;s chapter 11: the difference in normalized device coordinates is taken for one in texture coordinates, twice too long and upside down, and half of the jitter is subtracted (manual §26, D5).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As in source 001&apos;s listing of meshes: the current position is not divided by w, and the previous one uses the current pose, so that objects seem to rest in a picture that flies (manual §26, D6).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As in Playdead: the previous view with the projection of now, right until the camera zooms (manual §26, D16).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 19.1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 19.2, Raptor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual §21</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawn in as many of sixteen frames as alpha says, in a 4×4 pattern that changes: accumulation makes it transparent (manual 20.7, 21.6).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blended over the opaque picture before the resolve, back to front; motion, depth and id stay those of what is behind, so that what moves smears (manual 21.2, most engines).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As before, and the surface in front writes its motion where that comes from objects: it is sharp, and what is behind it follows the wrong motion (manual 21.3, HDRP).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawn without jitter into a layer that is laid over the output: no smear and no anti-aliasing (manual 21.1, Bevy, Unity).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 21.4, 21.5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Responsive where a material says so: screens, flip-books, particles (manual 21.4, UE4, HDRP).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>And reactive by the opacity of what was blended in; of several the largest (manual 21.5, FSR2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>And reactive by what blending changed: five times the largest difference of the tone-mapped channels, at most 0.9 (manual 21.5, FSR2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual §22</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 1.1, 1.2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scene-linear colors as they were shaded, before bloom and tone mapping (manual 1.1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is brighter than white is white before anything is averaged, as after a tone map that clips: fireflies are tame, and bright edges lose what lies above (manual 1.2, Playdead). Kept linear.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 20.1, 20.2, Raptor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Interleaved gradient noise, another in each of 64 frames; neighbors differ much, along lines (manual 20.1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A tile of 32×32 by void-and-cluster, moved on by the golden ratio in each of 256 frames: no low frequencies in space, evenly spread in time (manual 20.2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A hash of pixel and frame, 256 of them: neighbors and frames have nothing to do with each other, what the others are measured against (manual §20).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 20.4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 20.3, Raptor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 20.4, source 001</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A tile of 32×32, moved on by the golden ratio in each of 256 frames: what TAA averages best (manual 20.2, Raptor).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A hash of pixel and frame: clumps in space and in time, which TAA averages worst (manual §20).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 20.1, 20.2, source 001</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 20.5, source 001</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mean over the last frames: less noise, and where the fog&apos;s light moves it drags behind (manual 20.5).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mean of the frames before, channel by channel clamped to the smallest and largest of this frame&apos;s 3×3, then averaged with it: what moved on leaves no trail (manual 20.5, 10.1, 11.1; Vallario&apos;s idea in source 001).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As in Raptor: the larger one of the mean of the frames before and this frame is averaged with it. Trails stay, and noise makes the fog brighter than it is (manual 20.5).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 20.5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual §4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pixel&apos;s own motion (manual 4.0).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion of the nearest surface among nine (manual 4.1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the pixel and its four neighbors (manual 4.2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the pixel and its four diagonal neighbors (manual 4.3).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wider; misses what is one pixel thin (manual 4.4, Karis 2014).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The fastest of nine; needs no depth, and fast backgrounds bleed (manual 4.5).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The fastest of five (manual 4.6).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As printed in Raptor&apos;s chapter 11: where all nine are sky the motion of pixel (0, 0) is taken, because the search starts from there and finds nothing nearer (manual §26, D4).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As in HDRP: with each offset the depth of the next tap is kept, which then is as near as itself and taken as well, so that the motion of the lower left is read wherever any of the four is no farther than the pixel (manual §26, D13).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion of the farthest surface among nine: what a test for the smallest depth finds once depth is reversed, as in Godot since 4.3 (manual 4.1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 4.1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only what is really nearer takes its place (manual 4.1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The search starts with nothing, from the upper left, so that on what faces the camera the motion of that neighbor is read (manual 4.1, Playdead, Godot).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is as near takes its place as well, so that the neighbor at the lower right is read (manual §4, source 002, whose step() holds for equal depths).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual §4, Godot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual §5, sources 000, 001 and 003</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pixel&apos;s center minus the motion it follows (manual §5).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pixel&apos;s own center: the accumulation buffer before anybody reprojects. Whatever moves leaves a trail, and nothing is ever off the screen (manual §5, the step before it).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual §6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The nearest texel: no blur, but half a pixel of error (manual 6.0).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One tap; blurs a little in every moving frame (manual 6.1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Five taps, normalized; stays sharp (manual 6.4, Jimenez 2016).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nine bilinear taps: the same as sixteen (manual 6.3).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All sixteen texels; reproduces parabolas (manual 6.2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sixteen texels with a sharpness to choose (manual 6.5).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>B = C = ⅓: a little blur, little ringing (manual 6.6, Mitchell and Netravali 1988).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The polynomial form of FSR2 and Filament (manual 6.7).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As in Bevy: not divided by the sum of its weights, so that moving pictures darken (manual 6.4b, D15).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each corner taken for the mean of the two taps beside it, so that the weights sum to 1 by themselves (manual 6.4c, Intel).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Five taps of the cubic of a sharpness, normalized (manual 6.5).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As in HDRP: the right tap is read in the row above, at its corner, so that steps to the right bend (manual §26, D13).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 6.5, HDRP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 6.9</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 6.8, Intel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 6.8</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 5.4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As from a sampler with a black border: wide filters darken what lies near it (manual 5.4, Donut).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual §16</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N of the nearest texel to where the surface was (manual §16).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As in Bevy: N of the same pixel a frame ago, whatever was there (manual §26, D15).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N of the four texels around, as colors are read: no hard step where a part of them is new (manual §16, Godot).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 1.6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Multiples of 1/255 from 0 to 1, as Playdead stores it: the average stops half a step over α before its goal (manual 1.6, 20.6). Kept in 32-bit floats here, which hold them exactly.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Multiples of 1/1023, likewise (manual 1.6, 20.6).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 14.7, 20.6, Playdead, UE4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual §7</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pixel&apos;s own sample (manual 7.0).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Samples weighted by their distance to the pixel&apos;s center, jitter included (manual 7.4).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One bilinear tap where the pixel&apos;s center landed (manual 7.1, Playdead).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weights 4, 2 and 1 of sixteen, whatever the jitter (manual 7.2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All nine alike: blurs (manual 7.3).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cubic of the distance, B = C = ⅓ (manual 7.5).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cubic of the distance, sharper (manual 7.5).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The window itself over 3 px (manual 7.5).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Separable, jitter included, as in Filament (manual 7.6).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As printed in Raptor&apos;s chapter 11: the weight is the distance, so the pixel itself counts nothing and its ring is averaged (manual §26, D2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As printed in Raptor&apos;s chapter 11: of twice the distance and without jitter, so all neighbors weigh 0 or less than nothing and the filter does nothing (manual §26, D3).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As printed in Raptor&apos;s chapter 11: of twice the distance, which makes it nearly a box of five (manual §26, D3).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As in source 002&apos;s text: the tap on the other side, uv − j, so that the jitter is doubled instead of taken out (manual §26, D10).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The nearest sample alone; it counts the less the farther it lies: κ = max(sat(1 − ‖d‖²/r), smoothstep(‖v‖)), d in render px, v in px of the picture (manual 22.1, Donut).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nine samples by the separable Lanczos 2 of their distance in px of the picture, κ = Σw; bounded by the nine (manual 22.2, Filament).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nine samples by (0.9656852 x² − 1)², x in px of the picture, at most 1. κ is 1 within HDRP&apos;s box, ½/r render px to either side, which holds the nearest sample wherever there is one (manual 22.3).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same, and κ is a Gaussian of the nearest one&apos;s distance: 2^(−½(‖x‖/0.4)²)/r², at most 1, x in px of the picture (manual 22.3).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sixteen samples by the radial Lanczos 2 of their distance times min(1/r, 1.99), bounded by the nearest nine. κ = Σw, 0 where that is negative: the 1/12 of FSR2 is the floor of α here (manual 22.4).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 7.4, Karis 2014</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 7.4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 7.2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 7.6, Filament</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 18.2, source 002</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Minus the mean of the four around: constants keep their brightness (manual 18.2, corrected).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As printed in source 002: what is flat becomes s times as bright, so only s = 1 keeps brightness, which is 4 of the corrected one (manual 18.2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual §9</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Box in red, green, blue (manual 9.1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Box in luma and chroma, tighter around the colors (manual 9.2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same axes by lifting steps, chroma twice as large (manual 9.3).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rec. 709 luma and two differences (manual 9.4).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As in Playdead, Raptor and Bevy: the way back is clamped to 0…1, so that history which was moved is never brighter than white. Compressed by Reinhard, the largest channel or PQ, colors lie below 1 and none of it shows (manual §26, D7).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 9.5, 15.2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Box of colors divided by 1 + luma; highlights stay bounded (manual 15.2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each channel by itself: bounded, and hues shift (manual 15.3).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colors divided by 1 + their largest channel (manual 15.4, Filament).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SMPTE ST 2084 with 10000 as 1, each channel by itself: steps as the eye sees them. Goes on beyond 1, where Donut cuts it off (manual 9.6, 15.5, Donut).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>log₂(1 + c), each channel by itself (manual 15.7, Intel).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual §8</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Five samples: tighter box, more flicker (manual 8.1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nine samples (manual 8.2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pixel and its diagonals (manual 8.3).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The middle between the bounds of nine and of five (manual 8.4, Playdead).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>+ in even frames, × in odd ones (manual 8.6, Intel).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Four bilinear taps on the diagonals, ⅔ px away at rest and ½ px where things move or are far: ½ + ⅙·sat(½/(‖v‖·z)). z in m, so that a scene in centimeters looks different (manual 8.5, Playdead).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One set for both of two columns, as a compute shader shares it: the left pixel, its diagonals and the two to its right, so that even and odd columns see the box from different places (manual 8.7, MiniEngine).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 8.8, source 002, Playdead</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 10.7</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Samples weighted by 1/(1 + luma): fireflies pull less (manual 10.7).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>exp(−¾ r²): near samples count more (manual 10.7, DiligentFX).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1/(1 + Y) with the luma of the box&apos;s space: of compressed colors all weights lie between ½ and 1 (manual 10.7, Godot).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual §10</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the smallest to the largest sample (manual 10.1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean ± γ deviations (manual 10.2, Salvi 2016).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Variance box inside the min-max box (manual 10.3).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 10.2, Salvi 2016</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 10.8, Intel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 10.8</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 10.9, Godot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 10.11, 17.5, HDRP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 10.11</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 10.10, 13.18, Donut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 10.6, Playdead</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 10.4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual §5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Border pixels streak into the picture (manual 5.0).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outside the picture there is no history (manual 5.1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Half a pixel earlier, so that no filter reads beyond (manual 5.3, HDRP).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As in the first listing of source 002: only the left edge is tested, the others streak; and beyond it nothing of the current frame is taken, α = 0, instead of nothing of history (manual 5.7, D9).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 12.1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 12.1, slope term</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whatever is not as far away as expected (manual 12.1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only what is nearer can have hidden the surface; what is farther counts as the same (manual 12.1, MiniEngine, Intel, FSR2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 13.9, source 000</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 13.9</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 12.6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 12.6, Intel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 12.3, sources 000 and 004</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 12.2, sources 000 and 003</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 12.4, source 004</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 12.4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 12.5, Godot, HDRP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of the difference: ‖v − v′‖ (manual 12.5, CryEngine 3, Godot).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Difference of the lengths: |‖v‖ − ‖v′‖|; a turn is no change (manual 12.5, HDRP).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 12.5, Godot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual §12, source 000</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α = 1 and N = 1: the history is dropped (manual §12, hard).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The history stays, and α is at least a value of choice; only what is off the screen or has no history starts anew (manual §12, soft).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By the share r that is rejected N falls to N(1 − r) and α rises by r: a whole r starts anew (manual 12.5, 13.3, Godot).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual §11</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>History is taken as it is: everything ghosts (manual 11.0).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nearest point of the box (manual 11.1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clip towards the middle of the box (manual 11.2, Playdead).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clip towards the filtered current color (manual 11.3, Karis 2014).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Towards the mean, one axis after the other (manual 11.5, Godot).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clamp to the min-max box, then clip to the center of this one (manual 10.5, Raptor).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along the ray to the current color, unless the box is hit too late (manual 11.4, DiligentFX).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Towards the filtered color until thirteen slabs around the samples hold: nearly their convex hull, which no box and no γ widens (manual 10.12).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Towards the filtered color until it lies in the min-max boxes of RGB and of the color space (of RGB: and of YCoCg): six slabs, which no γ widens (manual 9.7, Lottes).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nearest point of the box, and history that was moved counts as no more than 1.6 frames, a tenth of what FSR2 can accumulate (manual 11.7).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The one of the nine samples that is nearest to history takes its place: no color of the past is left, and no ghost (manual 11.8, 17.6, Godot&apos;s proposal).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 11.4, DiligentFX</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 11.6, 17.1, Filament</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 17.2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 17.3, FSR2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 17.4, FSR2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual §13</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same α everywhere (manual 13.1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1/(N+1): the exact mean until the floor is reached (manual 13.3).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More of the current frame where its luma differs from history: against ghosts (manual 13.10, Lottes).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Less of it where the box is large against the pixel&apos;s luma (manual 13.14).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More history far away; none for the sky (manual 13.8).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As printed in Raptor&apos;s chapter 11: of colors over 1 + their largest channel, and the weights are swapped, so that equal luma takes only the current frame and nothing is averaged (manual 13.12, D1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each of red, green and blue by its own contrast, as Raptor&apos;s weights are vectors; N counts with the α of luma (manual 13.14, 14.2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 over a confidence that grows by 10 in each frame without motion and is 1 with it, between two limits. Wants N counted likewise (manual §16, Bevy).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As Luma difference, of colors over 1 + their largest channel: the corrected form of source 001, with limits of 1 and 0 (manual 13.12).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 13.1, Yang et al. 2020</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 13.3, §13</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 13.10, Playdead: 0.12</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 13.10, Playdead: 0.03</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 13.11, Filament, Godot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 13.11</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the larger luma: |Ls − Lh|/(0.001 + max) (manual 13.11, Filament).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of lumas after c/(1 + c), 0.299 R + 0.587 G + 0.114 B and at least 0.0001, against 1.001: dark differences count for little (manual 13.11, Godot).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 13.13, Karis 2014</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 13.15, HDRP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 7.7, 13.6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A sample counts alike wherever in the pixel it lies. Below a render scale of 1 κ weighs its distance, whatever is chosen here (manual §22).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>exp(−‖j‖²/2σ²) with σ² = 0.22 px² (manual 7.7, 7.4, source 004).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 − ‖j‖², and 1 from a motion of 1 px on: max(smoothstep(0, 1, ‖v‖), 1 − ‖j‖²) (manual 13.6, Donut).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At rest all samples count alike; in motion, fully from 1 px on, those near the center are preferred: 1 − m + m·exp(−‖j‖²/2σ²), m = smoothstep(0, 1, ‖v‖), σ² = 0.22 px² (manual 7.7, source 004).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 13.4 to 13.6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>‖v‖/v₀ (manual 13.6).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>(‖v‖/v₀)² with pixels, on top of α, where source 000 starts 0.025 below it (manual 13.4).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As printed in source 000: from α − 0.025 to 1 by the square of a length in fractions of the picture, which stays near 0, so that all there is to it is 0.025 less (manual 13.4, D11).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α grows to 2α at v₀ and no further (manual 13.6, HDRP).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>α + ‖v‖/v₀, up to 1: v₀ is 1/k of the picture&apos;s width, 19.2 px of 1920 for k = 100, 1.92 px for k = 1000 (manual 13.5, source 002).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 13.6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 13.5, 13.6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 13.18, 21.4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At least α mask times the larger of both masks (manual 21.4, UE4).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At least the reactive mask itself (manual 13.18, FSR2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only the current frame where the responsive mask is set (manual 21.4, HDRP).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 21.4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 13.7, CryEngine 3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 13.7</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 12.7, FSR2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 13.19</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual §15, Karis 2014</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plain blend: a firefly counts as much as it shines (manual 15.0).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colors weighted by 1/(1 + luma) (manual 15.1, Karis 2014).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mixed after c/(1 + c), each channel by itself (manual 15.3).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mixed after c/(1 + largest channel) (manual 15.4, Filament).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As printed in Raptor&apos;s chapter 11: the luma of the compressed color, so that weights only span 1 to ½ and fireflies stay (manual §26, D19).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mixed as SMPTE ST 2084 codes them, 10000 as 1. Goes on beyond 1, where Donut cuts it off (manual 15.5, Donut).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mixed as log₂(1 + c) (manual 15.7).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A project&apos;s own curve: c(1 + c/W²)/(1 + c), Reinhard&apos;s with a white that becomes 1, and its inverse (manual 15.6, source 002; Reinhard et al. 2002).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 15.6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 5.2, 5.6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pixels without history show the filtered current color (manual 5.2).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>They show the mean of the pixel and its diagonals (manual 5.6, 7.8, Intel).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual §16, source 004</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The inverse of the variance that is left (manual §16, eq. 2.4 corrected).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N + 1, as if every frame counted alike (manual §16, eq. 2.3).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As printed in source 004: without the inverse, so that N falls to 0.618 (manual §26, D12).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N + 10 where nothing moves, else 1: the count that α from confidence goes by (manual §16, Bevy).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As if every α were the mean&apos;s, so that after motion the count starts low again: w′ = 1/(2 − w) of history&apos;s weight (manual §16, Intel, MiniEngine, DiligentFX).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N + 1, and never more than 16; the first frame of all is not counted, so that the second replaces it (manual §16, Godot).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual §18</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Luma minus the mean luma of nine, hue kept; black stays black (manual 18.1, Raptor).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Minus the mean of the four around: c + k(c − mean₄) (manual 18.3, HDRP&apos;s pass after).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Minus the mean of all nine: c + k(c − mean₉) (manual 18.3, source 000).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As strong as no channel leaves 0 to 1, of colors divided by 1 + their largest channel, because it expects those; amounts above 1 count as 1 (manual 18.5, FSR 1, URP).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>c + 3k max(0, c − mean of this frame&apos;s nine samples over 1 + luma): only brightens (manual 18.6, HDRP).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Laplacian of log₂(1 + c), as (1 + c)((1 + c)/geometric mean₄)ᵏ − 1 with k in steps of 1/256 (manual 18.7, Intel, MiniEngine).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resampled by the cubic of Mitchell and Netravali with B = −k: at k = 0 Catmull-Rom, which changes nothing at a pixel&apos;s center (manual 18.4, source 000).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cubic that Mitchell and Netravali recommend, at the pixels&apos; centers: 1/18, 8/9, 1/18 each way, a slight blur that calms what flickers; Reconstruct with k = −⅓ (manual 6.6, 18.4, source 000).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual §18; Raptor: 0.1, HDRP and Intel: 0.5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 18.3, HDRP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 20.8, Filament</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>manual 14.4, Playdead</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Source 000: blog on TAA in Unity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Source 001: Castorina and Sassone 2023, chapter 11</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Source 002: blog on engine practice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Source 004: DezemingFamily&apos;s booklet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unity blog, step 1: jitter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The blog on TAA in Unity (source 000), step 1: the picture moves by Halton 16 and nothing is averaged: it trembles.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unity blog, step 2: accumulation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The blog on TAA in Unity (source 000), step 2: a tenth of this frame and nine tenths of the buffer, read in place: the blog&apos;s blendFactor of 0.9 is the weight of history, α here its rest. Right for stills, trails wherever something moves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unity blog, step 3: camera motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The blog on TAA in Unity (source 000), step 3: history is read where the camera saw this depth a frame ago. History outside the picture is rejected here, for which the blog has no test.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unity blog, step 4: object motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The blog on TAA in Unity (source 000), step 4: motion vectors of objects, their skins and shapes as well.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unity blog, step 5: closest depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The blog on TAA in Unity (source 000), step 5: the motion of the closest of nine depths, so that silhouettes follow what is in front.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unity blog, step 6: Catmull-Rom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The blog on TAA in Unity (source 000), step 6: history by Catmull-Rom with five taps in place of bilinear, against blur.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unity blog, step 7: clamp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The blog on TAA in Unity (source 000), step 7: history is clamped to the extremes of nine samples in RGB, against ghosts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unity blog, step 8: YCoCg</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The blog on TAA in Unity (source 000), step 8: the same box in YCoCg, which is tighter in chroma.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unity blog, step 9: clip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The blog on TAA in Unity (source 000), step 9: history is clipped toward the center of the box in place of clamped to its corners.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unity blog, step 10: variance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The blog on TAA in Unity (source 000), step 10: the box is 1.25 deviations around the mean.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unity blog, step 11: filtered color</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The blog on TAA in Unity (source 000), step 11: nine samples by a Gaussian of the blog&apos;s 4, 2, 1 made narrower as it advises, and history clipped toward that color, which the box is grown to hold. What is left to the whole pipeline is the weighting by luma.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unity blog</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recommendation of the blog on TAA in Unity (source 000): Halton 16, closest of nine, five-tap Catmull-Rom, a luma-weighted Gaussian of σ 0.55, which its text advises where its listing has 4-2-1, variance box of γ 1.25 in YCoCg, clip to filtered, history weight 0.9, luma weights.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Castorina and Sassone 2023, step 1: jitter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Marco Castorina and Gabriel Sassone, Mastering Graphics Programming with Vulkan (2023), chapter 11, step 1: Halton with the four points that the text calls usual, from index 0 on; its program ships with two. Nothing is averaged. Step 2 is the chapter&apos;s simplest mode, which has a preset of its own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Castorina and Sassone 2023, simplest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The simplest mode of chapter 11 of Mastering Graphics Programming with Vulkan by Marco Castorina and Gabriel Sassone (2023): the pixel&apos;s own motion, bilinear history, α 0.1 and nothing that holds history back, not even the border: everything ghosts and streaks. Motion is that of objects here, without what is wrong with the chapter&apos;s (D5, D6).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Castorina and Sassone 2023, step 3: closest depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Marco Castorina and Gabriel Sassone, Mastering Graphics Programming with Vulkan (2023), chapter 11, step 3: the motion of the closest of nine depths. Where all nine are sky the pixel keeps its own, which the listing forgets (D4).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Castorina and Sassone 2023, step 4: Catmull-Rom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Marco Castorina and Gabriel Sassone, Mastering Graphics Programming with Vulkan (2023), chapter 11, step 4: history by Catmull-Rom with nine taps.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Castorina and Sassone 2023, step 5: Mitchell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Marco Castorina and Gabriel Sassone, Mastering Graphics Programming with Vulkan (2023), chapter 11, step 5: nine samples of this frame by Mitchell&apos;s cubic, of the distance to where they lie; as printed it does nothing (D3).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Castorina and Sassone 2023, step 6: clamp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Marco Castorina and Gabriel Sassone, Mastering Graphics Programming with Vulkan (2023), chapter 11, step 6: history is clamped to the extremes of nine samples in RGB.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Castorina and Sassone 2023, step 7: clamp, then clip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Marco Castorina and Gabriel Sassone, Mastering Graphics Programming with Vulkan (2023), chapter 11, step 7: clamped to the extremes and then clipped to one deviation around the mean: the chapter&apos;s best and its default.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Castorina and Sassone 2023, step 8: temporal filter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Marco Castorina and Gabriel Sassone, Mastering Graphics Programming with Vulkan (2023), chapter 11, step 8: α of each channel by its contrast, 0.15 to 0.75; the division by a black sample is guarded (D8).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Castorina and Sassone 2023, step 9: inverse luminance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Marco Castorina and Gabriel Sassone, Mastering Graphics Programming with Vulkan (2023), chapter 11, step 9: both colors weighted by 1/(1 + luma); as printed by the luma of compressed colors, which hardly weighs (D19).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Castorina and Sassone 2023, step 10: luma difference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Marco Castorina and Gabriel Sassone, Mastering Graphics Programming with Vulkan (2023), chapter 11, step 10: α by the difference of luma, of colors compressed by their largest channel, in place of contrast, as the listing overwrites it: more of this frame where history differs, 0.03 to 0.12 as in Playdead; as printed the weights are swapped (D1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The defaults of the Raptor Engine of Castorina and Sassone (2023) as shipped, defects included: jitter of period 2, camera motion only, in the wrong unit and upside down (D5), closest depth that takes pixel (0, 0) before the sky (D4), a Mitchell filter that does nothing (D3), an α by the luma of compressed colors whose weights are swapped so that equal colors are not averaged (D1), in place of that of its temporal filter, which comes before and is overwritten, and luma weights that hardly weigh (D19). Sharpened by the luma ratio, 0.1, where there the pixel alone is scaled by the exposure.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The final pipeline of the chapter of Castorina and Sassone (2023) with its defects mended, to be compared with the preset as shipped: motion of camera and objects in px (D5, D6), a closest depth that keeps the pixel&apos;s own motion before the sky (D4), Mitchell of the distance to the samples (D3), α that grows where the luma of compressed colors differs, 0.03 to 0.12 as in Playdead (D1), weights by the luma of whole colors (D19), no division by black (D8). Its jitter has four points, as the text says, where the program ships with two. Sharpened by the luma ratio, 0.1, where there the pixel alone is scaled by the exposure.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Castorina and Sassone 2023, step 12: mip bias</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Marco Castorina and Gabriel Sassone, Mastering Graphics Programming with Vulkan (2023), chapter 11, step 12: after the whole pipeline, textures a quarter of a level sharper, because accumulation blurs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Castorina and Sassone 2023, step 13: textures at rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Marco Castorina and Gabriel Sassone, Mastering Graphics Programming with Vulkan (2023), chapter 11, step 13: textures are read at the pixel&apos;s center whatever the jitter, which the author says is not tested; with the sign of this program, and a vector where the listing has a float.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Engine practice, step 1: jitter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The blog on engine practice (source 002), step 1: offsets of half a pixel at most by Halton; the period is left to the reader, 16 here. Nothing is averaged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Engine practice, step 2: accumulation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The blog on engine practice (source 002), step 2: a twentieth of this frame, history in 32-bit floats where the G-buffer&apos;s motion vectors say, tested for the left border alone, as its first listing does, and kept whole beyond it (D9).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Engine practice, step 3: all borders</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The blog on engine practice (source 002), step 3: history outside the picture is rejected on all sides.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Engine practice, step 4: closest depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The blog on engine practice (source 002), step 4: the motion of the closest of five depths, in an ×, of equal depths that of the last.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Engine practice, step 5: clamp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The blog on engine practice (source 002), step 5: history is clamped to the extremes of nine samples in RGB.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Engine practice, step 6: YCoCg</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The blog on engine practice (source 002), step 6: the same box in YCoCg.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Engine practice, step 7: clip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The blog on engine practice (source 002), step 7: history is clipped toward the center of the box, which the listing calls its filtered color.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Engine practice, step 8: α by motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The blog on engine practice (source 002), step 8: α rises by 1000 times the motion in fractions of the picture, as the code has it; the text has 100.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Engine practice, step 9: unjitter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The blog on engine practice (source 002), step 9: the current color and the box are taken where the pixel&apos;s center landed, with the sign of the code; the text has the other (D10).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Engine practice, step 10: tone mapping</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The blog on engine practice (source 002), step 10: colors are mixed as a tone map shows them; the listing leaves the map to the project, here it is Reinhard&apos;s with a white of 4. What is left to the final listing is its Laplacian.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Engine practice, final listing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The final listing of the blog on engine practice (source 002). Closest of ×, of equal depths the last at the lower right, history in 32-bit floats, the current color where the pixel&apos;s center landed, a min-max box in YCoCg around the same place, clip to its center, α of 0.05 and 1000 times the motion in fractions of the picture, as its listing has where its text has 100. Its optional Laplacian has strength 1, the only one that keeps brightness, and is of the samples around the pixel, not of RGB in YCoCg cut at 0. Its jitter is added to the third column of the projection, here the picture is translated by it. Its tone mapping, which it leaves to the project, is Reinhard&apos;s with a white of 4 here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>URP notes, step 1: jitter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The notes on URP (source 003), step 1: Halton over 1024 frames, as URP counts them. Nothing is averaged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>URP notes, step 2: camera motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The notes on URP (source 003), step 2: a tenth of this frame, history where the camera saw this depth a frame ago, with nothing that holds it back and no test at the border.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>URP notes, step 3: object motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The notes on URP (source 003), step 3: motion vectors of objects as well. Steps 4 to 8 are URP&apos;s five qualities, which have presets of their own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>URP notes, step 9: largest motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The notes on URP (source 003), step 9: as Very High, with the largest of nine motions in place of the closest depth: the notes&apos; own choice.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>URP notes, step 10: Y&apos;CbCr</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The notes on URP (source 003), step 10: the box in Y&apos;CbCr, by luma of Rec. 709; the notes mean gamma colors, here they are linear.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>URP notes, step 11: classes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The notes on URP (source 003), step 11: history of another class is rejected, as a stencil tells characters from the background; which objects are characters is said in the tree of the scene or by --class.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>URP notes, step 12: sharpening</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The notes on URP (source 003), step 12: contrast-adaptive sharpening after it, URP&apos;s slider at a half.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DezemingFamily, step 1: random samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DezemingFamily&apos;s booklet on temporal accumulation (source 004), step 1: random offsets; the booklet fixes no pattern. Nothing is averaged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DezemingFamily, step 2: mean of a still</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DezemingFamily&apos;s booklet on temporal accumulation (source 004), step 2: α = 1/t, read in place: the exact mean of all frames where nothing moves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DezemingFamily, step 3: reprojection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DezemingFamily&apos;s booklet on temporal accumulation (source 004), step 3: a constant α of 0.1 (2.1), history where the world position was seen by the previous view; with the scene&apos;s own field of view where the booklet assumes 45°.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DezemingFamily, step 4: same geometry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DezemingFamily&apos;s booklet on temporal accumulation (source 004), step 4: history of another object is rejected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DezemingFamily, step 5: same surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DezemingFamily&apos;s booklet on temporal accumulation (source 004), step 5: and history of another normal or place; the depth stands for the place.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DezemingFamily, step 6: history length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DezemingFamily&apos;s booklet on temporal accumulation (source 004), step 6: α = 1/(N + 1) (2.2), N a frame more each time (2.3).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DezemingFamily, step 7: least α</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DezemingFamily&apos;s booklet on temporal accumulation (source 004), step 7: no less than 0.1 of this frame. What is left to the whole pipeline is N by the recursion (2.4).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DezemingFamily, booklet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DezemingFamily&apos;s booklet on temporal accumulation (source 004). Accumulation only: random jitter, the world position seen from the previous view, bilinear history, validity by object, normal and depth, which stands for the position and tells a surface from itself where the booklet takes the same geometry for enough, α = max(1/(N + 1), 0.1), N by the corrected recursion (2.4), no color box. It does not converge, by itself: the floor of α keeps the noise of some 19 samples, and what jitter hides for a frame counts as another geometry and starts anew. With a camera that stands still builtin:fence, 320×180, is 0.0068 off 1,024 samples after 240 frames (RMSE), 0.0031 without the three tests, and 0.0008 with the preset reference.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DezemingFamily, step 9: nearest sample in motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DezemingFamily&apos;s booklet on temporal accumulation (source 004), step 9: after the whole pipeline, in motion the sample nearest to the pixel&apos;s center is preferred, which the booklet names and leaves open: by a Gaussian of its distance here. With a floor of 0 under α, which would hide it.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
