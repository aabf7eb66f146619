#include "bt_core/model/markup.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace coppice {
namespace {

using Pieces = std::vector<std::pair<MarkupKind, std::string>>;

Pieces Cut(std::string_view text) {
  Pieces pieces;
  for (std::size_t at = 0; at < text.size();) {
    const Markup piece = ReadMarkup(text, at);
    pieces.emplace_back(piece.kind, text.substr(at, piece.end - at));
    at = piece.end;
  }
  return pieces;
}

TEST(Markup, CutsATextIntoItsPieces) {
  const Pieces expected = {{MarkupKind::kInstruction, "<?xml v='>'?>"},
                           {MarkupKind::kText, "\n"},
                           {MarkupKind::kComment, "<!-- <a> -->"},
                           {MarkupKind::kTag, R"(<a x='>' y="'>">)"},
                           {MarkupKind::kText, "b > c"},
                           {MarkupKind::kCharacterData, "<![CDATA[<x>]]>"},
                           {MarkupKind::kDocumentType, "<!DOCTYPE a>"},
                           {MarkupKind::kTag, "<b/>"},
                           {MarkupKind::kTag, "</a>"}};
  EXPECT_EQ(Cut("<?xml v='>'?>\n<!-- <a> --><a x='>' y=\"'>\">b > c<![CDATA[<x>]]><!DOCTYPE a>"
                "<b/></a>"),
            expected);
}

TEST(Markup, ACommentEndsAtItsFirstArrow) {
  EXPECT_EQ(Cut("<!------->x").front().second, "<!------->");
  EXPECT_EQ(Cut("<!--> -->x").front().second, "<!--> -->");
}

TEST(Markup, WhatIsNotClosedReachesToTheEnd) {
  for (const char* text : {"<a x='>", "<a ", "<!-- --", "<![CDATA[ ]]", "<?xml ?", "<!DOCTYPE"}) {
    const Markup piece = ReadMarkup(text, 0);
    EXPECT_FALSE(piece.is_closed) << text;
    EXPECT_EQ(piece.end, std::string(text).size()) << text;
  }
}

}  // namespace
}  // namespace coppice
