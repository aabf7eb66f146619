#include "bt_nodes/people/people_view.h"

#include <gtest/gtest.h>

namespace coppice::leaves {
namespace {

using Traits = ValueTraits<PeopleView>;

PeopleView TwoPeople() {
  PeopleView view;
  view.stamp = TimeFromNanoseconds(1500000000);
  view.people = {{7, 3, 0, 1.25, 4, 0, Mask::kWithout}, {9, 0, 2, 0, 0.5, 0.75, Mask::kUnknown}};
  return view;
}

TEST(PeopleView, ItsTextReadsAsTheSame) {
  PeopleView read;
  ASSERT_TRUE(Traits::Parse(Traits::Print(TwoPeople()), read));
  EXPECT_EQ(Traits::Print(read), Traits::Print(TwoPeople()));
  EXPECT_EQ(read.people.at(0).id, 7U);
  EXPECT_EQ(read.people.at(0).mask, Mask::kWithout);
  EXPECT_EQ(read.people.at(1).unseen_for, 0.75);
}

TEST(PeopleView, NobodyIsAnEmptyList) {
  EXPECT_EQ(Traits::Print({}), "{\"stamp\":0,\"people\":[]}");
}

TEST(PeopleView, WhatIsNoSuchTextIsRefused) {
  PeopleView view;
  for (const char* text :
       {"", "7", "{}", "{\"stamp\":1}", "{\"stamp\":1,\"people\":7}",
        "{\"stamp\":1,\"people\":[{\"id\":1}]}", "{\"stamp\":\"1\",\"people\":[]}",
        "{\"stamp\":1,\"people\":[{\"id\":-1,\"x\":0,\"y\":0,\"speed\":0,\"known_for\":0,"
        "\"unseen_for\":0,\"mask\":0}]}"}) {
    EXPECT_FALSE(Traits::Parse(text, view)) << text;
  }
}

TEST(PeopleView, TheNearestIsOneOfThoseWhoAreWanted) {
  const auto anybody = [](const SeenPerson&) { return true; };
  EXPECT_EQ(TwoPeople().Nearest(anybody)->id, 9U);
  EXPECT_EQ(TwoPeople().Nearest([](const SeenPerson& p) { return p.unseen_for == 0; })->id, 7U);
  EXPECT_EQ(TwoPeople().Nearest([](const SeenPerson& p) { return p.x > 5; }), nullptr);
  EXPECT_EQ(PeopleView().Nearest(anybody), nullptr);
}

}  // namespace
}  // namespace coppice::leaves
