#include "editor/live/log_points.h"

#include <gtest/gtest.h>

namespace coppice::editor {
namespace {

std::string Again(const std::string& typed) {
  LogPoint point;
  const Outcome read = ReadLogPoint(typed, point);
  return read ? ToString(point) : read.problem();
}

TEST(LogPoints, AreTypedAsTextConditionAndHit) {
  LogPoint point;
  EXPECT_EQ(ReadLogPoint("to {goal}, {left} m if battery < 20 #3", point).problem(), "");
  EXPECT_EQ(point.text, "to {goal}, {left} m");
  EXPECT_EQ(point.condition, "battery < 20");
  EXPECT_EQ(point.from_hit, 3U);
  for (const char* same :
       {"to {goal}", "a if b #2", "if b", "a #2", "what if a if b", "room#3", ""}) {
    std::string again = Again(same);
    if (again.rfind(" if", 0) == 0) again.erase(0, 1);
    EXPECT_EQ(again, same);
  }
}

TEST(LogPoints, WhatCannotBeReadIsSaid) {
  EXPECT_EQ(Again("a #x"), "expected a number after #");
  EXPECT_EQ(Again("a #0"), "expected a number after #");
  EXPECT_EQ(Again("a if"), "expected a condition after if");
}

TEST(LogPoints, AreFoundByRunAndPathAndEveryChangeIsANewVersion) {
  LogPoints points;
  LogPoint point;
  point.run = "robot:1";
  point.path = "drive";
  points.Add(point);
  EXPECT_NE(points.FindAt("robot:1", "drive"), nullptr);
  EXPECT_EQ(points.FindAt("robot:2", "drive"), nullptr);
  const std::uint64_t version = points.version();
  point.text = "here";
  points.Change(points.all()[0].number, point);
  EXPECT_EQ(points.all()[0].text, "here");
  EXPECT_NE(points.version(), version);
  points.Remove(points.all()[0].number);
  EXPECT_TRUE(points.all().empty());
}

}  // namespace
}  // namespace coppice::editor
