#include "bt_core/base/json_library.h"

#include <gtest/gtest.h>

#include <ctime>
#include <nlohmann/json.hpp>

#include "bt_core/base/json.h"

namespace coppice {
namespace {

std::string Nested(int depth) {
  return std::string(static_cast<std::size_t>(depth), '[') +
         std::string(static_cast<std::size_t>(depth), ']');
}

TEST(LimitedJson, TakesAListOfVeryManyObjectsInTheTimeOfItsLength) {
  std::string text = "[{}";
  for (std::size_t i = 2; i < kMostJsonValues; ++i) text += ",{}";
  const std::clock_t begin = std::clock();
  EXPECT_EQ(ParseLimitedJson(text + "]").size(), kMostJsonValues - 1);
  EXPECT_LT(std::clock() - begin, 10 * CLOCKS_PER_SEC);
}

TEST(LimitedJson, ReadsWhatTheLibraryReads) {
  EXPECT_EQ(ParseLimitedJson(R"({"a": [1, "x"]})")["a"][1], "x");
  EXPECT_EQ(ParseLimitedJson(Nested(kMaxJsonDepth)).size(), 1u);
}

TEST(LimitedJson, ThrowsTheTextOfTheLibrary) {
  try {
    ParseLimitedJson("{");
    FAIL();
  } catch (const std::exception& error) {
    EXPECT_EQ(std::string(error.what()).substr(0, 32), "[json.exception.parse_error.101]");
  }
}

TEST(LimitedJson, RefusesWhatIsNestedTooDeep) {
  EXPECT_THROW(ParseLimitedJson(Nested(kMaxJsonDepth + 2)), std::invalid_argument);
  EXPECT_THROW(ParseLimitedJson(std::string(1 << 20, '[')), std::invalid_argument);
}

// Of N zeros.
std::string Array(std::size_t count) {
  std::string text = "[0";
  for (std::size_t i = 1; i < count; ++i) text += ",0";
  return text + "]";
}

TEST(LimitedJson, RefusesMoreValuesThanThereIsMemoryFor) {
  EXPECT_EQ(ParseLimitedJson(Array(kMostJsonValues - 1)).size(), kMostJsonValues - 1);
  EXPECT_THROW(ParseLimitedJson(Array(kMostJsonValues)), std::invalid_argument);
  EXPECT_EQ(ParseLimitedJson(Array(kMostJsonValues), kMostOwnJsonValues).size(), kMostJsonValues);
  EXPECT_THROW(ParseLimitedJson(R"({"a": [{"b": 1}, 2]})", 4), std::invalid_argument);
  EXPECT_EQ(ParseLimitedJson(R"({"a": [{"b": 1}, 2]})", 5).size(), 1u);
}

TEST(LimitedJson, RefusesMessagePackOfMoreValues) {
  const auto nils = [](std::uint32_t count) {
    std::string bytes = "\xdd";
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(count >> shift);
    return bytes + std::string(count, '\xc0');
  };
  EXPECT_EQ(ReadLimitedMessagePack(nils(kMostJsonValues - 1)).size(), kMostJsonValues - 1);
  EXPECT_TRUE(ReadLimitedMessagePack(nils(kMostJsonValues)).is_discarded());
}

TEST(LimitedJson, ReadsMessagePackThatIsNotNestedTooDeep) {
  EXPECT_EQ(ReadLimitedMessagePack("\x81\xa1k\x93\x01\xc0\xa1x"),
            nlohmann::json({{"k", {1, nullptr, "x"}}}));
  const std::string inner = "\x01";
  EXPECT_FALSE(ReadLimitedMessagePack(std::string(kMaxJsonDepth, '\x91') + inner).is_discarded());
  EXPECT_TRUE(
      ReadLimitedMessagePack(std::string(kMaxJsonDepth + 1, '\x91') + inner).is_discarded());
  EXPECT_TRUE(ReadLimitedMessagePack(std::string(10 << 20, '\x91')).is_discarded());
  EXPECT_TRUE(ReadLimitedMessagePack("\x81\xa1k").is_discarded());
  EXPECT_TRUE(ReadLimitedMessagePack("").is_discarded());
}

}  // namespace
}  // namespace coppice
