#include "editor/export/pdf.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cstdlib>

#include "tests/editor/export/painted.h"
#include "tests/editor/shared_fonts.h"

namespace coppice::editor {
namespace {

std::string PdfOf(const std::string& xml) {
  PictureMaker maker(1, SharedFonts(1));
  return ToPdf(maker.Draw(Painted(xml).painting), Glyphs());
}

// The marks on the page.
std::string ContentOf(const std::string& pdf) {
  const std::size_t begin = pdf.find("stream\n") + 7;
  const std::size_t end = pdf.find("\nendstream");
  std::string content(8 << 20, '\0');
  uLongf size = content.size();
  const int result = uncompress(reinterpret_cast<Bytef*>(content.data()), &size,
                                reinterpret_cast<const Bytef*>(pdf.data() + begin), end - begin);
  EXPECT_EQ(result, Z_OK);
  content.resize(size);
  return content;
}

TEST(Pdf, ItsTableSaysWhereEachObjectBegins) {
  const std::string pdf = PdfOf("<A><B/></A>");
  EXPECT_EQ(pdf.substr(0, 8), "%PDF-1.4");
  const std::size_t start = pdf.find("startxref\n") + 10;
  const std::size_t table = std::strtoul(pdf.c_str() + start, nullptr, 10);
  ASSERT_EQ(pdf.substr(table, 5), "xref\n");
  std::size_t line = pdf.find("00000 n ", table) - 11;
  for (int object = 1; object <= 4; ++object, line += 20) {
    const std::size_t place = std::strtoul(pdf.substr(line, 10).c_str(), nullptr, 10);
    EXPECT_EQ(pdf.substr(place, 6), std::to_string(object) + " 0 ob");
  }
}

TEST(Pdf, SavesAndRestoresInPairsAndNamesOnlyAlphasThatItDeclares) {
  const std::string pdf = PdfOf("<A><B x='{k}'/><C/></A>");
  const std::string content = ContentOf(pdf);
  EXPECT_EQ(CountOf(content, "q "), CountOf(content, "Q\n"));
  for (std::size_t at = content.find("/A"); at != std::string::npos;
       at = content.find("/A", at + 1)) {
    const std::string name = content.substr(at, content.find(' ', at) - at);
    EXPECT_NE(pdf.find(name + "<</ca"), std::string::npos) << name;
  }
}

TEST(Pdf, IsNeverLongerThanAPageMayBe) {
  Drawing drawing;
  drawing.size = {100000, 10};
  const std::string pdf = ToPdf(drawing, Glyphs());
  EXPECT_NE(pdf.find("/MediaBox[0 0 14400.00 1.44 ]"), std::string::npos);
}

TEST(Pdf, WritesTextsAsOutlines) {
  Drawing drawing;
  drawing.size = {100, 20};
  drawing.items.push_back(
      {DrawnItem::Kind::kText, {{0, 10}}, 0xFF000000, 12, "Wait", Face::kSans, 30});
  const std::string content = ContentOf(ToPdf(drawing, Glyphs()));
  EXPECT_GT(CountOf(content, " m "), 4U);
  EXPECT_GT(CountOf(content, " c "), 4U);
}

}  // namespace
}  // namespace coppice::editor
