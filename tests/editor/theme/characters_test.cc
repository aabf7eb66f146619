#include "editor/theme/characters.h"

#include <gtest/gtest.h>

#include <string>

namespace coppice::editor {
namespace {

TEST(UnusualCharacters, AreThoseThatAreNotAlwaysBaked) {
  EXPECT_EQ(UnusualCharacters(""), CharacterSet());
  EXPECT_EQ(UnusualCharacters("Door? <a/> 100 % \xE2\x80\xA6"), CharacterSet());
  EXPECT_EQ(UnusualCharacters("T\xC3\xBCr \xE6\x88\xBF, T\xC3\xBCr"), (CharacterSet{0xFC, 0x623F}));
}

TEST(UnusualCharacters, AreFoundWhereverTheyStandInALongText) {
  for (std::size_t at = 0; at < 20; ++at) {
    std::string text(20, 'x');
    text.insert(at, "\xC3\xBC");
    EXPECT_EQ(UnusualCharacters(text), CharacterSet{0xFC}) << at;
  }
}

TEST(UnusualCharacters, AreNoIconsAndNothingThatIsNoCharacter) {
  for (const char* text :
       {"\xEF\x80\x82", "\xC2\x85", "cut off: \xC3", "\xF0\x9F\x9A\xAA", "\xFF"}) {
    EXPECT_EQ(UnusualCharacters(text), CharacterSet()) << text;
  }
}

TEST(WithAlphabets, BringsTheOtherLettersOfAnAlphabet) {
  const CharacterSet greek = WithAlphabets({0x03B1});
  EXPECT_EQ(greek.count(0x03C9), 1U);
  EXPECT_EQ(greek.count(0x0416), 0U);
  EXPECT_EQ(WithAlphabets({0x0416}).count(0x0436), 1U);
  EXPECT_EQ(WithAlphabets({0x623F}), CharacterSet{0x623F}) << "no alphabet";
  EXPECT_EQ(WithAlphabets(Alphabets()), Alphabets());
}

TEST(IsEastAsian, KnowsChineseJapaneseAndKorean) {
  for (const ImWchar code : {0x623F, 0x3042, 0xD55C, 0xFF01}) EXPECT_TRUE(IsEastAsian(code));
  for (const ImWchar code : {0x41, 0xFC, 0x0416, 0x2192}) EXPECT_FALSE(IsEastAsian(code));
}

}  // namespace
}  // namespace coppice::editor
