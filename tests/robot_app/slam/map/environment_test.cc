#include "robot_app/slam/map/environment.h"

#include <gtest/gtest.h>

namespace coppice::robot::slam {
namespace {

constexpr EnvironmentReading kOffice{2.5, 0, 0.5};
constexpr EnvironmentReading kBetween{5, 0, 0.5};
constexpr EnvironmentReading kHall{7, 0.1, 0.5};
constexpr EnvironmentReading kCampus{20, 0.7, 0.9};

Environment After(const EnvironmentReading& first, const EnvironmentReading& then, double seconds) {
  Environment environment;
  environment.Add(0, first);
  for (double stamp = 1; stamp <= seconds; ++stamp) environment.Add(stamp, then);
  return environment;
}

TEST(Environment, TheFirstReadingIsBelievedAtOnce) {
  EXPECT_EQ(After(kHall, kHall, 0).surroundings(), Surroundings::kHall);
}

TEST(Environment, AHallIsOneOnceItHasBeenOneForAWhile) {
  EXPECT_EQ(After(kOffice, kHall, 3).surroundings(), Surroundings::kIndoor);
  EXPECT_EQ(After(kOffice, kHall, 4).surroundings(), Surroundings::kHall);
}

TEST(Environment, BetweenTheLimitsItStaysWhatItWas) {
  EXPECT_EQ(After(kOffice, kBetween, 60).surroundings(), Surroundings::kIndoor);
  EXPECT_EQ(After(kHall, kBetween, 60).surroundings(), Surroundings::kHall);
}

TEST(Environment, ADoorwayDoesNotMakeItFlutter) {
  Environment environment;
  int changes = 0;
  Surroundings last = Surroundings::kIndoor;
  for (double stamp = 0; stamp < 60; ++stamp) {
    environment.Add(stamp, static_cast<int>(stamp) % 3 == 0 ? kHall : kOffice);
    changes += environment.surroundings() != last ? 1 : 0;
    last = environment.surroundings();
  }
  EXPECT_LE(changes, 2);  // the first reading, and away from it
}

TEST(Environment, WithoutWallsAndBrightItIsOutdoors) {
  EXPECT_EQ(After(kHall, kCampus, 10).surroundings(), Surroundings::kOutdoor);
  EnvironmentReading night = kCampus;
  night.brightness = 0.01;
  EXPECT_EQ(After(kHall, night, 10).surroundings(), Surroundings::kHall);
  EXPECT_TRUE(After(kHall, night, 10).is_dark());
}

TEST(Environment, WhereTimeIsSetBackItStillChanges) {
  Environment environment = After(kOffice, kOffice, 1000);
  environment.Add(1001, kHall);
  for (double stamp = 0; stamp <= 4; ++stamp) environment.Add(stamp, kHall);
  EXPECT_EQ(environment.surroundings(), Surroundings::kHall);
}

TEST(Environment, APersonMaySayWhatItIs) {
  Environment environment = After(kOffice, kOffice, 5);
  environment.Force(Surroundings::kOutdoor);
  EXPECT_EQ(environment.surroundings(), Surroundings::kOutdoor);
  environment.Force(std::nullopt);
  EXPECT_EQ(environment.surroundings(), Surroundings::kIndoor);
}

TEST(Environment, WhatIsReadOfACloudIsTheDistanceOfItsWalls) {
  CloudDescriptor cloud;
  for (std::size_t i = 0; i < kSectors; ++i) cloud.contour[i] = i % 4 == 0 ? 0 : 3;
  const EnvironmentReading reading = Read(cloud, 0.4);
  EXPECT_NEAR(reading.walls, 3, 1e-6);
  EXPECT_NEAR(reading.open, 0.25, 1e-6);
}

TEST(Environment, WhatIsAskedForIsFoundByItsName) {
  for (const auto one : {Surroundings::kIndoor, Surroundings::kHall, Surroundings::kOutdoor}) {
    EXPECT_EQ(*AskedSurroundings(NameOf(one)), one);
  }
  EXPECT_EQ(*AskedSurroundings("auto"), std::nullopt);
  EXPECT_EQ(AskedSurroundings("cellar").problem(),
            "surroundings: expected auto, indoor, hall or outdoor, not \"cellar\"");
  EXPECT_LT(AskedSurroundings(std::string(8'000'000, 'x')).problem().size(), 200u);  // for a log
}

TEST(Environment, TheRangeOfTheMapIsShortIndoors) {
  EXPECT_LT(ConfigurationFor(Surroundings::kIndoor).range,
            ConfigurationFor(Surroundings::kHall).range);
  EXPECT_LT(ConfigurationFor(Surroundings::kHall).range,
            ConfigurationFor(Surroundings::kOutdoor).range);
}

}  // namespace
}  // namespace coppice::robot::slam
