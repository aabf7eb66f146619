#include "robot_app/common/parameters.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <xmlrpcpp/XmlRpcValue.h>

namespace coppice::robot {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Optional;
using XmlRpc::XmlRpcValue;

struct Settings {
  double speed = 0.7;
  int attempts = 3;
  std::uint64_t seed = 1;
  bool localization = true;
  std::string frame = "map";
  std::optional<Point2D> station;
  std::optional<Pose2D> start = Pose2D();
};

Parameters ParametersOf(Settings& settings) {
  return {{"speed", &settings.speed, 0.05, 3, "at most [m/s]"},
          {"attempts", &settings.attempts, 1, 20, "until it gives up"},
          {"seed", &settings.seed, 0, 1e9, "of the noise"},
          {"localization", &settings.localization, "publishes map -> odom"},
          {"frame", &settings.frame, "of the map"},
          {"station", &settings.station, "\"X Y\" on the map"},
          {"start", &settings.start, "\"X Y YAW\" at the start"}};
}

class ParametersTest : public testing::Test {
 protected:
  std::vector<std::string> Problems() { return ReadParameters(ParametersOf(settings_), given_); }

  Settings settings_;
  XmlRpcValue given_;
};

TEST_F(ParametersTest, KeepTheirDefaultsIfNothingIsGiven) {
  EXPECT_THAT(Problems(), IsEmpty());
  EXPECT_DOUBLE_EQ(settings_.speed, 0.7);
}

TEST_F(ParametersTest, GoWhereTheTableSays) {
  given_["speed"] = 0.4;
  given_["attempts"] = 5;
  given_["seed"] = 7;
  given_["localization"] = false;
  given_["frame"] = "world";
  given_["station"] = "-2.4 0";
  given_["start"] = "none";
  EXPECT_THAT(Problems(), IsEmpty());
  EXPECT_DOUBLE_EQ(settings_.speed, 0.4);
  EXPECT_EQ(settings_.attempts, 5);
  EXPECT_EQ(settings_.seed, 7u);
  EXPECT_FALSE(settings_.localization);
  EXPECT_EQ(settings_.frame, "world");
  EXPECT_THAT(settings_.station, Optional(testing::Field(&Point2D::x, -2.4)));
  EXPECT_EQ(settings_.start, std::nullopt);
}

TEST_F(ParametersTest, AWholeNumberIsANumber) {
  given_["speed"] = 1;
  EXPECT_THAT(Problems(), IsEmpty());
  EXPECT_DOUBLE_EQ(settings_.speed, 1);
}

TEST_F(ParametersTest, AMisspeltOneIsNamedWithTheNearest) {
  given_["sped"] = 0.4;
  EXPECT_THAT(Problems(), ElementsAre("unknown parameter ~sped (did you mean \"speed\"?)"));
}

TEST_F(ParametersTest, ANumberOutOfRangeKeepsTheDefault) {
  given_["speed"] = 50.0;
  EXPECT_THAT(Problems(), ElementsAre("~speed must be a number, 0.05..3, not 50"));
  EXPECT_DOUBLE_EQ(settings_.speed, 0.7);
}

TEST_F(ParametersTest, AWrongTypeIsSaid) {
  given_["attempts"] = 2.5;
  given_["frame"] = 7;
  given_["localization"] = "no";
  given_["speed"] = "fast";
  given_["start"] = "here";
  given_["station"] = "1";
  EXPECT_THAT(Problems(), ElementsAre("~attempts must be a whole number, 1..20, not 2.5",
                                      "~frame must be a text, not 7",
                                      "~localization must be true or false, not \"no\"",
                                      "~speed must be a number, 0.05..3, not \"fast\"",
                                      "~start must be \"X Y YAW\" or none, not \"here\"",
                                      "~station must be \"X Y\" or none, not \"1\""));
}

TEST_F(ParametersTest, AnEmptyTextIsNone) {
  given_["frame"] = "";
  EXPECT_THAT(Problems(), ElementsAre("~frame must be a text, not \"\""));
}

TEST_F(ParametersTest, AreExplainedInColumns) {
  const std::string text = Explain(ParametersOf(settings_));
  EXPECT_EQ(text.substr(0, text.find('\n')),
            "    ~speed                   0.7        0.05..3       at most [m/s]");
}

}  // namespace
}  // namespace coppice::robot
