// The bytes of the Groot2 protocol, version 2: what a request is and how it is answered. Knows
// neither sockets nor trees.
//
// A request is one message part of six bytes (version, type, the client's number) and, for some
// types, a second part. The answer is a header of 22 bytes and, for some types, a second part; or,
// if something is wrong, the part "error" and a text for people. All numbers are little endian.
// Source: the wire format of BehaviorTree.CPP 4, loggers/groot2_protocol.h.
#ifndef COPPICE_BT_CORE_LIVE_GROOT2_GROOT2_PROTOCOL_H_
#define COPPICE_BT_CORE_LIVE_GROOT2_GROOT2_PROTOCOL_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/base/outcome.h"

namespace coppice::groot2 {

inline constexpr std::uint8_t kVersion = 2;
inline constexpr std::size_t kRequestHeaderSize = 6;
inline constexpr std::size_t kReplyHeaderSize = 22;

/// The largest number of nodes that a 16-bit node number can name.
inline constexpr std::size_t kMaxNodes = 65535;

/// The values are those on the wire.
enum class RequestType : char {
  kFullTree = 'T',
  kStatus = 'S',
  kBlackboard = 'B',   ///< argument: names separated by ';'
  kInsertHooks = 'I',  ///< argument: JSON
  kRemoveHook = 'R',   ///< argument: JSON
  kUnlock = 'U',       ///< argument: JSON
  kDumpHooks = 'D',
  kRemoveAllHooks = 'A',
  kDisableAllHooks = 'X',
  kToggleRecording = 'r',  ///< argument: "start" or "stop"
  kTransitions = 't',
  kBreakpointReached = 'N',  ///< only published
  kExtension = 'C',          ///< not of this protocol; argument: JSON
};

struct Request {
  RequestType type;
  std::uint32_t number;       ///< chosen by the client, echoed in the reply
  std::string_view argument;  ///< of the types that have one
};

/// Message parts as they go over the wire.
using Parts = std::vector<std::string>;

/// Takes a request apart; it looks into `parts`.
Expected<Request> ParseRequest(const Parts& parts);

/// The text of an error when a hook or its node is not there.
inline constexpr const char* kNoSuchNode = "Node ID not found";

/// The first part of every request.
std::string MakeHeader(char type, std::uint32_t number);

/// 16 random bytes that tell clients one run of a tree from another (a UUID, version 4).
using TreeId = std::array<char, 16>;
TreeId RandomTreeId();

Parts MakeReply(const Request& request, const TreeId& tree);
Parts MakeReply(const Request& request, const TreeId& tree, std::string payload);
Parts MakeError(std::string text);

/// Appends one node to the payload of a STATUS reply.
void AppendStatus(std::string& payload, std::uint16_t uid, std::uint8_t status);

/// "a;b" -> {"a", "b"}; empty names are left out.
std::vector<std::string_view> SplitNames(std::string_view names);

}  // namespace coppice::groot2

#endif  // COPPICE_BT_CORE_LIVE_GROOT2_GROOT2_PROTOCOL_H_
