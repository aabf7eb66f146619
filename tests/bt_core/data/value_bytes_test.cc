#include "bt_core/data/value_bytes.h"

#include <gtest/gtest.h>

#include <limits>

#include "bt_core/data/enum.h"
#include "bt_core/data/json.h"
#include "bt_core/data/standard_types.h"

namespace coppice {

enum class Mode : int { SLOW = 2, FAST = 7 };
struct Spot {
  double x = 0;
  std::string name;
};

template <>
struct ValueTraits<Spot> : JsonTraits<Spot> {
  static constexpr const char* kName = "Spot";
  template <class Fields, class S>
  static void List(Fields& fields, S& spot) {
    fields("x", spot.x)("name", spot.name);
  }
};

}  // namespace coppice

COPPICE_ENUM(coppice::Mode, SLOW, FAST)

namespace coppice {
namespace {

std::string BytesOf(const Value& value) {
  std::string bytes;
  AppendValueBytes(value, bytes);
  return bytes;
}

template <class T>
T RoundTrip(const T& value) {
  Value out;
  EXPECT_TRUE(ReadValueBytes(BytesOf(Value(value)), TypeOf<T>(), out));
  return out.has_value() ? out.Get<T>() : T();
}

TEST(ValueBytes, NumbersComeBackAsTheyWere) {
  EXPECT_EQ(RoundTrip(-5), -5);
  EXPECT_EQ(RoundTrip(std::numeric_limits<std::int64_t>::min()),
            std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(RoundTrip(std::numeric_limits<std::uint64_t>::max()),
            std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(RoundTrip(4000000000U), 4000000000U);
  EXPECT_EQ(RoundTrip(0.1), 0.1);
  EXPECT_EQ(RoundTrip(1.5F), 1.5F);
  EXPECT_EQ(RoundTrip(true), true);
}

TEST(ValueBytes, TextsComeBackByteForByte) {
  EXPECT_EQ(RoundTrip(std::string("a\0b\xff", 4)), std::string("a\0b\xff", 4));
  EXPECT_EQ(RoundTrip(std::string()), "");
}

TEST(ValueBytes, EnumsAreTheirNames) {
  EXPECT_EQ(PrintValueBytes(BytesOf(Value(Mode::FAST))), "FAST");
  EXPECT_EQ(RoundTrip(Mode::SLOW), Mode::SLOW);
}

TEST(ValueBytes, OtherTypesAreTheirJson) {
  const std::string bytes = BytesOf(Value(Spot{1.5, "door"}));
  EXPECT_EQ(FormOfValue(bytes), ValueForm::kJson);
  EXPECT_EQ(ValueBytesToJson(bytes), R"({"x":1.5,"name":"door"})");
  EXPECT_EQ(RoundTrip(Spot{1.5, "door"}).name, "door");
}

TEST(ValueBytes, NoValueIsOneByte) {
  EXPECT_EQ(BytesOf(Value()), std::string(1, '\0'));
  EXPECT_EQ(ValueBytesToJson(BytesOf(Value())), "null");
  Value out(3);
  EXPECT_FALSE(ReadValueBytes(BytesOf(Value()), TypeOf<int>(), out));
  EXPECT_FALSE(out.has_value());
}

TEST(ValueBytes, ATextIsQuotedInJson) {
  EXPECT_EQ(ValueBytesToJson(BytesOf(Value(std::string("a\"b")))), R"("a\"b")");
}

TEST(ValueBytes, AnotherTypeIsRefused) {
  Value out;
  EXPECT_FALSE(ReadValueBytes(BytesOf(Value(std::string("door"))), TypeOf<int>(), out));
  EXPECT_FALSE(ReadValueBytes(BytesOf(Value(-1)), TypeOf<unsigned>(), out));
}

TEST(ValueBytes, BytesThatNoValueHasAreNothing) {
  for (const std::string bytes : {"", "\x02", "\x03zz", "\x05", "\x09zzzzzzzz"}) {
    EXPECT_EQ(FormOfValue(bytes), ValueForm::kEmpty);
    EXPECT_TRUE(std::holds_alternative<std::monostate>(ReadPlainValue(bytes)));
    EXPECT_EQ(PrintValueBytes(bytes), "");
  }
}

}  // namespace
}  // namespace coppice
