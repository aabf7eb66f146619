// The extension of the live protocol as a client writes and reads it: JSON texts (docs/live.md).
#ifndef COPPICE_BT_CORE_LIVE_CLIENT_CLIENT_JSON_H_
#define COPPICE_BT_CORE_LIVE_CLIENT_CLIENT_JSON_H_

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/live/client/client_types.h"

namespace coppice {

std::string WriteHello(const std::string& name);
std::string WriteCommand(const LiveCommand& command, std::size_t tree);

struct SubscribeRequest {
  std::size_t tree = 0;
  RunId run{};
  std::optional<std::uint64_t> from;  ///< a frame of this run
  bool with_past = true;              ///< without `from`: from the oldest frame or the youngest
};
std::string WriteSubscribe(const SubscribeRequest& request);
std::string WriteAck(std::uint32_t subscription, std::uint64_t next);
/// A request without members.
std::string WriteSimple(const char* what);

/// What a robot says of itself.
struct HelloReply {
  std::string refusal;
  std::vector<std::string> trees;
  bool has_pictures = false;
};
Expected<HelloReply> ReadHello(std::string_view json);

struct SubscribeReply {
  std::uint32_t subscription = 0;
  RunId run{};
  std::uint64_t next = 0;
  std::uint64_t missed = 0;
};
Expected<SubscribeReply> ReadSubscribe(std::string_view json);

LiveReply ReadReply(std::string_view json);
/// What is read as the reply to a request that nobody answers any more.
std::string WriteAbandoned(const std::string& why);

struct NoticeMessage {
  std::string event;
  std::size_t tree = 0;
  LiveNotice notice;               ///< of stopped, resumed, replaced, refused
  std::vector<std::string> trees;  ///< of trees
  LivePicture picture;             ///< of picture; as it was sent, so perhaps none
};
NoticeMessage ReadNotice(std::string_view json);

/// Of 32 hexadecimal digits; zeros if they are none.
RunId ReadRunId(std::string_view digits);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_CLIENT_CLIENT_JSON_H_
