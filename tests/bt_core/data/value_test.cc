#include "bt_core/data/value.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>
#include <utility>

namespace coppice {

struct Pose {  // does not fit inside a Value
  std::array<double, 6> numbers{};
};
struct Counted {  // tells how many there are
  static int alive;
  Counted() { ++alive; }
  Counted(const Counted&) { ++alive; }
  Counted& operator=(const Counted&) = default;
  ~Counted() { --alive; }
};
int Counted::alive = 0;

template <>
struct ValueTraits<Pose> {
  static constexpr const char* kName = "Pose";
  static bool Parse(std::string_view text, Pose& out) {
    return ValueTraits<double>::Parse(text, out.numbers[0]);
  }
  static std::string Print(const Pose& value) {
    return ValueTraits<double>::Print(value.numbers[0]);
  }
};
template <>
struct ValueTraits<Counted> {
  static constexpr const char* kName = "Counted";
  static bool Parse(std::string_view text, Counted&) { return text == "yes"; }
  static std::string Print(const Counted&) { return "yes"; }
};

namespace {

template <class T>
bool Parses(std::string_view text, T expected) {
  T value{};
  return ValueTraits<T>::Parse(text, value) && value == expected;
}
template <class T>
bool Rejects(std::string_view text) {
  T value{};
  return !ValueTraits<T>::Parse(text, value);
}

TEST(Value, IsEmptyAtFirst) {
  const Value value;
  EXPECT_FALSE(value.has_value());
  EXPECT_EQ(value.type(), nullptr);
  EXPECT_EQ(value.Print(), "");
}

TEST(Value, KnowsItsType) {
  const Value value(2.5);
  EXPECT_TRUE(value.Is<double>());
  EXPECT_FALSE(value.Is<int>());
  EXPECT_EQ(value.type(), &TypeOf<double>());
}

TEST(Value, ChangesItsTypeWhenSet) {
  Value value(1);
  value.Set(std::string("text"));
  EXPECT_EQ(value.Get<std::string>(), "text");
  value.Set(Pose{{7}});
  EXPECT_EQ(value.Get<Pose>().numbers[0], 7);
  value.Set(true);
  EXPECT_TRUE(value.Get<bool>());
}

TEST(Value, CopiesAreIndependent) {
  Value first(Pose{{1}});
  Value second(first);
  second.Get<Pose>().numbers[0] = 2;
  EXPECT_EQ(first.Get<Pose>().numbers[0], 1);
}

TEST(Value, MovesSmallAndLargeValues) {
  Value small(std::string(100, 'x'));
  EXPECT_EQ(Value(std::move(small)).Get<std::string>(), std::string(100, 'x'));
  Value large(Pose{{3}});
  EXPECT_EQ(Value(std::move(large)).Get<Pose>().numbers[0], 3);
}

TEST(Value, AssignsItselfWithoutHarm) {
  Value value(std::string("text"));
  const Value& same = value;
  value = same;
  EXPECT_EQ(value.Get<std::string>(), "text");
}

TEST(Value, AssigningAnEmptyValueEmpties) {
  Value value(5);
  value = Value();
  EXPECT_FALSE(value.has_value());
}

TEST(Value, DestroysWhatItHolds) {
  {
    Value value{Counted()};
    Value copy(value);
    copy.Set(1);
    EXPECT_EQ(Counted::alive, 1);
    value.Reset();
    EXPECT_EQ(Counted::alive, 0);
    value.Parse(TypeOf<Counted>(), "yes");
    EXPECT_EQ(Counted::alive, 1);
  }
  EXPECT_EQ(Counted::alive, 0);
}

TEST(Value, IsEmptyAfterAParseThatFails) {
  Value value(5);
  EXPECT_FALSE(value.Parse(TypeOf<Counted>(), "no"));
  EXPECT_FALSE(value.has_value());
  EXPECT_EQ(Counted::alive, 0);
}

TEST(Value, PrintsWhatItParses) {
  Value value;
  ASSERT_TRUE(value.Parse(TypeOf<double>(), " 0.1 "));
  EXPECT_EQ(value.Print(), "0.1");
}

TEST(ValueTraits, TakeTheSpellingsOfBool) {
  for (const char* yes : {"true", "True", "TRUE", "1", " true "}) EXPECT_TRUE(Parses(yes, true));
  for (const char* no : {"false", "False", "FALSE", "0"}) EXPECT_TRUE(Parses(no, false));
  for (const char* neither : {"", "yes", "2", "truee"}) EXPECT_TRUE(Rejects<bool>(neither));
}

TEST(ValueTraits, TakeWholeIntegersOnly) {
  EXPECT_TRUE(Parses("42", 42));
  EXPECT_TRUE(Parses(" -7\t", -7));
  EXPECT_TRUE(Parses("+7", 7));
  for (const char* bad : {"", " ", "+", "-", "+-5", "++5", "12abc", "1.5", "0x10", "2147483648"}) {
    EXPECT_TRUE(Rejects<int>(bad)) << bad;
  }
}

TEST(ValueTraits, TakeNoNegativeUnsigned) {
  EXPECT_TRUE(Parses("4294967295", 4294967295U));
  EXPECT_TRUE(Rejects<unsigned>("-1"));
  EXPECT_TRUE(Rejects<unsigned>("4294967296"));
  EXPECT_TRUE(Rejects<unsigned long>("-1"));
}

TEST(ValueTraits, TakeTheFullRangeOfLong) {
  EXPECT_TRUE(Parses("9223372036854775807", std::numeric_limits<long>::max()));
  EXPECT_TRUE(Parses("-9223372036854775808", std::numeric_limits<long>::min()));
  EXPECT_TRUE(Parses("18446744073709551615", std::numeric_limits<unsigned long>::max()));
}

TEST(ValueTraits, TakeWholeDoublesOnly) {
  EXPECT_TRUE(Parses("2.5", 2.5));
  EXPECT_TRUE(Parses(" -1e-3 ", -1e-3));
  for (const char* bad : {"", "2,5", "2.5m", "1 2", "a"}) EXPECT_TRUE(Rejects<double>(bad)) << bad;
  EXPECT_TRUE(
      Rejects<double>(std::string_view("1\0"
                                       "2",
                                       3)));
}

TEST(ValueTraits, DoublesReadBackTheSame) {
  for (const double value : {0.1, 1.0 / 3, 1e300, -0.0, 5e-324, 123456789.123456789, 2.0}) {
    EXPECT_TRUE(Parses(ValueTraits<double>::Print(value), value)) << value;
  }
  EXPECT_EQ(ValueTraits<double>::Print(0.1), "0.1");
  EXPECT_EQ(ValueTraits<double>::Print(1.0 / 3), "0.3333333333333333");
}

TEST(ValueTraits, KeepStringsAsTheyAre) {
  EXPECT_TRUE(Parses(" 00042 ", std::string(" 00042 ")));
  EXPECT_EQ(ValueTraits<std::string>::Print("a b"), "a b");
}

}  // namespace
}  // namespace coppice
