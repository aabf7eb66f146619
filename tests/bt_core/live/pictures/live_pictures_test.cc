#include "bt_core/live/pictures/live_pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace coppice {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

LivePicture Lamp(const std::string& name, std::uint8_t green) {
  return {name, "", 1, 1, {0, green, 0}};
}

// The names of those that are new.
std::vector<std::string> News(const LivePictures& pictures, std::uint64_t& seen) {
  std::vector<std::string> names;
  while (const auto picture = pictures.Next(seen)) names.push_back(picture->name);
  return names;
}

TEST(LivePictures, TellsEachWatcherWhatIsNewToHim) {
  LivePictures pictures;
  std::uint64_t early = 0;
  EXPECT_THAT(News(pictures, early), IsEmpty());
  EXPECT_TRUE(pictures.Show(Lamp("ears", 1)));
  EXPECT_TRUE(pictures.Show(Lamp("arms", 1)));
  EXPECT_THAT(News(pictures, early), ElementsAre("ears", "arms"));
  EXPECT_TRUE(pictures.Show(Lamp("ears", 2)));
  EXPECT_THAT(News(pictures, early), ElementsAre("ears"));
  std::uint64_t late = 0;
  EXPECT_THAT(News(pictures, late), ElementsAre("arms", "ears"));
}

TEST(LivePictures, OnlyTheNewestOfANameIsTold) {
  LivePictures pictures;
  EXPECT_TRUE(pictures.Show(Lamp("ears", 1)));
  EXPECT_TRUE(pictures.Show(Lamp("ears", 2)));
  std::uint64_t seen = 0;
  EXPECT_EQ(pictures.Next(seen), Lamp("ears", 2));
  EXPECT_FALSE(pictures.Next(seen));
}

TEST(LivePictures, WhatIsShownAgainIsNoNews) {
  LivePictures pictures;
  EXPECT_TRUE(pictures.Show(Lamp("ears", 1)));
  std::uint64_t seen = 0;
  EXPECT_THAT(News(pictures, seen), ElementsAre("ears"));
  EXPECT_TRUE(pictures.Show(Lamp("ears", 1)));
  EXPECT_THAT(News(pictures, seen), IsEmpty());
}

TEST(LivePictures, WhatIsRefusedChangesNothing) {
  LivePictures pictures;
  EXPECT_TRUE(pictures.Show(Lamp("ears", 1)));
  EXPECT_FALSE(pictures.Show({"ears", "", 2, 2, {}}));
  std::uint64_t seen = 0;
  EXPECT_EQ(pictures.Next(seen), Lamp("ears", 1));
}

}  // namespace
}  // namespace coppice
