#include "robot_app/app/crowd_figures.h"

#include <gtest/gtest.h>

namespace coppice::robot {
namespace {

using coppice_msgs::Person;

Person Somebody(std::uint32_t id, double speed, std::uint8_t mask = Person::MASK_UNKNOWN,
                float unseen_for = 0) {
  Person person;
  person.id = id;
  person.velocity.y = speed;
  person.mask = mask;
  person.unseen_for = unseen_for;
  return person;
}

TEST(CrowdFigures, TheCrowdIsHowManyAreSeenAtOnceInTheMean) {
  CrowdFigures figures;
  coppice_msgs::People people;
  figures.Add(people);
  people.people = {Somebody(1, 0), Somebody(2, 1.2), Somebody(3, 0.1)};
  figures.Add(people);
  EXPECT_DOUBLE_EQ(figures.crowd(), 1.5);
  EXPECT_EQ(figures.most, 3);
}

TEST(CrowdFigures, LivelyIsWhereManyMove) {
  CrowdFigures figures;
  coppice_msgs::People people;
  people.people = {Somebody(1, 0), Somebody(2, 1.2), Somebody(3, 0.5), Somebody(4, 0)};
  figures.Add(people);
  EXPECT_DOUBLE_EQ(figures.liveliness(), 0.5);
}

TEST(CrowdFigures, WhoIsOnlyRememberedIsFollowedButNotSeen) {
  CrowdFigures figures;
  coppice_msgs::People people;
  people.people = {Somebody(1, 1, Person::MASK_UNKNOWN, 2)};
  figures.Add(people);
  EXPECT_EQ(figures.masks.size(), 1U);
  EXPECT_EQ(figures.crowd(), 0);
}

TEST(CrowdFigures, NobodyEverIsNoCrowd) {
  EXPECT_EQ(ToText({}),
            "0 followed, faces: 0 with mask, 0 without; crowd: 0.0 at once, at most 0, "
            "0 % of them moving");
}

TEST(CrowdFigures, AMaskOnceKnownIsNotForgotten) {
  CrowdFigures figures;
  coppice_msgs::People people;
  people.people = {Somebody(1, 0, Person::WITH_MASK), Somebody(2, 0, Person::WITHOUT_MASK)};
  figures.Add(people);
  people.people = {Somebody(1, 0), Somebody(2, 0)};
  figures.Add(people);
  EXPECT_NE(ToText(figures).find("faces: 1 with mask, 1 without"), std::string::npos);
}

}  // namespace
}  // namespace coppice::robot
