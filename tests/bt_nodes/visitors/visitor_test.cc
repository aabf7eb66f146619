#include "bt_nodes/visitors/visitor.h"

#include <gtest/gtest.h>

namespace coppice::leaves {
namespace {

using Traits = ValueTraits<Visitor>;

TEST(Visitor, ItsTextReadsAsTheSame) {
  const Visitor visitor{TimeFromNanoseconds(5), 2, 3, TimeFromNanoseconds(7), "a \"hall\"", "de"};
  Visitor read;
  ASSERT_TRUE(Traits::Parse(Traits::Print(visitor), read));
  EXPECT_EQ(Traits::Print(read), Traits::Print(visitor));
  EXPECT_EQ(read.place, "a \"hall\"");
  EXPECT_EQ(read.request, 3);
}

TEST(Visitor, WhatIsNoSuchTextIsRefused) {
  Visitor read;
  for (const char* text :
       {"", "{}", "[1]", "{\"heard\":1}",
        "{\"heard\":1,\"touches\":0,\"request\":\"x\",\"asked\":0,\"place\":\"\","
        "\"language\":\"en\"}"}) {
    EXPECT_FALSE(Traits::Parse(text, read)) << text;
  }
}

}  // namespace
}  // namespace coppice::leaves
