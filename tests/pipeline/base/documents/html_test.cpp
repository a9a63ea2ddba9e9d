#include "pipeline/base/documents/html.h"

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

TEST(HtmlEscaped, LeavesNothingThatHtmlReads) {
  EXPECT_EQ(html_escaped(R"(<a href="x">'&')"), "&lt;a href=&quot;x&quot;&gt;&#39;&amp;&#39;");
  EXPECT_EQ(html_escaped("速い · quick"), "速い · quick");
}

TEST(HtmlList, EscapesItsTextsAndIsNothingWithoutAny) {
  EXPECT_EQ(html_list("warnings", {}), "");
  EXPECT_EQ(html_list("warnings", {"a < b", "c"}),
            "<ul class=\"warnings\">\n<li>a &lt; b</li>\n<li>c</li>\n</ul>\n");
}

TEST(HtmlTable, MarksNumbersAndTheirHeadsAlike) {
  const std::string table =
      html_table({"who", ">count", "note", ""},
                 "<tr><th scope=\"row\">a</th><td>3</td><td>some</td><td class=\"bar\"></td></tr>\n"
                 "<tr><td>b</td><td class=\"bar\">4</td><td>1</td></tr>\n");
  EXPECT_EQ(table,
            "<table><thead><tr><th>who</th><th class=\"number\">count</th><th>note</th><th></th>"
            "</tr></thead>\n<tbody><tr><th scope=\"row\">a</th><td class=\"number\">3</td>"
            "<td>some</td><td class=\"bar\"></td></tr>\n"
            "<tr><td>b</td><td class=\"bar\">4</td><td>1</td></tr>\n</tbody></table>\n");
}

/// The text that a browser reads out of a data URL.
std::string decoded(std::string_view url) {
  std::string text;
  for (std::size_t i = 0; i < url.size(); ++i) {
    if (url[i] != '%') {
      text += url[i];
    } else {
      text += static_cast<char>(std::stoi(std::string(url.substr(i + 1, 2)), nullptr, 16));
      i += 2;
    }
  }
  return text;
}

TEST(EmbeddedSvg, IsTheDrawingAgainAndEndsNoAttribute) {
  std::string every_byte;
  for (int c = 1; c < 256; ++c) every_byte += static_cast<char>(c);
  const std::string html = embedded_svg(every_byte, "a \"picture\"");
  const std::string start = "src=\"data:image/svg+xml,";
  const std::size_t from = html.find(start) + start.size();
  const std::string url = html.substr(from, html.find('"', from) - from);
  EXPECT_EQ(decoded(url), every_byte);
  EXPECT_EQ(url.find_first_of("<>'#&"), std::string::npos);
  EXPECT_NE(html.find("alt=\"a &quot;picture&quot;\""), std::string::npos);
}

TEST(HtmlPage, EscapesItsTitleAlone) {
  const std::string page = html_page("a & b", "p > a {}\n", "<p>c</p>\n");
  EXPECT_NE(page.find("<title>a &amp; b</title>"), std::string::npos);
  EXPECT_NE(page.find("<style>\np > a {}\n</style>"), std::string::npos);
  EXPECT_NE(page.find("<body>\n<p>c</p>\n</body>"), std::string::npos);
}

}  // namespace
}  // namespace mien::pipeline
