#include "editor/live/protocol.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace coppice::editor {
namespace {

constexpr char kVersion = 2;
constexpr std::size_t kRequestHeader = 6;
constexpr std::size_t kReplyHeader = 22;
constexpr std::size_t kBytesPerNode = 3;
constexpr std::uint8_t kIdleOffset = 10;  // added to the last status of an idle node

std::optional<NodeStatus> DecodeStatus(const unsigned char* bytes) {
  NodeStatus node;
  node.uid = static_cast<std::uint16_t>(bytes[0] | (bytes[1] << 8));
  const std::uint8_t code = bytes[2];
  if (code <= static_cast<std::uint8_t>(Status::kSkipped)) {
    node.status = static_cast<Status>(code);
  } else if (code > kIdleOffset &&
             code <= kIdleOffset + static_cast<std::uint8_t>(Status::kSkipped)) {
    node.before = static_cast<Status>(code - kIdleOffset);
  } else {
    return std::nullopt;
  }
  return node;
}

Board ReadBoard(const std::string& name, const nlohmann::json& values) {
  Board board;
  board.name = name;
  if (!values.is_object()) return board;
  for (const auto& [key, value] : values.items()) {
    board.entries.push_back(
        {key, value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)});
  }
  return board;
}

}  // namespace

std::string EncodeRequest(RequestType type, std::uint32_t number) {
  std::string bytes = {kVersion, static_cast<char>(type)};
  for (int shift = 0; shift < 32; shift += 8) {
    bytes += static_cast<char>(static_cast<unsigned char>(number >> shift));
  }
  return bytes;
}

std::optional<Reply> DecodeReply(const std::vector<std::string>& parts, RequestType type,
                                 std::uint32_t number, std::string& error) {
  if (parts.size() >= 2 && parts[0] == "error") {
    error = "the robot answers: " + parts[1];
    return std::nullopt;
  }
  if (parts.empty() || parts[0].size() != kReplyHeader) {
    error = "this is no robot with the Groot2 protocol (wrong reply header)";
    return std::nullopt;
  }
  if (parts[0].compare(0, kRequestHeader, EncodeRequest(type, number)) != 0) {
    error = "the answer belongs to another request or protocol version";
    return std::nullopt;
  }
  Reply reply;
  std::copy_n(parts[0].begin() + kRequestHeader, reply.tree_id.size(), reply.tree_id.begin());
  if (parts.size() > 1) reply.payload = parts[1];
  return reply;
}

std::optional<std::vector<NodeStatus>> DecodeStatuses(std::string_view payload) {
  if (payload.size() % kBytesPerNode != 0) return std::nullopt;
  std::vector<NodeStatus> nodes;
  nodes.reserve(payload.size() / kBytesPerNode);
  const auto* bytes = reinterpret_cast<const unsigned char*>(payload.data());
  for (std::size_t at = 0; at < payload.size(); at += kBytesPerNode) {
    const std::optional<NodeStatus> node = DecodeStatus(bytes + at);
    if (!node) return std::nullopt;
    nodes.push_back(*node);
  }
  return nodes;
}

std::optional<std::vector<Board>> DecodeBoards(std::string_view payload) {
  const nlohmann::json all = nlohmann::json::from_msgpack(payload, true, false);
  if (all.is_null()) return std::vector<Board>();  // none of the names is known
  if (!all.is_object()) return std::nullopt;
  std::vector<Board> boards;
  for (const auto& [name, values] : all.items()) boards.push_back(ReadBoard(name, values));
  return boards;
}

}  // namespace coppice::editor
