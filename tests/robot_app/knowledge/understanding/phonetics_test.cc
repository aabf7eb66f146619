#include "robot_app/knowledge/understanding/phonetics.h"

#include <gtest/gtest.h>

namespace coppice::robot::knowledge {
namespace {

TEST(ColognePhonetics, TheExamplesOfTheLiteratureHaveTheirCodes) {
  EXPECT_EQ(ColognePhonetics("wikipedia"), "3412");
  EXPECT_EQ(ColognePhonetics("muellerluedenscheidt"), "65752682");
  EXPECT_EQ(ColognePhonetics("breschnew"), "17863");
  EXPECT_EQ(ColognePhonetics("xaver"), "4837");
  EXPECT_EQ(ColognePhonetics("christen"), "47826");
}

TEST(ColognePhonetics, NamesThatSoundAlikeHaveOneCode) {
  for (const char* name : {"meyer", "maier", "mayer", "meier"}) {
    EXPECT_EQ(ColognePhonetics(name), "67") << name;
  }
  EXPECT_EQ(ColognePhonetics("schmidt"), ColognePhonetics("schmitt"));
  EXPECT_NE(ColognePhonetics("weber"), ColognePhonetics("becker"));
}

TEST(DoubleMetaphone, TheExamplesOfTheLiteratureHaveTheirCodes) {
  EXPECT_EQ(DoubleMetaphone("smith").primary, "SM0");
  EXPECT_EQ(DoubleMetaphone("smith").other, "XMT");
  EXPECT_EQ(DoubleMetaphone("schmidt").primary, "XMT");
  EXPECT_EQ(DoubleMetaphone("thompson").primary.substr(0, 1), "0");
  EXPECT_EQ(DoubleMetaphone("knight").primary, "NT");
  EXPECT_EQ(DoubleMetaphone("station").primary, "STXN");
  EXPECT_EQ(DoubleMetaphone("laugh").primary, "LF");
}

TEST(DoubleMetaphone, WordsThatSoundAlikeHaveOneCode) {
  EXPECT_EQ(DoubleMetaphone("phone").primary, DoubleMetaphone("fone").primary);
  EXPECT_EQ(DoubleMetaphone("library").primary, DoubleMetaphone("librery").primary);
  EXPECT_EQ(DoubleMetaphone("write").primary, DoubleMetaphone("rite").primary);
}

TEST(Phonetics, WhatHasNoSoundHasNoCode) {
  EXPECT_EQ(ColognePhonetics(""), "");
  EXPECT_EQ(ColognePhonetics("103"), "");
  EXPECT_EQ(DoubleMetaphone("103").primary, "");
}

}  // namespace
}  // namespace coppice::robot::knowledge
