#include "bt_core/frames/history_size.h"

#include <gtest/gtest.h>

namespace coppice {
namespace {

constexpr std::size_t kLong = 1 << 20;
const std::string kText(kLong, 'x');

TEST(HistorySize, CountsWhatIsLong) {
  TreeDescription tree;
  EXPECT_LT(BytesOf(tree), 1000U);
  tree.models = kText;
  tree.documents.push_back({kText, kText});
  tree.nodes.emplace_back().path = kText;
  tree.nodes.back().ports.push_back({kText, SlotIndex{0}});
  tree.slots.push_back({kText, kText, kText, true});
  EXPECT_GE(BytesOf(tree), 8 * kLong);
  EXPECT_LT(BytesOf(tree), 8 * kLong + 1000);
  HistoryState state;
  state.values.assign(3, kText);
  EXPECT_GE(BytesOf(state), 3 * kLong);
  EXPECT_GE(BytesOf(HistoryNote{Time{}, kText, kText}), 2 * kLong);
}

}  // namespace
}  // namespace coppice
