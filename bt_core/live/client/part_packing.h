// The parts of a message of the live protocol as one message of a WebSocket, which knows no parts:
// each with its length before it (4 bytes, little endian).
#ifndef COPPICE_BT_CORE_LIVE_CLIENT_PART_PACKING_H_
#define COPPICE_BT_CORE_LIVE_CLIENT_PART_PACKING_H_

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace coppice {

/// No message of the protocol has more.
inline constexpr std::size_t kMaxPackedParts = 4;

std::string PackParts(const std::vector<std::string>& parts);

/// Any bytes may be handed in; none if they are no message: lengths that do not add up, no part, or
/// too many.
std::vector<std::string> UnpackParts(std::string_view message);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_CLIENT_PART_PACKING_H_
