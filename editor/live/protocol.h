// The Groot2 protocol (version 2) as bytes: what the editor asks a robot, and how it reads the
// answers. Integers are little endian. Nothing here trusts the peer: every reader returns nothing
// if the bytes are not what the protocol says.
//
// Request: 6 bytes header (version, type, 32-bit number chosen by the client) and for some types a
// second part. Answer: 22 bytes header (the same 6 and the 16-byte id of the tree) and a payload;
// or the two parts "error" and a text.
#ifndef COPPICE_EDITOR_LIVE_PROTOCOL_H_
#define COPPICE_EDITOR_LIVE_PROTOCOL_H_

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/base/status.h"

namespace coppice::editor {

enum class RequestType : char { kFullTree = 'T', kStatus = 'S', kBlackboard = 'B' };

using TreeId = std::array<std::uint8_t, 16>;  ///< changes when the robot runs another tree

std::string EncodeRequest(RequestType type, std::uint32_t number);

struct Reply {
  TreeId tree_id{};
  std::string payload;
};

/// Checks that the parts of an answer belong to that request. Otherwise nothing is returned and
/// `error` says why, with the robot's own words if it sent an error.
std::optional<Reply> DecodeReply(const std::vector<std::string>& parts, RequestType type,
                                 std::uint32_t number, std::string& error);

struct NodeStatus {
  std::uint16_t uid = 0;
  Status status = Status::kIdle;
  Status before = Status::kIdle;  ///< of an idle node: its last status, kIdle if it never ran
};

/// Three bytes per node. Nothing if the length is no multiple of three or a status is unknown.
std::optional<std::vector<NodeStatus>> DecodeStatuses(std::string_view payload);

struct BoardEntry {
  std::string key;
  std::string value;  ///< as JSON
};
struct Board {
  std::string name;
  std::vector<BoardEntry> entries;  ///< in alphabetical order
};

/// A MessagePack map of maps. Nothing if it is not one.
std::optional<std::vector<Board>> DecodeBoards(std::string_view payload);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_LIVE_PROTOCOL_H_
