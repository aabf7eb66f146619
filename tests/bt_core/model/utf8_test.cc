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

}  // namespace
}  // namespace coppice
