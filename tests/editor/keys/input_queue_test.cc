#include "editor/keys/input_queue.h"

#include <gtest/gtest.h>

namespace coppice::editor {
namespace {

TEST(InputQueue, SpreadsAShortTapOverTwoFrames) {
  InputQueue queue;
  queue.Add({KeyEvent{'C', true}, KeyEvent{'C', false}});
  EXPECT_EQ(queue.TakeFrame().size(), 1U);
  EXPECT_TRUE(queue.pending());
  EXPECT_EQ(queue.TakeFrame().size(), 1U);
  EXPECT_FALSE(queue.pending());
}

TEST(InputQueue, LosesNoTapHoweverMany) {
  InputQueue queue;
  std::vector<InputEvent> taps;
  for (int i = 0; i < 10; ++i) {
    taps.push_back(KeyEvent{kKeyF1, true});
    taps.push_back(KeyEvent{kKeyF1, false});
  }
  queue.Add(taps);
  int presses = 0;
  while (queue.pending()) {
    for (const InputEvent& event : queue.TakeFrame()) {
      presses += std::get<KeyEvent>(event).down;
    }
  }
  EXPECT_EQ(presses, 10);
}

TEST(InputQueue, GivesDifferentKeysInOneFrame) {
  InputQueue queue;
  queue.Add({KeyEvent{'A', true}, KeyEvent{'B', true}, TypedText{"ab"}});
  EXPECT_EQ(queue.TakeFrame().size(), 3U);
}

// Fast fingers let Ctrl go before the letter, within one frame.
TEST(InputQueue, AKeyIsSeenWithTheModifiersThatItHad) {
  constexpr Key kLeftCtrl = 341;
  InputQueue queue;
  queue.Add({KeyEvent{kLeftCtrl, true}, KeyEvent{'A', true, kCtrl},
             KeyEvent{kLeftCtrl, false, kCtrl}, KeyEvent{'A', false}});
  EXPECT_EQ(queue.TakeFrame().size(), 2U);
  EXPECT_EQ(queue.TakeFrame().size(), 2U);
  queue.Add({KeyEvent{'B', true}, KeyEvent{kLeftCtrl, true}, MouseButton{0, true},
             KeyEvent{kLeftCtrl, false, kCtrl}});
  EXPECT_EQ(queue.TakeFrame().size(), 1U);  // B alone
  EXPECT_EQ(queue.TakeFrame().size(), 2U);  // a click with Ctrl
  EXPECT_EQ(queue.TakeFrame().size(), 1U);
  queue.Add({KeyEvent{kLeftCtrl, true}, MouseWheel{0, 1}, KeyEvent{kLeftCtrl, false, kCtrl}});
  EXPECT_EQ(queue.TakeFrame().size(), 2U);
}

TEST(InputQueue, KeepsTheMouseWhereTheButtonWasPressed) {
  InputQueue queue;
  queue.Add({MouseMove{1, 1}, MouseButton{0, true}, MouseMove{2, 2}, MouseButton{0, false}});
  EXPECT_EQ(queue.TakeFrame().size(), 2U);
  const std::vector<InputEvent> second = queue.TakeFrame();
  ASSERT_EQ(second.size(), 2U);
  EXPECT_EQ(std::get<MouseMove>(second[0]).x, 2);
}

}  // namespace
}  // namespace coppice::editor
