#include "core/report/ManualPages.h"

#include "core/base/EmbeddedFiles.h"

#include <algorithm>
#include <cstddef>
#include <regex>

namespace taa {

namespace {

constexpr const char* kFolder = "resources/manual/";

std::string withoutRemarks(std::string text) {
  for (std::size_t begin; (begin = text.find("<!--")) != std::string::npos;) {
    const std::size_t end = text.find("-->", begin);
    text.erase(begin, end == std::string::npos ? end : end + 3 - begin);
  }
  return text;
}

/// Its title is its first heading.
ManualPage readPage(const std::string& file) {
  ManualPage page{file, "", withoutRemarks(embeddedText(kFolder + file))};
  if (page.text.starts_with("# ")) page.title = page.text.substr(2, page.text.find('\n') - 2);
  return page;
}

} // namespace

std::vector<ManualPage> manualPages() {
  std::vector<ManualPage> pages = {readPage("README.md")};
  static const std::regex kLink(R"(\]\(([a-z]+\.md)\))");
  const std::string contents = pages.front().text;
  for (std::sregex_iterator link(contents.begin(), contents.end(), kLink), end; link != end; ++link)
    if (std::ranges::find(pages, (*link)[1].str(), &ManualPage::file) == pages.end())
      pages.push_back(readPage((*link)[1]));
  return pages;
}

std::string headingAnchor(const std::string& heading) {
  std::string anchor;
  for (const char letter : heading) {
    const auto byte = static_cast<unsigned char>(letter);
    if (letter == ' ' || letter == '-')
      anchor += '-';
    else if (letter >= 'A' && letter <= 'Z')
      anchor += static_cast<char>(letter - 'A' + 'a');
    else if ((letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9') || letter == '_' ||
             byte >= 0x80)
      anchor += letter;
  }
  return anchor;
}

} // namespace taa
