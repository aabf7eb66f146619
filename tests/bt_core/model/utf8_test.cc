#include "bt_core/model/utf8.h"

#include <gtest/gtest.h>

#include <string>

namespace coppice {
namespace {

TEST(Utf8, ValidTextHasNoBadByte) {
  const std::string text("a\0\xC3\xA9\xE2\x82\xAC\xED\x9F\xBF\xF0\x9F\x98\x80\xF4\x8F\xBF\xBF", 18);
  EXPECT_EQ(FindInvalidUtf8(text), text.size());
  EXPECT_EQ(FindInvalidUtf8(""), 0U);
}

TEST(Utf8, FindsTheFirstBadByte) {
  for (const char* bad : {"\xFC", "\x80", "\xC3", "\xC0\x80", "\xE0\x80\x80", "\xED\xA0\x80",
                          "\xF0\x80\x80\x80", "\xF4\x90\x80\x80", "\xE2\x82", "\xFF"}) {
    EXPECT_EQ(FindInvalidUtf8(std::string("a\xC3\xA9") + bad), 3U) << bad;
  }
}

TEST(Utf8, Utf16IsTold) {
  EXPECT_TRUE(LooksLikeUtf16(std::string("\xFF\xFE<\0", 4)));
  EXPECT_TRUE(LooksLikeUtf16(std::string("\xFE\xFF\0<", 4)));
  EXPECT_TRUE(LooksLikeUtf16(std::string("<\0r\0", 4)));
  EXPECT_TRUE(LooksLikeUtf16(std::string("\0<\0r", 4)));
  EXPECT_FALSE(LooksLikeUtf16("<root/>"));
  EXPECT_FALSE(LooksLikeUtf16("\xEF\xBB\xBF<root/>"));
  EXPECT_FALSE(LooksLikeUtf16(""));
}

TEST(PlainText, LosesWhatControlsOrIsNotSeen) {
  EXPECT_EQ(PlainText("\x1b[2Ja\n\tb\x7f", 100), "[2Jab");
  EXPECT_EQ(PlainText("a\u202eb\u200bc\ufeffd\u0085e\U000E0041f", 100), "abcdef");
}

TEST(PlainText, LosesWhatIsNoCharacter) {
  EXPECT_EQ(PlainText("a\xff\xc3z\xed\xa0\x80y\xe4\xba", 100), "azy");
}

TEST(PlainText, KeepsCharactersOfAllLanguages) {
  EXPECT_EQ(PlainText("Gr\u00fc\u00dfe \u5de1\u903b \U0001F600", 100),
            "Gr\u00fc\u00dfe \u5de1\u903b \U0001F600");
}

TEST(PlainText, CutsNoCharacterIntoPieces) {
  EXPECT_EQ(PlainText("abc\u5de1d", 5), "abc");
  EXPECT_EQ(PlainText("abc\u5de1d", 6), "abc\u5de1");
  EXPECT_EQ(PlainText("abc", 0), "");
}

}  // namespace
}  // namespace coppice
