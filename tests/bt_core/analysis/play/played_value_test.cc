#include "bt_core/analysis/play/played_value.h"

#include <gtest/gtest.h>

#include <string>

#include "bt_core/data/value_bytes.h"

namespace coppice {
namespace {

template <class T>
std::string BytesOf(const T& content) {
  Value value;
  value.Set(content);
  std::string bytes;
  AppendValueBytes(value, bytes);
  return bytes;
}

TEST(PlayedValue, IsOfTheTypeThatIsAskedFor) {
  const Value value = PlayedValue(BytesOf(2.5), &TypeOf<double>());
  ASSERT_TRUE(value.has_value());
  EXPECT_EQ(value.Print(), "2.5");
  EXPECT_EQ(value.type(), &TypeOf<double>());
}

TEST(PlayedValue, WithoutATypeItIsWhatTheBytesAre) {
  EXPECT_EQ(PlayedValue(BytesOf(std::string("lab")), nullptr).Print(), "lab");
  EXPECT_EQ(PlayedValue(BytesOf(true), nullptr).Print(), "true");
  EXPECT_EQ(PlayedValue(BytesOf(std::int64_t{7}), nullptr).Print(), "7");
}

TEST(PlayedValue, BytesThatAreNoneAreEmpty) {
  EXPECT_FALSE(PlayedValue("", nullptr).has_value());
  EXPECT_FALSE(PlayedValue("", &TypeOf<double>()).has_value());
  EXPECT_FALSE(PlayedValue(BytesOf(std::string("lab")), &TypeOf<double>()).has_value());
}

}  // namespace
}  // namespace coppice
