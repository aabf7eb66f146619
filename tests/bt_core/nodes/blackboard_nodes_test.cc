#include "bt_core/nodes/blackboard_nodes.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace coppice {
namespace {

TEST(CopyTo, AnEmptySlotOfAnyTypeTakesTheValueAsItIs) {
  Slot slot;
  internal::CopyTo(slot, nullptr, Value(0.5));
  EXPECT_TRUE(slot.value.Is<double>());
}

TEST(CopyTo, ConvertsToTheTypeThatTheSlotHas) {
  Slot slot;
  internal::CopyTo(slot, &TypeOf<double>(), Value(std::string("2.5")));
  EXPECT_EQ(slot.value.Get<double>(), 2.5);
  internal::CopyTo(slot, nullptr, Value(3));  // the value there is a double already
  EXPECT_EQ(slot.value.Get<double>(), 3.0);
}

TEST(CopyTo, ASlotOfAnyTypeTakesWhatIsNotOfTheTypeThatItHas) {
  Slot slot;
  for (const Value& value : {Value(2), Value(2.5), Value(std::string("two"))}) {
    internal::CopyTo(slot, nullptr, value);
    EXPECT_EQ(slot.value.Print(), value.Print());
  }
}

TEST(CopyTo, RefusesWhatCannotBeConverted) {
  Slot slot;
  EXPECT_THROW(internal::CopyTo(slot, &TypeOf<int>(), Value(std::string("two"))),
               std::invalid_argument);
  EXPECT_FALSE(slot.value.has_value());
}

}  // namespace
}  // namespace coppice
