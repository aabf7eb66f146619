#include "bt_core/live/groot2_protocol.h"

#include <algorithm>
#include <random>
#include <utility>

namespace coppice::groot2 {
namespace {

std::uint32_t ReadNumber(std::string_view bytes) {
  std::uint32_t number = 0;
  for (int i = 3; i >= 0; --i) {
    number = number << 8 | static_cast<unsigned char>(bytes[static_cast<std::size_t>(i)]);
  }
  return number;
}

// Why a request that is not served is refused.
std::string Refusal(char type) {
  switch (type) {
    case 'I':  // insert, remove, dump, remove all, disable all; release a waiting tree
    case 'R':
    case 'D':
    case 'A':
    case 'X':
    case 'U':
      return "hooks and breakpoints are not supported by this tree";
    case 'r':
    case 't':
      return "recording over this socket is not supported; poll STATUS, or record on the robot";
    default:
      return "Request not recognized";
  }
}

}  // namespace

std::variant<Request, std::string> ParseRequest(const Parts& parts) {
  if (parts.empty() || parts[0].size() != kRequestHeaderSize) return "wrong request header";
  const std::string_view header = parts[0];
  const char type = header[1];
  if (type != 'T' && type != 'S' && type != 'B') return Refusal(type);
  Request request{static_cast<RequestType>(type), ReadNumber(header.substr(2)), {}};
  if (request.type == RequestType::kBlackboard) {
    if (parts.size() != 2) return "must be 2 parts message";
    request.argument = parts[1];
  }
  return request;
}

TreeId RandomTreeId() {
  std::random_device device;
  std::uniform_int_distribution<int> byte(0, 255);
  TreeId id;
  std::generate(id.begin(), id.end(), [&] { return static_cast<char>(byte(device)); });
  id[6] = static_cast<char>((id[6] & 0x0f) | 0x40);
  id[8] = static_cast<char>((id[8] & 0x3f) | 0x80);
  return id;
}

Parts MakeReply(const Request& request, const TreeId& tree) {
  std::string header;
  header.reserve(kReplyHeaderSize);
  header += static_cast<char>(kVersion);
  header += static_cast<char>(request.type);
  for (int shift = 0; shift < 32; shift += 8) {
    header += static_cast<char>(request.number >> shift & 0xff);
  }
  header.append(tree.data(), tree.size());
  return {std::move(header)};
}

Parts MakeReply(const Request& request, const TreeId& tree, std::string payload) {
  Parts parts = MakeReply(request, tree);
  parts.push_back(std::move(payload));
  return parts;
}

Parts MakeError(std::string text) { return {"error", std::move(text)}; }

void AppendStatus(std::string& payload, std::uint16_t uid, std::uint8_t status) {
  payload += static_cast<char>(uid & 0xff);
  payload += static_cast<char>(uid >> 8);
  payload += static_cast<char>(status);
}

std::vector<std::string_view> SplitNames(std::string_view names) {
  std::vector<std::string_view> result;
  while (!names.empty()) {
    const std::size_t end = std::min(names.find(';'), names.size());
    if (end > 0) result.push_back(names.substr(0, end));
    names.remove_prefix(std::min(end + 1, names.size()));
  }
  return result;
}

}  // namespace coppice::groot2
