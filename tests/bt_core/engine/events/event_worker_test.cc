#include "bt_core/engine/events/event_worker.h"

#include <gtest/gtest.h>

#include <thread>

namespace coppice {
namespace {

class Counter : public EventListener {
 public:
  void OnState(const StreamState& state) override { states.push_back(state.tick); }
  void OnTick(const TickEvents& events) override {
    if (events.tick != ticks + 1) in_order = false;
    ticks = events.tick;
  }
  std::vector<std::uint64_t> states;
  std::uint64_t ticks = 0;
  bool in_order = true;
};

TickEvents Numbered(std::uint64_t tick, const std::uint32_t& word) {
  return {tick, Time(Duration(5)), Duration(6), Status::kRunning, true, {&word, 1}};
}

StreamState At(std::uint64_t tick) {
  StreamState state;
  state.tick = tick;
  return state;
}

TEST(EventWorker, StatesStandBetweenTheTicksWhereTheyWereGiven) {
  EventWorker worker(1 << 12);
  Counter counter;
  worker.Add(counter, At(0));
  const std::uint32_t word = 8;
  ASSERT_TRUE(worker.PushTick(Numbered(1, word)));
  worker.PushState(At(1));
  ASSERT_TRUE(worker.PushTick(Numbered(2, word)));
  worker.Remove(counter);
  EXPECT_EQ(counter.states, (std::vector<std::uint64_t>{0, 1}));
  EXPECT_EQ(counter.ticks, 2U);
}

TEST(EventWorker, ATickThatDoesNotFitIsRefused) {
  EventWorker worker(16);
  const std::vector<std::uint32_t> words(16, 8);
  TickEvents events = Numbered(1, words[0]);
  events.words = {words.data(), words.size()};
  EXPECT_FALSE(worker.PushTick(events));
}

TEST(EventWorker, HandsOverWhatIsThereBeforeItEnds) {
  Counter counter;
  {
    EventWorker worker(1 << 12);
    worker.Add(counter, At(0));
    const std::uint32_t word = 8;
    for (std::uint64_t i = 1; i <= 100; ++i) ASSERT_TRUE(worker.PushTick(Numbered(i, word)));
  }
  EXPECT_EQ(counter.ticks, 100U);
  EXPECT_TRUE(counter.in_order);
}

TEST(EventWorker, FlushesFromManyThreadsReturn) {
  EventWorker worker(1 << 12);
  Counter counter;
  worker.Add(counter, At(0));
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&worker] {
      for (int k = 0; k < 20; ++k) worker.Flush();
    });
  }
  const std::uint32_t word = 8;
  std::uint64_t pushed = 0;
  for (int i = 0; i < 1000; ++i) pushed += worker.PushTick(Numbered(pushed + 1, word));
  for (std::thread& thread : threads) thread.join();
  worker.Remove(counter);
  EXPECT_EQ(counter.ticks, pushed);
}

}  // namespace
}  // namespace coppice
