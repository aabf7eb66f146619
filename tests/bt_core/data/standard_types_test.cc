#include "bt_core/data/standard_types.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "bt_core/data/value.h"

namespace coppice {
namespace {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;
using std::chrono::seconds;

// "no" or what the value prints.
template <class T>
std::string Reads(std::string_view text) {
  T value{};
  return ValueTraits<T>::Parse(text, value) ? ValueTraits<T>::Print(value) : "no";
}

TEST(Lists, AreSeparatedBySemicolons) {
  EXPECT_EQ(Reads<std::vector<int>>("1;-2; 3 "), "1;-2;3");
  EXPECT_EQ(Reads<std::vector<double>>("1;2.5"), "1;2.5");
  EXPECT_EQ(Reads<std::vector<bool>>("true;0;False"), "true;false;false");
  EXPECT_EQ(Reads<std::vector<std::string>>("a b;;c"), "a b;;c");
  EXPECT_EQ(Reads<std::vector<int>>("7"), "7");
}

TEST(Lists, MayBeEmpty) {
  std::vector<int> list = {1};
  EXPECT_TRUE(ValueTraits<std::vector<int>>::Parse("", list));
  EXPECT_TRUE(list.empty());
  EXPECT_EQ(ValueTraits<std::vector<int>>::Print(list), "");
}

TEST(Lists, TakeWholeElementsOnly) {
  for (const char* bad : {";", "1;", ";1", "1;;2", "1,2", "12abc", "1;x"}) {
    EXPECT_EQ(Reads<std::vector<int>>(bad), "no") << bad;
  }
}

TEST(Durations, HaveAUnit) {
  EXPECT_EQ(Reads<nanoseconds>("250ms"), "250ms");
  EXPECT_EQ(Reads<nanoseconds>(" 1.5 s "), "1500ms");
  EXPECT_EQ(Reads<nanoseconds>("90s"), "90s");
  EXPECT_EQ(Reads<nanoseconds>("-2min"), "-2min");
  EXPECT_EQ(Reads<nanoseconds>("0.1us"), "100ns");
  EXPECT_EQ(Reads<nanoseconds>("0h"), "0s");
  EXPECT_EQ(Reads<seconds>("2h"), "2h");
  for (const char* bad : {"", "5", "ms", "5 m", "5 s s", "s5", "1e9h", "nan s"}) {
    EXPECT_EQ(Reads<nanoseconds>(bad), "no") << bad;
  }
}

TEST(Durations, AreNotRounded) {
  EXPECT_EQ(Reads<milliseconds>("1.5s"), "1500ms");
  EXPECT_EQ(Reads<seconds>("1.5s"), "no");
  EXPECT_EQ(Reads<milliseconds>("10us"), "no");
}

TEST(Durations, ReadBackTheSame) {
  for (const std::int64_t count : {std::numeric_limits<std::int64_t>::max(), std::int64_t{-1},
                                   std::numeric_limits<std::int64_t>::min(), std::int64_t{86400}}) {
    nanoseconds read{};
    EXPECT_TRUE(ValueTraits<nanoseconds>::Parse(PrintDuration(nanoseconds(count)), read));
    EXPECT_EQ(read.count(), count);
  }
}

TEST(StatusType, IsReadByName) {
  EXPECT_EQ(Reads<Status>("SUCCESS"), "SUCCESS");
  EXPECT_EQ(Reads<Status>("3"), "FAILURE");
  EXPECT_EQ(Reads<Status>("success"), "no");
  for (const Enumerator& enumerator : EnumeratorsOf<Status>()) {
    EXPECT_EQ(enumerator.name, ToString(static_cast<Status>(enumerator.value)));
  }
}

TEST(FloatType, KeepsItsShortText) {
  EXPECT_EQ(Reads<float>("0.1"), "0.1");
  EXPECT_EQ(Reads<float>("16777217"), "16777216");
  EXPECT_EQ(Reads<float>("0.1f"), "no");
}

}  // namespace
}  // namespace coppice
