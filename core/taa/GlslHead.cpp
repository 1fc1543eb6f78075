// Conventions of the resolve in words, for whoever binds its inputs in an engine.
#include "core/taa/GlslHead.h"

#include "core/base/EmbeddedFiles.h"
#include "core/base/Text.h"
#include "core/settings/Faults.h"
#include "core/settings/Parameters.h"
#include "core/taa/GlslExport.h"
#include "core/taa/History.h"

#include <sstream>
#include <string_view>

namespace taa {

namespace {

/// Something the shader reads, and what has to be in it. Told where `mark` stands in its text.
struct Input {
  std::string_view mark, text;
};

constexpr Input kInputs[] = {
    {"u_color", "u_color (0), RGBA16F or RGBA32F: this frame's scene-linear color, Rec. 709 primaries, "
                "before tone mapping, drawn with the jitter. NaN, infinite and negative values are made sane "
                "here."},
    {"u_depth", "u_depth (1), 32-bit float: device depth of the same drawing, reversed (1 near, 0 infinitely "
                "far); exactly 0 is the sky."},
    {"u_motion",
     "u_motion (2), RG16F or RG32F: position in this frame minus position in the previous one, in "
     "pixels of the inputs, x right, y down, both jitters removed. Both components 65504: the "
     "point has no previous position."},
    {"u_normal", "u_normal (3), RGBA16F: world-space normal; alpha: the object's class, a small integer."},
    {"u_objectId", "u_objectId (4), R32UI: a number for each object, 0 for the sky."},
    {"u_previousDepth", "u_previousDepth (5), R32F: view depth in m that the surface had in the previous "
                        "frame; 0 for the sky or where there is none."},
    {"u_historyColor", "u_historyColor (6): o_color of the previous frame."},
    {"u_historySurface", "u_historySurface (7): o_surface of the previous frame."},
    {"u_historyObject", "u_historyObject (8): o_kept_object of the previous frame."},
    {"u_historyNormal", "u_historyNormal (9): o_kept_normal of the previous frame."},
    {"u_historyMotion", "u_historyMotion (10): o_kept_motion of the previous frame."},
    {"u_historyLock", "u_historyLock (11): o_kept_lock of the previous frame."},
    {"u_historyLumas", "u_historyLumas (12): o_kept_lumas of the previous frame."},
    {"u_mask", "u_mask (14), RG8: reactive (share of blended things in the color), responsive (1 where "
               "content changes without motion). One black texel where nothing is marked."},
    {"u_overlay", "u_overlay (15), RGBA16F: a premultiplied layer of the size of the inputs, drawn without "
                  "jitter, that is laid over what is shown. One black texel where there is none."},
    {"u_resolved", "u_resolved (8): o_color that the resolve has just written, of this frame."},
};

constexpr Input kMembers[] = {
    {"sizePx", "sizePx: width, height of the picture and of the history."},
    {"jitterPx", "jitterPx: how far the jitter moves image content, px of the inputs, x right, y down, at "
                 "most 1/2 each. In clip space that is (+2 x / width, -2 y / height) times w."},
    {"renderSizePx", "renderSizePx: width, height of the inputs."},
    {"renderRatio", "renderRatio: renderSizePx / sizePx."},
    {"depthTerms",
     "depthTerms: elements (P33, P32, P23, P22) of the projection, Pcr column c, row r from 0; view depth "
     "= (d P33 - P32) / (d P23 - P22) in m, positive in front of the camera."},
    {"state",
     "state: x: 0 in the first frame, after a cut and where the history is of another size; else 1 "
     "plus the value of kLayer_... for each kept layer that the previous frame wrote. y, z: 0 (pixel "
     "at the target's top left). w: number of the frame."},
    {"spread", "spread: 0, not used here."},
};

// The text in comment lines of at most 110 characters, the later ones indented.
std::string wrappedComment(const std::string& text, const std::string& indent) {
  std::istringstream words(text);
  std::string out, line = "// ", word;
  while (words >> word) {
    if (line.size() + 1 + word.size() > 110 && line.size() > 3) {
      out += line + "\n";
      line = "// " + indent;
    }
    line += (line.back() == ' ' ? "" : " ") + word;
  }
  return out + line + "\n";
}

std::string item(const std::string& text) {
  return "//   " + wrappedComment(text, "    ").substr(3);
}

bool isKernelOfPlace(CurrentFilter filter) {
  switch (filter) {
  case CurrentFilter::Gaussian:
  case CurrentFilter::Mitchell:
  case CurrentFilter::CatmullRom:
  case CurrentFilter::BlackmanHarris:
  case CurrentFilter::Lanczos:
    return false;
  case CurrentFilter::Center:
  case CurrentFilter::Unjitter:
  case CurrentFilter::Tent:
  case CurrentFilter::Box:
  case CurrentFilter::DistanceAsPrinted:
  case CurrentFilter::MitchellAsPrinted:
  case CurrentFilter::BlackmanHarrisAsPrinted:
  case CurrentFilter::UnjitterAsPrinted:
    break;
  }
  return true;
}

// With o a neighbor's offset and j the jitter (CurrentWeights.cpp).
std::string kernelText(const CurrentSettings& settings) {
  switch (settings.filter) {
  case CurrentFilter::Gaussian:
    return "exp(-r^2 / (2 v)), v = " +
           valueText(parameter("current.variance"), static_cast<double>(settings.variance));
  case CurrentFilter::Mitchell:
    return "the cubic of Mitchell and Netravali with B = C = 1/3 at r";
  case CurrentFilter::CatmullRom:
    return "the cubic of Mitchell and Netravali with B = 0, C = 1/2 at r";
  case CurrentFilter::BlackmanHarris:
    return "0.35875 - 0.48829 cos(a) + 0.14128 cos(2 a) - 0.01168 cos(3 a), a = 2 pi (r / 3 + 1/2), and 0 "
           "from r = 1.5 on";
  case CurrentFilter::Lanczos:
    return "f(x) f(y) of o - j, f(x) = (x^2 - 1) (x^2 - 4)^3 / 64 with x^2 at most 4";
  case CurrentFilter::Center:
  case CurrentFilter::Unjitter:
  case CurrentFilter::Tent:
  case CurrentFilter::Box:
  case CurrentFilter::DistanceAsPrinted:
  case CurrentFilter::MitchellAsPrinted:
  case CurrentFilter::BlackmanHarrisAsPrinted:
  case CurrentFilter::UnjitterAsPrinted:
    break;
  }
  return {};
}

std::string weightTermsText(const Settings& settings) {
  std::string text = "weightTerms: x: ";
  const bool isPlain = settings.weight.sampleDistance == SampleDistance::None || isUpsampled(settings);
  if (isPlain)
    text += "1";
  else
    text += settings.weight.sampleDistance == SampleDistance::Gaussian ? "exp(-|jitterPx|^2 / 0.44)"
                                                                       : "max(1 - |jitterPx|^2, 0)";
  return text + ". y: round(8 s " +
         valueText(parameter("weight.referenceRate"), static_cast<double>(settings.weight.referenceRate)) +
         "), 1 to 64, s the seconds since the previous frame. z, w: 0.";
}

bool declares(const std::string& body, const Input& input) {
  return body.find(" " + std::string(input.mark) + ";") != body.npos;
}

std::string texturesText(const std::string& resolve, const std::string& output) {
  std::string text =
      "//\n// WHAT GOES IN (texture unit): samplers nearest, clamped to the edge, no mipmaps.\n";
  for (const Input& input : kInputs)
    if (declares(resolve, input)) text += item(std::string(input.text));
  if (output.empty()) return text;
  text += "//\n// WHAT GOES IN with " + std::string(kOutputMacro) + ": likewise.\n";
  for (const Input& input : kInputs) {
    if (!declares(output, input)) continue;
    const std::string told(input.text.substr(0, input.text.find(')') + 1));
    text += item(declares(resolve, input) ? told + ": the same as the resolve's." : std::string(input.text));
  }
  return text;
}

std::string blockText(const Settings& settings, const std::string& resolve, const std::string& output) {
  const auto isThere = [&](std::string_view member) {
    const std::string use = "resolveBlock." + std::string(member);
    return resolve.find(use) != resolve.npos || output.find(use) != output.npos;
  };
  std::string text = std::string("//\n// WHAT GOES IN: the uniform block ResolveBlock at binding 0") +
                     (output.empty() ? "" : ", the same for both") + ".\n";
  for (const Input& input : kMembers)
    if (isThere(input.mark)) text += item(std::string(input.text));
  if (isThere("currentWeights"))
    text +=
        item("currentWeights0 to 2: weights of the 3x3 colors, row-major, w unused: " +
             kernelText(settings.current) +
             ", r = |o - j|, o the neighbor's offset in px (-1 to 1, y down), j = jitterPx. They need not "
             "sum up to 1. Where |sum| <= 0.0001: 1 for the center, else 0.");
  if (isThere("weightTerms")) text += item(weightTermsText(settings));
  return text;
}

// Of a layer of the history.
std::string formatText(gl::Format format) {
  if (format == gl::Format::RGBA16F) return "RGBA16F";
  return format == gl::Format::RGBA8 ? "RGBA8" : "RG32F";
}

std::string outputsText(const Settings& settings, bool hasOutput) {
  std::string text =
      "//\n// WHAT COMES OUT: color targets of the size of the picture, the next frame's history.\n";
  text += item(
      std::string("o_color (0), ") + (settings.history.precision == Precision::Half ? "RGBA16F" : "RGBA32F") +
      ": the resolved scene-linear color, alpha 1." + (hasOutput ? "" : " Tone map it for the screen."));
  text += item("o_surface (1), RG32F: length of the history in frames, view depth in m.");
  int location = 2;
  for (const HistoryLayer& layer : historyLayers())
    if (layer.isNeeded(settings)) {
      text += item("o_kept_" + std::string(layer.name) + " (" + std::to_string(location++) + "), " +
                   formatText(layer.format) + ".");
    }
  if (!hasOutput) return text;
  text += "//\n// WHAT COMES OUT with " + std::string(kOutputMacro) + ": a color target of the same size.\n";
  return text +
         item("o_output (0), RGBA16F or RGBA32F: the scene-linear color to show, alpha 1. Tone map it for "
              "the screen. No history: the next frame must not read it.");
}

std::string settingsText(const Settings& settings, bool hasOutput) {
  std::string text =
      "//\n// SETTINGS (a line for each stage; those of jitter and inputs are the renderer's business)\n";
  for (const StageInfo& stage : kStages) {
    if ((stage.stage == Stage::Output && !hasOutput) || stage.stage == Stage::Faults) continue;
    std::string line;
    for (const Parameter& row : parameters())
      if (row.stage == stage.stage && isRelevant(row, settings))
        line += " " + std::string(row.path) + "=" + valueText(row, row.get(settings));
    if (!line.empty()) text += item(line.substr(1));
  }
  if (const auto faults = injectedFaults(settings); !faults.empty())
    text += item("faults on purpose, as far as the resolve makes them: " + joined(faults));
  return text;
}

// Which passes there are, and in which order.
std::string passesText(bool hasOutput) {
  static const std::string kMacro = kOutputMacro;
  if (!hasOutput)
    return wrappedComment(
        "What is shown is o_color: with these settings nothing follows the resolve (stage Output of "
        "the inspector). What you do to it must not find its way into the history.",
        "");
  return "//\n// TWO SHADERS: compile the file twice.\n" +
         item("As it is: the resolve. It writes the history.") +
         item(
             "With a line \"#define " + kMacro + "\" behind #version, or -D" + kMacro +
             ": the pass after it (stage Output of the inspector), which makes of the resolved color what is "
             "shown.") +
         item("In each frame: 1. the resolve into this frame's set of targets. 2. the pass with " + kMacro +
              " into a target of its own; it reads o_color of this frame. 3. tone map o_output for the "
              "screen. 4. "
              "swap the sets. The history stays what the resolve wrote: what the second pass does would add "
              "up "
              "in it.");
}

std::string licenseText() {
  std::istringstream lines(embeddedText("LICENSE"));
  std::string text = "//\n";
  for (std::string line; std::getline(lines, line);) text += line.empty() ? "//\n" : "// " + line + "\n";
  return text;
}

} // namespace

bool hasConstantWeights(const CurrentSettings& settings) {
  return isKernelOfPlace(settings.filter) || settings.jitterAware == Switch::Off;
}

std::string glslHead(const Settings& settings, const std::string& title, const std::string& resolve,
                     const std::string& output) {
  const bool hasOutput = !output.empty();
  std::string text = std::string("// Temporal anti-aliasing: the resolve of one pixel") +
                     (hasOutput ? ", and what is shown of it" : "") + ". Settings: " + title + ".\n";
  text += "// Made by TAA Inspector " TAA_VERSION "; see the license below.\n//\n";
  text += wrappedComment(
      (hasOutput ? std::string("Fragment shaders") : std::string("A fragment shader")) +
          " without further needs: draw one triangle that covers the target, without blending. Row 0 of "
          "every "
          "texture and of the target is the top of the picture, so that gl_FragCoord.y grows downwards. Keep "
          "two sets of the resolve's targets and swap them every frame; the history must be of the same size "
          "as "
          "the picture.",
      "");
  if (isUpsampled(settings))
    text += wrappedComment(
        "The inputs are smaller than the picture (render scale " +
            valueText(parameter("inputs.renderScale"), static_cast<double>(settings.inputs.renderScale)) +
            "): it upsamples.",
        "");
  text += passesText(hasOutput) + texturesText(resolve, output) + blockText(settings, resolve, output);
  return text + outputsText(settings, hasOutput) + settingsText(settings, hasOutput) + licenseText();
}

} // namespace taa
