#include "robot_app/knowledge/store/folded_text.h"

#include <gtest/gtest.h>

namespace coppice::robot::knowledge {
namespace {

TEST(FoldedText, CapitalsAccentsAndSignsMakeNoDifference) {
  EXPECT_EQ(Folded("Hörsaal A!"), "hoersaal a");
  EXPECT_EQ(Folded("HÖRSAAL   a"), "hoersaal a");
  EXPECT_EQ(Folded("Lefèvre, Yılmaz & Straße"), "lefevre yilmaz strasse");
}

TEST(FoldedText, AnApostropheDoesNotPartAWord) {
  EXPECT_EQ(Folded("what's"), "whats");
  EXPECT_EQ(Folded("geht\u2019s"), "gehts");
}

TEST(FoldedText, AnyBytesAreATextOfSpaces) {
  EXPECT_EQ(Folded("a\xff\xfe b\xc3"), "a b");
  EXPECT_EQ(Folded("\xe6\x97\xa5"), "");
}

TEST(FoldedText, WordsAreItsParts) {
  EXPECT_EQ(Words(" Where is room-101? "),
            (std::vector<std::string>{"where", "is", "room", "101"}));
}

}  // namespace
}  // namespace coppice::robot::knowledge
