// A ring of 32-bit words between one writing and one reading thread, without locks. Memory is taken
// once.
#ifndef COPPICE_BT_CORE_ENGINE_EVENTS_WORD_RING_H_
#define COPPICE_BT_CORE_ENGINE_EVENTS_WORD_RING_H_

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace coppice {

class WordRing {
 public:
  explicit WordRing(std::size_t capacity) : words_(capacity) {}

  /// Writing thread: how many words can be pushed now.
  std::size_t room() const {
    return words_.size() -
           (pushed_.load(std::memory_order_relaxed) - popped_.load(std::memory_order_acquire));
  }

  /// Writing thread: appends words, which the reader sees after Publish. There must be room.
  void Push(const std::uint32_t* words, std::size_t count) {
    const std::size_t at = unpublished_ % words_.size();
    const std::size_t to_end = words_.size() - at;
    const std::size_t first = count < to_end ? count : to_end;
    if (first > 0) std::memcpy(&words_[at], words, first * sizeof *words);
    if (count > first) std::memcpy(words_.data(), words + first, (count - first) * sizeof *words);
    unpublished_ += count;
  }
  void Publish() { pushed_.store(unpublished_, std::memory_order_release); }

  /// Reading thread: replaces `out` by everything that was published, and takes it out.
  void PopAll(std::vector<std::uint32_t>& out) {
    const std::size_t begin = popped_.load(std::memory_order_relaxed);
    const std::size_t end = pushed_.load(std::memory_order_acquire);
    out.resize(end - begin);
    const std::size_t at = begin % words_.size();
    const std::size_t to_end = words_.size() - at;
    const std::size_t first = out.size() < to_end ? out.size() : to_end;
    if (first > 0) std::memcpy(out.data(), &words_[at], first * sizeof(std::uint32_t));
    if (out.size() > first) {
      std::memcpy(&out[first], words_.data(), (out.size() - first) * sizeof(std::uint32_t));
    }
    popped_.store(end, std::memory_order_release);
  }

  /// Any thread: how many words were ever published.
  std::size_t published() const { return pushed_.load(std::memory_order_acquire); }

 private:
  std::vector<std::uint32_t> words_;
  std::size_t unpublished_ = 0;  // of the writing thread: ever pushed
  std::atomic<std::size_t> pushed_{0};
  std::atomic<std::size_t> popped_{0};
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_EVENTS_WORD_RING_H_
