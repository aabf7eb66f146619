#include "behaviortree_cpp/internal/port_table.h"

namespace BT::internal {

namespace {
constexpr std::size_t kMostBits = 12;  // far more than any node has ports
constexpr int kFactors = 16;
}  // namespace

void PortTable::Fill(std::vector<PortLink> links) {
  for (PortLink& link : links) link.words = WordsOf(link.name);
  std::size_t bits = 1;
  while (bits < kMostBits && (std::size_t{1} << bits) < links.size()) ++bits;
  for (; bits <= kMostBits; ++bits) {
    for (int k = 0; k < kFactors; ++k) {
      if (Place(links, bits, 0x9e3779b97f4a7c15 + (2 * static_cast<std::uint64_t>(k) << 40)))
        return;
    }
  }
}

// False if two of them would share a place.
bool PortTable::Place(std::vector<PortLink>& links, std::size_t bits, std::uint64_t factor) {
  const auto shift = static_cast<std::uint8_t>(64 - bits);
  std::vector<bool> taken(std::size_t{1} << bits);
  for (const PortLink& link : links) {
    auto place = taken[(link.words.Mix() * factor) >> shift];
    if (place) return false;
    place = true;
  }
  places_.assign(taken.size(), PortLink{});
  factor_ = factor;
  shift_ = shift;
  for (PortLink& link : links) places_[(link.words.Mix() * factor) >> shift] = std::move(link);
  return true;
}

}  // namespace BT::internal
