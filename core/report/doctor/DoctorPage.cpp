#include "core/report/doctor/DoctorPage.h"

#include "core/base/HtmlText.h"
#include "core/base/NumberText.h"
#include "core/base/Say.h"
#include "core/doctor/Outline.h"
#include "core/report/doctor/DoctorReport.h"
#include "core/report/doctor/ShownPng.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

namespace taa {

using doctor::Diagnosis;
using doctor::Finding;
using doctor::RegionPlace;
using doctor::Residual;

namespace {

constexpr std::string_view kPageStyle =
    "body{font-family:sans-serif;line-height:1.45;max-width:56rem;margin:2rem auto;padding:0 1rem}"
    "table{border-collapse:collapse;width:100%}td{padding:.1rem .6rem .1rem 0;vertical-align:middle}"
    "td.number{text-align:right;font-variant-numeric:tabular-nums}td.bar{width:40%}"
    "div.bar{height:.7rem;background:#888}tr.fits div.bar{background:#2a7}tr.stored div.bar{background:#c43}"
    "tr.fits,tr.stored{font-weight:bold}dt{font-weight:bold}dd{margin:0 0 .4rem 0}"
    "div.pictures{display:flex;flex-wrap:wrap;gap:1rem}figure{margin:0;flex:1 1 20rem;max-width:27rem}"
    "svg{width:100%;height:auto;background:#ddd}path{fill:none;stroke:#d60;stroke-width:2;"
    "vector-effect:non-scaling-stroke}image{image-rendering:auto}";

std::string htmlTag(std::string_view tag, const std::string& text) {
  const std::string name(tag);
  return "<" + name + ">" + htmlText(text) + "</" + name + ">\n";
}

std::string htmlList(const std::string& title, const std::vector<std::string>& sentences) {
  if (sentences.empty()) return {};
  std::string text = htmlTag("h2", title) + "<ul>\n";
  for (const std::string& sentence : sentences) text += htmlTag("li", sentence);
  return text + "</ul>\n";
}

std::string htmlTerm(const std::string& term, const std::string& text) {
  return htmlTag("dt", term) + htmlTag("dd", text);
}

/// `largest`: of the finding, above 0.
std::string barRow(const Residual& residual, double largest) {
  const std::string mark = residual.isBest    ? say<"fits">()
                           : residual.isGiven ? say<"what is stored">()
                                              : std::string();
  const std::string look = residual.isBest ? " class=\"fits\"" : residual.isGiven ? " class=\"stored\"" : "";
  const long percent = std::lround(100.0 * std::max(0.0, residual.value) / largest);
  return "<tr" + look + "><td>" + htmlText(residual.text) + "</td><td>" + htmlText(mark) +
         "</td><td class=\"number\">" + shortNumber(residual.value) +
         "</td><td class=\"bar\"><div class=\"bar\" style=\"width:" + std::to_string(percent) +
         "%\"></div></td></tr>\n";
}

std::string residualBars(const Finding& finding) {
  double largest = 0.0;
  for (const Residual& residual : finding.residuals) largest = std::max(largest, residual.value);
  if (!(largest > 0.0)) return {};
  std::string text = "<p>" + htmlText(finding.measure) + "</p>\n<table>\n";
  for (const Residual& residual : finding.residuals) text += barRow(residual, largest);
  return text + "</table>\n";
}

std::string regionText(const RegionPlace& region, const doctor::FrameNames& names) {
  if (region.isWholeFrame) return region.name;
  return say<"%1: largest in frame %2, pixels %3, %4 to %5, %6, for example %7, %8">(
      region.name, names.of(region.frame), region.box.x, region.box.y, region.box.z - 1, region.box.w - 1,
      region.pixel.x, region.pixel.y);
}

/// Edges of the regions that were found in a frame.
std::string outlinePath(const Finding& finding, int frame) {
  std::string text;
  for (const RegionPlace& region : finding.regions) {
    if (region.frame != frame) continue;
    for (const doctor::OutlineEdge& edge : doctor::outlineOf(region.pixels))
      text += "M" + std::to_string(edge.from.x) + " " + std::to_string(edge.from.y) +
              (edge.from.y == edge.to.y ? "H" + std::to_string(edge.to.x) : "V" + std::to_string(edge.to.y));
  }
  return text.empty() ? text : "<path d=\"" + text + "\"/>";
}

std::string figureHtml(const std::string& content, const glm::ivec2& sizePx, const std::string& caption) {
  return "<figure><svg viewBox=\"0 0 " + std::to_string(sizePx.x) + " " + std::to_string(sizePx.y) + "\">" +
         content + "</svg><figcaption>" + htmlText(caption) + "</figcaption></figure>\n";
}

/// `picture`: as a screen is sent it; as large as the frame is taken to be.
std::string imageHtml(const Image& picture, const glm::ivec2& sizePx) {
  return "<image width=\"" + std::to_string(sizePx.x) + "\" height=\"" + std::to_string(sizePx.y) +
         "\" href=\"data:image/png;base64," + base64Of(pngOfShown(picture)) + "\"/>";
}

Image grayPicture(const Image& luma) {
  Image out(luma.width, luma.height, 3);
  for (std::size_t i = 0; i < luma.pixels.size(); ++i)
    std::fill_n(out.pixels.begin() + 3 * static_cast<std::ptrdiff_t>(i), 3, luma.pixels[i]);
  return out;
}

/// The outline of its regions, over the pictures where there are some.
std::string findingPictures(const Diagnosis& diagnosis, std::size_t index,
                            const doctor::CorrectedLook* corrected) {
  const Finding& finding = diagnosis.findings[index];
  const glm::ivec2& sizePx = diagnosis.sizePx;
  if (corrected)
    for (const doctor::CorrectedPicture& picture : corrected->pictures)
      if (picture.finding == index) {
        const std::string path = outlinePath(finding, picture.frame);
        return "<div class=\"pictures\">\n" +
               figureHtml(imageHtml(picture.given, sizePx) + path, sizePx,
                          say<"Frame %1 as it is">(diagnosis.frameNames.of(picture.frame))) +
               figureHtml(imageHtml(picture.corrected, sizePx) + path, sizePx,
                          say<"Frame %1 mended">(diagnosis.frameNames.of(picture.frame))) +
               "</div>\n";
      }
  if (finding.isWholePicture || finding.regions.empty()) return {};
  const int frame = finding.regions.front().frame;
  const auto picture = diagnosis.pictures.find(frame);
  const std::string seen =
      picture == diagnosis.pictures.end() ? std::string() : imageHtml(grayPicture(picture->second), sizePx);
  return "<div class=\"pictures\">\n" +
         figureHtml(seen + outlinePath(finding, frame), sizePx,
                    say<"Where it is in frame %1">(diagnosis.frameNames.of(frame))) +
         "</div>\n";
}

std::string findingHtml(const Finding& finding, int number, const doctor::FrameNames& names) {
  const bool isSure = finding.confidence == doctor::Confidence::Sure;
  std::string text = htmlTag("h2", std::to_string(number) + ". " + finding.name +
                                       (isSure ? std::string() : " (" + say<"likely">() + ")") +
                                       (finding.isKnown ? " (" + say<"known">() + ")" : std::string()));
  text += "<dl>\n";
  if (finding.isWholePicture) text += htmlTerm(say<"Where">(), say<"the whole picture">());
  for (const RegionPlace& region : finding.regions)
    text += htmlTerm(say<"Where">(), regionText(region, names));
  text += htmlTerm(say<"Seen as">(), finding.symptom) + htmlTerm(say<"Change">(), finding.change) +
          htmlTerm(say<"Evidence">(), finding.reason) + "</dl>\n";
  return text + residualBars(finding);
}

std::string correctedHtml(const doctor::CorrectedLook& look, const Diagnosis& diagnosis) {
  std::vector<std::string> lines;
  for (const std::size_t finding : look.corrected.findings) lines.push_back(diagnosis.findings[finding].name);
  std::string text = htmlList(say<"Mended in these pictures">(), lines);
  for (const Finding& finding : look.left.findings) text += htmlTag("p", say<"Found then: %1">(finding.name));
  if (!look.corrected.findings.empty() && look.left.isHealthy())
    text += htmlTag("p", say<"Nothing wrong is found then.">());
  if (look.givenPsnr && look.correctedPsnr)
    text += htmlTag("p", say<"PSNR of frame %1: %2 dB as it is, %3 dB mended">(
                             look.lastFrame, shortNumber(*look.givenPsnr), shortNumber(*look.correctedPsnr)));
  return text;
}

} // namespace

std::string doctorHtml(const Diagnosis& diagnosis, const std::string& source,
                       const doctor::CorrectedLook* corrected) {
  const std::string title = say<"What the doctor says of %1">(reportedName(source));
  std::string text = "<!DOCTYPE html>\n<html>\n<head>\n<meta charset=\"utf-8\">\n" + htmlTag("title", title) +
                     "<style>" + std::string(kPageStyle) + "</style>\n</head>\n<body>\n" +
                     htmlTag("h1", title) + htmlTag("p", diagnosis.lookedText());
  if (diagnosis.isHealthy()) text += htmlTag("p", diagnosis.healthySentence());
  int number = 0;
  for (const Finding& finding : diagnosis.findings) {
    text += findingHtml(finding, number + 1, diagnosis.frameNames);
    text += findingPictures(diagnosis, static_cast<std::size_t>(number), corrected);
    ++number;
  }
  if (corrected) text += correctedHtml(*corrected, diagnosis);
  std::vector<std::string> right;
  for (const doctor::RightPart& part : diagnosis.parts.right()) right.push_back(part.sentence);
  text += htmlList(say<"Right">(), right);
  std::vector<std::string> undecided;
  for (const doctor::Undecided& open : diagnosis.parts.undecided())
    undecided.push_back(open.question + ": " + open.reason + "." +
                        (open.capture.empty() ? "" : " " + open.capture));
  text +=
      htmlList(say<"Not decided by these frames">(), undecided) + htmlList(say<"Notes">(), diagnosis.notes);
  return text + "</body>\n</html>\n";
}

} // namespace taa
