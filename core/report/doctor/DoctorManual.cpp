#include "core/report/doctor/DoctorManual.h"

#include "core/report/doctor/DoctorCases.h"
#include "core/report/doctor/DoctorConfusions.h"

namespace taa {

std::string doctorManual() {
  return std::string(R"(
## The doctor

The doctor says what is wrong with the jitter, depth, motion vectors and colors of somebody's frames, in which part of the picture, how sure that is, and what to change. It measures: nothing is concluded from settings, and conventions are believed where the frames do not contradict them. `taa-batch doctor SOURCE` takes a capture, a folder of an engine's frames, a built-in scene or a glTF file, looks at its first 32 frames (`--frames`), and ends with 0 where nothing is wrong and with 3 where something is; `--json` prints every figure, `--html FILE` writes one page without scripts. `--write-baseline FILE` writes what is found as a JSON file of ids and regions, `{"known": [{"id": "motionZero", "region": "the sky"}]}`; with `--baseline FILE` such findings are said as known and fail no build: it ends with 3 where another one is there. A line with an empty region stands for the whole picture and all its regions. What it finds has the name of the table above that says the same.

### Regions

A wrong sky or one wrong object hides in any mean over the picture. So each object number is a region, the sky is one, and where there are no numbers, connected pixels whose depth and motion go on from one to the next are one. Only pixels well inside their region count, where nothing is blended over them, that nothing nearer hid in the frame before, and that have detail: luma that stands out from the pixels of the same region around it, 5×5, as shading need not move with its surface.

### What is stated

Some conventions of a capture are contradicted by what it holds, whatever pictures show. A near plane that is stated and not that of the matrices is told, and all else is examined by the matrices' own; where motion says that the stated one is right, the matrices are told instead. Distances of which 98 % would lie before the near plane are a depth buffer. Projections that are said to hold the jitter and are the same in all frames do not hold it; those that move with it, whatever its sign, and are said to be without it do. Motion below 0 or beyond 1 is not in Unreal's 16 bits; motion of that engine that lies around a half and never below 0 is. Each is told with what is stored, and the rest is examined as if it were stated so, so that two mistakes are both named.

Matrices are upside down where y of clip space the other way makes the motion given of what rests, to 0.05 px at 70 % of the pixels, and nothing that could be wrong with motion does.

### Motion

Each explanation says where a pixel was in the frame before; what is left is |luma − luma there|, on l/(1 + l) smoothed over 3×3 pixels. Compared are: as given, at rest on the screen, x, y or both negated, axes exchanged, times ½, 2 and others, texture or device coordinates for pixels with axes the one way or the other, this frame's, the last frame's or both jitters left in it, jitter taken off twice, of the frame before or after, without the camera's motion, with it twice, and that of the camera. Where motion is 0 or the camera's and does not fit, squares of the picture are searched for what they truly moved by.

An explanation is told where it leaves at most two thirds of what the motion given leaves, in at least 80 % of the squares and of the pairs of frames in which both differ, by 0.004 of luma or more. Where depth and matrices make the motion given, only something that rests on the screen can contradict it, at a third of what is left. What was searched for has to take the region's rim with it, as a light or a shadow that moves over a surface does not. Where there is too little detail, the outline of an object speaks that has a number: a pixel of it, in a square of 2 × 2 of it, whose place of the frame before lies between four pixels of others, none of them nearer, came from outside by that explanation; one is told where the motion given has 40 such pixels or more and four times as many as it, in 80 % of the pairs in which the two differ. What the middle of a region moves by, where all of it is seen, is tried likewise. Outlines say nothing of what leads less than 1.5 px elsewhere, which jitter of depth may be, nor where rims have the motion of what is beside them. Of objects that are small, or move by parts of a pixel, the way of their middles over all frames speaks, of all together: a factor, a sign, an axis or a unit is told where motions that are added up miss that way by twice as much as given, at 10 objects and frames or more. Objects that something nearer or the border cuts are left out, as are those as thin as a pixel; where their size changes, explanations have to differ by four times what that may move a middle by. Jitter left in the motion of one thing alone is told only at 60 squares or more, where others say that there is none. Where pixels say of what rests that its motion is not the camera's, and no more, outlines alone say nothing beside that. Where motion is longer than the picture at half of the pixels it is told to be of another unit, and looked at again in texture coordinates. A unit with other axes is two findings. Regions that one explanation fits are one finding. The sky, which has little detail and cannot move by itself, is decided by the matrices where these make the motion of other surfaces.

### Jitter

The shift of each picture against the one before, warped by the camera's motion, is measured by least squares, so that motion vectors have no part in it. What is stated makes a shift of j′ − j, and so does each explanation: none in the pictures, x, y or both negated, axes exchanged, times ½, ⅔, ¾, 1⅓, 1½ and 2, another unit, of the frame before or after; and, where none of these is told, a sign or exchanged axes and a frame late or early at once. Of each is also known what it leaves: the median of |luma − luma of the frame before| where pictures are shifted so. One is told where it leaves at most 85 % of what is left as stated, in 80 % of the pairs, and is nearer to the shifts that are measured; or where it leaves less, lies within 0.15 px of these shifts, and the stated one half as far again. Thin lines stay on their pixels whatever the jitter, and what repeats shifts by whatever it is told: there the doctor says that jitter is not decided, unless the shifts that are measured are those that are stated to 0.02 px and those of every other explanation are 0.1 px away or more. Where pictures hold no jitter, depth is asked, as a picture of its own: where that shifts as is stated, surfaces are drawn with the jitter, and textures are read as if there were none, which is a note. The sky is measured apart: it is told to rest where it leaves a third of what it leaves with the world's jitter. The sequence itself is looked at as well: its mean, its period, and how often it goes beyond half a pixel; the mean of fewer than 16 frames that do not repeat is told only where their range lies around it, and a sequence of two places whatever pictures hold of it. Wrong jitter makes all motion look wrong: motion is then looked at again with the jitter that the pictures hold.

### Depth

Of pixels that the camera passes, motion and matrices say at which depth they rest. That depth is the stored one, or it follows from it: by a factor (the near plane is another one), the other way around, or as a distance. Where no camera tells, what hides what does, where objects have numbers: a pixel whose place of the frame before lies between four pixels of another region was hidden by that, which has to be nearer by the depth stored. Where in 40 pixels or more, and 95 % of them, it is farther away, depth grows with the distance. The values themselves say the rest, where nothing that hides something else contradicts them: over flat surfaces the depth of a projection grows evenly from pixel to pixel, and of a distance 1 over it does; and where 1 % of the picture lies exactly in the near plane, nothing infinitely far away, and nine tenths of all else nearer than two near planes, depth is the other way around. The scale of depth is not decided so.

### Color

Squares of 8 × 8 pixels are followed by their edges, |luma − luma of the frame before| at them: at the same pixel, at the same pixel but for jitter, as given, and as what rests in the world moves. An interface is told where squares that hang together hold their edges in place, to 0.002 of luma in 90 % of the pairs, while motion leaves three times as much; and one that is drawn with the jitter where that leaves at most two thirds of what motion and rest leave, and no more than 30 % of the edges lie at rims of regions: a ball that a camera goes around looks the same from all sides, and its rim rests. What rests less clearly is not decided. Where the world rests, too, the one without jitter is told only beside edges that shift, and the one with it is not decided. An object, or the sky, that rests by itself is none. All else is examined beside what an interface covers, since its edges would be taken for those of what is behind. A step of brightness of the whole picture is taken off before the rest is looked at.

The light of places that are followed, over that of the frame before, has a median over the picture and in each of 8 × 6 parts of it: exposure has changed where the median is 0.1 stops or more and that of 85 % of the parts is the same. A light that changes leaves what it does not shine on.

Two objects fight for one place where pixels of one, in areas and at the same distance, showed the other one a frame before, both ways, in three pairs of frames or more. At a line where two touch, jitter changes a row of pixels and no more.

Where a mask says that something is blended in, its shapes are searched for in the mask of the frame before: one whose motion does not lead there has none of its own, which a mask that the resolve gets may stand for. Where an object rests, and its motion is another one where something is blended over it, but what is seen moves as what rests, the motion behind is overwritten.

How sharp a texture is before it is filtered is in no frame: the bias of the level of detail is not decided.

Color that is encoded for a screen ends at 1. Where more than one pixel in a thousand of a capture shows light above 1.5, color that is stated as encoded is not, and color that is stated as linear is; where fewer do, the encoding is not decided.

### The resolve

What the engine's own TAA made of the frames comes with a capture, or is what the preset makes of a scene. At some hundred pixels a frame each preset of this program is tried, as it is and with each mistake of the table above, on the frame's colors, motion and depth and on the output before: history read off by the last jitter, in place, on the other side, of the frame before the last, a box of two corners, and, at rims and where history lies beyond the picture, the motion of the farthest and a history that is kept. Where so little moves but rims that the farthest's motion explains the output as well as history in place, both are said. α is that of the preset, and eight from 0 to 1. A mistake is told where it leaves at most half of what the best sound resolve leaves; the preset that fits is told as the nearest one. Values that are no number and stay, and outputs in steps of 1/255, are seen without that. An output that no preset is near to is not decided, nor is one made of frames in which something is wrong, unless it fits exactly.

### Mended

What is wrong makes other things look wrong. So depth that clearly is another one, then jitter, then motion of the whole picture are made right, and the rest is looked at again. What was found is also shown as it would be if it were right, as a lane beside the original: faults that were injected are taken back, and what is wrong with the frames themselves is undone by settings of the group `fault`, for a capture as for a scene. A sign undoes itself, a unit has its inverse, jitter that was left in is taken off, a frame late is a frame early; motion that was not written becomes the camera's. *Show mended* of the page, Alt+M, compares the resolved picture with that. `taa-batch doctor SOURCE --mended FOLDER` looks at the mended frames again, says what is still found, and how far the last frame is from its reference as it is and mended, and writes pictures and settings, a preset. What a drawn picture lacks no setting brings back: a jitter that was not applied, an object's own motion, a plane of full resolution.

### What it does not decide

A region that is still, plain or small, or whose light changes, is not decided; the doctor says which and what to capture instead. A finding whose own explanations these frames do not tell apart is told as likely, with the others beside it.
)") + doctorConfusions(judgedCases());
}

} // namespace taa
