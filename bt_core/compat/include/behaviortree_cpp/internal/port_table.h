// The ports of one node, resolved when its tree is made and found by name in a few instructions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "behaviortree_cpp/internal/cell.h"

namespace BT::internal {

/// A name as numbers: what is equal has equal ones, and up to 16 characters the other way round.
struct NameWords {
  static constexpr std::size_t kExact = 16;

  std::uint64_t head = 0;
  std::uint64_t tail = 0;
  std::size_t size = SIZE_MAX;  // of no name

  std::uint64_t Mix() const { return (head ^ (tail * 0x9e3779b97f4a7c15)) + size; }
  bool operator==(const NameWords& other) const {
    return ((head ^ other.head) | (tail ^ other.tail) | (size ^ other.size)) == 0;
  }
};

inline std::uint64_t HashLongName(std::string_view name) {
  std::uint64_t hash = 0;
  for (const char letter : name) hash = hash * 31 + static_cast<unsigned char>(letter);
  return hash;
}

/// The first and the last 8 bytes, or 4; they may overlap. No call: names are short.
inline NameWords WordsOf(std::string_view name) {
  const char* const first = name.data();
  const std::size_t size = name.size();
  NameWords words{0, 0, size};
  if (size >= sizeof(std::uint64_t)) {
    std::memcpy(&words.head, first, sizeof(std::uint64_t));
    std::memcpy(&words.tail, first + size - sizeof(std::uint64_t), sizeof(std::uint64_t));
    if (size > NameWords::kExact) words.head = HashLongName(name);
  } else if (size >= sizeof(std::uint32_t)) {
    std::uint32_t head;
    std::uint32_t tail;
    std::memcpy(&head, first, sizeof(head));
    std::memcpy(&tail, first + size - sizeof(tail), sizeof(tail));
    words.head = head;
    words.tail = tail;
  } else if (size > 0) {
    const auto byte = [first](std::size_t k) { return static_cast<unsigned char>(first[k]); };
    words.head = byte(0);
    words.tail = static_cast<std::uint64_t>(byte(size / 2) << 8 | byte(size - 1));
  }
  return words;
}

/// A port of one node: where it reads and where it writes.
struct PortLink {
  std::string name;
  const coppice::Slot* input = nullptr;  // of its key or its literal; null: nothing can be read
  std::shared_ptr<Cell> output;          // of its key; null: it is looked up
  NameWords words;                       // of the name
};

/// A table in which every port has a place of its own, so that one comparison finds it.
class PortTable {
 public:
  /// What finds no place is left out: it is looked up by name whenever it is used.
  void Fill(std::vector<PortLink> links);
  void Clear() { Fill({}); }

  /// Null if it is not there.
  const PortLink* Find(std::string_view name) const {
    const NameWords words = WordsOf(name);
    const PortLink& link = places_[(words.Mix() * factor_) >> shift_];
    if (!(link.words == words)) return nullptr;
    return words.size <= NameWords::kExact || link.name == name ? &link : nullptr;
  }

 private:
  bool Place(std::vector<PortLink>& links, std::size_t bits, std::uint64_t factor);

  std::vector<PortLink> places_{2};
  std::uint64_t factor_ = 1;
  std::uint8_t shift_ = 63;
};

}  // namespace BT::internal
