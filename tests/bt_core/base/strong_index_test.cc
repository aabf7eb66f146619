#include "bt_core/base/strong_index.h"

#include <gtest/gtest.h>

#include <unordered_set>
#include <vector>

#include "bt_core/data/inbox.h"
#include "bt_core/nodes/control.h"

namespace coppice {
namespace {

static_assert(sizeof(NodeIndex) == 4);
static_assert(std::is_trivially_copyable_v<NodeIndex>);
static_assert(!std::is_convertible_v<NodeIndex, SlotIndex>);
static_assert(!std::is_constructible_v<SlotIndex, NodeIndex>);
static_assert(!std::is_assignable_v<SlotIndex&, NodeIndex>);
static_assert(!std::is_convertible_v<std::uint32_t, NodeIndex>);
static_assert(std::is_convertible_v<NodeIndex, std::uint32_t>);

template <class A, class B, class = void>
constexpr bool kCanBeCompared = false;
template <class A, class B>
constexpr bool kCanBeCompared<A, B, std::void_t<decltype(std::declval<A>() == std::declval<B>())>> =
    true;
static_assert(kCanBeCompared<NodeIndex, NodeIndex>);
static_assert(!kCanBeCompared<NodeIndex, SlotIndex>);

template <class A, class B, class = void>
constexpr bool kHaveAnOrder = false;
template <class A, class B>
constexpr bool kHaveAnOrder<A, B, std::void_t<decltype(std::declval<A>() >= std::declval<B>())>> =
    true;
static_assert(kHaveAnOrder<NodeIndex, NodeIndex>);
static_assert(!kHaveAnOrder<NodeIndex, SlotIndex>);

TEST(StrongIndexTest, IsZeroAtFirst) { EXPECT_EQ(NodeIndex(), NodeIndex{0}); }

TEST(StrongIndexTest, CountsThroughAnArray) {
  const std::vector<int> values = {3, 4, 5};
  int sum = 0;
  for (NodeIndex node{0}; node < values.size(); ++node) sum += values[node];
  EXPECT_EQ(sum, 12);
}

TEST(StrongIndexTest, AndADistanceAreAnIndex) {
  constexpr NodeIndex kNode = NodeIndex{7} + 2;
  EXPECT_EQ(kNode, NodeIndex{9});
  EXPECT_EQ(kNode - 1, NodeIndex{8});
}

TEST(StrongIndexTest, IsAKeyOfASet) {
  const std::unordered_set<NodeIndex> nodes = {NodeIndex{1}, NodeIndex{2}, NodeIndex{1}};
  EXPECT_EQ(nodes.size(), 2u);
}

}  // namespace
}  // namespace coppice
