#include "bt_core/analysis/json_writer.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

namespace coppice {
namespace {

using nlohmann::json;

TEST(JsonText, WritesAnyTextSoThatItCanBeReadBack) {
  for (const std::string text : {"", "plain", "\"quoted\" \\ and \n\t\x01\x7f",
                                 "n\xc3\xa4her \xe2\x82\xac \xf0\x9f\xa4\x96"}) {
    EXPECT_EQ(json::parse(JsonText(text)), text);
  }
}

TEST(JsonText, ReplacesBytesThatAreNotUtf8) {
  std::mt19937 random(4);
  for (int i = 0; i < 5000; ++i) {
    std::string text(random() % 12, '\0');
    for (char& c : text) c = static_cast<char>(random());
    EXPECT_NO_THROW(json::parse(JsonText(text))) << JsonText(text);
  }
}

TEST(JsonObject, IsOneObject) {
  JsonObject object;
  object.AddText("a", "b").Add("n", std::uint64_t{7}).AddBool("yes", true);
  object.Add("t", JsonSeconds(std::chrono::milliseconds(1500)));
  EXPECT_EQ(object.Finish(), "{\"a\":\"b\",\"n\":7,\"yes\":true,\"t\":1.500000000}");
}

}  // namespace
}  // namespace coppice
