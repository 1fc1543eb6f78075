#include "core/report/Techniques.h"

#include "core/settings/Parameters.h"

#include <algorithm>
#include <cstddef>
#include <regex>
#include <string>
#include <utility>
#include <vector>

namespace taa {

namespace {

/// Of what no choice alone chooses, and where a choice's own name says too little.
const std::vector<Technique>& writtenTechniques() {
  static const std::vector<Technique> kTechniques{
      {"1.1", "HDR, before post", "`inputs.range=hdr`: the resolve works on scene-linear colors"},
      {"1.2", "LDR, after tone map",
       "`inputs.range=ldr`: after a tone map that clips, which is the window's own; kept linear"},
      {"1.3", "tone map, resolve, inverse", "`blend.tone=reinhardChannel`"},
      {"1.4", "history by copy",
       "Left out: ping-pong gives the same bits without the copy, and frames are restored from checkpoints."},
      {"1.5", "history ping-pong", "always"},
      {"1.6", "history format",
       "`history.precision=half`, `history.precision=full`, `history.precision=unorm8`, "
       "`history.precision=unorm10`"},
      {"1.7", "reset and first frame",
       "always: at frame 0, at the cuts of a shot, and where it is restarted by hand (Shift+R, --restart N)"},
      {"1.8", "paused and drawn again",
       "always: frame n is a function, so a frame drawn again is the same frame"},
      {"1.9", "jitter frame offset", "`jitter.firstIndex`"},
      {"1.10", "history for each view",
       "Left out: there is one eye; the lanes each keep a history of their own."},
      {"1.11", "quality levels",
       "the presets `urp-verylow` to `urp-veryhigh` and `hdrp-low` to `hdrp-high`, `hdrp-taau`"},
      {"J0", "none, still",
       "`jitter.sequence=none`, `jitter.sequence=still`; `taa.enabled` off, the preset `off`, turns all of TAA "
       "off"},
      {"J9", "Halton (2, 3)", "`jitter.sequence=halton`"},
      {"J10", "across the motion",
       "`jitter.sequence=perpendicular`: the direction is followed anew from the 64 frames before, so that a "
       "frame stays a function of its number"},
      {"2.1", "into the projection",
       "`jitter.projection=translation`; as printed `jitter.projection=addedAsPrinted`, "
       "`jitter.projection=columnAsPrinted`, `jitter.projection=rightAsPrinted`"},
      {"2.2", "period, scale", "`jitter.period`, `jitter.scale`"},
      {"3.1", "camera, from depth", "`inputs.motion=cameraFromDepth`"},
      {"3.1a", "raw pixel position", "`inputs.motion=rawUv`"},
      {"3.1b", "difference of jitters", "`inputs.motion=jitterDifference`"},
      {"3.1c", "one matrix", "`inputs.motion=singleMatrix`"},
      {"3.2", "sky", "always: a direction, so that only turning moves it"},
      {"3.3", "rigid", "`inputs.motion=objects`; builtin:gallery"},
      {"3.4", "skinned", "`inputs.motion=objects`: joints of this frame and the previous one, on the GPU"},
      {"3.5", "morph targets", "`inputs.motion=objects`: weights of this frame and the previous one"},
      {"3.6", "vertex cache",
       "`inputs.motion=objects`: positions minus velocity times the step; glTF attribute `_VELOCITY`"},
      {"3.7", "vertex animation", "`inputs.motion=objects`: the same wave a moment earlier; builtin:foliage"},
      {"3.8", "flip-books, particles",
       "`inputs.mask=material`: no motion follows them, a mask names them; builtin:glass"},
      {"3.9", "reverse transform",
       "Left out: source 002 names it only to reject it; 3.1 does the same work."},
      {"4.0", "own pixel", "`dilate.method=none`"},
      {"4.1", "closest 3×3",
       "`dilate.method=closest3x3`; of equals `dilate.ties=center`, `dilate.ties=first`, `dilate.ties=last`; "
       "what Godot takes since its depth is reversed: `dilate.method=farthest3x3`, `dilate.upLeft`"},
      {"4.3", "closest ×",
       "`dilate.method=closestX`; source 002's takes the last of equals, `dilate.ties=last`"},
      {"5.0", "no test at the border", "`validate.offScreen=keep`"},
      {"5.1", "reject outside", "`validate.offScreen=reject`"},
      {"5.2", "filtered current where rejected", "`blend.restart=filtered`"},
      {"5.3", "half a pixel of margin", "`validate.offScreen=margin`"},
      {"5.4", "border color",
       "`history.border=black`, else `history.border=edge`; Donut tests the border as well: "
       "`validate.offScreen=reject`"},
      {"5.5", "history := filtered current",
       "`blend.restart=filtered`: α = 1 gives the same color, and N restarts"},
      {"5.6", "blurred restart", "`blend.restart=blurred`"},
      {"5.7", "one-sided test, as printed", "`validate.offScreen=oneSided`: beyond the left edge α = 0"},
      {"5.8", "position of the history",
       "always: the intermediate `historyPosition`; `reproject.method=motion`, or the step before it, "
       "`reproject.method=inPlace`; with `inputs.forward` the map of what forward reprojection leaves, "
       "`forwardCount`"},
      {"6.4b", "Catmull-Rom 5, not normalized", "`history.filter=catmullRom5AsPrinted`"},
      {"6.4c", "corners from their neighbors", "`history.filter=catmullRom5Corners`"},
      {"6.5", "cubic of a sharpness", "`history.filter=cubic`, `history.filter=cubic5`, `history.sharpness`"},
      {"6.6", "Mitchell", "`history.filter=mitchell`"},
      {"6.8", "bilinear at depth edges",
       "`history.bilinearAtEdges`, `history.edgeDepth`; the intermediate `depthEdge`"},
      {"6.9", "deringing", "`history.dering`"},
      {"6.10", "no negative values", "always: what is read is sanitized"},
      {"7.0", "center", "`current.filter=center`"},
      {"7.2", "4-2-1, luma weights", "`current.filter=tent`, `current.lumaWeighted`"},
      {"7.4", "jitter-aware Gaussian",
       "`current.filter=gaussian`, `current.jitterAware`, `current.variance`"},
      {"7.5", "Mitchell, Blackman-Harris, Catmull-Rom",
       "`current.filter=mitchell`, `current.filter=blackmanHarris`, `current.filter=catmullRom`"},
      {"7.6", "Lanczos 2, clamped", "`current.filter=lanczos`, `current.dering`"},
      {"7.7", "distance of the sample",
       "`weight.sampleDistance=gaussian`, `weight.sampleDistance=gaussianMoving`; off is "
       "`weight.sampleDistance=none`"},
      {"7.8", "blur where there is no history", "`blend.restart=blurred`"},
      {"8.3", "×", "`neighborhood.shape=x`"},
      {"8.5", "four taps that vary", "`neighborhood.shape=varying`: z in m"},
      {"8.7", "diagonals shared by pairs", "`neighborhood.shape=pairs`"},
      {"8.8", "unjittered neighborhood", "`neighborhood.unjitter`"},
      {"8.9", "at render resolution",
       "`inputs.renderScale` below 1: box, dilation and depth slope are of the render texels around the "
       "nearest one"},
      {"9.2", "YCoCg", "`space.color=yCoCg`"},
      {"9.4", "YCbCr", "`space.color=yCbCr`; of encoded colors with `space.tone=gamma`"},
      {"9.5", "after tone mapping",
       "`space.tone=reinhardLuma`, `space.tone=reinhardChannel`, `space.tone=maxChannel`, `space.tone=linear`"},
      {"9.6", "PQ", "`space.tone=pq`; powers of sums and products alone, the same bits everywhere"},
      {"9.7", "RGB and YCoCg", "`rectify.method=clipToBoth`: six slabs"},
      {"10.1", "min-max", "`neighborhood.box=minMax`"},
      {"10.2", "variance", "`neighborhood.box=variance`, `neighborhood.gamma`"},
      {"10.3", "both", "`neighborhood.box=intersection`"},
      {"10.4", "with the filtered color", "`neighborhood.includeFiltered`"},
      {"10.6", "chroma shrink", "`neighborhood.chromaShrink`"},
      {"10.7", "weighted moments",
       "`neighborhood.weights=equal`, `neighborhood.weights=luma`, `neighborhood.weights=distance`; Godot's of "
       "the compressed sample is `neighborhood.weights=boxLuma`"},
      {"10.8", "γ by motion",
       "`neighborhood.motionGamma`, `neighborhood.gammaMoving`, `neighborhood.gammaSpeed` in "
       "`neighborhood.gammaSpeedIn=px`, `neighborhood.gammaSpeedIn=lines1080` or "
       "`neighborhood.gammaSpeedIn=picture1080`"},
      {"10.9", "γ by resolution", "`neighborhood.resolutionGamma`"},
      {"10.10", "relax mask", "`neighborhood.maskRelax`"},
      {"10.11", "γ by contrast", "`neighborhood.contrastGamma`, `neighborhood.contrastGrowth`"},
      {"10.12", "convex hull, k-DOP", "`rectify.method=clipToHull`: thirteen slabs"},
      {"11.0", "none", "`rectify.method=none`"},
      {"11.1", "clamp", "`rectify.method=clamp`"},
      {"11.4", "ray to the current color", "`rectify.method=rayToCurrent`, `rectify.maxSteps`"},
      {"11.6", "in part", "`rectify.relaxAtRest`, `rectify.minStrength`"},
      {"11.7", "FSR2's",
       "`rectify.method=clampForget` with `rectify.locks` and `rectify.instability`; less of both where the "
       "mask is reactive (21.5)"},
      {"11.8", "select only", "`rectify.method=select`"},
      {"12.1", "depth",
       "`validate.depth`, `validate.depthTolerance`, `validate.slopeAllowance`, "
       "`validate.depthDirection=both`, one way alone `validate.depthDirection=nearer`; looked for in "
       "`validate.depthFootprint=square3x3` or, where something parts, in what is read, "
       "`validate.depthFootprint=readInMotion`"},
      {"12.2", "class",
       "`validate.class`; the classes are the intermediate `objectClass`; the tree of objects and the flag "
       "--class give others"},
      {"12.3", "object", "`validate.object`"},
      {"12.4", "normal, position",
       "`validate.normal`, `validate.normalLimit`; positions at the history position differ by depth alone: "
       "`validate.depth`"},
      {"12.5", "velocity difference",
       "`validate.velocity=vector`, `validate.velocity=length`, `validate.velocityLimit`, "
       "`validate.velocityGain`; off is `validate.velocity=none`. All of chapter 12 is hard with "
       "`validate.action=restart`, soft with `validate.action=raiseAlpha` and `validate.softAlpha`, and takes "
       "from N with `validate.action=decay`"},
      {"12.6", "velocity", "`validate.speed`, `validate.speedLimit`"},
      {"12.7", "divergence of motion", "`weight.divergence`, `weight.divergenceSpeed`"},
      {"13.1", "constant", "`weight.source=constant`, `weight.alpha`"},
      {"13.2", "1/t", "`weight.source=historyLength` with `weight.minimum=0`; the preset `reference`"},
      {"13.3", "1/(N + 1) with a floor", "`weight.source=historyLength`, `weight.minimum`"},
      {"13.4", "velocity, squared", "`weight.motion=squared`, `weight.motionSpeed`"},
      {"13.5", "velocity, linear",
       "`weight.motion=added`, its k as 1080/k with `weight.motionSpeedIn=picture1080`; off is "
       "`weight.motion=none`"},
      {"13.6", "velocity of the engines",
       "`weight.motion=linear`, `weight.motion=doubled`, `weight.sampleDistance=parabola`; in "
       "`weight.motionSpeedIn=px`, `weight.motionSpeedIn=lines1080`"},
      {"13.7", "change of velocity", "`weight.velocityChange`, `weight.velocityChangeSpeed`"},
      {"13.8", "depth", "`weight.source=depth`"},
      {"13.9", "change of depth at rest",
       "`validate.flicker`, `validate.restLimit`, `rectify.flickerStrength`, `weight.flickerShare`"},
      {"13.10", "luma difference", "`weight.source=lumaDifference`, `weight.sourceMax`, `weight.sourceMin`"},
      {"13.11", "luma difference, damping",
       "`weight.lumaFlicker`, `weight.flickerScale=relative`, `weight.flickerScale=compressed`"},
      {"13.12", "luma difference of source 001",
       "`weight.source=lumaDifferenceAsPrinted`; the right way round `weight.source=lumaDifferenceCompressed`"},
      {"13.13", "near the walls", "`weight.nearClamp`"},
      {"13.15", "contrast of the history", "`weight.historyContrast`"},
      {"13.16", "Filmic SMAA's weight", "Left out: the sources only link to it and give no formula."},
      {"13.17", "where history is invalid", "always: the intermediate `rejectReason`"},
      {"13.18", "mask",
       "`weight.mask=reactive`, `weight.mask=off`, `neighborhood.maskRelax` for Donut's division; `alphaMask`, "
       "`alphaRelax`"},
      {"13.19", "frame rate", "`weight.frameRate`, `weight.referenceRate`"},
      {"14.1", "lerp", "`blend.tone=none`"},
      {"14.2", "sum over weights",
       "`blend.tone=luma`, `weight.source=contrastPerChannel`; weights are α and 1 − α, so they never are all "
       "0"},
      {"14.3", "in tone-weighted space", "`blend.tone=maxChannel`"},
      {"14.4", "motion-blur fallback", "`output.motionBlur`, `blurTrust`"},
      {"14.5", "alpha", "Left out: there is no camera stacking whose alpha could be accumulated."},
      {"14.6", "sanitize", "always: every stage"},
      {"14.7", "quantization noise", "`history.dither`"},
      {"15.0", "none", "`blend.tone=none`"},
      {"15.1", "luma, Karis", "`blend.tone=luma`, L by `space.luma=rec709` or `space.luma=yCoCg`"},
      {"15.2", "Reinhard by luma", "`space.tone=reinhardLuma`; in the blend it equals 15.1"},
      {"15.3", "Reinhard", "`blend.tone=reinhardChannel`, `space.tone=reinhardChannel`"},
      {"15.4", "largest channel", "`blend.tone=maxChannel`, `space.tone=maxChannel`"},
      {"15.5", "PQ", "`blend.tone=pq`, `space.tone=pq`"},
      {"15.6", "a project's own",
       "`blend.tone=whitePoint`, `blend.white`: Reinhard's curve with a white point, one that can be inverted"},
      {"15.7", "logarithm", "`blend.tone=logarithm`, `space.tone=logarithm`"},
      {"16", "N",
       "`blend.length=variance`, `blend.length=count`, `blend.length=varianceAsPrinted`, "
       "`blend.length=reciprocal`; Godot's `blend.length=countTo16` with `history.length=bilinear`; Bevy's "
       "`weight.source=confidence` with `blend.length=confidence`; read at `history.length=reprojected`"},
      {"17.1", "no rectification at rest", "`rectify.relaxAtRest` with `rectify.minStrength=0`"},
      {"17.2", "by motion", "`rectify.relaxAtRest`, `rectify.restSpeed`"},
      {"17.3", "pixel lock", "`rectify.locks`, `rectify.lockFrames`"},
      {"17.4", "luma instability", "`rectify.instability`"},
      {"17.5", "temporal contrast", "`neighborhood.contrastGamma`"},
      {"17.6", "select from current", "`rectify.method=select`"},
      {"18.1", "luma ratio",
       "`output.sharpen=lumaRatio`, `output.amount`; the unguarded 0/0 (D8) is left out: made finite it is "
       "black too."},
      {"18.2", "Laplacian on current",
       "`current.sharpen=laplacian`, `current.sharpenAmount`, as printed `current.sharpen=laplacianAsPrinted`, "
       "off `current.sharpen=none`"},
      {"18.3", "unsharp after",
       "`output.sharpen=laplacian` (mean of four), `output.sharpen=unsharp` (of nine), `output.dering`"},
      {"18.6", "in the resolve", "`output.sharpen=inResolve`; not fed back"},
      {"18.7", "in logarithms", "`output.sharpen=logarithm`, off `output.sharpen=none`"},
      {"18.8", "sharp history",
       "`history.filter=cubic`, `history.sharpness`: the reading of history sharpens, not a pass after"},
      {"19.1", "mip bias", "`inputs.mipBias`"},
      {"19.2", "texture coordinates unjittered", "`inputs.unjitterTextures`"},
      {"20.1", "gradient noise",
       "`inputs.noise=gradientNoise`, `inputs.fogNoise=gradientNoise`, `inputs.shadowNoise=gradientNoise`; off "
       "is `inputs.noise=none`, `inputs.fogNoise=none`, `inputs.shadowNoise=none`"},
      {"20.2", "blue noise",
       "`inputs.noise=blueNoise`, `inputs.fogNoise=blueNoise`, `inputs.shadowNoise=blueNoise`: a tile of 32×32 "
       "by void-and-cluster, moved on by the golden ratio"},
      {"20.3", "triangular remap", "`inputs.noiseTriangular`"},
      {"20.4", "where it is applied",
       "`inputs.noise`, `inputs.noiseAmount`: on the shaded color; `inputs.fogNoise`, `inputs.fogAnimated`, "
       "`inputs.fogSteps`: where in its steps a ray through fog is sampled; `inputs.shadowNoise`, "
       "`inputs.shadowRays`, `inputs.sunRadius`: where on the sun's disk rays end, with `inputs.shadows=soft`, "
       "and not with `inputs.shadows=hard` or `inputs.shadows=none` (`inputs.shadows=asScene`: as the scene "
       "wants them); beside them white noise, "
       "`inputs.noise=whiteNoise`, `inputs.fogNoise=whiteNoise`, `inputs.shadowNoise=whiteNoise`"},
      {"20.5", "constraint in the fog",
       "`inputs.fogHistory=clamped`, of the last `inputs.fogFrames`; without it `inputs.fogHistory=kept`, as "
       "Raptor has it `inputs.fogHistory=largestAsPrinted`, none `inputs.fogHistory=none`"},
      {"20.6", "quantization noise",
       "`history.dither`, with `history.precision=unorm8`, `history.precision=unorm10` or halves"},
      {"20.7", "dithered alpha", "`inputs.blended=dithered`, `inputs.blended=mask`"},
      {"20.8", "output dither", "`output.dither`"},
      {"21.1", "after TAA", "`inputs.blended=after`, laid over the `output`; `overlay`, `overlayAlpha`"},
      {"21.3", "with motion",
       "`inputs.blended=beforeWithMotion`: motion, and not the depth that history is checked by"},
      {"21.4", "responsive mask",
       "`inputs.mask=material` with `weight.mask=responsive` or `weight.mask=exclude`; `responsive`"},
      {"21.5", "reactive mask",
       "`inputs.mask=opacity`, `inputs.mask=autoReactive` with `weight.mask=reactive`; `inputs.mask=none`; "
       "`reactive`"},
      {"21.7", "flip-books, screens",
       "`inputs.mask=material`; builtin:glass. Parallax occlusion is not there."},
      {"21.8", "overlays", "always: what the window draws over a picture is drawn after it"},
      {"22.1", "sample weight",
       "`inputs.renderScale` below 1 with `current.upsample=sampleWeight`; κ is `sampleConfidence`"},
      {"22.3", "HDRP's",
       "`current.upsample=hdrp` with its box as κ, `current.upsample=hdrpGaussian` with its Gaussian"},
      {"22.4", "FSR2's", "`current.upsample=fsr2`; its 1/12 is the floor of α, `weight.minimum`"},
      {"22.5", "native", "`inputs.renderScale=1`, the default: the same program as without upsampling"},
      {"24", "volumetric history constraint (001)", "`inputs.fogHistory=clamped`, as 20.5"},
      {"24", "adaptive TAA, ray-traced (000)", "Left out: it needs ray tracing."},
      {"24", "sub-pixel buffers, cached shading, SVGF (004)",
       "Left out: other algorithms than the accumulation of one color a pixel."},
      {"24", "multi-view, XR (003)", "Left out: as 1.10."},
      {"24", "bloom behind TAA (000)",
       "Left out: a post effect that reads what the resolve has written and gives nothing back to it. What a "
       "resolve "
       "does to bloom is seen without one: single bright pixels and their flicker, `flicker` and "
       "`relativeError`."},
      {"D3", "Mitchell, Blackman-Harris, as printed",
       "`current.filter=mitchellAsPrinted`, `current.filter=blackmanHarrisAsPrinted`"},
      {"D5", "motion in two units, as printed", "`inputs.motion=jitterDifferenceAsPrinted`"},
      {"D7", "saturating way back from YCoCg", "`space.color=yCoCgAsPrinted`"},
      {"D8", "division by 0",
       "Left out: 0/0 made finite, which every stage does, is black as it was; see 18.1 and 13.14."},
      {"D9", "one-sided test of the border", "`validate.offScreen=oneSided`"},
      {"D10", "unjitter on the other side, Laplacian's gain",
       "`current.filter=unjitterAsPrinted`, `current.sharpen=laplacianAsPrinted`; both k of source 002 are a "
       "`weight.motionSpeed`: 1080/k"},
      {"D11", "velocity squared, as printed", "`weight.motion=squaredAsPrinted`, from α − 0.025"},
      {"D12", "variance not inverted", "`blend.length=varianceAsPrinted`"},
      {"D13", "closest depth and cubic, as printed",
       "`dilate.method=closestXAsPrinted`, `history.filter=cubic5AsPrinted`"},
      {"D14", "root of a negative variance",
       "Left out: NaN walls reject nothing or everything, by driver; GLSL does not say which."},
      {"D15", "five taps not normalized; orthographic jitter; N of the own pixel",
       "`history.filter=catmullRom5AsPrinted`, `jitter.projection=columnAsPrinted`, "
       "`history.length=pixelAsPrinted`"},
      {"D16", "previous view, current projection", "`inputs.motion=currentProjectionAsPrinted`"},
      {"D17", "α damped to 0", "`weight.lumaFlicker` with `weight.minimum=0`"},
      {"D18", "no motion of objects, no jitter", "`inputs.motion=singleMatrix`, `jitter.sequence=none`"},
  };
  return kTechniques;
}

bool isRow(std::string_view text) {
  static const std::regex kRow("[JD][0-9]+|[0-9]+\\.[0-9]+[a-c]?");
  return std::regex_match(text.begin(), text.end(), kRow);
}

/// Those that a choice names behind its explanation: "… (manual 15.4, Filament)", "(manual 4.5 and 4.6)".
std::vector<std::string_view> rowsOf(std::string_view explanation) {
  constexpr std::string_view kBegin = "(manual ";
  std::vector<std::string_view> rows;
  for (std::size_t at = explanation.find(kBegin); at != explanation.npos; at = explanation.find(kBegin, at)) {
    at += kBegin.size();
    const std::size_t end = explanation.find(')', at);
    constexpr std::string_view kComma = ", ", kAnd = " and ";
    for (std::size_t from = at; from < end;) {
      const std::size_t comma = explanation.find(kComma, from), also = explanation.find(kAnd, from);
      const std::size_t to = std::min({comma, also, end});
      const std::string_view part = explanation.substr(from, to - from);
      if (isRow(part)) rows.push_back(part);
      from = to + (to == comma ? kComma.size() : kAnd.size());
    }
  }
  return rows;
}

/// Its place in the manual: the patterns of jitter before chapter 2, what is printed wrong at the end.
std::pair<double, std::string_view> placeOf(const Technique& technique) {
  const std::string_view row = technique.row;
  const bool isLetter = row.front() == 'J' || row.front() == 'D';
  const std::string number(isLetter ? row.substr(1) : row);
  const auto dot = number.find('.');
  const double chapter = isLetter ? (row.front() == 'J' ? 1.5 : 100.0) : std::stod(number.substr(0, dot));
  const double within = isLetter             ? std::stod(number)
                        : dot == number.npos ? 0.0
                                             : std::stod(number.substr(dot + 1));
  return {chapter + within / 1000.0, row};
}

std::vector<Technique> allTechniques() {
  std::vector<Technique> all = writtenTechniques();
  const auto written = all.size();
  const auto isWritten = [&](std::string_view row) {
    return std::any_of(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(written),
                       [&](const Technique& each) { return each.row == row; });
  };
  for (const Parameter& parameter : parameters())
    for (const Choice& choice : parameter.choices)
      for (const std::string_view row : rowsOf(choice.explanation)) {
        if (isWritten(row)) continue;
        const std::string code = "`" + std::string(parameter.path) + "=" + std::string(choice.id) + "`";
        const auto other = std::ranges::find(all, row, &Technique::row);
        if (other == all.end())
          all.push_back({row, choice.label, code});
        else
          other->here += ", " + code;
      }
  std::ranges::stable_sort(all, {}, placeOf);
  return all;
}

} // namespace

std::span<const Technique> techniques() {
  static const std::vector<Technique> kAll = allTechniques();
  return kAll;
}

} // namespace taa
