#include "robot_app/storage/messages/message_to_json.h"

#include <coppice_msgs/Health.h>
#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <sensor_msgs/BatteryState.h>
#include <sensor_msgs/PointCloud2.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "robot_app/storage/messages/json_to_message.h"

namespace coppice::robot::storage {
namespace {

template <class Message>
std::string Bytes(const Message& message) {
  std::string bytes(ros::serialization::serializationLength(message), '\0');
  ros::serialization::OStream stream(reinterpret_cast<std::uint8_t*>(bytes.data()),
                                     static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  return bytes;
}

template <class Message>
MessageLayout LayoutOf() {
  return ParseDefinition(ros::message_traits::datatype<Message>(),
                         ros::message_traits::definition<Message>())
      .value();
}

template <class Message>
std::string Json(const Message& message, const JsonRules& rules = {}) {
  return MessageToJson(LayoutOf<Message>(), Bytes(message), rules).value();
}

std::string JsonOf(const std::string& definition, const std::string& bytes,
                   const JsonRules& rules = {}) {
  const auto json = MessageToJson(ParseDefinition("a/B", definition).value(), bytes, rules);
  return json ? *json : json.problem();
}

// There and back again.
template <class Message>
void ExpectSameAgain(const Message& message) {
  const auto back = JsonToMessage(LayoutOf<Message>(), Json(message), {});
  ASSERT_TRUE(back) << back.problem();
  EXPECT_EQ(back->bytes, Bytes(message));
  EXPECT_TRUE(back->is_whole);
}

TEST(MessageToJson, NamesEveryField) {
  coppice_msgs::Health health;
  health.header.seq = 7;
  health.header.stamp = ros::Time(12, 5);
  health.source = "/a \"monitor\"";
  health.entries.resize(1);
  health.entries[0].monitor = "topic";
  health.entries[0].level = 2;
  health.entries[0].value = 0.1;
  EXPECT_EQ(Json(health),
            R"({"header":{"seq":7,"stamp":{"secs":12,"nsecs":5},"frame_id":""},)"
            R"("source":"/a \"monitor\"","entries":[{"monitor":"topic","subject":"","node":"",)"
            R"("level":2,"value":0.1,"unit":"","message":"","stamp":{"secs":0,"nsecs":0},)"
            R"("host":""}]})");
}

TEST(MessageToJson, WritesFloatsWithAsFewDigitsAsTheyNeed) {
  sensor_msgs::BatteryState battery;
  battery.voltage = 25.3F;
  EXPECT_NE(Json(battery).find(R"("voltage":25.3,)"), std::string::npos) << Json(battery);
}

TEST(MessageToJson, SaysWhatIsNoNumber) {
  sensor_msgs::BatteryState battery;
  battery.voltage = std::numeric_limits<float>::infinity();
  battery.charge = std::nanf("");
  const std::string json = Json(battery);
  EXPECT_NE(json.find(R"("voltage":"Infinity")"), std::string::npos) << json;
  EXPECT_NE(json.find(R"("charge":"NaN")"), std::string::npos) << json;
  ExpectSameAgain(battery);
}

TEST(MessageToJson, KeepsNumbersToTheLastBit) {
  nav_msgs::Odometry odometry;
  odometry.pose.pose.position.x = 0.1 + 0.2;
  odometry.pose.pose.position.y = std::numeric_limits<double>::denorm_min();
  odometry.pose.pose.position.z = -std::numeric_limits<double>::max();
  odometry.pose.covariance[35] = 1.0 / 3;
  ExpectSameAgain(odometry);
}

TEST(MessageToJson, KeepsTextsThatAreNone) {
  coppice_msgs::Health health;
  health.source = std::string("a\0b", 3);
  health.header.frame_id = "\xff\xfe";
  EXPECT_NE(Json(health).find(R"({"base64":"//4="})"), std::string::npos) << Json(health);
  ExpectSameAgain(health);
  health.source = "Umlaut \xc3\xa4\n";
  ExpectSameAgain(health);
}

TEST(MessageToJson, WritesBytesInBase64) {
  sensor_msgs::PointCloud2 cloud;
  cloud.data = {0, 1, 2, 255};
  EXPECT_NE(Json(cloud).find(R"("data":"AAEC/w==")"), std::string::npos) << Json(cloud);
  ExpectSameAgain(cloud);
}

TEST(MessageToJson, LeavesLongArraysOut) {
  sensor_msgs::PointCloud2 cloud;
  cloud.width = 2000;
  cloud.data.resize(2000, 7);
  std::string kept;
  JsonRules rules;
  rules.keep = [&](std::string_view bytes) {
    kept = bytes;
    return "day/1.bin";
  };
  const std::string json = Json(cloud, rules);
  EXPECT_NE(json.find(R"("data":{"left_out":"uint8","length":2000,"file":"day/1.bin"})"),
            std::string::npos)
      << json;
  EXPECT_EQ(kept, std::string(2000, 7));

  const auto layout = LayoutOf<sensor_msgs::PointCloud2>();
  const auto back = JsonToMessage(layout, json, [&](const std::string&) { return kept; });
  EXPECT_EQ(back->bytes, Bytes(cloud));
  const auto without = JsonToMessage(layout, json, [](const std::string&) { return std::nullopt; });
  EXPECT_FALSE(without->is_whole);
  cloud.data.clear();
  EXPECT_EQ(without->bytes, Bytes(cloud));
}

TEST(MessageToJson, LeavesLongArraysOfTextsOut) {
  const std::string text("\x01\0\0\0x", 5);
  const std::string bytes = std::string("\x02\0\0\0", 4) + text + text + "y";
  JsonRules rules;
  rules.longest_array = 1;
  EXPECT_EQ(JsonOf("string[] a\nchar b", bytes, rules),
            R"({"a":{"left_out":"string","length":2},"b":121})");
}

const std::string kMany(4, '\xff');  // as a length

TEST(MessageToJson, RefusesAMessageThatDoesNotFitItsType) {
  EXPECT_EQ(JsonOf("int32 x", "abc"), "a message of a/B has too few bytes");
  EXPECT_EQ(JsonOf("int32 x", "abcde"), "a message of a/B has 1 bytes too many");
  EXPECT_EQ(JsonOf("string x", kMany), "a message of a/B has too few bytes");
  EXPECT_EQ(JsonOf("float64[] x", kMany), "a message of a/B has too few bytes");
  EXPECT_EQ(JsonOf("string[] x", kMany), "a message of a/B has too few bytes");
  EXPECT_EQ(JsonOf("string[4000000000] x", ""), "a message of a/B has too few bytes");
}

TEST(MessageToJson, TakesNoMoreTimeThanItsBytesCallForWhateverTheySay) {
  const std::string nothing = "\n" + std::string(80, '=') + "\nMSG: a/N\nM[4000000000] m\n" +
                              std::string(80, '=') + "\nMSG: a/M\n";
  EXPECT_EQ(JsonOf("N[] x" + nothing, kMany), R"({"x":{"left_out":"a/N","length":4294967295}})");
  const std::string blow = "N[900] x\n" + std::string(80, '=') + "\nMSG: a/N\nO[900] o\n" +
                           std::string(80, '=') + "\nMSG: a/O\nM[900] m\n" + std::string(80, '=') +
                           "\nMSG: a/M\n";
  EXPECT_EQ(JsonOf(blow, ""), "a message of a/B is too long");
}

TEST(MessageToJson, PassesElementsOfNothingAtOnce) {
  const std::string nothing = "\n" + std::string(80, '=') + "\nMSG: a/N\nM[4000000000] m\n" +
                              std::string(80, '=') + "\nMSG: a/M\nstring[0] s\n";
  EXPECT_EQ(JsonOf("N[] x" + nothing, kMany), R"({"x":{"left_out":"a/N","length":4294967295}})");
}

TEST(JsonToMessage, InventsNoGigabytesForWhatIsNotThere) {
  const std::string left_out = R"({"left_out":"uint8","length":60000000})";
  const auto problem = [&](const std::string& definition, const std::string& json) {
    return JsonToMessage(ParseDefinition("a/B", definition).value(), json, {}).problem();
  };
  EXPECT_EQ(problem("uint8[60000000] x", R"({"x":)" + left_out + "}"), "");
  EXPECT_EQ(problem("uint8[60000000] x\nuint8[60000000] y",
                    R"({"x":)" + left_out + R"(,"y":)" + left_out + "}"),
            "a/B: the message is too long");
  const std::string huge =
      "N[4294967295] x\n" + std::string(80, '=') + "\nMSG: a/N\nuint8[4294967295] y\n";
  EXPECT_EQ(problem(huge, R"({"x":)" + left_out + "}"), "a/B: the message is too long");
}

TEST(JsonToMessage, NamesTheMemberThatDoesNotFit) {
  const MessageLayout layout = ParseDefinition("a/B", "int32 x\nfloat64[2] y").value();
  EXPECT_EQ(JsonToMessage(layout, R"({"y":[1,2]})", {}).problem(), "a/B: \"x\" does not fit a/B");
  EXPECT_EQ(JsonToMessage(layout, R"({"x":"1","y":[1,2]})", {}).problem(),
            "a/B: \"x\" does not fit a/B");
  EXPECT_EQ(JsonToMessage(layout, R"({"x":1,"y":[1]})", {}).problem(),
            "a/B: \"y\" has a wrong length");
  EXPECT_FALSE(JsonToMessage(layout, "[", {}));
}

}  // namespace
}  // namespace coppice::robot::storage
