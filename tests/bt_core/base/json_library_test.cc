#include "bt_core/base/json_library.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bt_core/base/json.h"

namespace coppice {
namespace {

std::string Nested(int depth) {
  return std::string(static_cast<std::size_t>(depth), '[') +
         std::string(static_cast<std::size_t>(depth), ']');
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
