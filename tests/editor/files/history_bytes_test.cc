#include "editor/files/history_bytes.h"

#include <gtest/gtest.h>

namespace coppice::editor {
namespace {

StoredHistory Example() {
  StoredHistory history;
  history.texts = {DescribeText("/a.xml", "<root/>")};
  for (const char* name : {"one", "two", "three"}) {
    Step step;
    step.name = name;
    step.files = {{"/a.xml", {{{3, 2, "inserted\n\xFF"}}}, {{{3, 10, "ab"}}}, {}, {}}};
    step.selected_before = {{"/a.xml", 7}};
    step.selected_after = {{"/a.xml", 9}, {"/b.xml", 1}};
    history.steps.push_back(step);
  }
  history.done = 2;
  return history;
}

TEST(HistoryBytes, ReadsWhatItHasWritten) {
  const auto read = ReadHistory(WriteHistory(Example(), 1 << 20));
  ASSERT_TRUE(read);
  ASSERT_EQ(read->steps.size(), 3U);
  EXPECT_EQ(read->done, 2U);
  EXPECT_EQ(read->steps[2].name, "three");
  EXPECT_EQ(read->steps[1].files[0].forward[0][0].inserted, "inserted\n\xFF");
  EXPECT_EQ(read->steps[1].files[0].back[0][0].removed, 10U);
  EXPECT_EQ(read->steps[0].selected_after[1].path, "/b.xml");
  EXPECT_TRUE(IsText(read->texts[0], "<root/>"));
  EXPECT_FALSE(IsText(read->texts[0], "<tree/>"));
}

TEST(HistoryBytes, LeavesOutWhatIsFarAwayIfItGrowsTooLarge) {
  const std::size_t one_step = WriteHistory(Example(), 1 << 20).size() / 3;
  const auto read = ReadHistory(WriteHistory(Example(), one_step + one_step / 2));
  ASSERT_TRUE(read);
  ASSERT_EQ(read->steps.size(), 1U);
  EXPECT_EQ(read->steps[0].name, "two") << "the one to undo next";
  EXPECT_EQ(read->done, 1U);
}

TEST(HistoryBytes, RefusesEveryBeginningAndEveryChangedByte) {
  const std::string bytes = WriteHistory(Example(), 1 << 20);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    EXPECT_FALSE(ReadHistory(bytes.substr(0, i))) << i;
    std::string changed = bytes;
    changed[i] = static_cast<char>(changed[i] ^ 0x20);
    EXPECT_FALSE(ReadHistory(changed)) << i;
  }
}

}  // namespace
}  // namespace coppice::editor
